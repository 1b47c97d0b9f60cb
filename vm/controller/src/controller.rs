//! One scan: freeze, execute twice, compare, publish.

use alloc::sync::Arc;

use twinrung_bytecode::channel::{Channel, ScanEnd, Status};
use twinrung_bytecode::index::{BitCell, EventTaskIndex, WordCell};
use twinrung_bytecode::observer::{Observer, Silent};
use twinrung_bytecode::{AdmittedImage, CellRange, limits};

use crate::clock::{Moment, NoClock, Part, ScanClock};
use crate::compare::{compared, mask};
use crate::fault::{SafetyFault, StopReason};
use crate::half::{Half, Permit};
use crate::image_check::ImageCheck;
use crate::mode::{Mode, ModeRequest};
use crate::verdict::{Multiplied, Rotated, Step};
use crate::{reciprocal, self_test};

/// Why a controller could not take an image.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LoadError<A, B> {
    /// The image has no safety task: it is a library.
    NoTask,
    /// Channel 1 could not load it.
    Primary(A),
    /// Channel 2 could not load it.
    Partner(B),
}

impl<A: core::fmt::Display, B: core::fmt::Display> core::fmt::Display for LoadError<A, B> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            LoadError::NoTask => f.write_str("the image has no safety task"),
            LoadError::Primary(error) => write!(f, "channel 1: {error}"),
            LoadError::Partner(error) => write!(f, "channel 2: {error}"),
        }
    }
}

/// What one call of [`Controller::scan`] did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ScanReport {
    /// Whether logic executed.
    pub executed: bool,
    /// Why the task does not execute any more, if so.
    pub stopped: Option<StopReason>,
    /// Instructions that one channel executed in this scan.
    pub instructions: u64,
}

/// The half of the primary: values as they are.
pub(crate) type PrimaryHalf = Half<0, Multiplied>;
/// The half of the partner: values complemented.
pub(crate) type PartnerHalf = Half<{ u32::MAX }, Rotated>;

/// A controller with two channels. A scan is a function of what it holds, the inputs and the time.
#[derive(Clone)]
pub struct Controller<A: Channel, B: Channel> {
    pub(crate) image: Arc<AdmittedImage>,
    pub(crate) check: ImageCheck,
    primary: A,
    partner: B,
    pub(crate) first: PrimaryHalf,
    pub(crate) second: PartnerHalf,
    /// Whether a scan executes at least one instruction.
    has_rungs: bool,
    pub(crate) mode: Mode,
    request: Option<ModeRequest>,
    pub(crate) stopped: Option<StopReason>,
}

impl<A: Channel, B: Channel> Controller<A, B> {
    /// Loads an admitted image into both channels. `bytes` are the sealed bytes that were admitted: the running check
    /// goes over them.
    pub fn load(image: AdmittedImage, bytes: &[u8]) -> Result<Controller<A, B>, LoadError<A::LoadError, B::LoadError>> {
        let task = image.image().task.as_ref().ok_or(LoadError::NoTask)?;
        let budget = u64::from(task.watchdog_us).saturating_mul(limits::BUDGET_PER_MICROSECOND);
        let primary = A::load(&image).map_err(LoadError::Primary)?;
        let partner = B::load(&image).map_err(LoadError::Partner)?;
        Ok(Controller {
            check: ImageCheck::new(bytes),
            primary,
            partner,
            first: Half::new(&image, budget),
            second: Half::new(&image, budget),
            has_rungs: has_rungs(&image),
            mode: Mode::Program,
            request: None,
            stopped: None,
            image: Arc::new(image),
        })
    }

    /// The image that both channels execute.
    pub fn image(&self) -> &AdmittedImage {
        &self.image
    }

    /// The mode.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// Why the task does not execute, if so.
    pub fn stopped(&self) -> Option<StopReason> {
        self.stopped
    }

    /// The status that both channels agreed on.
    pub fn status(&self) -> Status {
        self.primary.status()
    }

    /// Asks for another mode; it acts at the second scan boundary from now.
    pub fn request_mode(&mut self, mode: Mode) {
        self.request = Some(ModeRequest::new(mode));
    }

    /// The diagnostics of one channel's hardware failed: the partnership is lost, and nothing executes any more (1756-RM093
    /// Nonrecoverable Controller Faults). A simulation has no such hardware: whoever stands around the controller says so.
    pub fn lose_partnership(&mut self) {
        self.stop(StopReason::PartnershipLost);
    }

    /// Powers up with the mode switch in Run: the first scan prescans and executes.
    pub fn power_up_in_run(&mut self) {
        self.mode = Mode::Run;
        self.permit(Permit::Armed);
    }

    /// Sets the value of a system attribute for the scans that follow, at the position its record names.
    pub fn set_system_value(&mut self, position: usize, value: i32) {
        self.first.set_system_value(position, value);
        self.second.set_system_value(position, value);
    }

    /// Adds cells to those that are copied in at the start of each scan (a stimulus may drive any tag that no logic
    /// writes).
    pub fn freeze_also(&mut self, range: CellRange) {
        self.first.freeze_also(range);
        self.second.freeze_also(range);
    }

    /// Adds cells to those that are published.
    pub fn publish_also(&mut self, range: CellRange) {
        self.first.publish_also(range);
        self.second.publish_also(range);
    }

    /// Drives a BOOL from outside; logic sees it from the next scan on.
    pub fn drive_bit(&mut self, cell: BitCell, value: bool) {
        self.first.drive_bit(cell, value);
        self.second.drive_bit(cell, value);
    }

    /// Drives a number from outside; logic sees it from the next scan on.
    pub fn drive_word(&mut self, cell: WordCell, value: i32) {
        self.first.drive_word(cell, value);
        self.second.drive_word(cell, value);
    }

    /// A BOOL as it is driven from outside.
    pub fn driven_bit(&self, cell: BitCell) -> Option<bool> {
        self.first.driven_bit(cell)
    }

    /// A number as it is driven from outside.
    pub fn driven_word(&self, cell: WordCell) -> Option<i32> {
        self.first.driven_word(cell)
    }

    /// A BOOL as both channels hold it.
    pub fn bit(&self, cell: BitCell) -> Option<bool> {
        let byte = *self.primary.bits().get(cell.position())?;
        Some((byte ^ mask(A::REPRESENTATION) as u8) & 1 == 1)
    }

    /// A number as both channels hold it.
    pub fn word(&self, cell: WordCell) -> Option<i32> {
        let word = *self.primary.words().get(cell.position())?;
        Some((word ^ mask(A::REPRESENTATION)) as i32)
    }

    /// A published BOOL: what the machine sees. On only where both halves of the controller say so.
    pub fn published_bit(&self, cell: BitCell) -> Option<bool> {
        let (first, second) = (self.first.output_bit(cell)?, self.second.output_bit(cell)?);
        Some(first == 1 && second == 1)
    }

    /// A published number: what the machine sees. 0 where the halves of the controller do not say the same.
    pub fn published_word(&self, cell: WordCell) -> Option<i32> {
        let (first, second) = (self.first.output_word(cell)?, self.second.output_word(cell)?);
        Some(if first == second { first as i32 } else { 0 })
    }

    /// How often EVENT triggered a task in the last scan.
    pub fn events(&self, task: EventTaskIndex) -> u32 {
        self.primary.events(task)
    }

    /// The channels themselves, for measurement and fault injection.
    pub fn channels_mut(&mut self) -> (&mut A, &mut B) {
        (&mut self.primary, &mut self.partner)
    }

    /// The bytes that the running check goes over, for fault injection.
    pub fn checked_bytes_mut(&mut self) -> &mut [u8] {
        self.check.bytes_mut()
    }

    /// One scan boundary at `now_ms` in simulated time.
    pub fn scan(&mut self, now_ms: i64) -> ScanReport {
        self.scan_observed(now_ms, &mut NoClock, &mut Silent, &mut Silent)
    }

    /// One scan boundary at `now_ms`, watched by a clock and by one observer for each channel.
    pub fn scan_observed<C: ScanClock, P: Observer, Q: Observer>(
        &mut self,
        now_ms: i64,
        clock: &mut C,
        primary_observer: &mut P,
        partner_observer: &mut Q,
    ) -> ScanReport {
        self.pass_boundary();
        let reference = clock.reference();
        if self.mode == Mode::Program || self.stopped.is_some() {
            self.outputs_off();
            return ScanReport { executed: false, stopped: self.stopped, instructions: 0 };
        }
        let (Some(permit), true) = (self.permitted(), self.outputs_agree()) else {
            return self.stop_safely(SafetyFault::ControllerCorrupted);
        };
        let faults = (self.first.begin(now_ms, reference), self.second.begin(now_ms, reference));
        if let Some(fault) = faults.0.or(faults.1) {
            return self.stop_safely(SafetyFault::Time(fault));
        }
        self.disturb(clock, Moment::Begun);
        if permit == Permit::Armed {
            self.permit(Permit::Running);
            let primary_end = self.primary.prescan(self.first.inputs(), primary_observer);
            let partner_end = self.partner.prescan(self.second.inputs(), partner_observer);
            if let Some(reason) = self.judge((primary_end, partner_end)) {
                return self.stop(reason);
            }
        }
        clock.begin();
        self.first.freeze(&mut self.primary);
        self.second.freeze(&mut self.partner);
        clock.ended(Part::Freeze);
        self.disturb(clock, Moment::After(Part::Freeze));
        let before = self.primary.status().executed;
        self.partner.begin::<Q>(self.second.inputs());
        let primary_end = self.primary.scan(self.first.inputs(), primary_observer);
        clock.ended(Part::Primary);
        self.disturb(clock, Moment::After(Part::Primary));
        let partner_end = self.partner.scan(self.second.inputs(), partner_observer);
        clock.ended(Part::Partner);
        self.disturb(clock, Moment::After(Part::Partner));
        let reason = self.judge_scan((primary_end, partner_end));
        clock.ended(Part::Compare);
        let late = clock.expired();
        self.first.step(Step::Watchdog, u64::from(late));
        self.second.step(Step::Watchdog, u64::from(late));
        let watchdog = late.then_some(StopReason::Safety(SafetyFault::WatchdogExpired));
        self.disturb(clock, Moment::After(Part::Compare));
        let reason = match reason {
            // A channel that gave no answer until the watchdog expired has not made it in time: no more is known of it.
            Some(StopReason::Safety(fault)) if fault != SafetyFault::ChannelStopped => reason,
            _ => watchdog.or(reason),
        };
        if let Some(reason) = reason.or_else(|| self.publish()) {
            return self.stop(reason);
        }
        clock.ended(Part::Publish);
        self.disturb(clock, Moment::After(Part::Publish));
        ScanReport { executed: true, stopped: None, instructions: self.primary.status().executed.wrapping_sub(before) }
    }

    fn pass_boundary(&mut self) {
        let Some(request) = self.request.as_mut() else { return };
        if let Some(mode) = request.boundary() {
            match (self.mode, mode) {
                (Mode::Program, Mode::Run) => self.permit(Permit::Armed),
                (Mode::Run, Mode::Program) => self.permit(Permit::Halted),
                _ => {}
            }
            self.mode = mode;
            self.request = None;
        }
    }

    fn permit(&mut self, permit: Permit) {
        self.first.permit(permit);
        self.second.permit(permit);
    }

    /// What both halves permit; nothing where they do not say the same, or say that nothing may execute.
    fn permitted(&self) -> Option<Permit> {
        let permit = self.first.permitted().filter(|permit| *permit != Permit::Halted)?;
        (self.second.permitted() == Some(permit)).then_some(permit)
    }

    fn outputs_agree(&self) -> bool {
        self.first.agrees(&self.second) && self.second.agrees(&self.first)
    }

    /// Whether what a channel says means nothing.
    fn has_stopped_channel(&self) -> bool {
        self.primary.has_stopped() || self.partner.has_stopped()
    }

    /// Judges a scan, and tells both halves' verdicts.
    fn judge_scan(&mut self, ends: (ScanEnd, ScanEnd)) -> Option<StopReason> {
        let idle = (
            self.has_rungs && !self.first.has_executed(&self.primary),
            self.has_stopped_channel() || self.has_rungs && !self.second.has_executed(&self.partner),
        );
        self.first.step(Step::Execution, u64::from(idle.0));
        self.second.step(Step::Execution, u64::from(idle.1));
        let records = self.image.image();
        let compared = compared(records, &self.primary, &self.partner, ends);
        self.first.step(Step::Comparison, compared.remainder);
        let reciprocal = reciprocal::remainder(records, &self.partner, &self.primary, ends);
        self.second.step(Step::Comparison, reciprocal);
        self.first.step(Step::SelfTest, self_test::first(self.first.challenge()));
        self.second.step(Step::SelfTest, self_test::second(self.second.challenge()));
        let image = self.check.step();
        self.first.step(Step::Image, u64::from(!image));
        self.second.step(Step::Image, u64::from(!image));
        let fault = if !image {
            SafetyFault::ImageCorrupted
        } else if self.has_stopped_channel() {
            SafetyFault::ChannelStopped
        } else if let Some(difference) = compared.difference {
            SafetyFault::Difference(difference)
        } else if reciprocal != 0 {
            SafetyFault::SecondComparison
        } else if idle.0 || idle.1 {
            SafetyFault::NothingExecuted
        } else {
            return of_end(ends.0);
        };
        Some(StopReason::Safety(fault))
    }

    /// Judges a prescan.
    fn judge(&self, ends: (ScanEnd, ScanEnd)) -> Option<StopReason> {
        if self.has_stopped_channel() {
            return Some(StopReason::Safety(SafetyFault::ChannelStopped));
        }
        let records = self.image.image();
        if let Some(difference) = compared(records, &self.primary, &self.partner, ends).difference {
            return Some(StopReason::Safety(SafetyFault::Difference(difference)));
        }
        if reciprocal::remainder(records, &self.partner, &self.primary, ends) != 0 {
            return Some(StopReason::Safety(SafetyFault::SecondComparison));
        }
        of_end(ends.0)
    }

    /// Each half takes over what its channel holds, as far as its verdict lets it through; then both must say the same.
    fn publish(&mut self) -> Option<StopReason> {
        self.first.publish(&self.primary);
        self.second.publish(&self.partner);
        let fault = if !(self.first.is_open() && self.second.is_open()) {
            SafetyFault::VerdictIncomplete
        } else if !self.outputs_agree() {
            SafetyFault::OutputsDiffer
        } else {
            return None;
        };
        Some(StopReason::Safety(fault))
    }

    fn stop_safely(&mut self, fault: SafetyFault) -> ScanReport {
        self.stop(StopReason::Safety(fault))
    }

    fn stop(&mut self, reason: StopReason) -> ScanReport {
        self.permit(Permit::Halted);
        self.outputs_off();
        self.stopped = Some(reason);
        ScanReport { executed: true, stopped: self.stopped, instructions: 0 }
    }

    fn outputs_off(&mut self) {
        self.first.off();
        self.second.off();
    }

    /// Lets fault injection at what both channels share; without its feature nothing is there.
    #[cfg(feature = "injection")]
    fn disturb<C: ScanClock>(&mut self, clock: &mut C, moment: Moment) {
        clock.disturb(moment, &mut self.shared());
    }

    #[cfg(not(feature = "injection"))]
    #[inline(always)]
    fn disturb<C: ScanClock>(&mut self, _clock: &mut C, _moment: Moment) {}
}

const fn of_end(end: ScanEnd) -> Option<StopReason> {
    match end {
        ScanEnd::Completed => None,
        ScanEnd::MajorFault(fault) => Some(StopReason::Recoverable(fault)),
        ScanEnd::BudgetExceeded => Some(StopReason::Safety(SafetyFault::BudgetExceeded)),
    }
}

/// Whether a scheduled program has a rung in its main routine: one that is reached, and holds an instruction.
fn has_rungs(image: &AdmittedImage) -> bool {
    let records = image.image();
    let scheduled = records.task.iter().flat_map(|task| &task.schedule);
    let mut programs = scheduled.filter_map(|index| records.programs.get(index.position()));
    programs.any(|program| !program.disabled && program.main.is_some_and(|main| image.rungs(main) > 0))
}
