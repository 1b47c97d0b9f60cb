//! DCM, Dual Channel Input Monitor. `dual-channel-inputs.md` 8A.

use super::monitor::{Inputs, Monitor};
use super::pair::Consistency;
use crate::codes::{self, NONE, RESET_HELD};
use crate::members::members;
use twinrung_catalog::types::safety::dual_channel::DCI_MONITOR;

members! {
    DCI_MONITOR;
    inputs {
        INPUT_TYPE = "InputType",
        DISCREPANCY_TIME = "DiscrepancyTime",
        CHANNEL_A = "ChannelA",
        CHANNEL_B = "ChannelB",
        INPUT_STATUS = "InputStatus",
        RESET = "Reset",
    }
    outputs { O1 = "O1", FP = "FP", IS = "IS", FAULT_CODE = "FaultCode", DIAGNOSTIC_CODE = "DiagnosticCode" }
}

/// Memory of a DCM call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dcm {
    monitor: Monitor,
}

crate::bits!(Dcm { monitor });

impl Dcm {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Dcm::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let inputs = read(members);
        if !rung {
            self.monitor.rung_false(inputs.input_status);
            clear_outputs(members);
            return;
        }
        let pair = self.monitor.evaluate(&inputs, now_ms);
        let fault = self.monitor.fault;
        let diagnostic = if pair.is_none() {
            codes::INPUT_STATUS
        } else if fault != NONE && inputs.reset {
            RESET_HELD
        } else {
            NONE
        };
        members[O1] = i32::from(fault == NONE && pair == Some(Consistency::Active));
        members[FP] = i32::from(fault != NONE);
        // Decided D31: IS = O1 is trustworthy.
        members[IS] = i32::from(fault == NONE && pair.is_some());
        members[FAULT_CODE] = fault;
        members[DIAGNOSTIC_CODE] = diagnostic;
    }
}

fn read(members: &Members) -> Inputs {
    Inputs {
        input_type: members[INPUT_TYPE],
        discrepancy_ms: members[DISCREPANCY_TIME],
        channel_a: members[CHANNEL_A] != 0,
        channel_b: members[CHANNEL_B] != 0,
        input_status: members[INPUT_STATUS] != 0,
        reset: members[RESET] != 0,
    }
}
