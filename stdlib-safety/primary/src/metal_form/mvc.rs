//! MVC, Main Valve Control. `v14-and-metal-form.md` 9.

use super::latch::{FaultLatch, Status};
use super::valve::{Check, Finding};
use crate::codes::NONE;
use crate::members::members;
use crate::outputs::feedback::{Which, did_not_follow, unexpected};
use twinrung_catalog::types::safety::press::MAIN_VALVE_CONTROL;

members! {
    MAIN_VALVE_CONTROL;
    inputs {
        FEEDBACK_TYPE = "FeedbackType",
        FEEDBACK_REACTION_TIME = "FeedbackReactionTime",
        ACTUATE = "Actuate",
        FEEDBACK_1 = "Feedback1",
        FEEDBACK_2 = "Feedback2",
        INPUT_STATUS = "InputStatus",
        OUTPUT_STATUS = "OutputStatus",
        RESET = "Reset",
    }
    outputs { O1 = "O1", O2 = "O2", FP = "FP", FAULT_CODE = "FaultCode", DIAGNOSTIC_CODE = "DiagnosticCode" }
}

/// Diagnostic: Actuate is on, outputs are off; needs a fresh Actuate or closed feedbacks. 9, decided.
const ACTUATE_WITHOUT_EFFECT: i32 = 0xF501;

/// Memory of an MVC call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mvc {
    latch: FaultLatch,
    check_1: Check,
    check_2: Check,
    /// A fresh Actuate may turn the outputs on.
    armed: bool,
    /// The one decision behind O1 and O2.
    on: bool,
}

crate::bits!(Mvc { latch, check_1, check_2, armed, on });

impl Mvc {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Mvc::default();
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
        let says_on = |feedback: i32| (feedback != 0) == positive;
        let feedback = Which { first: says_on(members[FEEDBACK_1]), second: says_on(members[FEEDBACK_2]) };
        let lost = self.latch.begin(&status);
        let new_fault = if lost != NONE {
            lost
        } else if status.good() && self.latch.fault == NONE {
            self.check_feedback(feedback, positive, members[FEEDBACK_REACTION_TIME], now_ms)
        } else {
            // The checks start anew when there is something to judge.
            self.check_1 = Check::default();
            self.check_2 = Check::default();
            NONE
        };
        let cause_gone = status.good() && !feedback.any();
        if self.latch.settle(new_fault, cause_gone) {
            self.armed = false;
            self.restart_checks(now_ms);
        }
        let actuate = members[ACTUATE] != 0;
        self.command(status.good(), actuate, feedback, now_ms);
        let own = if actuate && !self.on { ACTUATE_WITHOUT_EFFECT } else { NONE };
        members[O1] = i32::from(self.on);
        members[O2] = i32::from(self.on);
        members[FP] = i32::from(self.latch.fault != NONE);
        members[FAULT_CODE] = self.latch.fault;
        members[DIAGNOSTIC_CODE] = self.latch.diagnostic(&status, cause_gone, own);
    }

    /// Both channels failing in the same way give the common code (9). The reference gives no order for two ways in
    /// one scan; decided: the channels are judged in their order, and the first fault is told (1.6 rule 1).
    fn check_feedback(&mut self, feedback: Which, positive: bool, reaction_ms: i32, now_ms: i64) -> i32 {
        let first = self.check_1.judge(feedback.first == self.on, now_ms, reaction_ms);
        let second = self.check_2.judge(feedback.second == self.on, now_ms, reaction_ms);
        let told = if first == Finding::Fine { second } else { first };
        let channels = Which { first: first == told, second: second == told };
        let raw = self.on != positive;
        match told {
            Finding::Fine => NONE,
            Finding::Unexpected => unexpected(channels, raw),
            Finding::TooLate => did_not_follow(channels, raw),
        }
    }

    fn command(&mut self, good: bool, actuate: bool, feedback: Which, now_ms: i64) {
        let before = self.on;
        if self.latch.fault != NONE || !good {
            self.on = false;
            self.armed = false;
        } else if !actuate {
            // The valve is proved closed before each new start.
            self.armed |= !self.on && !feedback.any();
            self.on = false;
        } else if !self.on && self.armed && !feedback.any() {
            self.on = true;
            self.armed = false;
        }
        if self.on != before {
            self.restart_checks(now_ms);
        }
    }

    fn restart_checks(&mut self, now_ms: i64) {
        self.check_1.restart(now_ms);
        self.check_2.restart(now_ms);
    }
}
