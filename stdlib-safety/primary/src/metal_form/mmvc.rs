//! MMVC, Maintenance Manual Valve Control. `v14-and-metal-form.md` 10.

use super::latch::{FaultLatch, Status};
use crate::codes::NONE;
use crate::edge::Edge;
use crate::members::members;
use twinrung_catalog::types::safety::press::MANUAL_VALVE_CONTROL;

members! {
    MANUAL_VALVE_CONTROL;
    inputs {
        ENABLE = "Enable",
        KEYSWITCH = "Keyswitch",
        BOTTOM = "Bottom",
        FLYWHEEL_STOPPED = "FlywheelStopped",
        SAFETY_ENABLE = "SafetyEnable",
        ACTUATE = "Actuate",
        INPUT_STATUS = "InputStatus",
        OUTPUT_STATUS = "OutputStatus",
        RESET = "Reset",
    }
    outputs { O1 = "O1", FP = "FP", FAULT_CODE = "FaultCode", DIAGNOSTIC_CODE = "DiagnosticCode" }
}

/// Diagnostic: Enable is off. 10, decided.
const NO_ENABLE: i32 = 0xF601;
/// Diagnostic: Keyswitch is off. 10, decided.
const NO_KEYSWITCH: i32 = 0xF602;
/// Diagnostic: Safety Enable is off. 10, decided.
const NO_SAFETY_ENABLE: i32 = 0xF603;
/// Diagnostic: the flywheel is not stopped. 10, decided.
const FLYWHEEL_TURNS: i32 = 0xF604;
/// Diagnostic: the slide is not at the bottom. 10, decided.
const NOT_AT_BOTTOM: i32 = 0xF605;
/// Diagnostic: Actuate is on but needs to be released and given again. 10, decided.
const ACTUATE_AGAIN: i32 = 0xF606;

/// Memory of an MMVC call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mmvc {
    latch: FaultLatch,
    actuate: Edge,
    permitted_before: bool,
    o1: bool,
}

crate::bits!(Mmvc { latch, actuate, permitted_before, o1 });

impl Mmvc {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Mmvc::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let _untimed = now_ms;
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
        let actuate = members[ACTUATE] != 0;
        let actuate_rises = self.actuate.rises(actuate);
        let lost = self.latch.begin(&status);
        self.latch.settle(lost, status.good());
        let missing = missing_permissive(members);
        let permitted = missing == NONE && status.good() && self.latch.fault == NONE;
        if !permitted || !actuate {
            self.o1 = false;
        } else if actuate_rises && self.permitted_before {
            self.o1 = true;
        }
        self.permitted_before = permitted;
        let own = if missing != NONE {
            missing
        } else if actuate && !self.o1 {
            ACTUATE_AGAIN
        } else {
            NONE
        };
        members[O1] = i32::from(self.o1);
        members[FP] = i32::from(self.latch.fault != NONE);
        members[FAULT_CODE] = self.latch.fault;
        let diagnostic = self.latch.diagnostic(&status, status.good(), own);
        // The first missing is told with a fault latched too (10: 20, 21, 05, then the first missing).
        members[DIAGNOSTIC_CODE] = if diagnostic == NONE { missing } else { diagnostic };
    }
}

/// The first permissive that is missing, in the order of the diagnostics, or 0.
fn missing_permissive(members: &Members) -> i32 {
    if members[ENABLE] == 0 {
        NO_ENABLE
    } else if members[KEYSWITCH] == 0 {
        NO_KEYSWITCH
    } else if members[SAFETY_ENABLE] == 0 {
        NO_SAFETY_ENABLE
    } else if members[FLYWHEEL_STOPPED] == 0 {
        FLYWHEEL_TURNS
    } else if members[BOTTOM] == 0 {
        NOT_AT_BOTTOM
    } else {
        NONE
    }
}
