//! DCAF, Dual Channel Analog Input of REAL values. `muting-and-outputs.md` 8.

use super::pair::{Reading, analog_instruction};
use twinrung_catalog::types::safety::analog::DCAF_INPUT;

analog_instruction! {
    /// Memory of a DCAF call.
    Dcaf, DCAF_INPUT
}

/// The arithmetic of 8.3 for REAL. Every f32 is an f64, so that each comparison with a limit is exact. Comparisons are
/// written positively: a value that is no number fails them.
fn reading(members: &Members) -> Reading {
    let real = |member: i32| f64::from(f32::from_bits(member.cast_unsigned()));
    let (a, b) = (real(members[CHANNEL_A]), real(members[CHANNEL_B]));
    let (tolerance, high, low) = (real(members[TOLERANCE]), real(members[HIGH_LIMIT]), real(members[LOW_LIMIT]));
    let finite = a.is_finite() && b.is_finite();
    Reading {
        usable: tolerance.is_finite() && high.is_finite() && low.is_finite() && tolerance >= 0.0 && low <= high,
        finite,
        in_range: finite && low <= a && a <= high && low <= b && b <= high,
        agree: finite && within(a, b, tolerance),
        above: !finite || a > high || b > high,
        below: !finite || a < low || b < low,
    }
}

/// Whether `|a - b| <= tolerance` holds for the numbers themselves: the rounding of the difference is made good by its
/// error term (two-sum), which decides where the rounded difference equals the tolerance.
fn within(a: f64, b: f64, tolerance: f64) -> bool {
    let (greater, less) = if a >= b { (a, b) } else { (b, a) };
    let difference = greater - less;
    let part = difference - greater;
    let error = (greater - (difference - part)) + (-less - part);
    difference < tolerance || (difference == tolerance && error <= 0.0)
}
