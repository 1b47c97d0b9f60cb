//! The clock between the parts of a scan.

use std::time::{Duration, Instant, SystemTime};

use twinrung_controller::{Part, Reference, ScanClock};

use super::Distribution;

/// What scans are judged by in real time.
#[derive(Debug, Clone, Copy)]
pub struct Realtime {
    /// How long a scan may take.
    pub watchdog: Duration,
    /// The period. Scans begin by one clock, which may go so far apart from the other, the wall clock.
    pub period: Duration,
}

/// Takes the time at the end of each part, and judges by watchdog and wall clock in real time. Nothing is recorded within the scan, and
/// the clock is read once at its beginning and once at the end of each part.
#[derive(Debug, Clone)]
pub struct Stopwatch {
    stamps: [Instant; 6],
    realtime: Option<Realtime>,
    first: Option<Instant>,
    boundaries: u32,
}

impl Stopwatch {
    /// With what judges in real time, or without.
    pub fn new(realtime: Option<Realtime>) -> Stopwatch {
        Stopwatch { stamps: [Instant::now(); 6], realtime, first: None, boundaries: 0 }
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
        self.realtime.is_some_and(|realtime| compared - self.stamps[0] > realtime.watchdog)
    }

    fn reference(&mut self) -> Option<Reference> {
        let realtime = self.realtime?;
        // A scan that begins late is told the time at which it was due, so its lateness is taken off.
        let due = realtime.period * self.boundaries;
        let late = self.first.get_or_insert_with(Instant::now).elapsed().saturating_sub(due);
        self.boundaries += 1;
        // A wall clock before 1970 stands still for this check, which stops the task.
        let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
        Some(Reference {
            ms: since.saturating_sub(late).as_millis() as i64,
            tolerance_ms: realtime.period.as_millis() as i64,
        })
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
