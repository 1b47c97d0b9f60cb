//! Immediate values.

use twinrung_grammar::tree::{Immediate, Number, Radix};

use crate::diagnostic::{Finding, OPERAND_TYPE, VALUE_RANGE};
use crate::project::reading::Refusal;

/// An immediate value of 32 bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Literal {
    /// An integer and its radix.
    Integer { value: i32, radix: u8 },
    /// The bits of a REAL.
    Real(u32),
}

/// The value of a literal in logic (neutral-text-and-l5x.md C.2): decimal within DINT, other bases 32 bits as written;
/// neither characters nor what is no number.
pub(crate) fn literal_of(immediate: &Immediate) -> Result<Literal, Refusal> {
    let refuse = |code, message: String| Err(Finding::new(code, immediate.span, message).into());
    let text = &immediate.text;
    match &immediate.number {
        Number::Integer { negative, magnitude, radix: Radix::Decimal } => {
            let value = i128::from(*magnitude) * if *negative { -1 } else { 1 };
            match i32::try_from(value) {
                Ok(value) => Ok(Literal::Integer { value, radix: 10 }),
                Err(_) => refuse(&VALUE_RANGE, format!("{text} does not fit 32 bits (-2147483648 to 2147483647)")),
            }
        }
        Number::Integer { negative: false, magnitude, radix } => match u32::try_from(*magnitude) {
            Ok(bits) => Ok(Literal::Integer { value: bits as i32, radix: base(*radix) }),
            Err(_) => refuse(&VALUE_RANGE, format!("{text} has more than 32 bits")),
        },
        Number::Integer { .. } => {
            refuse(&VALUE_RANGE, format!("{text}: a value in base 16, 8 or 2 is a bit pattern and has no sign"))
        }
        Number::Real { bits } if f32::from_bits(*bits).is_finite() => Ok(Literal::Real(*bits)),
        Number::Real { .. } => refuse(&VALUE_RANGE, format!("{text} is beyond the range of REAL")),
        Number::Special { .. } => refuse(&VALUE_RANGE, format!("{text} is no number; logic takes finite values only")),
        Number::Ascii(_) => refuse(&OPERAND_TYPE, "characters are no number in safety logic".to_owned()),
    }
}

fn base(radix: Radix) -> u8 {
    match radix {
        Radix::Decimal => 10,
        Radix::Hexadecimal => 16,
        Radix::Octal => 8,
        Radix::Binary => 2,
    }
}
