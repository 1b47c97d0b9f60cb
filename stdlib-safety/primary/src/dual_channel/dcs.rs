//! DCS, Dual Channel Input Stop. `dual-channel-inputs.md` 4.

use super::stop::{Inputs, Stop};
use crate::codes::{INPUT_STATUS, NONE};
use crate::members::members;
use twinrung_catalog::types::safety::dual_channel::DCI_STOP;

members! {
    DCI_STOP;
    inputs {
        INPUT_TYPE = "InputType",
        DISCREPANCY_TIME = "DiscrepancyTime",
        RESTART_TYPE = "RestartType",
        COLD_START_TYPE = "ColdStartType",
        CHANNEL_A = "ChannelA",
        CHANNEL_B = "ChannelB",
        INPUT_STATUS_IN = "InputStatus",
        RESET = "Reset",
    }
    outputs { O1 = "O1", FP = "FP", FAULT_CODE = "FaultCode", DIAGNOSTIC_CODE = "DiagnosticCode" }
}

/// Memory of a DCS call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dcs {
    stop: Stop,
}

impl Dcs {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Dcs::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let inputs = read(members);
        if !rung {
            self.stop.rung_false(&inputs);
            clear_outputs(members);
            return;
        }
        let diagnostic = match self.stop.begin(&inputs, now_ms) {
            None => INPUT_STATUS,
            Some(mut found) => {
                self.stop.judge(&mut found, &inputs, NONE, true);
                self.stop.decide(&found, &inputs, now_ms, true, false);
                self.stop.diagnostic(&found, &inputs, true, NONE)
            }
        };
        members[O1] = i32::from(self.stop.output());
        members[FP] = i32::from(self.stop.fault != NONE);
        members[FAULT_CODE] = self.stop.fault;
        members[DIAGNOSTIC_CODE] = diagnostic;
    }
}

fn read(members: &Members) -> Inputs {
    Inputs {
        input_type: members[INPUT_TYPE],
        discrepancy_ms: members[DISCREPANCY_TIME],
        restart_automatic: members[RESTART_TYPE] != 0,
        cold_start_automatic: members[COLD_START_TYPE] != 0,
        channel_a: members[CHANNEL_A] != 0,
        channel_b: members[CHANNEL_B] != 0,
        input_status: members[INPUT_STATUS_IN] != 0,
        reset: members[RESET] != 0,
    }
}
