//! A safety connection: what a producer sends, and what its consumer makes of it. 1756-RM093 Table 9, Appendix C; 1734-UM013,
//! Configure Safety Connections.
//!
//! The producer sends every requested packet interval what it publishes then. A packet carries the time at which it was sent. The
//! consumer holds the newest packet that arrived; once that is older than the connection reaction time limit the connection is
//! faulted, until a packet arrives that is young enough. So data that a consumer uses is never older than the limit. (That age and
//! not arrival counts is decided: it is what the limit promises, whatever the network does.)

use std::collections::VecDeque;

/// What a producer sends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Sent {
    /// It executes: the values of the tag, in the order of its declaration.
    Run(Vec<i32>),
    /// It is in Program mode, does not execute yet, or a recoverable fault stopped its logic: consumers are to be safe.
    Idle,
    /// Nothing: a module that is not there, a controller whose safety task is shut down or whose partnership is lost.
    Nothing,
}

/// What a consumer has: one of the three states of 1756-RM093 Table 9. The fourth combination of its two bits is invalid, and
/// cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Received<'c> {
    /// Data of a producer in Run: RunMode 1, ConnectionFaulted 0.
    Run(&'c [i32]),
    /// The producer is idle: data 0, RunMode 0, ConnectionFaulted 0.
    Idle,
    /// No packet that is young enough: data 0, RunMode 0, ConnectionFaulted 1.
    Faulted,
}

impl Received<'_> {
    /// The bit RunMode.
    pub const fn run_mode(&self) -> bool {
        matches!(self, Received::Run(_))
    }

    /// The bit ConnectionFaulted.
    pub const fn connection_faulted(&self) -> bool {
        matches!(self, Received::Faulted)
    }

    /// A value by its position; 0 unless the producer runs.
    pub fn value(&self, position: usize) -> i32 {
        match self {
            Received::Run(values) => values.get(position).copied().unwrap_or_default(),
            Received::Idle | Received::Faulted => 0,
        }
    }
}

/// The times of a connection, µs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Times {
    /// Requested packet interval, above 0.
    pub rpi_us: u64,
    /// Connection reaction time limit.
    pub limit_us: u64,
    /// How long a packet is on its way.
    pub delay_us: u64,
    /// When the first packet is sent.
    pub first_us: u64,
}

#[derive(Debug, Clone)]
struct Packet {
    sent_us: u64,
    /// The values; nothing where the producer is idle.
    values: Option<Vec<i32>>,
}

/// A connection: of a module's inputs, or of a consumed tag.
#[derive(Debug, Clone)]
pub struct Connection {
    times: Times,
    next_us: u64,
    network: bool,
    on_the_way: VecDeque<Packet>,
    newest: Option<Packet>,
}

impl Connection {
    /// Over which nothing was sent yet.
    pub const fn new(times: Times) -> Connection {
        Connection { times, next_us: times.first_us, network: true, on_the_way: VecDeque::new(), newest: None }
    }

    /// When the next packet is due, µs.
    pub const fn next_us(&self) -> u64 {
        self.next_us
    }

    /// Whether the network carries packets from now on; one that it does not carry is lost.
    pub const fn carry(&mut self, network: bool) {
        self.network = network;
    }

    /// A moment has come, which does not go back. Where a packet is due it is sent; of several the newest. Packets keep their
    /// grid, whatever the step of the simulation.
    pub fn pass(&mut self, now_us: u64, produce: impl FnOnce() -> Sent) {
        let Some(late_us) = now_us.checked_sub(self.next_us) else { return };
        let rpi_us = self.times.rpi_us.max(1);
        let sent_us = now_us - late_us % rpi_us;
        self.next_us = sent_us.saturating_add(rpi_us);
        let values = match produce() {
            _ if !self.network => return,
            Sent::Run(values) => Some(values),
            Sent::Idle => None,
            Sent::Nothing => return,
        };
        self.on_the_way.push_back(Packet { sent_us, values });
    }

    /// What the consumer has at `now_us`, which does not go back.
    pub fn at(&mut self, now_us: u64) -> Received<'_> {
        let delay_us = self.times.delay_us;
        while let Some(packet) = self.on_the_way.pop_front_if(|next| next.sent_us.saturating_add(delay_us) <= now_us) {
            self.newest = Some(packet);
        }
        self.held(now_us)
    }

    /// What the consumer has at the moment, or later, at which it was last asked what arrived.
    pub fn held(&self, now_us: u64) -> Received<'_> {
        match &self.newest {
            Some(packet) if now_us.saturating_sub(packet.sent_us) <= self.times.limit_us => match &packet.values {
                Some(values) => Received::Run(values),
                None => Received::Idle,
            },
            _ => Received::Faulted,
        }
    }
}
