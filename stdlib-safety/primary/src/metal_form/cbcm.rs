//! CBCM, Clutch Brake Continuous Mode. `v14-and-metal-form.md` 11.4.

use super::clutch_brake::{
    ClutchBrake, IN_MOTION, Inputs, NOT_IN_TOP, Permitted, RELEASED_EARLY, STOPPED_AT_TOP, ZONES_OUT_OF_ORDER,
    clutch_brake_members,
};
use super::zone::Zone;
use crate::codes::NONE;
use crate::edge::Edge;
use crate::timer::Timer;
use twinrung_catalog::types::safety::press::CB_CONTINUOUS_MODE;

clutch_brake_members! {
    CB_CONTINUOUS_MODE;
    inputs {
        MODE = "Mode",
        TAKEOVER_MODE = "TakeoverMode",
        ARM_CONTINUOUS = "ArmContinuous",
        STOP_AT_TOP = "StopAtTop",
    }
    outputs { CA = "CA" }
}

/// How long after arming Start is awaited; exactly this is in time. 11.4, H-CBCM.
const ARMING_MS: i32 = 5000;
/// Start without arming, or arming ran out. 11.1, decided.
const NOT_ARMED: i32 = 0xF00F;
/// Stop At Top pending, or Start refused because of it. 11.1, decided.
const STOP_PENDING: i32 = 0xF010;

/// Mode. 11, names H-CBCM, numbers recalled 60 %.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    Immediate,
    ImmediateWithArming,
    HalfStrokeWithArming,
    StrokeAndAHalfWithArming,
}

impl Mode {
    fn from_number(number: i32) -> Option<Mode> {
        match number {
            0 => Some(Mode::Immediate),
            1 => Some(Mode::ImmediateWithArming),
            2 => Some(Mode::HalfStrokeWithArming),
            3 => Some(Mode::StrokeAndAHalfWithArming),
            _ => None,
        }
    }

    fn needs_arming(self) -> bool {
        self != Mode::Immediate
    }

    /// How often Up must be reached before Start may be released. 11.4, points decided.
    fn strokes_held(self) -> u8 {
        match self {
            Mode::Immediate | Mode::ImmediateWithArming => 0,
            Mode::HalfStrokeWithArming => 1,
            Mode::StrokeAndAHalfWithArming => 2,
        }
    }
}

/// The configuration operands.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Configuration {
    acknowledge_manually: bool,
    takeover: bool,
    mode: i32,
}

crate::bits!(Configuration { acknowledge_manually, takeover, mode });

/// Memory of a CBCM call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cbcm {
    common: ClutchBrake<Configuration>,
    arm: Edge,
    /// CA.
    armed: bool,
    window: Timer,
    /// How often Up was reached in this run.
    ups: u8,
    stop_requested: bool,
}

crate::bits!(Cbcm { common, arm, armed, window, ups, stop_requested });

/// What CBCM reads beyond the common part.
struct Own {
    mode: Mode,
    takeover: bool,
    arm_rises: bool,
    stop_at_top: bool,
}

impl Cbcm {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Cbcm::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            // A false rung re-initialises (1.3).
            self.prescan(members);
            return;
        }
        let inputs = read(members);
        let mode = Mode::from_number(members[MODE]);
        let takeover = members[TAKEOVER_MODE] != 0;
        let own = Own {
            mode: mode.unwrap_or(Mode::Immediate),
            takeover,
            arm_rises: self.arm.rises(members[ARM_CONTINUOUS] != 0),
            stop_at_top: members[STOP_AT_TOP] != 0,
        };
        let configuration =
            Configuration { acknowledge_manually: inputs.acknowledge_manually, takeover, mode: members[MODE] };
        let diagnostic = match self.common.begin(&inputs, configuration, mode.is_some()) {
            Err(missing) => {
                self.armed = false;
                missing
            }
            Ok(permitted) => {
                self.follow(&permitted, &inputs, &own, now_ms);
                if self.common.on && self.stop_requested { STOP_PENDING } else { self.common.diagnostic(&inputs) }
            }
        };
        members[O1] = i32::from(self.common.on);
        members[CA] = i32::from(self.armed);
        members[DIAGNOSTIC_CODE] = diagnostic;
    }

    fn follow(&mut self, permitted: &Permitted, inputs: &Inputs, own: &Own, now_ms: i64) {
        if self.common.on {
            let stop = self.run(permitted, inputs, own);
            if stop != NONE {
                self.common.stop(stop);
                self.armed = false;
            }
            return;
        }
        // The lines of 11.4 in their order: a new arming keeps the window from running out, and what comes later has
        // the last word in the code.
        let armed_in_time = self.armed && !self.window.exceeded(now_ms, ARMING_MS);
        if own.arm_rises && own.mode.needs_arming() {
            self.arm(permitted, now_ms);
        }
        self.follow_window(permitted.start_rises, now_ms);
        if permitted.start_rises {
            self.start(permitted, own, armed_in_time);
        }
    }

    /// No Start edge within the window: the arming runs out.
    fn follow_window(&mut self, start_rises: bool, now_ms: i64) {
        let over =
            if start_rises { self.window.exceeded(now_ms, ARMING_MS) } else { self.window.reached(now_ms, ARMING_MS) };
        if self.armed && over {
            self.armed = false;
            self.common.stop(NOT_ARMED);
        }
    }

    /// An edge of Arm Continuous; a refused one leaves CA as it is.
    fn arm(&mut self, permitted: &Permitted, now_ms: i64) {
        let refusal = permitted.refusal_outside_top();
        self.common.stop(refusal);
        if refusal == NONE {
            self.armed = true;
            self.window.restart(now_ms);
        }
    }

    /// An edge of Start. `armed_in_time`: armed in an earlier scan that is not more than the window ago (1.1 rule 2); an
    /// arming of this scan does not make a late Start good.
    fn start(&mut self, permitted: &Permitted, own: &Own, armed_in_time: bool) {
        let refusal = match permitted.refusal_outside_top() {
            NONE if own.stop_at_top => STOP_PENDING,
            NONE if own.mode.needs_arming() && !armed_in_time => NOT_ARMED,
            refusal => refusal,
        };
        if matches!(refusal, IN_MOTION | NOT_IN_TOP | STOP_PENDING) {
            self.armed = false;
        }
        if refusal == NONE {
            self.common.run();
            self.ups = 0;
            self.stop_requested = false;
        } else {
            self.common.stop(refusal);
        }
    }

    /// A scan with O1 on; gives the reason to stop, or 0.
    fn run(&mut self, permitted: &Permitted, inputs: &Inputs, own: &Own) -> i32 {
        if permitted.out_of_order() {
            return ZONES_OUT_OF_ORDER;
        }
        if permitted.enters(Zone::Up) {
            self.ups = self.ups.saturating_add(1);
        }
        self.stop_requested |= own.stop_at_top;
        if permitted.enters(Zone::Top) && self.stop_requested {
            return STOPPED_AT_TOP;
        }
        let continuous = self.ups >= own.mode.strokes_held();
        let held = inputs.start || (own.takeover && permitted.zone == Zone::Up);
        if continuous || held { NONE } else { RELEASED_EARLY }
    }
}
