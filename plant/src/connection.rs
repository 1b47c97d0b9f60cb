//! A safety connection: packets at an interval, a reaction time limit, and the status that the consumer shows.
//! Source: 1756-RM093 Table 9; 1734-UM013, Configure Safety Connections.

/// What a consumer's CONNECTION_STATUS says: one of the three states of 1756-RM093 Table 9. The fourth combination of its two
/// bits is invalid, and cannot be made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ConnectionStatus {
    /// Data arrives from a producer in Run mode.
    Running,
    /// The connection is active and the producer is idle: data is 0.
    Idle,
    /// The connection is faulted, the state of the producer is not known: data is 0.
    Faulted,
}

impl ConnectionStatus {
    /// The bit RunMode.
    pub fn run_mode(self) -> bool {
        self == ConnectionStatus::Running
    }

    /// The bit ConnectionFaulted.
    pub fn connection_faulted(self) -> bool {
        self == ConnectionStatus::Faulted
    }
}

/// A connection as its consumer sees it: of a module's inputs, or of a consumed tag.
#[derive(Debug, Clone)]
pub struct Connection {
    rpi_us: u64,
    limit_us: u64,
    next_us: u64,
    last: Option<u64>,
    running: bool,
    data: Vec<i32>,
}

impl Connection {
    /// A connection that packets use each `rpi_us`, from time 0 on, and that is faulted when none has arrived for longer than
    /// `limit_us`. Both in µs.
    pub fn new(rpi_us: u64, limit_us: u64) -> Connection {
        Connection { rpi_us: rpi_us.max(1), limit_us, next_us: 0, last: None, running: false, data: Vec::new() }
    }

    /// A moment has come. Where a packet is due and the producer can be reached, it is filled by `produce` and arrives at once;
    /// `running` is whether the producer is in Run mode.
    pub fn pass(&mut self, now_us: u64, reachable: bool, running: bool, produce: impl FnOnce(&mut Vec<i32>)) {
        if now_us < self.next_us {
            return;
        }
        // Packets keep their grid, whatever the step of the simulation.
        self.next_us += (now_us - self.next_us) / self.rpi_us * self.rpi_us + self.rpi_us;
        if reachable {
            self.last = Some(now_us);
            self.running = running;
            self.data.clear();
            produce(&mut self.data);
        }
    }

    /// The status at a time in µs.
    pub fn status(&self, now_us: u64) -> ConnectionStatus {
        match self.last {
            Some(last) if now_us.saturating_sub(last) <= self.limit_us && self.running => ConnectionStatus::Running,
            Some(last) if now_us.saturating_sub(last) <= self.limit_us => ConnectionStatus::Idle,
            _ => ConnectionStatus::Faulted,
        }
    }

    /// A value of the last packet by its position; 0 unless the connection runs.
    pub fn value(&self, now_us: u64, position: usize) -> i32 {
        match self.status(now_us) {
            ConnectionStatus::Running => self.data.get(position).copied().unwrap_or_default(),
            ConnectionStatus::Idle | ConnectionStatus::Faulted => 0,
        }
    }
}
