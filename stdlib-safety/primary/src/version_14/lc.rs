//! LC, Light Curtain. `v14-and-metal-form.md` 3.1.

use super::circuit::{Circuit, Inputs};
use crate::members::members;
use crate::timer::Timer;
use core::ops::RangeInclusive;
use twinrung_catalog::types::safety::version_14::LIGHT_CURTAIN;

members! {
    LIGHT_CURTAIN;
    inputs {
        RESET_TYPE = "ResetType",
        CHANNEL_A = "ChannelA",
        CHANNEL_B = "ChannelB",
        INPUT_FILTER_TIME = "InputFilterTime",
        MUTE_LIGHT_CURTAIN = "MuteLightCurtain",
        CIRCUIT_RESET = "CircuitReset",
        FAULT_RESET = "FaultReset",
    }
    outputs { O1 = "O1", CI = "CI", CRHO = "CRHO", LCB = "LCB", LCM = "LCM", II = "II", FP = "FP" }
}

/// T_INC. 3.1, recalled 85 %.
const INCONSISTENT_MS: i32 = 500;
/// Input Filter Time; a value outside counts as 0. 3.1, recalled 75 %.
const FILTER_RANGE_MS: RangeInclusive<i32> = 0..=250;

/// Holds the falling side of a channel: low pulses are filtered, a rise is not (3.1, form decided).
#[derive(Clone, Debug, Default, PartialEq)]
struct Filter {
    output: bool,
    low: Timer,
}

crate::bits!(Filter { output, low });

impl Filter {
    fn follow(&mut self, raw: bool, filter_ms: i32, now_ms: i64) -> bool {
        self.low.follow(!raw, now_ms);
        self.output = raw || (self.output && !self.low.reached(now_ms, filter_ms));
        self.output
    }
}

/// Memory of an LC call.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lc {
    circuit: Circuit,
    filter_a: Filter,
    filter_b: Filter,
}

crate::bits!(Lc { circuit, filter_a, filter_b });

impl Lc {
    pub(crate) fn prescan(&mut self, members: &mut Members) {
        *self = Lc::default();
        clear_outputs(members);
    }

    pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
        if !rung {
            // A false rung is as prescan, a latched fault included (1.3).
            self.prescan(members);
            return;
        }
        let time_ms = members[INPUT_FILTER_TIME];
        let filter_ms = if FILTER_RANGE_MS.contains(&time_ms) { time_ms } else { 0 };
        let a = self.filter_a.follow(members[CHANNEL_A] != 0, filter_ms, now_ms);
        let b = self.filter_b.follow(members[CHANNEL_B] != 0, filter_ms, now_ms);
        let muted = members[MUTE_LIGHT_CURTAIN] != 0;
        let inputs = Inputs {
            manual: members[RESET_TYPE] != 0,
            a,
            b,
            circuit_reset: members[CIRCUIT_RESET] != 0,
            fault_reset: members[FAULT_RESET] != 0,
            // Muting keeps O1 on; it never turns it on (decided).
            hold: muted,
            inconsistent_ms: INCONSISTENT_MS,
        };
        self.circuit.scan(&inputs, now_ms);
        members[O1] = i32::from(self.circuit.o1);
        members[CI] = i32::from(self.circuit.cycle);
        members[CRHO] = i32::from(self.circuit.reset_held);
        members[LCB] = i32::from(!(a && b));
        members[LCM] = i32::from(muted);
        members[II] = i32::from(self.circuit.inconsistent);
        members[FP] = i32::from(self.circuit.inconsistent);
    }
}
