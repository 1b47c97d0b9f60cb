//! Two inputs that the module evaluates together. 1734-UM013, Dual-channel Mode and Discrepancy Time; Configure the Safety
//! Digital Inputs.

use crate::settings::PointSettings;

/// The evaluation of a pair.
#[derive(Debug, Clone)]
pub struct Pair {
    complementary: bool,
    /// Longest discrepancy in ms; 0 is without end.
    discrepancy_ms: u64,
    discrepant_since_ms: Option<u64>,
    safe: bool,
    active: bool,
    /// A channel has left the active state, and the pair was not in the safe state since: the inputs must be cycled.
    to_be_cycled: bool,
}

impl Pair {
    /// As the even point of the pair is configured; nothing where it is an input alone.
    pub fn new(even: &PointSettings) -> Option<Pair> {
        let complementary = even.has("Type", "COMPLEMENTARY");
        (complementary || even.has("Type", "EQUIVALENT")).then(|| Pair {
            complementary,
            discrepancy_ms: even.milliseconds("DiscrepancyTime", 0),
            discrepant_since_ms: None,
            safe: true,
            active: false,
            to_be_cycled: false,
        })
    }

    /// As new.
    pub fn power_up(&mut self) {
        self.discrepant_since_ms = None;
        self.safe = true;
        self.active = false;
        self.to_be_cycled = false;
    }

    /// Whether the channels are opposite to each other when all is well.
    pub fn is_complementary(&self) -> bool {
        self.complementary
    }

    /// The states of the even and of the odd input at a time in ms.
    pub fn look(&mut self, now_ms: u64, even: bool, odd: bool) {
        let odd = odd != self.complementary;
        self.safe = !even && !odd;
        if even == odd {
            self.discrepant_since_ms = None;
            if self.safe {
                self.to_be_cycled = false;
            }
            self.active = even && !self.to_be_cycled;
        } else {
            self.discrepant_since_ms.get_or_insert(now_ms);
            self.to_be_cycled |= self.active;
            self.active = false;
        }
    }

    /// Whether both channels are active, and have been cycled where they had to be.
    pub fn is_active(&self) -> bool {
        self.active
    }

    /// Whether both channels are in the safe state.
    pub fn is_safe(&self) -> bool {
        self.safe
    }

    /// Whether the channels have differed for longer than the discrepancy time.
    pub fn is_discrepant_too_long(&self, now_ms: u64) -> bool {
        self.discrepancy_ms != 0
            && self.discrepant_since_ms.is_some_and(|since| now_ms.saturating_sub(since) > self.discrepancy_ms)
    }
}
