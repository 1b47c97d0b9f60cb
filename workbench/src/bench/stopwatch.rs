//! The clock between the parts of a scan.

use std::time::{Duration, Instant};

use twinrung_controller::{Part, ScanClock};

use super::Distribution;

/// Takes the time at the end of each part, and judges by the watchdog in real time. Nothing is recorded within the scan.
pub(super) struct Stopwatch {
    stamps: [Instant; 6],
    watchdog: Option<Duration>,
}

impl Stopwatch {
    pub(super) fn new(watchdog: Option<Duration>) -> Stopwatch {
        Stopwatch { stamps: [Instant::now(); 6], watchdog }
    }

    /// Records the scan that has ended.
    pub(super) fn record(&self, whole: &mut Distribution, parts: &mut [Distribution; 5]) {
        let [begun, .., ended] = self.stamps;
        whole.record(ended - begun);
        for (part, stamps) in parts.iter_mut().zip(self.stamps.windows(2)) {
            if let [from, to] = stamps {
                part.record(*to - *from);
            }
        }
    }
}

impl ScanClock for Stopwatch {
    fn begin(&mut self) {
        self.stamps[0] = Instant::now();
    }

    fn ended(&mut self, part: Part) {
        self.stamps[part as usize + 1] = Instant::now();
    }

    fn expired(&mut self) -> bool {
        self.watchdog.is_some_and(|watchdog| self.stamps[0].elapsed() > watchdog)
    }
}

/// What reading the clock once costs, in ns: the mean of many readings.
pub(super) fn reading_ns() -> u64 {
    const READINGS: u32 = 10_000;
    let begun = Instant::now();
    for _ in 0..READINGS {
        std::hint::black_box(Instant::now());
    }
    (begun.elapsed() / READINGS).as_nanos() as u64
}
