//! CBIM, Clutch Brake Inch Mode. `v14-and-metal-form.md` 11.2.

use super::clutch_brake::{ClutchBrake, Inputs, Permitted, RELEASED_EARLY, STOPPED_AT_TOP, clutch_brake_members};
use super::zone::Zone;
use crate::codes::NONE;
use crate::timer::Timer;
use core::ops::RangeInclusive;
use twinrung_catalog::types::safety::press::CB_INCH_MODE;

clutch_brake_members! {
    CB_INCH_MODE;
    inputs { INCH_TIME = "InchTime" }
    outputs {}
}

/// Inch Time. 11, decided: an inch is always limited.
const INCH_RANGE_MS: RangeInclusive<i32> = 1..=10_000;
/// Stopped: Inch Time over. 11.1, decided.
const INCH_OVER: i32 = 0xF00C;

/// The configuration operands.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Configuration {
    acknowledge_manually: bool,
    inch_ms: i32,
}

crate::bits!(Configuration { acknowledge_manually, inch_ms });

/// Memory of a CBIM call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cbim {
    common: ClutchBrake<Configuration>,
    inch: Timer,
}

crate::bits!(Cbim { common, inch });

impl Cbim {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Cbim::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            // A false rung re-initialises (1.3).
            self.prescan(members);
            return;
        }
        let inputs = read(members);
        let inch_ms = members[INCH_TIME];
        let configuration = Configuration { acknowledge_manually: inputs.acknowledge_manually, inch_ms };
        let diagnostic = match self.common.begin(&inputs, configuration, INCH_RANGE_MS.contains(&inch_ms)) {
            Err(missing) => missing,
            Ok(permitted) => {
                self.follow(&permitted, &inputs, inch_ms, now_ms);
                self.common.diagnostic(&inputs)
            }
        };
        members[O1] = i32::from(self.common.on);
        members[DIAGNOSTIC_CODE] = diagnostic;
    }

    fn follow(&mut self, permitted: &Permitted, inputs: &Inputs, inch_ms: i32, now_ms: i64) {
        if self.common.on {
            if !inputs.start {
                self.common.stop(RELEASED_EARLY);
            } else if self.inch.reached(now_ms, inch_ms) {
                self.common.stop(INCH_OVER);
            } else if permitted.enters(Zone::Top) {
                self.common.stop(STOPPED_AT_TOP);
            }
        } else if permitted.start_rises {
            match permitted.refusal() {
                NONE => {
                    self.common.run();
                    self.inch.restart(now_ms);
                }
                refusal => self.common.stop(refusal),
            }
        }
    }
}
