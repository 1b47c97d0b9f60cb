//! Pulses of a sensor, and the frequency that the module makes of them. 1734-UM013, Tachometer Mode; Figures 15 to 17.

/// Phase of one pulse: mHz times µs.
const CYCLE: u64 = 1_000_000_000;
/// For how much of a cycle the signal is low: a quarter (decided; two sensors must not be low together).
const LOW: u64 = CYCLE / 4;
/// Longest time between two edges that is a frequency, µs: 1 Hz.
const SLOWEST_US: u64 = 1_000_000;
/// Shortest time between two edges that is within range, µs: 1 kHz.
const FASTEST_US: u64 = 1_000;

/// The signal of a sensor.
#[derive(Debug, Clone, Default)]
pub struct Sensor {
    /// Frequency in mHz.
    pub frequency: u64,
    phase: u64,
}

impl Sensor {
    /// A sensor at rest, between two pulses. The sensors of a pair are half a cycle apart, as Figure 15 has them.
    pub fn new(channel: u8) -> Sensor {
        let start = if channel.is_multiple_of(2) { CYCLE / 10 * 9 } else { CYCLE / 10 * 4 };
        Sensor { frequency: 0, phase: start }
    }

    /// One µs; whether the signal is high in it.
    pub fn pass(&mut self) -> bool {
        self.phase = (self.phase + self.frequency) % CYCLE;
        self.phase >= LOW
    }
}

/// What the module makes of the pulses.
#[derive(Debug, Clone)]
pub struct Tachometer {
    /// Whether rising edges count, and not falling ones.
    rising: bool,
    high: bool,
    last_edge_us: Option<u64>,
    /// Time between the last two edges, µs.
    interval_us: Option<u64>,
    over: bool,
    reset: bool,
    reset_before: bool,
}

impl Tachometer {
    /// Counts falling edges, or rising ones.
    pub fn new(rising: bool) -> Tachometer {
        Tachometer {
            rising,
            high: true,
            last_edge_us: None,
            interval_us: None,
            over: false,
            reset: false,
            reset_before: false,
        }
    }

    /// Whether the sensors source current, so that joined signals are high where one of them is.
    pub fn sources(&self) -> bool {
        self.rising
    }

    /// The level at the terminal in one µs.
    pub fn look(&mut self, now_us: u64, high: bool) {
        if high != self.high && high == self.rising {
            if let Some(last) = self.last_edge_us {
                let interval = now_us.saturating_sub(last);
                self.interval_us = Some(interval).filter(|interval| *interval <= SLOWEST_US);
                self.over |= interval < FASTEST_US;
            }
            self.last_edge_us = Some(now_us);
        }
        self.high = high;
    }

    /// The end of a look at the terminals: a frequency without a further edge runs out. A reset, which is edge-sensitive, comes
    /// last, so that its effect is seen for a moment even where the next pulses are too fast again.
    pub fn settle(&mut self, now_us: u64) {
        if self.last_edge_us.is_some_and(|last| now_us.saturating_sub(last) > SLOWEST_US) {
            self.interval_us = None;
            self.last_edge_us = None;
        }
        if self.reset && !self.reset_before {
            self.over = false;
            self.last_edge_us = None;
            self.interval_us = None;
        }
        self.reset_before = self.reset;
    }

    /// The command `ResetTach`.
    pub fn command_reset(&mut self, on: bool) {
        self.reset = on;
    }

    /// The frequency in mHz; nothing below 1 Hz. Beyond 1 kHz it is 1 kHz until the reset.
    pub fn frequency(&self) -> Option<f64> {
        match self.interval_us {
            _ if self.over => Some(1_000_000.0),
            Some(interval) => Some(1e9 / interval.max(1) as f64),
            None => None,
        }
    }

    /// Whether more than 1 kHz was there since the last reset.
    pub fn is_over(&self) -> bool {
        self.over
    }
}
