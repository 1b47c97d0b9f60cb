//! The plausibility of time: what a scan is told against another source, and against the scan before it.

/// What another source of time says at the start of a scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reference {
    /// Its time in ms, from any origin.
    pub ms: i64,
    /// How far the two sources may have gone apart since the first scan, in ms: 0 for two counts of one period.
    pub tolerance_ms: i64,
}

/// What is wrong with the time that a scan was told.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TimeFault {
    /// It is before that of the scan before.
    Backwards,
    /// It has gone on further than the other source allows.
    Fast,
    /// It has gone on less than the other source demands; a clock that stands is one of these.
    Slow,
}

/// One half's memory of the time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TimeCheck {
    last_ms: i64,
    /// What the two sources were apart at the first scan; `None` before it.
    apart_ms: Option<i64>,
}

impl TimeCheck {
    pub(crate) const fn new() -> TimeCheck {
        TimeCheck { last_ms: i64::MIN, apart_ms: None }
    }

    /// Judges the time of a scan. Without another source it must not run backwards.
    pub(crate) fn judge(&mut self, now_ms: i64, reference: Option<Reference>) -> Option<TimeFault> {
        let backwards = (now_ms < self.last_ms).then_some(TimeFault::Backwards);
        self.last_ms = now_ms;
        backwards.or_else(|| self.against(now_ms, reference?))
    }

    fn against(&mut self, now_ms: i64, reference: Reference) -> Option<TimeFault> {
        let apart_ms = now_ms.saturating_sub(reference.ms);
        let drift_ms = apart_ms.saturating_sub(*self.apart_ms.get_or_insert(apart_ms));
        if drift_ms > reference.tolerance_ms {
            Some(TimeFault::Fast)
        } else if drift_ms < reference.tolerance_ms.saturating_neg() {
            Some(TimeFault::Slow)
        } else {
            None
        }
    }

    /// For fault injection.
    #[cfg(feature = "injection")]
    pub(crate) fn visit_bits(&mut self, visitor: &mut twinrung_bytecode::injection::BitVisitor) {
        visitor.field(&mut self.last_ms);
        if let Some(apart_ms) = &mut self.apart_ms {
            visitor.field(apart_ms);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(times: &[(i64, i64)], tolerance_ms: i64) -> Option<TimeFault> {
        let mut check = TimeCheck::new();
        times.iter().find_map(|(now_ms, ms)| check.judge(*now_ms, Some(Reference { ms: *ms, tolerance_ms })))
    }

    /// REQ-SCAN-015
    #[test]
    fn time_when_both_sources_go_on_alike_then_it_is_plausible() {
        assert_eq!(judged(&[(1000, 0), (1020, 20), (1040, 40)], 0), None);
        assert_eq!(judged(&[(1000, 0), (1030, 20), (1030, 40)], 10), None);
    }

    /// REQ-SCAN-015
    #[test]
    fn time_when_it_runs_fast_slow_or_stands_then_that_is_said() {
        assert_eq!(judged(&[(0, 0), (20, 20), (41, 40)], 0), Some(TimeFault::Fast));
        assert_eq!(judged(&[(0, 0), (20, 20), (39, 40)], 0), Some(TimeFault::Slow));
        assert_eq!(judged(&[(0, 0), (20, 20), (20, 40)], 0), Some(TimeFault::Slow));
        assert_eq!(judged(&[(0, 0), (20, 20), (51, 40)], 10), Some(TimeFault::Fast));
        assert_eq!(judged(&[(0, 0), (20, 20), (29, 40)], 10), Some(TimeFault::Slow));
    }

    /// REQ-SCAN-015
    #[test]
    fn time_when_it_runs_backwards_then_that_is_said_without_another_source_too() {
        let mut check = TimeCheck::new();
        assert_eq!(check.judge(20, None), None);
        assert_eq!(check.judge(20, None), None);
        assert_eq!(check.judge(19, None), Some(TimeFault::Backwards));
    }
}
