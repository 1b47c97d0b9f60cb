//! The pair evaluator: two channels that must agree within the discrepancy time. `dual-channel-inputs.md` 3.

use crate::codes::NONE;
use crate::timer::Timer;

/// Fault: inconsistent for the discrepancy time, A active and B safe. dual-channel-inputs.md 1.9, recalled-high.
pub(crate) const DISCREPANCY_A_ACTIVE: i32 = 0x4000;
/// Fault: inconsistent for the discrepancy time, A safe and B active. dual-channel-inputs.md 1.9, recalled-high.
pub(crate) const DISCREPANCY_B_ACTIVE: i32 = 0x4001;
/// Fault: A went safe and came back while B stayed active. dual-channel-inputs.md 1.9, recalled-high.
pub(crate) const CYCLE_A: i32 = 0x4002;
/// Fault: B went safe and came back while A stayed active. dual-channel-inputs.md 1.9, recalled-high.
pub(crate) const CYCLE_B: i32 = 0x4003;

/// Input Type: active is A 0, B 0. dual-channel-inputs.md 1.3.
const EQUIVALENT_ACTIVE_LOW: i32 = 1;
/// Input Type: active is A 1, B 0. dual-channel-inputs.md 1.3.
const COMPLEMENTARY: i32 = 2;

/// What the two channels say together in one scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Consistency {
    /// Both in the safe state.
    Safe,
    /// Both in the active state.
    Active,
    /// One in each.
    Discrepant,
}

/// The channel that was active when a discrepancy began.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum First {
    A,
    B,
}

crate::bits!(
    enum First {
        A,
        B,
    }
);

/// The two channels, each as "in its active state".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Channels {
    pub(crate) a: bool,
    pub(crate) b: bool,
}

impl Channels {
    /// Reads the raw channels by Input Type: 0 and every value not listed is EQUIVALENT - ACTIVE HIGH.
    pub(crate) fn read(input_type: i32, a: bool, b: bool) -> Channels {
        match input_type {
            EQUIVALENT_ACTIVE_LOW => Channels { a: !a, b: !b },
            COMPLEMENTARY => Channels { a, b: !b },
            _ => Channels { a, b },
        }
    }
}

/// Memory of the pair evaluator. Its default is the state after `clear()` of the reference.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Pair {
    /// Whether the last consistent state was ACTIVE. SAFE and "none yet" need not be told apart: neither begins a
    /// one-channel cycle.
    from_active: bool,
    /// The discrepancy that lasts: when it began, and the channel that was active then.
    discrepancy: Timer,
    first: Option<First>,
}

crate::bits!(Pair { from_active, discrepancy, first });

impl Pair {
    /// `eval(a, b, now, DT)`: the pair's state, and a channel fault or 0.
    pub(crate) fn evaluate(&mut self, channels: Channels, now_ms: i64, discrepancy_ms: i32) -> (Consistency, i32) {
        let Channels { a, b } = channels;
        let discrepant = a != b;
        let fault = match self.first {
            Some(first) => self.judge(first, channels, now_ms, discrepancy_ms),
            None => NONE,
        };
        if discrepant {
            self.discrepancy.start(now_ms);
            self.first.get_or_insert(if a { First::A } else { First::B });
            return (Consistency::Discrepant, fault);
        }
        self.discrepancy.clear();
        self.first = None;
        self.from_active = a;
        (if a { Consistency::Active } else { Consistency::Safe }, fault)
    }

    /// The fault of a discrepancy that was there before this scan.
    fn judge(&self, first: First, Channels { a, b }: Channels, now_ms: i64, discrepancy_ms: i32) -> i32 {
        let discrepant = a != b;
        let first_is_a = first == First::A;
        if discrepant && self.discrepancy.reached(now_ms, discrepancy_ms) {
            return if a { DISCREPANCY_A_ACTIVE } else { DISCREPANCY_B_ACTIVE };
        }
        // Decided D4: lateness is judged also when the pair is found consistent again.
        if !discrepant && self.discrepancy.exceeded(now_ms, discrepancy_ms) {
            return if first_is_a { DISCREPANCY_A_ACTIVE } else { DISCREPANCY_B_ACTIVE };
        }
        // The dropped channel is back, alone or by swapping with the other one.
        let returned = (a && b) || (discrepant && first_is_a != a);
        if self.from_active && returned {
            return if first_is_a { CYCLE_B } else { CYCLE_A };
        }
        NONE
    }
}
