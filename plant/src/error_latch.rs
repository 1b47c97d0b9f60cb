//! The error latch time: an error stays shown for some time after its cause is gone, so that the controller sees it.

/// An error that is shown.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ErrorLatch {
    /// For how long after the cause is gone, in ms. (1756-RM093, Input and Output Diagnostics: counted from the repair.)
    latch_ms: u64,
    /// Until when it is shown at least.
    until_ms: Option<u64>,
}

impl ErrorLatch {
    /// No error.
    pub fn new(latch_ms: u64) -> ErrorLatch {
        ErrorLatch { latch_ms, until_ms: None }
    }

    /// No error any more, as at power-up.
    pub fn power_up(&mut self) {
        self.until_ms = None;
    }

    /// Whether an error is shown.
    pub fn is_set(&self) -> bool {
        self.until_ms.is_some()
    }

    /// The cause is there.
    pub fn seen(&mut self, now_ms: u64) {
        self.seen_for(now_ms, self.latch_ms);
    }

    /// A cause is there whose error stays for a time of its own, in ms; an error that stays longer is not shortened.
    pub fn seen_for(&mut self, now_ms: u64, latch_ms: u64) {
        self.until_ms = self.until_ms.max(Some(now_ms.saturating_add(latch_ms)));
    }

    /// For how long an error stays, in ms.
    pub fn latch_ms(&self) -> u64 {
        self.latch_ms
    }

    /// The cause is not there: the error goes when its time has run out and `may_clear` holds.
    pub fn gone(&mut self, now_ms: u64, may_clear: bool) {
        if may_clear && self.until_ms.is_some_and(|until| now_ms >= until) {
            self.until_ms = None;
        }
    }
}
