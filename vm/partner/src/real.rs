//! REAL without a library: rounding to integers, square root, remainder. binary32, nearest even, one NaN.
//! general-instructions.md 2.2, A.9.

/// The bits of every NaN that an instruction stores.
pub(crate) const NAN: u32 = 0x7FC0_0000;

const FRACTION_BITS: u32 = 23;
const FRACTION: u32 = (1 << FRACTION_BITS) - 1;
const HIDDEN: u32 = 1 << FRACTION_BITS;
const SIGN: u32 = 1 << 31;
/// Exponent field of infinities and NaNs.
const SPECIAL: u32 = 0xFF;
/// What the exponent field counts beyond, for a mantissa read as an integer.
const BIAS: i32 = 150;

/// The bits of a result, every NaN in its one form.
pub(crate) fn canonical(bits: u32) -> u32 {
    if bits & !SIGN > SPECIAL << FRACTION_BITS { NAN } else { bits }
}

/// A finite magnitude as `mantissa * 2^exponent`.
fn parts(bits: u32) -> (u32, i32) {
    let field = (bits >> FRACTION_BITS) & SPECIAL;
    let fraction = bits & FRACTION;
    let mantissa = if field == 0 { fraction } else { fraction | HIDDEN };
    (mantissa, (field.max(1) as i32).wrapping_sub(BIAS))
}

fn is_special(bits: u32) -> bool {
    (bits >> FRACTION_BITS) & SPECIAL == SPECIAL
}

/// The nearest integer, ties to even; `None` for NaN, infinities and magnitudes from 2^63 on.
pub(crate) fn nearest_integer(value: f32) -> Option<i64> {
    let bits = value.to_bits();
    if is_special(bits) {
        return None;
    }
    let (mantissa, exponent) = parts(bits);
    let mantissa = u64::from(mantissa);
    let magnitude = if exponent >= 0 {
        if exponent >= 40 {
            return None;
        }
        mantissa << exponent
    } else {
        let shift = exponent.unsigned_abs();
        if shift > 25 {
            0
        } else {
            let whole = mantissa >> shift;
            let rest = mantissa & (1u64 << shift).wrapping_sub(1);
            let half = 1u64 << (shift.wrapping_sub(1));
            let up = rest > half || (rest == half && whole & 1 == 1);
            whole.wrapping_add(u64::from(up))
        }
    };
    let magnitude = i64::try_from(magnitude).ok()?;
    Some(if bits & SIGN != 0 { magnitude.wrapping_neg() } else { magnitude })
}

/// The whole part of the square root of an integer, and whether anything is left over.
pub(crate) fn integer_root(value: u64) -> (u64, bool) {
    let mut rest = value;
    let mut root = 0u64;
    let mut bit = 1u64 << 62;
    while bit != 0 {
        let trial = root | bit;
        root >>= 1;
        if rest >= trial {
            rest = rest.wrapping_sub(trial);
            root |= bit;
        }
        bit >>= 2;
    }
    (root, rest != 0)
}

/// Square root of the absolute value; NaN and infinity pass.
pub(crate) fn square_root(value: f32) -> f32 {
    let bits = value.to_bits() & !SIGN;
    if is_special(bits) || bits == 0 {
        return f32::from_bits(canonical(bits));
    }
    let (mantissa, exponent) = parts(bits);
    // A full mantissa and an even exponent.
    let lift = mantissa.leading_zeros().saturating_sub(8);
    let mut mantissa = u64::from(mantissa) << lift;
    let mut exponent = exponent.wrapping_sub(lift as i32);
    if exponent & 1 != 0 {
        mantissa <<= 1;
        exponent = exponent.wrapping_sub(1);
    }
    // 26 more bits below: the root has 25 or 26 bits, two or one of them beyond the mantissa.
    let (root, inexact) = integer_root(mantissa << 26);
    let exponent = exponent.wrapping_sub(26) >> 1;
    let extra = 40u32.saturating_sub(root.leading_zeros());
    let whole = root >> extra;
    let rest = root & (1u64 << extra).wrapping_sub(1);
    let half = 1u64 << extra.saturating_sub(1);
    let up = rest > half || (rest == half && (inexact || whole & 1 == 1));
    // A root is far from the ends of the exponent range, and a carry out of the mantissa raises the exponent by itself.
    let field = exponent.wrapping_add(extra as i32).wrapping_add(BIAS) as u32;
    let packed = (field << FRACTION_BITS).wrapping_add((whole as u32) & FRACTION).wrapping_add(u32::from(up));
    f32::from_bits(packed)
}

/// The exact remainder with the sign of `left`; NaN where there is none. `right` = 0 is the caller's affair.
pub(crate) fn remainder(left: f32, right: f32) -> f32 {
    let (a, b) = (left.to_bits(), right.to_bits());
    if left.is_nan() || right.is_nan() || left.is_infinite() || right == 0.0 {
        return f32::from_bits(NAN);
    }
    if right.is_infinite() {
        return left;
    }
    let (mut rest, mut exponent) = parts(a);
    let (divisor, least) = parts(b & !SIGN);
    if divisor == 0 {
        return f32::from_bits(NAN);
    }
    if exponent < least {
        // Smaller by exponent: either smaller altogether, or both are brought to the finer exponent.
        let gap = least.wrapping_sub(exponent).unsigned_abs();
        if gap >= 32 {
            return left;
        }
        let wide = u64::from(divisor) << gap;
        let rest = u64::from(rest).checked_rem(wide).unwrap_or(0) as u32;
        return pack(a & SIGN, rest, exponent);
    }
    rest = rest.checked_rem(divisor).unwrap_or(0);
    while exponent > least {
        rest = (rest << 1).checked_rem(divisor).unwrap_or(0);
        exponent = exponent.wrapping_sub(1);
    }
    pack(a & SIGN, rest, exponent)
}

/// An exactly representable `mantissa * 2^exponent`.
fn pack(sign: u32, mantissa: u32, exponent: i32) -> f32 {
    if mantissa == 0 {
        return f32::from_bits(sign);
    }
    let mut mantissa = mantissa;
    let mut field = exponent.wrapping_add(BIAS);
    while mantissa & HIDDEN == 0 && field > 1 {
        mantissa <<= 1;
        field = field.wrapping_sub(1);
    }
    let field = if mantissa & HIDDEN == 0 { 0 } else { field as u32 };
    f32::from_bits(sign | (field << FRACTION_BITS) | (mantissa & FRACTION))
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;

    fn samples() -> impl Iterator<Item = f32> {
        let mut state = 0x2545_F491_4F6C_DD1Du64;
        (0..200_000u32).map(move |index| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            let bits = (state >> 11) as u32;
            f32::from_bits(if index % 4 == 0 { (bits & 0x7FFF_FFFF) % 0x00FF_FFFF } else { bits })
        })
    }

    #[test]
    fn square_root_when_compared_with_the_host_then_equal_bits() {
        for value in samples().chain([0.0, 1.0, 2.0, 4.0, f32::MIN_POSITIVE, f32::MAX, f32::INFINITY]) {
            assert_eq!(canonical(square_root(value).to_bits()), canonical(value.abs().sqrt().to_bits()), "{value:e}");
        }
    }

    #[test]
    fn remainder_when_compared_with_the_host_then_equal_bits() {
        let values: Vec<f32> = samples().take(20_000).filter(|value| *value != 0.0).collect();
        for pair in values.windows(2) {
            let expected = canonical((pair[0] % pair[1]).to_bits());
            assert_eq!(canonical(remainder(pair[0], pair[1]).to_bits()), expected, "{:e} % {:e}", pair[0], pair[1]);
        }
        assert_eq!(remainder(-6.0, 3.0).to_bits(), (-0.0f32).to_bits());
        assert_eq!(remainder(5.5, 2.0), 1.5);
    }

    #[test]
    fn nearest_integer_when_halfway_then_even() {
        let rows = [(2.5, 2), (3.5, 4), (-2.5, -2), (-3.5, -4), (1.5, 2), (0.5, 0), (0.500_000_06, 1), (-0.5, 0)];
        for (value, expected) in rows {
            assert_eq!(nearest_integer(value), Some(expected));
        }
        assert_eq!(nearest_integer(3e9), Some(3_000_000_000));
        assert_eq!(nearest_integer(f32::NAN), None);
        assert_eq!(nearest_integer(9.3e18), None);
        assert_eq!(nearest_integer(9.2e18), Some(9.2e18f32 as i64));
    }

    #[test]
    fn nearest_integer_when_compared_with_the_host_then_equal() {
        for value in samples().filter(|value| value.abs() < 9.2e18) {
            assert_eq!(nearest_integer(value), Some(value.round_ties_even() as i64));
        }
    }

    #[test]
    fn integer_root_when_around_squares_then_truncated() {
        for root in [0u64, 1, 2, 3, 46340, 46341, 65535] {
            assert_eq!(integer_root(root * root), (root, false));
            assert_eq!(integer_root(root * root + 2 * root).0, root);
        }
    }
}
