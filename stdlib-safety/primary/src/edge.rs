//! Rising edges of inputs.

/// The memory of an edge-sensitive input. It starts as ON, and is set ON again by prescan and by a false rung, so that
/// an input that is on when the instruction comes alive is no edge (`dual-channel-inputs.md` D6,
/// `muting-and-outputs.md` 1.2 rule 5, `v14-and-metal-form.md` 1.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edge {
    previous: bool,
}

crate::bits!(Edge { previous });

impl Default for Edge {
    fn default() -> Self {
        Edge { previous: true }
    }
}

impl Edge {
    /// A memory that starts as OFF: an input that is on when the instruction comes alive is an edge.
    pub(crate) fn from_off() -> Edge {
        Edge { previous: false }
    }

    /// Samples the input: whether it went from 0 to 1 since the last sample.
    pub(crate) fn rises(&mut self, input: bool) -> bool {
        let rises = input && !self.previous;
        self.previous = input;
        rises
    }
}
