//! Time that a condition has lasted.

/// Remembers the scan in which a condition began. Times are the scan's frozen millisecond; in the scan that starts a
/// timer the elapsed time is 0 (`dual-channel-inputs.md` 1.4, `muting-and-outputs.md` 1.2, `v14-and-metal-form.md` 1.1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Timer {
    start_ms: Option<i64>,
}

crate::bits!(Timer { start_ms });

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

/// A limit "for T" of `v14-and-metal-form.md` 1.1 rule 2. It is broken once for each time that the condition holds
/// without a break: the scan in which a condition ends breaks it only when no scan before did.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Limit {
    since: Timer,
    /// A scan since the condition began has broken it.
    broken: bool,
}

crate::bits!(Limit { since, broken });

impl Limit {
    /// Whether `condition` has now lasted `limit_ms`, or ends in this scan after it lasted longer unnoticed (scans
    /// were skipped).
    pub(crate) fn breaks(&mut self, condition: bool, now_ms: i64, limit_ms: i32) -> bool {
        let ends_late = !self.broken && self.since.exceeded(now_ms, limit_ms);
        self.since.follow(condition, now_ms);
        let lasts = self.since.reached(now_ms, limit_ms);
        self.broken = lasts;
        ends_late || lasts
    }
}

#[cfg(test)]
mod tests {
    use super::Limit;

    const LIMIT_MS: i32 = 500;

    /// One answer for each scan, given as its time and the condition in it.
    fn breaks<const SCANS: usize>(scans: [(i64, bool); SCANS]) -> [bool; SCANS] {
        let mut limit = Limit::default();
        scans.map(|(now_ms, condition)| limit.breaks(condition, now_ms, LIMIT_MS))
    }

    #[test]
    fn limit_when_the_condition_ends_after_a_break_that_was_seen_then_it_is_not_broken_again() {
        assert_eq!(breaks([(0, true), (500, true), (600, false)]), [false, true, false]);
    }

    #[test]
    fn limit_when_scans_are_skipped_past_it_then_the_end_of_the_condition_breaks_it() {
        assert_eq!(breaks([(0, true), (501, false), (600, false)]), [false, true, false]);
    }

    #[test]
    fn limit_when_the_condition_ends_exactly_at_it_then_it_is_not_broken() {
        assert_eq!(breaks([(0, true), (500, false)]), [false, false]);
    }

    #[test]
    fn limit_when_the_condition_comes_again_after_a_break_then_the_time_starts_anew() {
        let scans = [(0, true), (500, true), (600, false), (700, true), (1199, true), (1201, false)];
        assert_eq!(breaks(scans), [false, true, false, false, false, true]);
    }
}
