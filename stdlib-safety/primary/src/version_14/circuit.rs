//! The two-channel state machine of DIN, RIN, ENPEND, ESTOP and LC. `v14-and-metal-form.md` 2.1.

use crate::edge::Edge;
use crate::timer::Limit;

/// What one scan reads.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs {
    /// Reset Type: 1 Manual, 0 Automatic. 2, H-DIN and H-RIN; the opposite of the version-17 family.
    pub(crate) manual: bool,
    /// Channel A is in its active state.
    pub(crate) a: bool,
    /// Channel B is in its active state.
    pub(crate) b: bool,
    pub(crate) circuit_reset: bool,
    pub(crate) fault_reset: bool,
    /// Keeps an O1 that is on while the channels are not active (LC, 3.1).
    pub(crate) hold: bool,
    /// T_INC: how long the channels may disagree.
    pub(crate) inconsistent_ms: i32,
}

/// Memory of a circuit; its default is the state before the first scan.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Circuit {
    alive: bool,
    pub(crate) o1: bool,
    /// CI: both channels must be seen safe together.
    pub(crate) cycle: bool,
    /// CRHO.
    pub(crate) reset_held: bool,
    /// II, and FP.
    pub(crate) inconsistent: bool,
    /// One channel left while the other stayed.
    partial: bool,
    split: Limit,
    both_before: bool,
    circuit_reset: Edge,
    fault_reset: Edge,
}

crate::bits!(Circuit {
    alive,
    o1,
    cycle,
    reset_held,
    inconsistent,
    partial,
    split,
    both_before,
    circuit_reset,
    fault_reset
});

impl Circuit {
    /// One scan with a true rung.
    pub(crate) fn scan(&mut self, inputs: &Inputs, now_ms: i64) {
        let circuit_reset = self.circuit_reset.rises(inputs.circuit_reset);
        let fault_reset = self.fault_reset.rises(inputs.fault_reset);
        let both = inputs.a && inputs.b;
        let none = !inputs.a && !inputs.b;
        let fault_before = self.inconsistent;
        self.supervise(both, none, fault_reset, inputs.inconsistent_ms, now_ms);
        // (d): a reset that rises in the scan in which the channels do counts as held.
        if !inputs.manual || !inputs.circuit_reset {
            self.reset_held = false;
        } else if both && !self.both_before {
            self.reset_held = true;
        }
        if self.cycle || self.inconsistent || !(both || (inputs.hold && self.o1)) {
            self.o1 = false;
        } else if !inputs.manual || (circuit_reset && self.both_before && !fault_before) {
            // (f): fault and circuit reset on one button need two presses.
            self.o1 = true;
        }
        self.both_before = both;
        self.alive = true;
    }

    /// The rows of 2.1 up to II, in their order.
    fn supervise(&mut self, both: bool, none: bool, fault_reset: bool, inconsistent_ms: i32, now_ms: i64) {
        let split = !both && !none;
        // (a): channels that are active when the instruction comes alive must be cycled.
        if !self.alive {
            self.cycle = !none;
        }
        let detected = self.split.breaks(split, now_ms, inconsistent_ms);
        if detected {
            // (b)
            self.inconsistent = true;
            self.cycle = true;
        } else if fault_reset && !split {
            self.inconsistent = false;
        }
        if none {
            self.cycle = false;
            self.partial = false;
        } else if split {
            self.partial |= self.both_before;
        } else if self.partial {
            // (c): one channel left and came back while the other stayed.
            self.cycle = true;
            self.partial = false;
        }
    }
}

/// An instruction that is a circuit with nothing else: its members and the memory of a call.
macro_rules! circuit_instruction {
    (
        $(#[$doc:meta])* $name:ident, $backing:path;
        channel_b_active: $channel_b_active:expr,
        inconsistent_ms: $inconsistent_ms:expr
    ) => {
        crate::members::members! {
            $backing;
            inputs {
                RESET_TYPE = "ResetType",
                CHANNEL_A = "ChannelA",
                CHANNEL_B = "ChannelB",
                CIRCUIT_RESET = "CircuitReset",
                FAULT_RESET = "FaultReset",
            }
            outputs { O1 = "O1", CI = "CI", CRHO = "CRHO", II = "II", FP = "FP" }
        }

        $(#[$doc])*
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct $name {
            circuit: $crate::version_14::circuit::Circuit,
        }

        $crate::bits!($name { circuit });

        impl $name {
            pub(crate) fn prescan(&mut self, members: &mut Members) {
                *self = $name::default();
                clear_outputs(members);
            }

            pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
                if !rung {
                    // A false rung is as prescan, a latched fault included (1.3).
                    self.prescan(members);
                    return;
                }
                let inputs = $crate::version_14::circuit::Inputs {
                    manual: members[RESET_TYPE] != 0,
                    a: members[CHANNEL_A] != 0,
                    b: (members[CHANNEL_B] != 0) == $channel_b_active,
                    circuit_reset: members[CIRCUIT_RESET] != 0,
                    fault_reset: members[FAULT_RESET] != 0,
                    hold: false,
                    inconsistent_ms: $inconsistent_ms,
                };
                self.circuit.scan(&inputs, now_ms);
                members[O1] = i32::from(self.circuit.o1);
                members[CI] = i32::from(self.circuit.cycle);
                members[CRHO] = i32::from(self.circuit.reset_held);
                members[II] = i32::from(self.circuit.inconsistent);
                members[FP] = i32::from(self.circuit.inconsistent);
            }
        }
    };
}

pub(crate) use circuit_instruction;
