//! ROUT, Redundant Output with continuous feedback monitoring. `muting-and-outputs.md` 7.

use super::feedback::Which;
use crate::edge::Edge;
use crate::members::members;
use crate::timer::Timer;
use twinrung_catalog::types::safety::output::REDUNDANT_OUTPUT;

members! {
    REDUNDANT_OUTPUT;
    inputs {
        FEEDBACK_TYPE = "FeedbackType",
        ENABLE = "Enable",
        FEEDBACK_1 = "Feedback1",
        FEEDBACK_2 = "Feedback2",
        FAULT_RESET = "FaultReset",
    }
    outputs { O1 = "O1", O2 = "O2", O1FF = "O1FF", O2FF = "O2FF", FP = "FP" }
}

/// Longest time that a feedback may differ from its output. 7.3, recalled 50 %, the shorter candidate taken.
const REACTION_MS: i32 = 250;

/// Memory of a ROUT call; its default is the state after prescan.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rout {
    /// The one decision behind O1 and O2.
    on: bool,
    /// Enable has been seen 0 since prescan or since a fault.
    armed: bool,
    /// The channels whose feedback failed; both false without a fault.
    failed: Which,
    mismatch: Timer,
    reset: Edge,
}

crate::bits!(Rout { on, armed, failed, mismatch, reset });

impl Rout {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Rout::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            // As after prescan, but the failure pattern is kept (1.3).
            *self = Rout { failed: self.failed, ..Rout::default() };
            clear_outputs(members);
            return;
        }
        let positive = members[FEEDBACK_TYPE] != 0;
        let says_on = |feedback: i32| (feedback != 0) == positive;
        let feedback = Which { first: says_on(members[FEEDBACK_1]), second: says_on(members[FEEDBACK_2]) };
        let reset = self.reset.rises(members[FAULT_RESET] != 0);
        if self.failed.any() {
            if reset && !feedback.any() {
                self.failed = Which::default();
            }
        } else {
            self.command(members[ENABLE] != 0, feedback, now_ms);
            self.supervise(feedback, now_ms);
        }
        members[O1] = i32::from(self.on);
        members[O2] = i32::from(self.on);
        members[O1FF] = i32::from(self.failed.first);
        members[O2FF] = i32::from(self.failed.second);
        members[FP] = i32::from(self.failed.any());
    }

    /// Step 1 of 7.3.
    fn command(&mut self, enable: bool, feedback: Which, now_ms: i64) {
        self.armed |= !enable;
        let turns_on = !self.on && enable && self.armed && !feedback.any();
        let turns_off = self.on && !enable;
        if turns_on || turns_off {
            self.on = turns_on;
            self.mismatch.restart(now_ms);
        }
    }

    /// Step 2 of 7.3: one timer, from the first mismatch or from the last change of the outputs.
    fn supervise(&mut self, feedback: Which, now_ms: i64) {
        let mismatch = if self.on { feedback.not() } else { feedback };
        self.mismatch.follow(mismatch.any(), now_ms);
        if self.mismatch.reached(now_ms, REACTION_MS) {
            // The edge memory of Fault Reset goes on, everything else starts anew.
            *self = Rout { failed: mismatch, reset: self.reset, ..Rout::default() };
        }
    }
}
