//! Time that a condition has lasted.

/// Remembers the scan in which a condition began. Times are the scan's frozen millisecond; in the scan that starts a
/// timer the elapsed time is 0 (`dual-channel-inputs.md` 1.4, `muting-and-outputs.md` 1.2, `v14-and-metal-form.md` 1.1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Timer {
    start_ms: Option<i64>,
}

impl Timer {
    /// Starts anew in this scan.
    pub(crate) fn restart(&mut self, now_ms: i64) {
        self.start_ms = Some(now_ms);
    }

    /// Starts in this scan unless it runs already.
    pub(crate) fn start(&mut self, now_ms: i64) {
        self.start_ms.get_or_insert(now_ms);
    }

    /// Forgets the start.
    pub(crate) fn clear(&mut self) {
        self.start_ms = None;
    }

    /// Runs while `condition` holds, and is cleared when it does not.
    pub(crate) fn follow(&mut self, condition: bool, now_ms: i64) {
        if condition { self.start(now_ms) } else { self.clear() }
    }

    /// A limit "for T" of `v14-and-metal-form.md` 1.1 rule 2: whether `condition` has now lasted `limit_ms`, or ends in
    /// this scan after it lasted longer (scans were skipped).
    pub(crate) fn lasts(&mut self, condition: bool, now_ms: i64, limit_ms: i32) -> bool {
        let late = self.exceeded(now_ms, limit_ms);
        self.follow(condition, now_ms);
        late || self.reached(now_ms, limit_ms)
    }

    /// Whether it runs.
    pub(crate) fn runs(&self) -> bool {
        self.start_ms.is_some()
    }

    /// Milliseconds since the start; `None` while it does not run.
    pub(crate) fn elapsed_ms(&self, now_ms: i64) -> Option<i64> {
        self.start_ms.map(|start_ms| now_ms.saturating_sub(start_ms))
    }

    /// Whether it runs and at least `limit_ms` have elapsed.
    pub(crate) fn reached(&self, now_ms: i64, limit_ms: i32) -> bool {
        self.elapsed_ms(now_ms).is_some_and(|elapsed_ms| elapsed_ms >= i64::from(limit_ms))
    }

    /// Whether it runs and more than `limit_ms` have elapsed.
    pub(crate) fn exceeded(&self, now_ms: i64, limit_ms: i32) -> bool {
        self.elapsed_ms(now_ms).is_some_and(|elapsed_ms| elapsed_ms > i64::from(limit_ms))
    }
}
