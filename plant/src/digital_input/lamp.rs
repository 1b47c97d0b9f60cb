//! The test of a muting lamp. 1734-UM013, Muting Lamp Operation; Figure 21; Table 4.

/// From one lamp test to the next, ms. Tests are counted from power-up, not from switching on.
pub const TEST_INTERVAL_MS: u64 = 3000;
/// Failed tests in a row that make a lamp burnt out.
const FAILURES: u8 = 2;

/// A lamp on a test output, as the module sees it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MutingLamp {
    failures: u8,
    good: bool,
}

impl MutingLamp {
    /// A lamp that is not known to be burnt out: so the status begins, that no muting instruction faults by mistake.
    pub fn new() -> MutingLamp {
        MutingLamp { failures: 0, good: true }
    }

    /// The muting status bit: 1 where the lamp is good.
    pub fn status(&self) -> bool {
        self.good
    }

    /// There is no field power: nothing is tested, and tests that failed before do not count.
    pub fn rest(&mut self) {
        self.failures = 0;
    }

    /// A ms, counted from power-up. A lamp that is on is tested; of one that is off only that it was replaced is seen, which the
    /// manual says is seen in either state. Tests that failed before it was switched off do not count (decided).
    pub fn step(&mut self, since_power_up_ms: u64, on: bool, broken: bool) {
        if !on {
            self.failures = 0;
        }
        if since_power_up_ms == 0 || !since_power_up_ms.is_multiple_of(TEST_INTERVAL_MS) {
            return;
        }
        if !broken {
            self.failures = 0;
            self.good = true;
        } else if on {
            self.failures = self.failures.saturating_add(1);
            self.good &= self.failures < FAILURES;
        }
    }
}
