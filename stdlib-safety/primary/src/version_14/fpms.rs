//! FPMS, Five Position Mode Selector. `v14-and-metal-form.md` 3.2.

use crate::edge::Edge;
use crate::members::members;
use crate::selector::{NO_POSITION_MS, Selection};
use crate::timer::Limit;
use twinrung_catalog::types::safety::version_14::FIVE_POS_MODE_SELECTOR;

members! {
    FIVE_POS_MODE_SELECTOR;
    inputs {
        INPUT_1 = "Input1",
        INPUT_2 = "Input2",
        INPUT_3 = "Input3",
        INPUT_4 = "Input4",
        INPUT_5 = "Input5",
        FAULT_RESET = "FaultReset",
    }
    outputs {
        O1 = "O1",
        O2 = "O2",
        O3 = "O3",
        O4 = "O4",
        O5 = "O5",
        NM = "NM",
        MMS = "MMS",
        FP = "FP",
    }
}

/// Memory of an FPMS call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fpms {
    none: Limit,
    /// NM, latched.
    no_mode: bool,
    /// MMS, latched.
    several_modes: bool,
    reset: Edge,
}

crate::bits!(Fpms { none, no_mode, several_modes, reset });

impl Fpms {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Fpms::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            // A false rung is as prescan, a latched fault included (1.3).
            self.prescan(members);
            return;
        }
        let reset = self.reset.rises(members[FAULT_RESET] != 0);
        let selection =
            Selection::read([members[INPUT_1], members[INPUT_2], members[INPUT_3], members[INPUT_4], members[INPUT_5]]);
        let no_mode = self.none.breaks(selection == Selection::None, now_ms, NO_POSITION_MS);
        let several_modes = selection == Selection::Several;
        self.no_mode = no_mode || (self.no_mode && (selection == Selection::None || !reset));
        self.several_modes = several_modes || (self.several_modes && !reset);
        let fault = self.no_mode || self.several_modes;
        let selected = |position: u8| i32::from(!fault && selection == Selection::One(position));
        members[O1] = selected(1);
        members[O2] = selected(2);
        members[O3] = selected(3);
        members[O4] = selected(4);
        members[O5] = selected(5);
        members[NM] = i32::from(self.no_mode);
        members[MMS] = i32::from(self.several_modes);
        members[FP] = i32::from(fault);
    }
}
