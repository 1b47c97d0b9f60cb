//! Two channels that the module compares. 1734-UM013, Dual-channel Equivalent Mode; Figure 14.

use crate::settings::PointSettings;

/// The comparison of a pair.
#[derive(Debug, Clone)]
pub struct Pair {
    /// How long the channels may differ, and must agree again, ms; 0 is without end.
    discrepancy_ms: u64,
    /// By how much they may differ, in engineering units.
    deadband: i32,
    /// Added to the second channel before they are compared.
    offset: i32,
    faulted: bool,
    /// Since when the comparison says the opposite of what is shown, ms.
    since_ms: Option<u64>,
}

impl Pair {
    /// As the even channel is configured; nothing where it is a channel alone. What the even one does not set is taken from the
    /// odd one (decided).
    pub fn new(even: &PointSettings, odd: &PointSettings) -> Option<Pair> {
        let number = |key: &str, default: i64| even.number(key).or_else(|| odd.number(key)).unwrap_or(default);
        let small = |key: &str| i32::try_from(number(key, 0)).unwrap_or_default();
        even.has("Type", "EQUIVALENT").then(|| Pair {
            // Table 21.
            discrepancy_ms: u64::try_from(number("DiscrepancyTime", 100)).unwrap_or_default(),
            deadband: small("DiscrepancyDeadband"),
            offset: small("ChannelOffset"),
            faulted: false,
            since_ms: None,
        })
    }

    /// As new.
    pub fn power_up(&mut self) {
        self.faulted = false;
        self.since_ms = None;
    }

    /// The values of both channels at a time in ms; whether a discrepancy fault is shown. It comes when they have differed by more
    /// than the deadband for longer than the discrepancy time, and goes when they have agreed for the discrepancy time.
    pub fn look(&mut self, now_ms: u64, even: i32, odd: i32) -> bool {
        let difference = i64::from(even) - (i64::from(odd) + i64::from(self.offset));
        let differs = difference.abs() > i64::from(self.deadband);
        if differs == self.faulted || self.discrepancy_ms == 0 {
            self.since_ms = None;
            return self.faulted;
        }
        let for_ms = now_ms.saturating_sub(*self.since_ms.get_or_insert(now_ms));
        if for_ms > self.discrepancy_ms || (self.faulted && for_ms == self.discrepancy_ms) {
            self.faulted = differs;
            self.since_ms = None;
        }
        self.faulted
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// For longer than the time it must differ, and for the time agree. Figure 14; REQ-PLANT-044
    #[test]
    fn pair_when_it_differs_and_agrees_then_the_fault_comes_after_the_time_and_goes_with_it() {
        let settings = PointSettings::new([("Type", "EQUIVALENT"), ("DiscrepancyTime", "100")]);
        let mut pair = Pair::new(&settings, &PointSettings::default()).unwrap();
        let mut shown =
            |range: std::ops::Range<u64>, odd: i32| range.filter(|now_ms| pair.look(*now_ms, 0, odd)).count();
        // Differs from 0 ms on: the fault is there from 101 ms on.
        assert_eq!((shown(0..101, 1), shown(101..200, 1)), (0, 99));
        // Agrees from 200 ms on: it is gone at 300 ms.
        assert_eq!((shown(200..300, 0), shown(300..400, 0)), (100, 0));
    }
}
