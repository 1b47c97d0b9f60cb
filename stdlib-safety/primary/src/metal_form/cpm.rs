//! CPM, Crankshaft Position Monitor. `v14-and-metal-form.md` 6.

use super::latch::{FaultLatch, Status};
use super::zone::Zone;
use crate::codes::NONE;
use crate::members::members;
use twinrung_catalog::types::safety::press::CB_CRANKSHAFT_POS_MONITOR;

members! {
    CB_CRANKSHAFT_POS_MONITOR;
    inputs {
        CAM_PROFILE = "CamProfile",
        ENABLE = "Enable",
        BRAKE_CAM = "BrakeCam",
        TAKEOVER_CAM = "TakeoverCam",
        DYNAMIC_CAM = "DynamicCam",
        INPUT_STATUS = "InputStatus",
        REVERSE = "Reverse",
        PRESS_MOTION_STATUS = "PressMotionStatus",
        RESET = "Reset",
    }
    outputs {
        TZ = "TZ",
        DZ = "DZ",
        UZ = "UZ",
        FP = "FP",
        SLIDE_ZONE = "SlideZone",
        FAULT_CODE = "FaultCode",
        DIAGNOSTIC_CODE = "DiagnosticCode",
    }
}

/// Fault: cam pattern not possible in this profile. 6.2, decided.
const ILLEGAL_PATTERN: i32 = 0xF201;
/// Fault: zones out of sequence, forward. 6.2, decided.
const OUT_OF_SEQUENCE: i32 = 0xF202;
/// Fault: Top left in reverse, or another illegal change in reverse. 6.2, H-CPM for the condition, number decided.
const ILLEGAL_IN_REVERSE: i32 = 0xF203;
/// Fault: zone changed without motion. 6.2, decided.
const CHANGED_AT_REST: i32 = 0xF204;
/// Fault: dynamic cam did not operate. 6.2, decided.
const NO_DYNAMIC_CAM: i32 = 0xF205;

/// Memory of a CPM call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cpm {
    latch: FaultLatch,
    /// The zone that the cams showed last; `None` before the first decode.
    raw: Option<Zone>,
    /// The dynamic cam was enabled in every scan of this Up zone.
    enabled_throughout: bool,
    /// The dynamic cam gave an early Top in this Up zone.
    early_top: bool,
    motion_before: bool,
}

crate::bits!(Cpm { latch, raw, enabled_throughout, early_top, motion_before });

/// What a scan reads.
struct Inputs {
    profile_b: bool,
    enable: bool,
    brake: bool,
    takeover: bool,
    dynamic: bool,
    reverse: bool,
    motion: bool,
}

impl Cpm {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Cpm::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        let _untimed = now_ms;
        if !rung {
            // A false rung is as prescan, a latched fault included (1.3).
            self.prescan(members);
            return;
        }
        let status = Status { input: members[INPUT_STATUS] != 0, output: true, reset: members[RESET] != 0 };
        let inputs = Inputs {
            profile_b: members[CAM_PROFILE] != 0,
            enable: members[ENABLE] != 0,
            brake: members[BRAKE_CAM] != 0,
            takeover: members[TAKEOVER_CAM] != 0,
            dynamic: members[DYNAMIC_CAM] != 0,
            reverse: members[REVERSE] != 0,
            motion: members[PRESS_MOTION_STATUS] != 0,
        };
        let lost = self.latch.begin(&status);
        let decoded = self.decode(&inputs);
        let new_fault = match decoded {
            _ if lost != NONE || !status.input => lost,
            None => ILLEGAL_PATTERN,
            Some(zone) => self.judge(zone, &inputs),
        };
        let cause_gone = status.input && decoded.is_some();
        self.latch.settle(new_fault, cause_gone);
        self.motion_before = inputs.motion;
        let usable = status.input && self.latch.fault == NONE;
        self.follow(decoded.filter(|_| usable), &inputs);
        let published = self.published();
        members[TZ] = i32::from(published == Some(Zone::Top));
        members[DZ] = i32::from(published == Some(Zone::Down));
        members[UZ] = i32::from(published == Some(Zone::Up));
        members[FP] = i32::from(self.latch.fault != NONE);
        members[SLIDE_ZONE] = published.map_or(0, Zone::number);
        members[FAULT_CODE] = self.latch.fault;
        members[DIAGNOSTIC_CODE] = self.latch.diagnostic(&status, cause_gone, NONE);
    }

    /// The table of 6.1 (decided); `None` for the pattern that the profile does not have.
    fn decode(&self, inputs: &Inputs) -> Option<Zone> {
        match (inputs.brake, inputs.takeover, inputs.profile_b) {
            (false, false, _) | (false, true, false) => Some(Zone::Top),
            (false, true, true) => None,
            (true, true, _) => Some(Zone::Up),
            // The takeover cam drops before Top.
            (true, false, true) if self.raw == Some(Zone::Up) && !inputs.reverse => Some(Zone::Up),
            (true, false, _) => Some(Zone::Down),
        }
    }

    /// The fault of a zone change, or 0 (6.2).
    fn judge(&self, zone: Zone, inputs: &Inputs) -> i32 {
        let Some(before) = self.raw else { return NONE };
        if zone == before {
            return NONE;
        }
        if inputs.reverse && (before, zone) != (Zone::Down, Zone::Top) {
            return ILLEGAL_IN_REVERSE;
        }
        if !inputs.reverse && zone != before.next() {
            return OUT_OF_SEQUENCE;
        }
        if !inputs.motion && !self.motion_before {
            return CHANGED_AT_REST;
        }
        if before == Zone::Up && self.enabled_throughout && !self.early_top {
            return NO_DYNAMIC_CAM;
        }
        NONE
    }

    /// Takes over the zone, or forgets everything with a fault or without Input Status: it is decoded afresh then.
    fn follow(&mut self, zone: Option<Zone>, inputs: &Inputs) {
        if zone == Some(Zone::Up) {
            let enters = self.raw != zone;
            self.enabled_throughout = inputs.enable && (enters || self.enabled_throughout);
            self.early_top = (inputs.enable && !inputs.dynamic) || (!enters && self.early_top);
        }
        self.raw = zone;
    }

    /// An early Top counts as Top.
    fn published(&self) -> Option<Zone> {
        match self.raw {
            Some(Zone::Up) if self.early_top => Some(Zone::Top),
            raw => raw,
        }
    }
}
