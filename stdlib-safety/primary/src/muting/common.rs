//! The core that TSAM, TSSM and FSBM share: latch, override, restart, faults. `muting-and-outputs.md` 2.
//!
//! The instructions differ in their [`Sequence`]: which sensors there are, in which order they must change, and which
//! times bind them.

use super::sequence::{Field, Sequence, Stage};
use crate::codes::{INPUT_STATUS, NONE, RESET_HELD};
use crate::edge::Edge;
use crate::restart::AUTOMATIC_RESTART_MS;
use crate::timer::Timer;
use core::ops::RangeInclusive;

/// Fault: muting lamp bad when the mute started or during it. 2.8, decided.
const LAMP: i32 = 0xF050;
/// Fault: Enable Mute went OFF while muted with the curtain blocked. 2.8, decided.
const ENABLE_LOST: i32 = 0xF051;
/// Fault: Maximum Mute Time reached. 2.8, decided.
const MUTE_TIME: i32 = 0xF060;
/// Fault: Maximum Override Time reached. 2.8, decided.
const OVERRIDE_TIME: i32 = 0xF061;
/// Fault: configuration out of range. 2.8, decided.
const CONFIGURATION: i32 = 0xF06F;

/// Diagnostic: clear curtain and sensors. 2.9, decided.
const CLEAR_AREA: i32 = 0xF150;
/// Diagnostic: press Reset. 2.9, decided.
const PRESS_RESET: i32 = 0xF151;
/// Diagnostic: muting lamp bad. 2.9, decided.
const LAMP_BAD: i32 = 0xF152;
/// Diagnostic: Override is on without effect, release it. 2.9, decided.
const RELEASE_OVERRIDE: i32 = 0xF153;

/// Maximum Mute Time in s; 0 = no limit. 2.2, recalled 65 %.
const MUTE_RANGE_S: RangeInclusive<i32> = 0..=3600;
/// Maximum Override Time in s; 0 = override never works. 2.2, 30 s repo R6, 0 decided.
const OVERRIDE_RANGE_S: RangeInclusive<i32> = 0..=30;
/// What every instruction reads beside its field.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs {
    pub(crate) enable_mute: bool,
    pub(crate) override_request: bool,
    pub(crate) input_status: bool,
    pub(crate) lamp_good: bool,
    pub(crate) reset: bool,
}

/// The configuration operands as they were at prescan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Configuration<T> {
    pub(crate) restart_automatic: bool,
    pub(crate) mute_s: i32,
    pub(crate) override_s: i32,
    pub(crate) times: T,
}

crate::bits!(Configuration<T> where (T) { restart_automatic, mute_s, override_s, times });

/// What one scan shows.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Outputs {
    pub(crate) o1: bool,
    pub(crate) muting_lamp: bool,
    pub(crate) clear_area: bool,
    pub(crate) fault: i32,
    pub(crate) diagnostic: i32,
}

/// Memory of one call.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Muting<S: Sequence> {
    /// `None` without a usable configuration.
    configuration: Option<Configuration<S::Times>>,
    sequence: S,
    /// O1 is energized by the normal latch.
    latch: bool,
    overriding: bool,
    override_timer: Timer,
    mute_timer: Timer,
    on_delay: Timer,
    fault: i32,
    reset: Edge,
    override_edge: Edge,
    input_status_before: bool,
    o1_before: bool,
}

crate::bits!(Muting<S: Sequence> where (S, S::Times) {
    configuration, sequence, latch, overriding, override_timer, mute_timer, on_delay, fault, reset,
    override_edge, input_status_before, o1_before
});

impl<S: Sequence> Default for Muting<S> {
    fn default() -> Self {
        Muting {
            configuration: None,
            sequence: S::default(),
            latch: false,
            overriding: false,
            override_timer: Timer::default(),
            mute_timer: Timer::default(),
            on_delay: Timer::default(),
            fault: CONFIGURATION,
            reset: Edge::default(),
            override_edge: Edge::default(),
            input_status_before: false,
            o1_before: false,
        }
    }
}

impl<S: Sequence> Muting<S> {
    /// Prescan: takes the snapshot of the configuration; `usable` says whether the instruction's own times are in range.
    pub(crate) fn prescan(&mut self, configuration: Configuration<S::Times>, usable: bool) {
        *self = Muting::default();
        let in_range = usable
            && MUTE_RANGE_S.contains(&configuration.mute_s)
            && OVERRIDE_RANGE_S.contains(&configuration.override_s);
        if in_range {
            self.configuration = Some(configuration);
            self.fault = NONE;
        }
    }

    /// As after prescan, but a latched fault is kept (1.3).
    pub(crate) fn rung_false(&mut self) {
        let configuration = self.configuration.take();
        *self = Muting { configuration, fault: self.fault, ..Muting::default() };
    }

    /// One scan with a true rung, in the order of 2.6.
    pub(crate) fn scan(&mut self, inputs: &Inputs, field: &S::Field, now_ms: i64) -> Outputs {
        let reset_rises = self.reset.rises(inputs.reset);
        let override_rises = self.override_edge.rises(inputs.override_request);
        let new_fault = self.follow(inputs, field, now_ms);
        let latched_before = self.fault != NONE;
        if new_fault != NONE {
            self.sequence.wait();
            if !latched_before {
                self.fault = new_fault;
            }
        }
        let consumed = latched_before && reset_rises && self.clear_fault(inputs, field);
        self.follow_override(inputs, field, override_rises, now_ms);
        self.follow_latch(inputs, field, reset_rises && !consumed, now_ms);
        if self.sequence.stage() != Stage::Running {
            self.mute_timer.clear();
        }
        let outputs = self.outputs(inputs, field, consumed);
        self.input_status_before = inputs.input_status;
        self.o1_before = outputs.o1;
        outputs
    }

    /// Step 3: Input Status, then the sequence; gives this scan's fault or 0.
    fn follow(&mut self, inputs: &Inputs, field: &S::Field, now_ms: i64) -> i32 {
        if !inputs.input_status {
            self.sequence.wait();
            self.overriding = false;
            return if self.input_status_before { INPUT_STATUS } else { NONE };
        }
        if self.fault != NONE || !self.latch {
            return NONE;
        }
        if !inputs.enable_mute {
            let lost = self.sequence.muted() && field.curtain();
            self.sequence.wait();
            return if lost { ENABLE_LOST } else { NONE };
        }
        let Some(configuration) = &self.configuration else { return CONFIGURATION };
        if self.sequence.stage() == Stage::Wait {
            if !field.curtain() && !field.any_sensor() {
                self.sequence.idle();
            }
            return NONE;
        }
        let step_fault = self.sequence.step(field, &configuration.times, now_ms);
        if step_fault != NONE {
            return step_fault;
        }
        let muted = self.sequence.muted();
        if muted && !inputs.lamp_good {
            return LAMP;
        }
        if self.sequence.stage() != Stage::Running {
            return NONE;
        }
        let overdue = self.sequence.overdue(field, &configuration.times, now_ms);
        if overdue != NONE {
            return overdue;
        }
        // Runs from the first muted scan until the sequence is back in IDLE; trips only while muted (2.3).
        if muted {
            self.mute_timer.start(now_ms);
        }
        let limit_ms = configuration.mute_s.saturating_mul(1000);
        if muted && limit_ms != 0 && self.mute_timer.reached(now_ms, limit_ms) { MUTE_TIME } else { NONE }
    }

    /// Step 5: whether the Reset edge was consumed.
    fn clear_fault(&mut self, inputs: &Inputs, field: &S::Field) -> bool {
        let clear = !field.curtain() && !field.any_sensor();
        let clears = inputs.input_status
            && clear
            && !self.overriding
            && self.fault != CONFIGURATION
            && (self.fault != LAMP || inputs.lamp_good);
        if clears {
            self.fault = NONE;
        }
        clears
    }

    /// Step 6 (2.4).
    fn follow_override(&mut self, inputs: &Inputs, field: &S::Field, rises: bool, now_ms: i64) {
        let blocked = self.blocked(inputs, field);
        let limit_s = self.configuration.as_ref().map_or(0, |configuration| configuration.override_s);
        if self.overriding {
            if !inputs.override_request || !blocked {
                self.overriding = false;
            } else if self.override_timer.reached(now_ms, limit_s.saturating_mul(1000)) {
                self.overriding = false;
                if self.fault == NONE {
                    self.fault = OVERRIDE_TIME;
                }
            }
        } else if rises && !self.o1_before && inputs.input_status && limit_s > 0 && blocked {
            self.overriding = true;
            self.override_timer.restart(now_ms);
        }
    }

    /// Step 7. `reset` is a Reset edge that is not used up.
    fn follow_latch(&mut self, inputs: &Inputs, field: &S::Field, reset: bool, now_ms: i64) {
        let run = inputs.input_status && self.fault == NONE && !self.overriding;
        self.latch &= run && (!field.curtain() || self.sequence.muted());
        if self.latch {
            self.on_delay.clear();
            return;
        }
        self.sequence.wait();
        if !run || field.curtain() || (inputs.enable_mute && field.any_sensor()) {
            self.on_delay.clear();
            return;
        }
        self.on_delay.start(now_ms);
        self.latch = if self.restart_automatic() {
            self.on_delay.reached(now_ms, AUTOMATIC_RESTART_MS)
        } else {
            // The starting conditions held in an earlier scan as well.
            reset && self.on_delay.exceeded(now_ms, 0)
        };
        if self.latch && inputs.enable_mute {
            self.sequence.idle();
        }
    }

    /// Steps 8 and 9.
    fn outputs(&self, inputs: &Inputs, field: &S::Field, consumed: bool) -> Outputs {
        let blocked = self.blocked(inputs, field);
        let not_armed = self.sequence.stage() == Stage::Wait && inputs.enable_mute;
        let clear_area = blocked && (!self.latch || not_armed);
        Outputs {
            o1: self.latch || self.overriding,
            muting_lamp: self.sequence.muted() || self.overriding,
            clear_area,
            fault: self.fault,
            diagnostic: self.diagnostic(inputs, clear_area, consumed),
        }
    }

    fn diagnostic(&self, inputs: &Inputs, clear_area: bool, consumed: bool) -> i32 {
        let off = !self.latch && !self.overriding;
        let wait = self.fault != NONE || (!self.restart_automatic() && off);
        if !inputs.input_status {
            INPUT_STATUS
        } else if wait && inputs.reset && !consumed {
            RESET_HELD
        } else if inputs.override_request && off {
            RELEASE_OVERRIDE
        } else if clear_area {
            CLEAR_AREA
        } else if !inputs.lamp_good {
            LAMP_BAD
        } else if wait {
            PRESS_RESET
        } else {
            NONE
        }
    }

    /// `blocked` of 2.1: with Enable Mute off and no fault the sensors do not matter.
    fn blocked(&self, inputs: &Inputs, field: &S::Field) -> bool {
        field.curtain() || (field.any_sensor() && (inputs.enable_mute || self.fault != NONE))
    }

    fn restart_automatic(&self) -> bool {
        self.configuration.as_ref().is_some_and(|configuration| configuration.restart_automatic)
    }
}
