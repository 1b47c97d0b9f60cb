//! DCSRT, Dual Channel Input Start. `dual-channel-inputs.md` 8B.

use super::monitor::{Inputs, Monitor};
use super::pair::Consistency;
use crate::codes::{self, NONE, NOT_ARMED, RESET_HELD};
use crate::members::members;
use twinrung_catalog::types::safety::dual_channel::DCI_START;

members! {
    DCI_START;
    inputs {
        INPUT_TYPE = "InputType",
        DISCREPANCY_TIME = "DiscrepancyTime",
        ENABLE = "Enable",
        CHANNEL_A = "ChannelA",
        CHANNEL_B = "ChannelB",
        INPUT_STATUS = "InputStatus",
        RESET = "Reset",
    }
    outputs { O1 = "O1", FP = "FP", FAULT_CODE = "FaultCode", DIAGNOSTIC_CODE = "DiagnosticCode" }
}

/// Memory of a DCSRT call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dcsrt {
    monitor: Monitor,
    /// Both channels were seen released while enabled (decided D33).
    armed: bool,
    /// O1 is on: the channels became active from there and stayed so.
    granted: bool,
}

crate::bits!(Dcsrt { monitor, armed, granted });

impl Dcsrt {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Dcsrt::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let inputs = read(members);
        if !rung {
            self.monitor.rung_false(inputs.input_status);
            self.disarm();
            clear_outputs(members);
            return;
        }
        let faulted_before = self.monitor.fault != NONE;
        let pair = self.monitor.evaluate(&inputs, now_ms);
        let fault = self.monitor.fault;
        if faulted_before || fault != NONE || members[ENABLE] == 0 {
            self.disarm();
        }
        if fault == NONE && members[ENABLE] != 0 {
            self.follow(pair);
        }
        let diagnostic = if pair.is_none() {
            codes::INPUT_STATUS
        } else if fault != NONE {
            if inputs.reset { RESET_HELD } else { NONE }
        } else if pair == Some(Consistency::Active) && !self.granted {
            NOT_ARMED
        } else {
            NONE
        };
        members[O1] = i32::from(self.granted);
        members[FP] = i32::from(fault != NONE);
        members[FAULT_CODE] = fault;
        members[DIAGNOSTIC_CODE] = diagnostic;
    }

    /// Enabled and without a fault.
    fn follow(&mut self, pair: Option<Consistency>) {
        match pair {
            None => self.disarm(),
            Some(Consistency::Safe) => {
                self.granted = false;
                self.armed = true;
            }
            Some(Consistency::Active) => {
                self.granted |= self.armed;
                self.armed = false;
            }
            Some(Consistency::Discrepant) => self.granted = false,
        }
    }

    fn disarm(&mut self) {
        self.armed = false;
        self.granted = false;
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
