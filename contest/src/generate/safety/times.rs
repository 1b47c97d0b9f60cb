//! How long something lasts: the times of the configuration and those of the reference, a scan less, exactly, a scan more.

use twinrung_catalog::OperandKind;

use super::call::{Call, Given};
use crate::generate::Random;

/// Times in ms that the references name and no operand shows: reset pulses, restart delays, the discrepancies of the
/// version-14 set, lamp tests, two-hand buttons.
const NAMED_MS: &[i64] = &[50, 100, 250, 500, 1_000, 2_000, 3_000, 5_000, 30_000];

/// The durations that matter to one call.
#[derive(Debug, Clone)]
pub struct Times {
    period_ms: i64,
    configured_ms: Vec<i64>,
}

impl Times {
    /// Those of a call that is scanned with this period.
    pub fn new(call: &Call, period_ms: i64) -> Times {
        let time = |(index, given): (usize, &Given)| {
            let Given::Literal(value) = *given else { return None };
            match call.kind(index) {
                OperandKind::Literal { unit: "ms", .. } | OperandKind::SafetyInteger { unit: "ms", .. } => {
                    Some(i64::from(value))
                }
                OperandKind::Literal { unit: "s", .. } => Some(i64::from(value) * 1_000),
                _ => None,
            }
        };
        let configured_ms = call.operands.iter().enumerate().filter_map(time).filter(|time| *time > 0).collect();
        Times { period_ms, configured_ms }
    }

    /// The times of the configuration, in ms.
    pub fn configured_ms(&self) -> &[i64] {
        &self.configured_ms
    }

    /// A duration of at least one scan.
    pub fn hold_ms(&self, random: &mut Random) -> i64 {
        let near = |random: &mut Random, time: i64| time + (random.below(5) as i64 - 2) * self.period_ms;
        let chosen = match random.below(10) {
            0..=2 => random.between(1, 6) as i64 * self.period_ms,
            3..=4 => random.between(5, 60) as i64 * self.period_ms,
            5..=7 if !self.configured_ms.is_empty() => {
                let time = *random.of(&self.configured_ms);
                if random.percent(25) { near(random, time / 2) } else { near(random, time) }
            }
            _ => {
                let time = *random.of(NAMED_MS);
                near(random, time)
            }
        };
        // Nothing is learned from a hold of an hour that a hundred scans do not teach, once in a while aside.
        let longest = self.period_ms * if random.one_in(30) { 2_000 } else { 300 };
        chosen.clamp(self.period_ms, longest)
    }

    /// How much later than its partner a channel changes: often not at all.
    pub fn skew_ms(&self, random: &mut Random) -> i64 {
        match random.below(10) {
            0..=4 => 0,
            5..=6 => self.period_ms * random.between(1, 3) as i64,
            _ => self.hold_ms(random),
        }
    }
}
