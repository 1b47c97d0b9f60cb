//! DCS, Dual Channel Input Stop. `dual-channel-inputs.md` 4.

use super::stop::{Stop, stop_members};
use crate::codes::{self, NONE};
use twinrung_catalog::types::safety::dual_channel::DCI_STOP;

stop_members! {
    DCI_STOP;
    inputs {}
    outputs {}
}

/// Memory of a DCS call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dcs {
    stop: Stop,
}

crate::bits!(Dcs { stop });

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
            None => codes::INPUT_STATUS,
            Some(mut found) => {
                self.stop.judge(&mut found, &inputs, NONE, true);
                self.stop.decide(&found, &inputs, now_ms, true, false);
                self.stop.diagnostic(&found, &inputs, true, NONE)
            }
        };
        write(&self.stop, diagnostic, members);
    }
}
