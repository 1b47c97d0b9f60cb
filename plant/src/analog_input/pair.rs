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
