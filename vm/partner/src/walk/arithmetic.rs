//! Arithmetic of instructions and expressions: integers widened and narrowed with a check, REAL in binary32.
//! general-instructions.md A.9.

use twinrung_bytecode::format;

use super::value::{Value, narrow_to_dint};
use crate::real;

/// A result and whether it overflowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Outcome {
    /// The result.
    pub(crate) value: Value,
    /// Whether the exact result did not fit, or a divisor was 0.
    pub(crate) overflow: bool,
}

fn integer(exact: i64) -> Outcome {
    let (value, overflow) = narrow_to_dint(exact);
    Outcome { value: Value::dint(value), overflow }
}

fn truth(value: bool) -> Outcome {
    Outcome { value: Value::dint(i32::from(value)), overflow: false }
}

/// A REAL result: infinite out of finite operands is an overflow.
fn rounded(result: f32, left: f32, right: f32) -> Outcome {
    let overflow = result.is_infinite() && left.is_finite() && right.is_finite();
    Outcome { value: Value::real(result), overflow }
}

/// An operator with one operand, `format::OPERATION_NEGATE` to `OPERATION_SQUARE_ROOT`.
pub(crate) fn unary(operator: u8, operand: Value, real: bool) -> Outcome {
    if operator == format::OPERATION_NOT {
        let (value, overflow) = logic_operand(operand);
        return Outcome { value: Value::dint(!value as i32), overflow };
    }
    if real {
        let operand = operand.to_real();
        let result = match operator {
            format::OPERATION_NEGATE => f32::from_bits(operand.to_bits() ^ (1 << 31)),
            format::OPERATION_ABSOLUTE => f32::from_bits(operand.to_bits() & !(1 << 31)),
            _ => real::square_root(operand),
        };
        return Outcome { value: Value::real(result), overflow: false };
    }
    let operand = i64::from(operand.bits);
    match operator {
        format::OPERATION_NEGATE => integer(operand.wrapping_neg()),
        format::OPERATION_ABSOLUTE => integer(operand.wrapping_abs()),
        _ => integer(real::integer_root(operand.unsigned_abs()).0 as i64),
    }
}

/// An operator with two operands, `format::OPERATION_MULTIPLY` to `OPERATION_NOT_EQUAL`.
pub(crate) fn binary(operator: u8, left: Value, right: Value, real: bool) -> Outcome {
    match operator {
        format::OPERATION_AND | format::OPERATION_XOR | format::OPERATION_OR => bitwise(operator, left, right),
        format::OPERATION_LESS..=format::OPERATION_NOT_EQUAL => truth(compare(operator, left, right, real)),
        _ if real => real_binary(operator, left.to_real(), right.to_real()),
        _ => integer_binary(operator, left.bits, right.bits),
    }
}

fn logic_operand(value: Value) -> (u32, bool) {
    if value.is_real() {
        let (value, overflow) = value.to_dint();
        (value as u32, overflow)
    } else {
        (value.zero_filled(), false)
    }
}

/// A value as bitwise logic takes it: REAL rounded to DINT, SINT and INT zero-filled.
pub(crate) fn pattern(value: Value) -> Outcome {
    let (bits, overflow) = logic_operand(value);
    Outcome { value: Value::dint(bits as i32), overflow }
}

fn bitwise(operator: u8, left: Value, right: Value) -> Outcome {
    let ((left, left_unfit), (right, right_unfit)) = (logic_operand(left), logic_operand(right));
    let value = match operator {
        format::OPERATION_AND => left & right,
        format::OPERATION_XOR => left ^ right,
        _ => left | right,
    };
    Outcome { value: Value::dint(value as i32), overflow: left_unfit | right_unfit }
}

/// A relation; REAL where `real`, with IEEE's view of NaN.
pub(crate) fn compare(operator: u8, left: Value, right: Value, real: bool) -> bool {
    if real {
        let (left, right) = (left.to_real(), right.to_real());
        return match operator {
            format::OPERATION_LESS => left < right,
            format::OPERATION_LESS_OR_EQUAL => left <= right,
            format::OPERATION_GREATER => left > right,
            format::OPERATION_GREATER_OR_EQUAL => left >= right,
            format::OPERATION_EQUAL => left == right,
            _ => left != right,
        };
    }
    let (left, right) = (left.bits, right.bits);
    match operator {
        format::OPERATION_LESS => left < right,
        format::OPERATION_LESS_OR_EQUAL => left <= right,
        format::OPERATION_GREATER => left > right,
        format::OPERATION_GREATER_OR_EQUAL => left >= right,
        format::OPERATION_EQUAL => left == right,
        _ => left != right,
    }
}

fn real_binary(operator: u8, left: f32, right: f32) -> Outcome {
    match operator {
        format::OPERATION_MULTIPLY => rounded(left * right, left, right),
        format::OPERATION_ADD => rounded(left + right, left, right),
        format::OPERATION_SUBTRACT => rounded(left - right, left, right),
        format::OPERATION_DIVIDE => {
            // By a zero of either sign: an infinity with the sign of the left operand (A.9).
            let by_zero = right == 0.0;
            let outcome = rounded(left / if by_zero { 0.0 } else { right }, left, right);
            Outcome { overflow: outcome.overflow || by_zero, ..outcome }
        }
        _ if right == 0.0 => Outcome { value: Value::real(0.0), overflow: true },
        _ => Outcome { value: Value::real(real::remainder(left, right)), overflow: false },
    }
}

fn integer_binary(operator: u8, left: i32, right: i32) -> Outcome {
    let (wide_left, wide_right) = (i64::from(left), i64::from(right));
    match operator {
        format::OPERATION_MULTIPLY => {
            let exact = i128::from(left).wrapping_mul(i128::from(right));
            Outcome { value: Value::dint(exact as i32), overflow: i128::from(exact as i32) != exact }
        }
        format::OPERATION_ADD => integer(wide_left.wrapping_add(wide_right)),
        format::OPERATION_SUBTRACT => integer(wide_left.wrapping_sub(wide_right)),
        format::OPERATION_DIVIDE => match wide_left.checked_div(wide_right) {
            Some(quotient) => integer(quotient),
            None => Outcome { value: Value::dint(left), overflow: true },
        },
        _ => match wide_left.checked_rem(wide_right) {
            Some(rest) => integer(rest),
            None => Outcome { value: Value::dint(0), overflow: true },
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integers(operator: u8, left: i32, right: i32) -> (i32, bool) {
        let outcome = binary(operator, Value::dint(left), Value::dint(right), false);
        (outcome.value.bits, outcome.overflow)
    }

    #[test]
    fn integer_operations_when_the_result_does_not_fit_then_low_bits_and_overflow() {
        use format::*;
        let rows = [
            (OPERATION_ADD, i32::MAX, 1, i32::MIN, true),
            (OPERATION_SUBTRACT, i32::MIN, 1, i32::MAX, true),
            (OPERATION_MULTIPLY, 65536, 65536, 0, true),
            (OPERATION_MULTIPLY, -3, 7, -21, false),
            (OPERATION_DIVIDE, -7, 2, -3, false),
            (OPERATION_DIVIDE, 7, 0, 7, true),
            (OPERATION_DIVIDE, i32::MIN, -1, i32::MIN, true),
            (OPERATION_MODULO, -7, 3, -1, false),
            (OPERATION_MODULO, 7, 0, 0, true),
            (OPERATION_MODULO, i32::MIN, -1, 0, false),
        ];
        for (operator, left, right, value, overflow) in rows {
            assert_eq!(integers(operator, left, right), (value, overflow), "{operator} {left} {right}");
        }
    }

    #[test]
    fn unary_when_the_least_dint_then_it_stays_with_overflow() {
        for operator in [format::OPERATION_NEGATE, format::OPERATION_ABSOLUTE] {
            let outcome = unary(operator, Value::dint(i32::MIN), false);
            assert_eq!((outcome.value.bits, outcome.overflow), (i32::MIN, true));
        }
        assert_eq!(unary(format::OPERATION_SQUARE_ROOT, Value::dint(-17), false).value.bits, 4);
        assert_eq!(unary(format::OPERATION_SQUARE_ROOT, Value::dint(i32::MIN), false).value.bits, 46340);
    }

    #[test]
    fn real_division_when_by_zero_then_signed_infinity_and_overflow() {
        let divide = |left: f32, right: f32| {
            let outcome = binary(format::OPERATION_DIVIDE, Value::real(left), Value::real(right), true);
            (outcome.value.bits as u32, outcome.overflow)
        };
        assert_eq!(divide(1.0, 0.0), (f32::INFINITY.to_bits(), true));
        assert_eq!(divide(-1.0, 0.0), (f32::NEG_INFINITY.to_bits(), true));
        assert_eq!(divide(0.0, 0.0), (real::NAN, true));
        assert_eq!(divide(f32::INFINITY, 2.0), (f32::INFINITY.to_bits(), false));
    }

    #[test]
    fn compare_when_nan_then_only_not_equal_holds() {
        let (nan, one) = (Value::real(f32::NAN), Value::real(1.0));
        for operator in format::OPERATION_LESS..=format::OPERATION_EQUAL {
            assert!(!compare(operator, nan, one, true));
        }
        assert!(compare(format::OPERATION_NOT_EQUAL, nan, one, true));
        assert!(compare(format::OPERATION_EQUAL, Value::real(0.0), Value::real(-0.0), true));
    }
}
