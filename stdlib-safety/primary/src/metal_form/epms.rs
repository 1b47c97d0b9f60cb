//! EPMS, Eight Position Mode Selector. `v14-and-metal-form.md` 5.

use super::latch::{FaultLatch, Status};
use crate::codes::NONE;
use crate::members::members;
use crate::selector::{NO_POSITION_MS, Selection};
use crate::timer::Limit;
use twinrung_catalog::types::safety::press::EIGHT_POS_MODE_SELECTOR;

members! {
    EIGHT_POS_MODE_SELECTOR;
    inputs {
        INPUT_1 = "Input1",
        INPUT_2 = "Input2",
        INPUT_3 = "Input3",
        INPUT_4 = "Input4",
        INPUT_5 = "Input5",
        INPUT_6 = "Input6",
        INPUT_7 = "Input7",
        INPUT_8 = "Input8",
        INPUT_STATUS = "InputStatus",
        LOCK = "Lock",
        RESET = "Reset",
    }
    outputs {
        O1 = "O1",
        O2 = "O2",
        O3 = "O3",
        O4 = "O4",
        O5 = "O5",
        O6 = "O6",
        O7 = "O7",
        O8 = "O8",
        FP = "FP",
        FAULT_CODE = "FaultCode",
        DIAGNOSTIC_CODE = "DiagnosticCode",
    }
}

/// Fault: no input for 250 ms. 5, condition H-EPMS, number decided.
const NO_INPUT: i32 = 0xF101;
/// Fault: more than one input. 5, condition H-EPMS, number decided.
const SEVERAL_INPUTS: i32 = 0xF102;
/// Diagnostic: change of position while locked. 5, condition H-EPMS, number decided.
const CHANGE_WHILE_LOCKED: i32 = 0xF103;

/// Memory of an EPMS call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Epms {
    latch: FaultLatch,
    none: Limit,
    /// The output that is on, counted from 1.
    active: Option<u8>,
    /// The selector was moved while locked: no mode until it is unlocked (decided).
    moved: bool,
}

crate::bits!(Epms { latch, none, active, moved });

impl Epms {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Epms::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            // A false rung is as prescan, a latched fault included (1.3).
            self.prescan(members);
            return;
        }
        let status = Status { input: members[INPUT_STATUS] != 0, output: true, reset: members[RESET] != 0 };
        let selection = Selection::read([
            members[INPUT_1],
            members[INPUT_2],
            members[INPUT_3],
            members[INPUT_4],
            members[INPUT_5],
            members[INPUT_6],
            members[INPUT_7],
            members[INPUT_8],
        ]);
        let lost = self.latch.begin(&status);
        let no_input = self.none.breaks(status.input && selection == Selection::None, now_ms, NO_POSITION_MS);
        let new_fault = if lost != NONE || !status.input {
            lost
        } else if no_input {
            NO_INPUT
        } else if selection == Selection::Several {
            SEVERAL_INPUTS
        } else {
            NONE
        };
        let cause_gone = status.input && matches!(selection, Selection::One(_));
        self.latch.settle(new_fault, cause_gone);
        let usable = status.input && self.latch.fault == NONE;
        self.select(selection, members[LOCK] != 0, usable);
        let own = if self.moved { CHANGE_WHILE_LOCKED } else { NONE };
        let output = |position: u8| i32::from(self.active == Some(position));
        members[O1] = output(1);
        members[O2] = output(2);
        members[O3] = output(3);
        members[O4] = output(4);
        members[O5] = output(5);
        members[O6] = output(6);
        members[O7] = output(7);
        members[O8] = output(8);
        members[FP] = i32::from(self.latch.fault != NONE);
        members[FAULT_CODE] = self.latch.fault;
        members[DIAGNOSTIC_CODE] = self.latch.diagnostic(&status, cause_gone, own);
    }

    fn select(&mut self, selection: Selection, locked: bool, usable: bool) {
        self.moved &= locked;
        if !usable {
            self.active = None;
            return;
        }
        let wanted = match selection {
            Selection::One(position) => Some(position),
            Selection::None | Selection::Several => None,
        };
        if !locked {
            self.active = wanted;
        } else if wanted != self.active {
            self.active = None;
            self.moved = true;
        }
    }
}
