//! The clock between the parts of a scan.

use std::time::{Duration, Instant};

use twinrung_controller::{Part, ScanClock};

use super::Distribution;

/// Takes the time at the end of each part, and judges by the watchdog in real time. Nothing is recorded within the scan, and
/// the clock is read once at its beginning and once at the end of each part.
#[derive(Debug, Clone)]
pub struct Stopwatch {
    stamps: [Instant; 6],
    watchdog: Option<Duration>,
}

impl Stopwatch {
    /// With a watchdog in real time, or without one.
    pub fn new(watchdog: Option<Duration>) -> Stopwatch {
        Stopwatch { stamps: [Instant::now(); 6], watchdog }
    }

    /// The parts of the last scan, in the order of [`Part::ALL`].
    pub fn parts(&self) -> [Duration; 5] {
        let [begun, freeze, primary, partner, compare, publish] = self.stamps;
        [freeze - begun, primary - freeze, partner - primary, compare - partner, publish - compare]
    }

    /// Records the scan that has ended.
    pub(super) fn record(&self, whole: &mut Distribution, parts: &mut [Distribution; 5]) {
        let times = self.parts();
        whole.record(times.iter().sum());
        parts.iter_mut().zip(times).for_each(|(part, time)| part.record(time));
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
        // Asked right after the comparison, whose end has its stamp.
        let compared = self.stamps[Part::Compare as usize + 1];
        self.watchdog.is_some_and(|watchdog| compared - self.stamps[0] > watchdog)
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
