//! CBSSM, Clutch Brake Single Stroke Mode. `v14-and-metal-form.md` 11.3.

use super::clutch_brake::{
    ClutchBrake, Inputs, Permitted, RELEASED_EARLY, STOPPED_AT_TOP, ZONES_OUT_OF_ORDER, clutch_brake_members,
};
use super::zone::Zone;
use crate::codes::NONE;
use twinrung_catalog::types::safety::press::CB_SINGLE_STROKE_MODE;

clutch_brake_members! {
    CB_SINGLE_STROKE_MODE;
    inputs { TAKEOVER_MODE = "TakeoverMode" }
    outputs {}
}

/// The configuration operands.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Configuration {
    acknowledge_manually: bool,
    /// Start may be released in the Up zone. 11, recalled 65 %.
    takeover: bool,
}

crate::bits!(Configuration { acknowledge_manually, takeover });

/// Memory of a CBSSM call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cbssm {
    common: ClutchBrake<Configuration>,
}

crate::bits!(Cbssm { common });

impl Cbssm {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Cbssm::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let _untimed = now_ms;
        if !rung {
            // A false rung re-initialises (1.3).
            self.prescan(members);
            return;
        }
        let inputs = read(members);
        let takeover = members[TAKEOVER_MODE] != 0;
        let configuration = Configuration { acknowledge_manually: inputs.acknowledge_manually, takeover };
        let diagnostic = match self.common.begin(&inputs, configuration, true) {
            Err(missing) => missing,
            Ok(permitted) => {
                self.follow(&permitted, &inputs, takeover);
                self.common.diagnostic(&inputs)
            }
        };
        members[O1] = i32::from(self.common.on);
        members[DIAGNOSTIC_CODE] = diagnostic;
    }

    fn follow(&mut self, permitted: &Permitted, inputs: &Inputs, takeover: bool) {
        if self.common.on {
            if permitted.out_of_order() {
                self.common.stop(ZONES_OUT_OF_ORDER);
            } else if permitted.enters(Zone::Top) {
                self.common.stop(STOPPED_AT_TOP);
            } else if !(inputs.start || (takeover && permitted.zone == Zone::Up)) {
                self.common.stop(RELEASED_EARLY);
            }
        } else if permitted.start_rises {
            match permitted.refusal_outside_top() {
                NONE => self.common.run(),
                refusal => self.common.stop(refusal),
            }
        }
    }
}
