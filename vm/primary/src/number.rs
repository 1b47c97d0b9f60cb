//! Integer and REAL arithmetic, and the conversions between the types. general-instructions.md 2.2 and A.9.

use twinrung_catalog::Element;

/// The one form in which a NaN is stored (REQ-EXEC-003).
pub(crate) const CANONICAL_NAN: u32 = 0x7FC0_0000;

/// A value while an instruction works with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Number {
    /// SINT, INT or DINT, sign-extended.
    Integer(i32),
    /// REAL.
    Real(f32),
}

impl Number {
    /// The value as REAL: exact for SINT and INT, nearest (ties to even) for DINT.
    pub(crate) fn real(self) -> f32 {
        match self {
            Number::Integer(value) => value as f32,
            Number::Real(value) => value,
        }
    }
}

/// An operator with two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    And,
    Or,
    Xor,
}

/// An operator with one operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unary {
    Negate,
    Absolute,
    SquareRoot,
    Not,
}

/// A relation of two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Relation {
    Equal,
    NotEqual,
    Greater,
    GreaterOrEqual,
    Less,
    LessOrEqual,
}

impl Relation {
    /// Whether the relation holds; REAL follows IEEE 754, so a NaN is only ever unequal.
    pub(crate) fn holds<T: PartialOrd>(self, left: T, right: T) -> bool {
        match self {
            Relation::Equal => left == right,
            Relation::NotEqual => left != right,
            Relation::Greater => left > right,
            Relation::GreaterOrEqual => left >= right,
            Relation::Less => left < right,
            Relation::LessOrEqual => left <= right,
        }
    }

    /// The relation between two values, in REAL when either is REAL.
    pub(crate) fn of(self, left: Number, right: Number) -> bool {
        match (left, right) {
            (Number::Integer(left), Number::Integer(right)) => self.holds(left, right),
            _ => self.holds(left.real(), right.real()),
        }
    }
}

/// What an operation gave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Outcome {
    pub(crate) value: Number,
    pub(crate) overflow: bool,
    pub(crate) carry: bool,
}

fn integer_outcome((value, overflow): (i32, bool), carry: bool) -> Outcome {
    Outcome { value: Number::Integer(value), overflow, carry }
}

/// A binary operation on integers.
pub(crate) fn integer_binary(operator: Binary, left: i32, right: i32) -> Outcome {
    match operator {
        Binary::Add => integer_outcome(left.overflowing_add(right), (left as u32).checked_add(right as u32).is_none()),
        Binary::Subtract => integer_outcome(left.overflowing_sub(right), (left as u32) < (right as u32)),
        Binary::Multiply => integer_outcome(left.overflowing_mul(right), false),
        // By zero the result is A (A.9); the minimum by -1 wraps to itself.
        Binary::Divide => {
            let exceeded = if right == 0 { left } else { i32::MIN };
            let quotient = left.checked_div(right);
            integer_outcome((quotient.unwrap_or(exceeded), quotient.is_none()), false)
        }
        Binary::Modulo => integer_outcome((left.checked_rem(right).unwrap_or(0), right == 0), false),
        Binary::And => integer_outcome((left & right, false), false),
        Binary::Or => integer_outcome((left | right, false), false),
        Binary::Xor => integer_outcome((left ^ right, false), false),
    }
}

/// A unary operation on an integer.
pub(crate) fn integer_unary(operator: Unary, value: i32) -> Outcome {
    match operator {
        Unary::Negate => integer_outcome(value.overflowing_neg(), false),
        Unary::Absolute => integer_outcome(value.overflowing_abs(), false),
        Unary::SquareRoot => integer_outcome((value.unsigned_abs().isqrt() as i32, false), false),
        Unary::Not => integer_outcome((!value, false), false),
    }
}

/// A binary operation on REAL. The logical operators have no REAL form; the loader never asks for one.
pub(crate) fn real_binary(operator: Binary, left: f32, right: f32) -> Outcome {
    let (value, undefined) = match operator {
        Binary::Add => (left + right, false),
        Binary::Subtract => (left - right, false),
        Binary::Multiply => (left * right, false),
        // An infinity with the sign of A, whatever the sign of the zero (A.9).
        Binary::Divide if right == 0.0 => {
            let nothing = left == 0.0 || left.is_nan();
            (if nothing { f32::NAN } else { f32::INFINITY.copysign(left) }, true)
        }
        Binary::Divide => (left / right, false),
        Binary::Modulo if right == 0.0 => (0.0, true),
        Binary::Modulo => (libm::fmodf(left, right), false),
        Binary::And | Binary::Or | Binary::Xor => (f32::NAN, true),
    };
    let overflow = undefined || (value.is_infinite() && left.is_finite() && right.is_finite());
    Outcome { value: Number::Real(value), overflow, carry: false }
}

/// A unary operation on REAL.
pub(crate) fn real_unary(operator: Unary, value: f32) -> Outcome {
    let result = match operator {
        Unary::Negate => -value,
        Unary::Absolute => value.abs(),
        Unary::SquareRoot => libm::sqrtf(value.abs()),
        Unary::Not => f32::NAN,
    };
    Outcome { value: Number::Real(result), overflow: false, carry: false }
}

/// The bits of a REAL as they are stored.
pub(crate) fn stored_real(value: f32) -> u32 {
    if value.is_nan() { CANONICAL_NAN } else { value.to_bits() }
}

/// REAL to DINT: nearest, ties to even; what does not fit keeps its low bits and overflows.
pub(crate) fn rounded(value: f32) -> (i32, bool) {
    if !value.is_finite() {
        return (i32::MIN, true);
    }
    let nearest = libm::rintf(value);
    if (-2_147_483_648.0..2_147_483_648.0).contains(&nearest) {
        (nearest as i32, false)
    } else if nearest.abs() < 9_223_372_036_854_775_808.0 {
        (nearest as i64 as i32, true)
    } else {
        (i32::MIN, true)
    }
}

/// The low bits of a DINT, sign-extended, and whether the value did not fit.
pub(crate) fn narrowed(value: i32, element: Element) -> (i32, bool) {
    let kept = match element {
        Element::Sint => i32::from(value as i8),
        Element::Int => i32::from(value as i16),
        Element::Bool | Element::Dint | Element::Real => value,
    };
    (kept, kept != value)
}

/// The value as it is stored in a cell of this type, and whether it did not fit.
pub(crate) fn converted(value: Number, element: Element) -> (u32, bool) {
    match (value, element) {
        (Number::Integer(value), Element::Real) => ((value as f32).to_bits(), false),
        (Number::Real(value), Element::Real) => (stored_real(value), false),
        (Number::Integer(value), _) => {
            let (kept, lost) = narrowed(value, element);
            (kept as u32, lost)
        }
        (Number::Real(value), _) => {
            let (whole, beyond) = rounded(value);
            let (kept, lost) = narrowed(whole, element);
            (kept as u32, beyond || lost)
        }
    }
}

/// A SINT or INT with zeros instead of its sign, as the bitwise instructions see it.
pub(crate) fn zero_filled(value: i32, element: Element) -> i32 {
    match element {
        Element::Sint => value & 0xFF,
        Element::Int => value & 0xFFFF,
        Element::Bool | Element::Dint | Element::Real => value,
    }
}
