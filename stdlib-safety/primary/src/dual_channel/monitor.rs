//! What DCM and DCSRT share: Input Status, the pair, and faults that only Reset clears. `dual-channel-inputs.md` 8A.4.

use super::pair::{Channels, Consistency, Pair};
use crate::codes::{INPUT_STATUS, NONE};
use crate::edge::Edge;

/// What both read in every scan.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs {
    pub(crate) input_type: i32,
    pub(crate) discrepancy_ms: i32,
    pub(crate) channel_a: bool,
    pub(crate) channel_b: bool,
    pub(crate) input_status: bool,
    pub(crate) reset: bool,
}

/// Memory of both; its default is the state after prescan.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Monitor {
    pair: Pair,
    reset: Edge,
    /// The latched fault code, 0 without one.
    pub(crate) fault: i32,
    /// Both channels were seen safe since the last channel fault (`cyc`).
    cycled: bool,
    /// Input Status was valid.
    valid: bool,
}

crate::bits!(Monitor { pair, reset, fault, cycled, valid });

impl Monitor {
    /// Rung false: a latched fault is kept (decided D13).
    pub(crate) fn rung_false(&mut self, input_status: bool) {
        self.pair = Pair::default();
        self.reset = Edge::default();
        self.valid &= input_status;
    }

    /// The pair's state; `None` while Input Status is OFF.
    pub(crate) fn evaluate(&mut self, inputs: &Inputs, now_ms: i64) -> Option<Consistency> {
        let rise = self.reset.rises(inputs.reset);
        if !inputs.input_status {
            self.pair = Pair::default();
            if self.valid && self.fault == NONE {
                self.fault = INPUT_STATUS;
            }
            self.valid = false;
            return None;
        }
        self.valid = true;
        let channels = Channels::read(inputs.input_type, inputs.channel_a, inputs.channel_b);
        let (pair, channel_fault) = self.pair.evaluate(channels, now_ms, inputs.discrepancy_ms);
        self.cycled |= pair == Consistency::Safe;
        self.cycled &= channel_fault == NONE;
        if self.fault == NONE {
            self.fault = channel_fault;
        } else if rise && (self.fault == INPUT_STATUS || (self.cycled && pair != Consistency::Discrepant)) {
            self.fault = NONE;
        }
        Some(pair)
    }
}
