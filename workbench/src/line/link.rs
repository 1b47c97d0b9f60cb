//! A connection between two controllers: what a producer sends, and what its consumer makes of it. 1756-RM093 Table 9, Appendix C.
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
    /// Nothing: its safety task is shut down, or the partnership is lost.
    Nothing,
}

/// What a consumer has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Received<'l> {
    /// Data of a producer in Run: RunMode 1, ConnectionFaulted 0.
    Run(&'l [i32]),
    /// The producer is idle: data 0, RunMode 0, ConnectionFaulted 0.
    Idle,
    /// No packet that is young enough: data 0, RunMode 0, ConnectionFaulted 1.
    Faulted,
}

impl Received<'_> {
    /// RunMode and ConnectionFaulted.
    pub const fn status(&self) -> (bool, bool) {
        match self {
            Received::Run(_) => (true, false),
            Received::Idle => (false, false),
            Received::Faulted => (false, true),
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

/// A connection.
#[derive(Debug, Clone)]
pub struct Link {
    times: Times,
    next_us: u64,
    network: bool,
    on_the_way: VecDeque<Packet>,
    newest: Option<Packet>,
}

impl Link {
    /// Over which nothing was sent yet.
    pub fn new(times: Times) -> Link {
        Link { times, next_us: times.first_us, network: true, on_the_way: VecDeque::new(), newest: None }
    }

    /// When the next packet is due, µs.
    pub const fn next_us(&self) -> u64 {
        self.next_us
    }

    /// Whether the network carries packets from now on; one that it does not carry is lost.
    pub fn carry(&mut self, network: bool) {
        self.network = network;
    }

    /// The packet that is due is sent.
    pub fn send(&mut self, sent: &Sent) {
        let values = match sent {
            Sent::Run(values) => Some(Some(values.clone())),
            Sent::Idle => Some(None),
            Sent::Nothing => None,
        };
        if let Some(values) = values.filter(|_| self.network) {
            self.on_the_way.push_back(Packet { sent_us: self.next_us, values });
        }
        self.next_us = self.next_us.saturating_add(self.times.rpi_us.max(1));
    }

    /// What the consumer has at `now_us`, which does not go back.
    pub fn at(&mut self, now_us: u64) -> Received<'_> {
        while let Some(first) = self.on_the_way.front() {
            if first.sent_us.saturating_add(self.times.delay_us) > now_us {
                break;
            }
            self.newest = self.on_the_way.pop_front();
        }
        match &self.newest {
            Some(packet) if now_us.saturating_sub(packet.sent_us) <= self.times.limit_us => match &packet.values {
                Some(values) => Received::Run(values),
                None => Received::Idle,
            },
            _ => Received::Faulted,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIMES: Times = Times { rpi_us: 10_000, limit_us: 40_064, delay_us: 1_000, first_us: 0 };

    /// A link over which packets went at 0 and 10 ms.
    fn sent_twice() -> Link {
        let mut link = Link::new(TIMES);
        link.send(&Sent::Run(vec![7]));
        link.send(&Sent::Run(vec![8]));
        link
    }

    #[test]
    fn link_when_nothing_has_arrived_yet_then_it_is_faulted() {
        assert_eq!(Link::new(TIMES).at(0), Received::Faulted);
        assert_eq!(sent_twice().at(999), Received::Faulted);
    }

    #[test]
    fn link_when_packets_arrive_then_the_newest_counts() {
        let mut link = sent_twice();
        assert_eq!(link.at(1_000), Received::Run(&[7]));
        assert_eq!(link.at(11_000), Received::Run(&[8]));
    }

    /// 1756-RM093 Appendix C: without a valid packet within the limit the connection times out.
    #[test]
    fn link_when_the_newest_packet_is_older_than_the_limit_then_it_is_faulted() {
        let mut link = sent_twice();
        assert_eq!(link.at(50_064), Received::Run(&[8]));
        assert_eq!(link.at(50_065), Received::Faulted);
    }

    #[test]
    fn link_when_the_network_loses_packets_then_it_is_faulted_and_comes_back_with_the_next_one() {
        let mut link = sent_twice();
        link.carry(false);
        (0..5).for_each(|_| link.send(&Sent::Run(vec![9])));
        assert_eq!(link.at(60_000), Received::Faulted);
        link.carry(true);
        link.send(&Sent::Run(vec![10]));
        assert_eq!(link.at(71_000), Received::Run(&[10]));
    }

    #[test]
    fn link_when_packets_take_longer_than_the_limit_then_their_data_is_never_used() {
        let mut link = Link::new(Times { delay_us: 40_065, ..TIMES });
        (0..9).for_each(|_| link.send(&Sent::Run(vec![7])));
        assert_eq!(link.at(200_000), Received::Faulted);
    }

    /// Table 9, row by row; the fourth is invalid.
    #[test]
    fn status_when_each_state_is_received_then_it_is_that_of_the_table() {
        let states = [Received::Run(&[]), Received::Idle, Received::Faulted];
        assert_eq!(states.map(|one| one.status()), [(true, false), (false, false), (false, true)]);
    }

    #[test]
    fn link_when_the_producer_is_idle_or_silent_then_the_consumer_is_idle_or_faulted() {
        let mut link = sent_twice();
        link.send(&Sent::Idle);
        assert_eq!(link.at(21_000), Received::Idle);
        (0..4).for_each(|_| link.send(&Sent::Nothing));
        assert_eq!(link.at(60_064), Received::Idle);
        assert_eq!(link.at(60_065), Received::Faulted);
    }
}
