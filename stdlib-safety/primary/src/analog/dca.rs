//! DCA, Dual Channel Analog Input of DINT values. `muting-and-outputs.md` 8.

use super::pair::{Reading, analog_instruction};
use twinrung_catalog::types::safety::analog::DCA_INPUT;

analog_instruction! {
    /// Memory of a DCA call.
    Dca, DCA_INPUT
}

/// The arithmetic of 8.3 for DINT: exact.
fn reading(members: &Members) -> Reading {
    let (a, b) = (members[CHANNEL_A], members[CHANNEL_B]);
    let (tolerance, high, low) = (members[TOLERANCE], members[HIGH_LIMIT], members[LOW_LIMIT]);
    Reading {
        usable: tolerance >= 0 && low <= high,
        finite: true,
        in_range: low <= a && a <= high && low <= b && b <= high,
        agree: i64::from(a.abs_diff(b)) <= i64::from(tolerance),
        above: a > high || b > high,
        below: a < low || b < low,
    }
}
