//! What the grammar of operands does when it has recognised something.

use lalrpop_util::ParseError;

use super::token::Token;
use crate::limits::SUBSCRIPTS_MAX;
use crate::reading::number::parse_number;
use crate::tree::{
    BinaryOperator, ErrorKind, Expression, Immediate, Name, Number, Operand, Part, ReadError, UnaryOperator,
};

type Failure<'a> = ParseError<usize, Token<'a>, ReadError>;

fn failure<'a>(error: ReadError) -> Failure<'a> {
    ParseError::User { error }
}

pub(super) fn member<'a>(operand: &Operand, text: &str, l: usize, r: usize) -> Result<Part, Failure<'a>> {
    let span = operand.locate(l, r);
    if text.contains(':') {
        let message = format!("`{text}` is no member: only a module tag begins with a colon in its name");
        return Err(failure(ReadError::new(ErrorKind::MalformedTagReference, span, message)));
    }
    Ok(Part::Member(Name::new(text, span)))
}

pub(super) fn bit<'a>(operand: &Operand, text: &str, l: usize, r: usize) -> Result<Part, Failure<'a>> {
    let span = operand.locate(l, r);
    let digits = text.bytes().all(|byte| byte.is_ascii_digit());
    match text.parse::<u32>() {
        Ok(number) if digits => Ok(Part::Bit { number, span }),
        _ => Err(failure(ReadError::new(
            ErrorKind::MalformedTagReference,
            span,
            format!("`{text}` is no bit number: a bit is named by decimal digits"),
        ))),
    }
}

pub(super) fn subscripts<'a>(
    operand: &Operand,
    subscripts: Vec<Expression>,
    l: usize,
    r: usize,
) -> Result<Part, Failure<'a>> {
    let span = operand.locate(l, r);
    if subscripts.len() > SUBSCRIPTS_MAX {
        let message = format!("{} subscripts: an array has at most {SUBSCRIPTS_MAX} dimensions", subscripts.len());
        return Err(failure(ReadError::new(ErrorKind::TooMany, span, message)));
    }
    Ok(Part::Subscripts { subscripts, span })
}

pub(super) fn binary(
    operand: &Operand,
    operator: BinaryOperator,
    left: Expression,
    right: Expression,
    l: usize,
    r: usize,
) -> Expression {
    Expression::Binary { operator, left: Box::new(left), right: Box::new(right), span: operand.locate(l, r) }
}

/// A minus directly before a number makes a negative number; before anything else, a number in parentheses among it, it
/// is an operation: `-2#1010` is a bit pattern with a sign, which nothing takes, `-(2#1010)` the negation of 10.
pub(super) fn negate(operand: &Operand, inner: Expression, l: usize, begin: usize, r: usize) -> Expression {
    let span = operand.locate(l, r);
    let bare = inner.span() == operand.locate(begin, r);
    match inner {
        Expression::Immediate(Immediate { number, text, .. }) if bare && !text.starts_with(['-', '\'']) => {
            let number = match number {
                Number::Integer { magnitude, radix, .. } => Number::Integer { negative: true, magnitude, radix },
                Number::Real { bits } => Number::Real { bits: bits ^ 0x8000_0000 },
                Number::Special { bits } => Number::Special { bits: bits ^ 0x8000_0000 },
                Number::Ascii(bytes) => Number::Ascii(bytes),
            };
            Expression::Immediate(Immediate { number, text: format!("-{text}").into(), span })
        }
        inner => Expression::Unary { operator: UnaryOperator::Negate, operand: Box::new(inner), span },
    }
}

pub(super) fn immediate<'a>(operand: &Operand, text: &str, l: usize, r: usize) -> Result<Immediate, Failure<'a>> {
    let span = operand.locate(l, r);
    match parse_number(text) {
        Ok(number) => Ok(Immediate { number, text: text.into(), span }),
        Err(reason) => Err(failure(ReadError::new(reason.kind(), span, reason.message(text)))),
    }
}

/// `.6`: a REAL without a digit before its point.
pub(super) fn fraction<'a>(operand: &Operand, text: &str, l: usize, r: usize) -> Result<Immediate, Failure<'a>> {
    immediate(operand, &format!(".{text}"), l, r)
}
