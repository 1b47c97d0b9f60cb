//! How long a scan takes, how bad it can get, and what watchdog that allows.
//!
//! A measurement drives a controller with a stimulus, reads the clock between the parts of each scan, and counts
//! instructions through the observers in a second pass whose time is not taken: an observed channel is slower than one
//! that nobody watches. Beside what was measured stands the static bound, which no scan exceeds in instructions.

mod costs;
mod count;
mod distribution;
mod inputs;
mod page;
mod picture;
mod report;
mod source;
mod stopwatch;
mod units;

use std::time::{Duration, Instant};

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::bound::{self, Bound};

use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::observer::Silent;
use twinrung_controller::{Controller, NoClock, Partner, Primary, StopReason};

pub use costs::{CostRow, Estimate, estimate};
pub use count::Counts;
pub use distribution::{Bucket, Distribution, Quantiles};
pub use inputs::{Coverage, Inputs};
pub use page::page;
pub use picture::picture;
pub use report::{Report, RoutineRow, RungRow};
pub use stopwatch::{Realtime, Stopwatch};
pub(crate) use units::count;
pub use units::time;

use crate::mix;
use crate::run::RunError;
use crate::stimulus::Stimulus;
use crate::threads::{OnThread, Threads};
use count::Counter;
use source::Source;

/// What to measure.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Scans whose time is taken.
    pub scans: u64,
    /// Scans before them, whose time is not taken: caches and branch predictors are cold.
    pub warm_up: u64,
    /// What drives the inputs.
    pub inputs: Driven,
    /// One scan in each period, judged by the watchdog; otherwise scan after scan.
    pub realtime: bool,
    /// On how many threads the channels execute.
    pub threads: Threads,
}

/// What drives the inputs of a measurement.
#[derive(Debug, Clone)]
pub enum Driven {
    /// Every input, at random, from this seed.
    Random(u64),
    /// A stimulus, again from its first row when it is over.
    Stimulus(Stimulus),
    /// So many toggles before each scan, as [`crate::mix`] defines them; for a generated program.
    Toggles(usize),
}

impl Default for Plan {
    fn default() -> Plan {
        Plan { scans: 10_000, warm_up: 100, inputs: Driven::Random(1), realtime: false, threads: Threads::One }
    }
}

/// What was measured.
#[derive(Debug, Clone)]
pub struct Measurement {
    /// Scans whose time was taken.
    pub scans: u64,
    /// On how many threads the channels executed.
    pub threads: Threads,
    /// The whole scan.
    pub whole: Distribution,
    /// Its parts, in the order of [`twinrung_controller::Part::ALL`]. On two threads the partner's is the wait for it, after the
    /// primary has ended.
    pub parts: [Distribution; 5],
    /// How late scans began, in real time.
    pub lateness: Option<Distribution>,
    /// Most instructions that one channel executed in a scan.
    pub instructions_max: u64,
    /// Instructions of the prescan; `None` where the measurement ended in its first scan.
    pub prescan_instructions: Option<u64>,
    /// Instructions of each rung, in the scans that were observed.
    pub counts: Counts,
    /// The static bound in instructions.
    pub bound: Bound,
    /// The scan in which the safety task stopped, and why.
    pub stopped: Option<(u64, StopReason)>,
    /// What the random values reached; `None` with a stimulus.
    pub coverage: Option<Coverage>,
    /// The state after the last scan, in one number; for a generated program.
    pub hash: Option<u64>,
    /// What reading the clock once costs, in ns. It is read six times in each scan; five of these lie within the time measured.
    pub clock_ns: u64,
}

/// Most scans of a measurement: at the longest period their time still fits in a time stamp.
pub const SCANS_MAX: u64 = 1_000_000_000_000;
/// Scans that are observed to count instructions.
const OBSERVED_SCANS: u64 = 200;
/// How long before its time a scan in real time stops sleeping and waits awake: the scheduler's usual error.
const AWAKE: Duration = Duration::from_micros(500);

/// Measures. `progress` is told after each scan how many there were, warm-up and observed scans included.
///
/// # Errors
///
/// An image without a task, a period that is not a whole number of milliseconds, a stimulus that does not fit, more than
/// [`SCANS_MAX`] scans.
pub fn measure(
    image: &AdmittedImage,
    bytes: &[u8],
    plan: &Plan,
    progress: impl FnMut(u64),
) -> Result<Measurement, RunError> {
    let task = image.image().task.as_ref().ok_or(RunError::NoTask)?;
    if !task.period_us.is_multiple_of(1000) {
        return Err(RunError::Period(task.period_us));
    }
    if plan.scans > SCANS_MAX {
        return Err(RunError::Scans(plan.scans));
    }
    let (period_us, watchdog_us) = (u64::from(task.period_us), u64::from(task.watchdog_us));
    let watchdog = plan.realtime.then(|| Duration::from_micros(watchdog_us));
    let mut work = Work { image, bytes, plan, period_us, watchdog, done: 0, progress };
    let counts = work.observed_scans()?;
    match plan.threads {
        Threads::One => work.timed_scans(&mut work.loaded::<Partner>()?, counts),
        Threads::Two => {
            let mut controller = work.loaded::<OnThread<Partner>>()?;
            // In real time a partner that is later than the watchdog is not waited for.
            controller.channels_mut().1.set_time_limit(watchdog);
            work.timed_scans(&mut controller, counts)
        }
    }
}

/// A measurement at work.
struct Work<'a, F> {
    image: &'a AdmittedImage,
    bytes: &'a [u8],
    plan: &'a Plan,
    period_us: u64,
    /// In real time.
    watchdog: Option<Duration>,
    /// Scans so far.
    done: u64,
    progress: F,
}

impl<F: FnMut(u64)> Work<'_, F> {
    fn loaded<B: Channel>(&self) -> Result<Controller<Primary, B>, RunError> {
        Controller::load(self.image.clone(), self.bytes).map_err(|error| RunError::Load(error.to_string()))
    }

    fn passed(&mut self) {
        self.done += 1;
        (self.progress)(self.done);
    }

    /// Counts the instructions of some scans, whose time is not taken.
    fn observed_scans(&mut self) -> Result<Counts, RunError> {
        let mut controller = self.loaded::<Partner>()?;
        let mut source = Source::new(&mut controller, self.plan)?;
        let mut counter = Counter::new(self.image);
        controller.power_up_in_run();
        // The first boundary also prescans, and what a prescan executes is not part of a scan.
        source.before(&mut controller, 0, 0);
        controller.scan(0);
        for scan in 1..=self.plan.scans.min(OBSERVED_SCANS) {
            let time_ms = scan * self.period_us / 1000;
            source.before(&mut controller, scan, time_ms);
            counter.begin();
            let report = controller.scan_observed(time_ms as i64, &mut NoClock, &mut counter, &mut Silent);
            counter.end();
            if report.stopped.is_some() {
                break;
            }
            self.passed();
        }
        Ok(counter.counts())
    }

    /// Takes the time of scans that nobody observes.
    fn timed_scans<B: Channel>(
        &mut self,
        controller: &mut Controller<Primary, B>,
        counts: Counts,
    ) -> Result<Measurement, RunError> {
        let plan = self.plan;
        let distribution = || Distribution::new().map_err(|error| RunError::Load(error.to_string()));
        let mut source = Source::new(controller, plan)?;
        controller.power_up_in_run();
        let mut measurement = Measurement {
            scans: 0,
            threads: plan.threads,
            whole: distribution()?,
            parts: [distribution()?, distribution()?, distribution()?, distribution()?, distribution()?],
            lateness: if plan.realtime { Some(distribution()?) } else { None },
            instructions_max: 0,
            prescan_instructions: None,
            counts,
            bound: bound::instructions(self.image),
            stopped: None,
            coverage: None,
            hash: None,
            clock_ns: stopwatch::reading_ns(),
        };
        let period = Duration::from_micros(self.period_us);
        let mut stopwatch = Stopwatch::new(self.watchdog.map(|watchdog| Realtime { watchdog, period }));
        let begun = Instant::now();
        for scan in 0..plan.warm_up.saturating_add(plan.scans) {
            let time_ms = scan * self.period_us / 1000;
            source.before(controller, scan, time_ms);
            let late = plan.realtime.then(|| wait_until(begun + Duration::from_micros(scan * self.period_us)));
            let report = controller.scan_observed(time_ms as i64, &mut stopwatch, &mut Silent, &mut Silent);
            if let Some(reason) = report.stopped {
                measurement.stopped = Some((scan, reason));
                break;
            }
            if scan == 0 {
                // The first boundary prescans before it scans.
                let executed = controller.status().executed;
                measurement.prescan_instructions = Some(executed.saturating_sub(report.instructions));
            }
            measurement.instructions_max = measurement.instructions_max.max(report.instructions);
            if scan >= plan.warm_up {
                measurement.scans += 1;
                stopwatch.record(&mut measurement.whole, &mut measurement.parts);
                if let (Some(late), Some(lateness)) = (late, measurement.lateness.as_mut()) {
                    lateness.record(late);
                }
            }
            self.passed();
        }
        match source {
            Source::Random(inputs) => measurement.coverage = Some(inputs.coverage()),
            Source::Toggles(_) => measurement.hash = Some(mix::hash(controller)),
            Source::Stimulus(_) => {}
        }
        Ok(measurement)
    }
}

/// Scans that a plan makes in all, for a progress bar.
pub fn scans_in_all(plan: &Plan) -> u64 {
    plan.scans.min(OBSERVED_SCANS).saturating_add(plan.warm_up).saturating_add(plan.scans)
}

/// Waits, the last of it awake. Answers with how late it is then.
fn wait_until(when: Instant) -> Duration {
    loop {
        let now = Instant::now();
        let left = when.saturating_duration_since(now);
        if left.is_zero() {
            return now - when;
        }
        if left > AWAKE {
            std::thread::sleep(left - AWAKE);
        } else {
            std::hint::spin_loop();
        }
    }
}
