//! The fault latch of the metal-form instructions. `v14-and-metal-form.md` 1.6.

use crate::codes::{INPUT_STATUS, NONE, OUTPUT_STATUS, RESET_HELD};
use crate::edge::Edge;

/// What the latch reads in every scan.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Status {
    pub(crate) input: bool,
    /// True for an instruction that has no Output Status.
    pub(crate) output: bool,
    pub(crate) reset: bool,
}

impl Status {
    pub(crate) fn good(&self) -> bool {
        self.input && self.output
    }
}

/// Memory of the latch; its default is the state before the first scan.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct FaultLatch {
    /// Code of the first fault, 0 without one.
    pub(crate) fault: i32,
    reset: Edge,
    reset_rises: bool,
    input_before: bool,
    output_before: bool,
}

crate::bits!(FaultLatch { fault, reset, reset_rises, input_before, output_before });

impl FaultLatch {
    /// Samples the inputs; gives the fault of a status that went from 1 to 0, or 0 (1.6 rule 3).
    pub(crate) fn begin(&mut self, status: &Status) -> i32 {
        self.reset_rises = self.reset.rises(status.reset);
        let fault = if self.input_before && !status.input {
            INPUT_STATUS
        } else if self.output_before && !status.output {
            OUTPUT_STATUS
        } else {
            NONE
        };
        self.input_before = status.input;
        self.output_before = status.output;
        fault
    }

    /// Latches the first fault, or clears the one latched before this scan by an edge of Reset when its cause is gone
    /// (1.6 rules 1 and 2); a fault of this very scan outlives that Reset (1.7). Whether the one latched before was
    /// cleared.
    pub(crate) fn settle(&mut self, new_fault: i32, cause_gone: bool) -> bool {
        if self.fault == NONE {
            self.fault = new_fault;
            return false;
        }
        let clears = self.reset_rises && cause_gone;
        if clears {
            self.fault = new_fault;
        }
        clears
    }

    /// DiagnosticCode (1.6 rule 4); `own` is the instruction's, shown last and without a fault only.
    pub(crate) fn diagnostic(&self, status: &Status, cause_gone: bool, own: i32) -> i32 {
        if !status.input {
            INPUT_STATUS
        } else if !status.output {
            OUTPUT_STATUS
        } else if self.fault == NONE {
            own
        } else if cause_gone && status.reset && !self.reset_rises {
            RESET_HELD
        } else {
            NONE
        }
    }
}
