//! The common part of CBIM, CBSSM and CBCM. `v14-and-metal-form.md` 11.1.

use super::zone::Zone;
use crate::codes::NONE;
use crate::edge::Edge;

/// Enable off. 11.1, decided, as all that follow.
const NO_ENABLE: i32 = 0xF001;
/// Safety Enable off.
const NO_SAFETY_ENABLE: i32 = 0xF002;
/// Waiting for Safety Enable Ack.
const NO_ACKNOWLEDGMENT: i32 = 0xF003;
/// Safety Enable Ack is held on.
const ACKNOWLEDGMENT_HELD: i32 = 0xF004;
/// Standard Enable off.
const NO_STANDARD_ENABLE: i32 = 0xF005;
/// Motion Monitor Fault.
const MOTION_MONITOR_FAULT: i32 = 0xF006;
/// Slide Zone invalid.
const ZONE_INVALID: i32 = 0xF007;
/// Start or Arm refused: press in motion.
pub(crate) const IN_MOTION: i32 = 0xF008;
/// Start is held on.
const START_HELD: i32 = 0xF009;
/// Start or Arm refused: slide not in Top (CBSSM, CBCM).
pub(crate) const NOT_IN_TOP: i32 = 0xF00A;
/// Stopped: Start released too early.
pub(crate) const RELEASED_EARLY: i32 = 0xF00B;
/// Stopped at Top, normal end.
pub(crate) const STOPPED_AT_TOP: i32 = 0xF00D;
/// Configuration out of range or changed at run time.
const CONFIGURATION: i32 = 0xF00E;
/// Stopped: zones out of order.
pub(crate) const ZONES_OUT_OF_ORDER: i32 = 0xF011;
/// Start or Arm in the very scan in which the permissives came.
const TOO_SOON: i32 = 0xF012;

/// What the three read in every scan.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs {
    /// Ack Type: 1 manual, 0 automatic. 11, numbers decided.
    pub(crate) acknowledge_manually: bool,
    pub(crate) enable: bool,
    pub(crate) safety_enable: bool,
    pub(crate) standard_enable: bool,
    pub(crate) start: bool,
    pub(crate) press_in_motion: bool,
    pub(crate) motion_monitor_fault: bool,
    pub(crate) slide_zone: i32,
    pub(crate) acknowledge: bool,
}

/// A scan in which all permissives hold.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Permitted {
    pub(crate) zone: Zone,
    /// The zone of the previous scan, where it was valid.
    pub(crate) zone_before: Option<Zone>,
    pub(crate) start_rises: bool,
    /// The permissives did not hold in the previous scan.
    fresh: bool,
    in_motion: bool,
}

impl Permitted {
    /// Why a Start or Arm edge is refused whatever the mode, or 0 (11.1 rule 4).
    pub(crate) fn refusal(&self) -> i32 {
        if self.fresh {
            TOO_SOON
        } else if self.in_motion {
            IN_MOTION
        } else {
            NONE
        }
    }

    /// As [`Permitted::refusal`], for a mode that starts in Top only.
    pub(crate) fn refusal_outside_top(&self) -> i32 {
        let refusal = self.refusal();
        if refusal == NONE && self.zone != Zone::Top { NOT_IN_TOP } else { refusal }
    }

    /// Whether the zone became this one in this scan, from the one before it in forward motion.
    pub(crate) fn enters(&self, zone: Zone) -> bool {
        self.zone == zone && self.zone_before.is_some_and(|before| before != zone)
    }

    /// Whether the zone changed otherwise than Top > Down > Up > Top.
    pub(crate) fn out_of_order(&self) -> bool {
        self.zone_before.is_some_and(|before| self.zone != before && self.zone != before.next())
    }
}

/// Memory of the common part; `C` are the configuration operands.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ClutchBrake<C> {
    /// As remembered at the first scan with a true rung.
    configuration: Option<C>,
    configuration_bad: bool,
    acknowledged: bool,
    enabled_before: bool,
    permitted_before: bool,
    zone_before: Option<Zone>,
    acknowledge: Edge,
    start: Edge,
    /// O1.
    pub(crate) on: bool,
    /// Why the press stopped last or refused to start, kept until the next Start or Arm edge; 0 without a reason.
    pub(crate) reason: i32,
}

crate::bits!(ClutchBrake<C> where (C) {
    configuration, configuration_bad, acknowledged, enabled_before, permitted_before, zone_before, acknowledge,
    start, on, reason
});

impl<C> Default for ClutchBrake<C> {
    fn default() -> Self {
        ClutchBrake {
            configuration: None,
            configuration_bad: false,
            acknowledged: false,
            enabled_before: false,
            permitted_before: false,
            zone_before: None,
            acknowledge: Edge::default(),
            start: Edge::default(),
            on: false,
            reason: NONE,
        }
    }
}

impl<C: Copy + PartialEq> ClutchBrake<C> {
    /// Rules 1 to 3: either all permissives hold, or O1 is off and the code of the first missing one is given.
    pub(crate) fn begin(&mut self, inputs: &Inputs, configuration: C, in_range: bool) -> Result<Permitted, i32> {
        let remembered = *self.configuration.get_or_insert(configuration);
        self.configuration_bad |= !in_range || remembered != configuration;
        let start_rises = self.start.rises(inputs.start);
        self.follow_acknowledgment(inputs);
        let zone = Zone::from_number(inputs.slide_zone);
        let zone_before = core::mem::replace(&mut self.zone_before, zone);
        let permitted = self.missing(inputs).and_then(|()| {
            let zone = zone.ok_or(ZONE_INVALID)?;
            let fresh = !self.permitted_before;
            Ok(Permitted { zone, zone_before, start_rises, fresh, in_motion: inputs.press_in_motion })
        });
        self.permitted_before = permitted.is_ok();
        if permitted.is_err() {
            self.stop(NONE);
        }
        permitted
    }

    /// O1 off, for a reason.
    pub(crate) fn stop(&mut self, reason: i32) {
        self.on = false;
        self.reason = reason;
    }

    /// O1 on.
    pub(crate) fn run(&mut self) {
        self.on = true;
        self.reason = NONE;
    }

    /// DiagnosticCode while all permissives hold (rule 5).
    pub(crate) fn diagnostic(&self, inputs: &Inputs) -> i32 {
        if self.on || self.reason != NONE {
            self.reason
        } else if inputs.start {
            START_HELD
        } else {
            NONE
        }
    }

    /// Rule 2.
    fn follow_acknowledgment(&mut self, inputs: &Inputs) {
        let rises = self.acknowledge.rises(inputs.acknowledge);
        let enabled = inputs.safety_enable && inputs.enable;
        let acknowledges = !inputs.acknowledge_manually || (rises && self.enabled_before);
        self.acknowledged = enabled && (self.acknowledged || acknowledges);
        self.enabled_before = enabled;
    }

    /// The first missing permissive in the order of rule 3, the zone apart.
    fn missing(&self, inputs: &Inputs) -> Result<(), i32> {
        if self.configuration_bad {
            Err(CONFIGURATION)
        } else if !inputs.enable {
            Err(NO_ENABLE)
        } else if !inputs.safety_enable {
            Err(NO_SAFETY_ENABLE)
        } else if !self.acknowledged {
            Err(if inputs.acknowledge { ACKNOWLEDGMENT_HELD } else { NO_ACKNOWLEDGMENT })
        } else if !inputs.standard_enable {
            Err(NO_STANDARD_ENABLE)
        } else if inputs.motion_monitor_fault {
            Err(MOTION_MONITOR_FAULT)
        } else {
            Ok(())
        }
    }
}

/// [`members!`](crate::members::members) with the members that the three instructions have, and `read` for them.
macro_rules! clutch_brake_members {
    (
        $backing:path;
        inputs { $($input:ident = $input_name:literal),* $(,)? }
        outputs { $($output:ident = $output_name:literal),* $(,)? }
    ) => {
        crate::members::members! {
            $backing;
            inputs {
                ACK_TYPE = "AckType",
                ENABLE = "Enable",
                SAFETY_ENABLE = "SafetyEnable",
                STANDARD_ENABLE = "StandardEnable",
                START = "Start",
                PRESS_IN_MOTION = "PressInMotion",
                MOTION_MONITOR_FAULT = "MotionMonitorFault",
                SLIDE_ZONE = "SlideZone",
                SAFETY_ENABLE_ACK = "SafetyEnableAck",
                $($input = $input_name,)*
            }
            outputs { O1 = "O1", DIAGNOSTIC_CODE = "DiagnosticCode", $($output = $output_name,)* }
        }

        fn read(members: &Members) -> $crate::metal_form::clutch_brake::Inputs {
            $crate::metal_form::clutch_brake::Inputs {
                acknowledge_manually: members[ACK_TYPE] != 0,
                enable: members[ENABLE] != 0,
                safety_enable: members[SAFETY_ENABLE] != 0,
                standard_enable: members[STANDARD_ENABLE] != 0,
                start: members[START] != 0,
                press_in_motion: members[PRESS_IN_MOTION] != 0,
                motion_monitor_fault: members[MOTION_MONITOR_FAULT] != 0,
                slide_zone: members[SLIDE_ZONE],
                acknowledge: members[SAFETY_ENABLE_ACK] != 0,
            }
        }
    };
}

pub(crate) use clutch_brake_members;
