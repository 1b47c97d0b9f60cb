//! Controller modes. A change takes more than one period and less than two: a request that arrives between two scans acts
//! at the second scan boundary after it (1756-RM093F p. 49).

/// Whether logic executes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Logic does not execute; outputs are off.
    Program,
    /// Logic executes.
    Run,
}

/// A mode change that was asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModeRequest {
    /// The mode asked for.
    pub mode: Mode,
    /// Scan boundaries that must still pass before it acts.
    pub boundaries_left: u8,
}

impl ModeRequest {
    pub(crate) const fn new(mode: Mode) -> ModeRequest {
        ModeRequest { mode, boundaries_left: 2 }
    }

    /// A scan boundary passes; the mode to take on, when it is time.
    pub(crate) const fn boundary(&mut self) -> Option<Mode> {
        self.boundaries_left = self.boundaries_left.saturating_sub(1);
        if self.boundaries_left == 0 { Some(self.mode) } else { None }
    }
}
