//! AVC, Auxiliary Valve Control. `v14-and-metal-form.md` 8.

use super::latch::{FaultLatch, Status};
use super::valve::{Check, Finding};
use crate::codes::NONE;
use crate::members::members;
use crate::outputs::feedback::{Which, did_not_follow, unexpected};
use crate::timer::Timer;
use twinrung_catalog::types::safety::press::AUX_VALVE_CONTROL;

members! {
    AUX_VALVE_CONTROL;
    inputs {
        FEEDBACK_TYPE = "FeedbackType",
        FEEDBACK_REACTION_TIME = "FeedbackReactionTime",
        DELAY_TYPE = "DelayType",
        DELAY_TIME = "DelayTime",
        OUTPUT_FOLLOWS_ACTUATE = "OutputFollowsActuate",
        ACTUATE = "Actuate",
        DELAY_ENABLE = "DelayEnable",
        FEEDBACK_1 = "Feedback1",
        INPUT_STATUS = "InputStatus",
        OUTPUT_STATUS = "OutputStatus",
        RESET = "Reset",
    }
    outputs { O1 = "O1", FP = "FP", FAULT_CODE = "FaultCode", DIAGNOSTIC_CODE = "DiagnosticCode" }
}

/// Diagnostic: waiting for Actuate to go off. 8, decided.
const WAITING_FOR_ACTUATE_OFF: i32 = 0xF401;

/// The only channel there is.
const FEEDBACK: Which = Which { first: true, second: false };

/// The delay of one direction.
#[derive(Clone, Debug, Default, PartialEq)]
struct Delay {
    taken_over: bool,
    pending: Timer,
}

crate::bits!(Delay { taken_over, pending });

/// How a change is taken over.
struct DelayInputs {
    /// Delay Type: 1 off delay, 0 on delay. 8, decided.
    off_delay: bool,
    enabled: bool,
    time_ms: i32,
}

impl Delay {
    /// The delayed command: its delayed direction after the delay time, the other one at once.
    fn follow(&mut self, command: bool, inputs: &DelayInputs, now_ms: i64) -> bool {
        let delayed_direction = command != inputs.off_delay;
        // The time is that of the delayed change alone: one that was taken over at once has no part in it.
        self.pending.follow(delayed_direction && command != self.taken_over, now_ms);
        if !inputs.enabled || !delayed_direction || self.pending.reached(now_ms, inputs.time_ms) {
            self.taken_over = command;
        }
        self.taken_over
    }
}

/// Memory of an AVC call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Avc {
    latch: FaultLatch,
    check: Check,
    delay: Delay,
    /// Actuate has been seen 0 since the start or since a fault.
    armed: bool,
    o1: bool,
}

crate::bits!(Avc { latch, check, delay, armed, o1 });

impl Avc {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Avc::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            // A false rung is as prescan, a latched fault included (1.3).
            self.prescan(members);
            return;
        }
        let status = Status {
            input: members[INPUT_STATUS] != 0,
            output: members[OUTPUT_STATUS] != 0,
            reset: members[RESET] != 0,
        };
        let positive = members[FEEDBACK_TYPE] != 0;
        let raw = members[FEEDBACK_1] != 0;
        let lost = self.latch.begin(&status);
        let new_fault = if lost != NONE {
            lost
        } else if status.good() && self.latch.fault == NONE {
            self.check_feedback(raw, positive, members[FEEDBACK_REACTION_TIME], now_ms)
        } else {
            // The check starts anew when there is something to judge.
            self.check = Check::default();
            NONE
        };
        let cause_gone = status.good() && raw != positive;
        if self.latch.settle(new_fault, cause_gone) {
            self.armed = false;
            self.check.restart(now_ms);
        }
        self.command(&status, members, now_ms);
        let waits = members[ACTUATE] != 0 && !self.armed;
        let own = if waits { WAITING_FOR_ACTUATE_OFF } else { NONE };
        members[O1] = i32::from(self.o1);
        members[FP] = i32::from(self.latch.fault != NONE);
        members[FAULT_CODE] = self.latch.fault;
        members[DIAGNOSTIC_CODE] = self.latch.diagnostic(&status, cause_gone, own);
    }

    fn check_feedback(&mut self, raw: bool, positive: bool, reaction_ms: i32, now_ms: i64) -> i32 {
        let expected = self.o1 == positive;
        match self.check.judge(raw == expected, now_ms, reaction_ms) {
            Finding::Fine => NONE,
            Finding::Unexpected => unexpected(FEEDBACK, !expected),
            Finding::TooLate => did_not_follow(FEEDBACK, !expected),
        }
    }

    fn command(&mut self, status: &Status, members: &Members, now_ms: i64) {
        let before = self.o1;
        if self.latch.fault != NONE || !status.good() {
            self.o1 = false;
            self.armed = false;
            self.delay = Delay::default();
        } else {
            let actuate = members[ACTUATE] != 0;
            self.armed |= !actuate;
            let delay_inputs = DelayInputs {
                off_delay: members[DELAY_TYPE] != 0,
                enabled: members[DELAY_ENABLE] != 0,
                time_ms: members[DELAY_TIME],
            };
            let delayed = self.delay.follow(self.armed && actuate, &delay_inputs, now_ms);
            // Output Follows Actuate: 1 O1 is the delayed command, 0 its opposite. 8, decided.
            self.o1 = self.armed && (delayed == (members[OUTPUT_FOLLOWS_ACTUATE] != 0));
        }
        if self.o1 != before {
            self.check.restart(now_ms);
        }
    }
}
