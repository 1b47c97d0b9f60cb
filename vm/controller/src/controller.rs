//! One scan: freeze, execute twice, compare, publish.

use alloc::vec::Vec;

use twinrung_bytecode::channel::{Channel, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::index::{BitCell, EventTaskIndex, WordCell};
use twinrung_bytecode::observer::{Observer, Silent};
use twinrung_bytecode::{AdmittedImage, CellRange, limits};

use crate::clock::{NoClock, Part, ScanClock};
use crate::compare::{compare, mask};
use crate::fault::{SafetyFault, StopReason};
use crate::image_check::ImageCheck;
use crate::mode::{Mode, ModeRequest};

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

/// A controller with two channels. A scan is a function of what it holds, the inputs and the time.
pub struct Controller<A: Channel, B: Channel> {
    image: AdmittedImage,
    check: ImageCheck,
    primary: A,
    partner: B,
    frozen: Vec<CellRange>,
    published: Vec<CellRange>,
    input_bits: Vec<u8>,
    input_words: Vec<i32>,
    output_bits: Vec<u8>,
    output_words: Vec<i32>,
    system_values: Vec<i32>,
    budget: u64,
    mode: Mode,
    request: Option<ModeRequest>,
    stopped: Option<StopReason>,
    prescanned: bool,
}

impl<A: Channel, B: Channel> Controller<A, B> {
    /// Loads an admitted image into both channels. `bytes` are the sealed bytes that were admitted: the running check
    /// goes over them.
    pub fn load(image: AdmittedImage, bytes: &[u8]) -> Result<Controller<A, B>, LoadError<A::LoadError, B::LoadError>> {
        let task = image.image().task.as_ref().ok_or(LoadError::NoTask)?;
        let budget = u64::from(task.watchdog_us).saturating_mul(limits::BUDGET_PER_MICROSECOND);
        let primary = A::load(&image).map_err(LoadError::Primary)?;
        let partner = B::load(&image).map_err(LoadError::Partner)?;
        let records = image.image();
        Ok(Controller {
            check: ImageCheck::new(bytes),
            primary,
            partner,
            frozen: image.frozen().to_vec(),
            published: image.published().to_vec(),
            input_bits: records.initial_bits.clone(),
            input_words: records.initial_words.clone(),
            output_bits: alloc::vec![0; records.initial_bits.len()],
            output_words: alloc::vec![0; records.initial_words.len()],
            system_values: alloc::vec![0; records.system_values_length()],
            budget,
            mode: Mode::Program,
            request: None,
            stopped: None,
            prescanned: false,
            image,
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

    /// Powers up with the mode switch in Run: the first scan prescans and executes.
    pub fn power_up_in_run(&mut self) {
        self.mode = Mode::Run;
        self.prescanned = false;
    }

    /// Sets the value of a system attribute for the scans that follow, at the position its record names.
    pub fn set_system_value(&mut self, position: usize, value: i32) {
        if let Some(slot) = self.system_values.get_mut(position) {
            *slot = value;
        }
    }

    /// Adds cells to those that are copied in at the start of each scan (a stimulus may drive any tag that no logic
    /// writes).
    pub fn freeze_also(&mut self, range: CellRange) {
        if !self.frozen.contains(&range) {
            self.frozen.push(range);
        }
    }

    /// Adds cells to those that are published.
    pub fn publish_also(&mut self, range: CellRange) {
        if !self.published.contains(&range) {
            self.published.push(range);
        }
    }

    /// Drives a BOOL from outside; logic sees it from the next scan on.
    pub fn drive_bit(&mut self, cell: BitCell, value: bool) {
        if let Some(slot) = self.input_bits.get_mut(cell.position()) {
            *slot = u8::from(value);
        }
    }

    /// Drives a number from outside; logic sees it from the next scan on.
    pub fn drive_word(&mut self, cell: WordCell, value: i32) {
        if let Some(slot) = self.input_words.get_mut(cell.position()) {
            *slot = value;
        }
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

    /// A published BOOL: what the machine sees.
    pub fn published_bit(&self, cell: BitCell) -> Option<bool> {
        self.output_bits.get(cell.position()).map(|byte| *byte == 1)
    }

    /// A published number: what the machine sees.
    pub fn published_word(&self, cell: WordCell) -> Option<i32> {
        self.output_words.get(cell.position()).copied()
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
        if self.mode == Mode::Program || self.stopped.is_some() {
            self.outputs_off();
            return ScanReport { executed: false, stopped: self.stopped, instructions: 0 };
        }
        let inputs = ScanInputs { now_ms, budget: self.budget, system_values: &self.system_values };
        if !self.prescanned {
            self.prescanned = true;
            let ends = (self.primary.prescan(inputs, primary_observer), self.partner.prescan(inputs, partner_observer));
            if let Some(reason) = self.judge(ends) {
                return self.stop(reason);
            }
        }
        clock.begin();
        self.freeze();
        clock.ended(Part::Freeze);
        let before = self.primary.status().executed;
        let inputs = ScanInputs { now_ms, budget: self.budget, system_values: &self.system_values };
        self.partner.begin::<Q>(inputs);
        let primary_end = self.primary.scan(inputs, primary_observer);
        clock.ended(Part::Primary);
        let partner_end = self.partner.scan(inputs, partner_observer);
        clock.ended(Part::Partner);
        let mut reason = self.judge((primary_end, partner_end));
        if !self.check.step() {
            reason = Some(StopReason::Safety(SafetyFault::ImageCorrupted));
        }
        clock.ended(Part::Compare);
        // A channel that gave no answer until the watchdog expired has not made it in time: no more is known of it.
        let known = matches!(reason, Some(StopReason::Safety(fault)) if fault != SafetyFault::ChannelStopped);
        if clock.expired() && !known {
            reason = Some(StopReason::Safety(SafetyFault::WatchdogExpired));
        }
        if let Some(reason) = reason {
            return self.stop(reason);
        }
        self.publish();
        clock.ended(Part::Publish);
        ScanReport { executed: true, stopped: None, instructions: self.primary.status().executed.wrapping_sub(before) }
    }

    fn pass_boundary(&mut self) {
        let Some(request) = self.request.as_mut() else { return };
        if let Some(mode) = request.boundary() {
            if mode == Mode::Run && self.mode == Mode::Program {
                self.prescanned = false;
            }
            self.mode = mode;
            self.request = None;
        }
    }

    fn freeze(&mut self) {
        for range in &self.frozen {
            for (offset, value) in self.input_bits.get(bits_of(range)).unwrap_or_default().iter().enumerate() {
                let cell = BitCell(range.bit_cell.wrapping_add(offset as u32));
                self.primary.set_bit(cell, *value == 1);
                self.partner.set_bit(cell, *value == 1);
            }
            for (offset, value) in self.input_words.get(words_of(range)).unwrap_or_default().iter().enumerate() {
                let cell = WordCell(range.word_cell.wrapping_add(offset as u32));
                self.primary.set_word(cell, *value);
                self.partner.set_word(cell, *value);
            }
        }
    }

    fn judge(&self, ends: (ScanEnd, ScanEnd)) -> Option<StopReason> {
        if self.primary.has_stopped() || self.partner.has_stopped() {
            return Some(StopReason::Safety(SafetyFault::ChannelStopped));
        }
        if let Some(difference) = compare(self.image.image(), &self.primary, &self.partner, ends) {
            return Some(StopReason::Safety(SafetyFault::Difference(difference)));
        }
        match ends.0 {
            ScanEnd::Completed => None,
            ScanEnd::MajorFault(fault) => Some(StopReason::Recoverable(fault)),
            ScanEnd::BudgetExceeded => Some(StopReason::Safety(SafetyFault::BudgetExceeded)),
        }
    }

    fn stop(&mut self, reason: StopReason) -> ScanReport {
        self.outputs_off();
        self.stopped = Some(reason);
        ScanReport { executed: true, stopped: self.stopped, instructions: 0 }
    }

    fn outputs_off(&mut self) {
        self.output_bits.fill(0);
        self.output_words.fill(0);
    }

    fn publish(&mut self) {
        let own = mask(A::REPRESENTATION);
        for range in &self.published {
            let source = self.primary.bits().get(bits_of(range)).unwrap_or_default();
            let target = self.output_bits.get_mut(bits_of(range)).unwrap_or_default();
            for (to, from) in target.iter_mut().zip(source) {
                *to = from ^ own as u8;
            }
            let source = self.primary.words().get(words_of(range)).unwrap_or_default();
            let target = self.output_words.get_mut(words_of(range)).unwrap_or_default();
            for (to, from) in target.iter_mut().zip(source) {
                *to = (from ^ own) as i32;
            }
        }
    }
}

fn bits_of(range: &CellRange) -> core::ops::Range<usize> {
    let begin = range.bit_cell as usize;
    begin..begin.saturating_add(range.bit_cells as usize)
}

fn words_of(range: &CellRange) -> core::ops::Range<usize> {
    let begin = range.word_cell as usize;
    begin..begin.saturating_add(range.word_cells as usize)
}
