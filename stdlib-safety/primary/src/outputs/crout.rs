//! CROUT, Configurable Redundant Output. `muting-and-outputs.md` 6.

use super::feedback::{Which, did_not_follow, unexpected};
use crate::codes::{INPUT_STATUS, NONE, OUTPUT_STATUS, RESET_HELD};
use crate::edge::Edge;
use crate::members::members;
use crate::timer::Timer;
use twinrung_catalog::types::safety::output::CONFIGURABLE_ROUT;

members! {
    CONFIGURABLE_ROUT;
    inputs {
        FEEDBACK_TYPE = "FeedbackType",
        FEEDBACK_REACTION_TIME = "FeedbackReactionTime",
        ACTUATE = "Actuate",
        FEEDBACK_1 = "Feedback1",
        FEEDBACK_2 = "Feedback2",
        INPUT_STATUS_IN = "InputStatus",
        OUTPUT_STATUS_IN = "OutputStatus",
        RESET = "Reset",
    }
    outputs { O1 = "O1", O2 = "O2", FP = "FP", FAULT_CODE = "FaultCode", DIAGNOSTIC_CODE = "DiagnosticCode" }
}

/// Diagnostic: a feedback still says on while the outputs are off, within the grace time at start. 6.5, decided.
const WAITING_FOR_OFF: i32 = 0xF180;
/// Diagnostic: Actuate is held ON and must be cycled. 6.5, recalled 55 %.
const ACTUATE_HELD: i32 = 0x5000;

/// The states of 6.3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Phase {
    #[default]
    Off,
    TurningOn,
    On,
    TurningOff,
    Fault,
}

crate::bits!(
    enum Phase {
        Off,
        TurningOn,
        On,
        TurningOff,
        Fault,
    }
);

/// Memory of a CROUT call; its default is the state after prescan.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Crout {
    phase: Phase,
    fault: i32,
    /// Actuate has been seen 0 since the start or since the last fault.
    armed: bool,
    /// Both feedbacks have been seen OFF: the grace time at start is over.
    seen_off: bool,
    /// Runs from the first valid scan.
    grace: Timer,
    reaction: Timer,
    reset: Edge,
    input_status_before: bool,
    output_status_before: bool,
}

crate::bits!(Crout {
    phase,
    fault,
    armed,
    seen_off,
    grace,
    reaction,
    reset,
    input_status_before,
    output_status_before
});

/// What a scan reads.
struct Inputs {
    /// Feedback 1 means output on (POSITIVE); otherwise feedback 1 means output off (NEGATIVE).
    positive: bool,
    reaction_ms: i32,
    actuate: bool,
    /// Which feedbacks say that their output is on.
    on: Which,
    input_status: bool,
    output_status: bool,
    reset: bool,
}

impl Crout {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Crout::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            self.rung_false();
            clear_outputs(members);
            return;
        }
        let inputs = read(members);
        let valid = inputs.input_status && inputs.output_status;
        let rise = self.reset.rises(inputs.reset);
        self.check_status(&inputs, valid);
        let mut consumed = false;
        if valid {
            self.grace.start(now_ms);
            if self.phase == Phase::Fault {
                consumed = self.clear_fault(&inputs, rise);
            } else {
                self.command(&inputs, now_ms);
                self.step(&inputs, now_ms);
            }
            self.seen_off |= !inputs.on.any();
        }
        let outputs_on = matches!(self.phase, Phase::TurningOn | Phase::On);
        members[O1] = i32::from(outputs_on);
        members[O2] = i32::from(outputs_on);
        members[FP] = i32::from(self.phase == Phase::Fault);
        members[FAULT_CODE] = self.fault;
        members[DIAGNOSTIC_CODE] = self.diagnostic(&inputs, consumed);
    }

    /// As after prescan, but a latched fault is kept (1.3).
    fn rung_false(&mut self) {
        let fault = self.fault;
        *self = Crout { fault, phase: if fault == NONE { Phase::Off } else { Phase::Fault }, ..Crout::default() };
    }

    /// A status that goes from ON to OFF is a fault; one that is OFF from the start only keeps the outputs off (1.4).
    fn check_status(&mut self, inputs: &Inputs, valid: bool) {
        if self.input_status_before && !inputs.input_status {
            self.latch(INPUT_STATUS);
        } else if self.output_status_before && !inputs.output_status {
            self.latch(OUTPUT_STATUS);
        }
        self.armed &= valid;
        self.input_status_before = inputs.input_status;
        self.output_status_before = inputs.output_status;
    }

    /// Actuate = 0 arms, and turns the outputs off.
    fn command(&mut self, inputs: &Inputs, now_ms: i64) {
        if inputs.actuate {
            return;
        }
        self.armed = true;
        if matches!(self.phase, Phase::TurningOn | Phase::On) {
            self.phase = Phase::TurningOff;
            self.reaction.restart(now_ms);
        }
    }

    /// The row of the state just reached.
    fn step(&mut self, inputs: &Inputs, now_ms: i64) {
        let on = inputs.on;
        let too_late = self.reaction.reached(now_ms, inputs.reaction_ms);
        match self.phase {
            Phase::Off => {
                let grace_over = self.seen_off || self.grace.reached(now_ms, inputs.reaction_ms);
                if on.any() {
                    if grace_over {
                        self.latch(unexpected(on, inputs.positive));
                    }
                } else if inputs.actuate && self.armed {
                    self.phase = Phase::TurningOn;
                    self.reaction.restart(now_ms);
                }
            }
            Phase::TurningOn => {
                if on.both() {
                    self.phase = Phase::On;
                } else if too_late {
                    self.latch(did_not_follow(on.not(), !inputs.positive));
                }
            }
            Phase::On => {
                if !on.both() {
                    self.latch(unexpected(on.not(), !inputs.positive));
                }
            }
            Phase::TurningOff => {
                if !on.any() {
                    self.phase = Phase::Off;
                } else if too_late {
                    self.latch(did_not_follow(on, inputs.positive));
                }
            }
            Phase::Fault => {}
        }
    }

    /// The first fault wins (1.5).
    fn latch(&mut self, fault: i32) {
        if self.phase != Phase::Fault {
            self.phase = Phase::Fault;
            self.fault = fault;
            self.armed = false;
        }
    }

    /// Whether the Reset edge was consumed. Actuate must be seen 0 in a later scan.
    fn clear_fault(&mut self, inputs: &Inputs, rise: bool) -> bool {
        let clears = rise && !inputs.on.any();
        if clears {
            self.phase = Phase::Off;
            self.fault = NONE;
        }
        clears
    }

    fn diagnostic(&self, inputs: &Inputs, consumed: bool) -> i32 {
        if !inputs.input_status {
            INPUT_STATUS
        } else if !inputs.output_status {
            OUTPUT_STATUS
        } else if self.phase == Phase::Fault && inputs.reset && !consumed {
            RESET_HELD
        } else if self.phase == Phase::Off && inputs.on.any() {
            WAITING_FOR_OFF
        } else if inputs.actuate && !self.armed {
            ACTUATE_HELD
        } else {
            NONE
        }
    }
}

fn read(members: &Members) -> Inputs {
    let positive = members[FEEDBACK_TYPE] != 0;
    let on = |feedback: i32| (feedback != 0) == positive;
    Inputs {
        positive,
        reaction_ms: members[FEEDBACK_REACTION_TIME],
        actuate: members[ACTUATE] != 0,
        on: Which { first: on(members[FEEDBACK_1]), second: on(members[FEEDBACK_2]) },
        input_status: members[INPUT_STATUS_IN] != 0,
        output_status: members[OUTPUT_STATUS_IN] != 0,
        reset: members[RESET] != 0,
    }
}
