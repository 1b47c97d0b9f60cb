//! What is checked on the atoms of an expression before it is parsed: depth, length, and relations
//! mixed with other operators.
//!
//! The classic table ranks relations above `+` and `-`, newer help ranks them below AND, XOR and OR
//! (reference A.9). An expression that the two read differently is refused: `a + b = c` must be
//! written `(a + b) = c`.

use super::token::Token;
use crate::limits::{EXPRESSION_DEPTH_MAX, EXPRESSION_OPERATORS_MAX};
use crate::tree::{ErrorKind, Operand, ReadError};

/// What stands between one pair of parentheses.
#[derive(Default)]
struct Level {
    relation: Option<(usize, usize)>,
    mixed: Option<(usize, usize)>,
}

pub(super) fn check(operand: &Operand, tokens: &[(usize, Token<'_>, usize)]) -> Result<(), ReadError> {
    let mut levels = vec![Level::default()];
    let mut operators = 0;
    let mut signs = 0;
    let mut previous = None;
    for &(start, token, end) in tokens {
        let place = Some((start, end));
        let after_operand = previous.is_some_and(Token::ends_operand);
        let sign = matches!(token, Token::Not) || (matches!(token, Token::Minus) && !after_operand);
        signs = if sign {
            signs + 1
        } else if after_operand {
            0
        } else {
            signs
        };
        if levels.len() + signs > EXPRESSION_DEPTH_MAX {
            let message = format!("nested deeper than {EXPRESSION_DEPTH_MAX}");
            return Err(ReadError::new(ErrorKind::TooDeep, operand.locate(start, end), message));
        }
        match token {
            Token::Open | Token::OpenBracket => levels.push(Level::default()),
            Token::Close | Token::CloseBracket => {
                // An unbalanced one is the parser's to report.
                levels.pop();
                if levels.is_empty() {
                    return Ok(());
                }
            }
            Token::Comma => {
                if let Some(level) = levels.last_mut() {
                    *level = Level::default();
                }
            }
            _ => {}
        }
        let binary = token.is_relation()
            || matches!(
                token,
                Token::Plus
                    | Token::And
                    | Token::Or
                    | Token::Xor
                    | Token::Star
                    | Token::Slash
                    | Token::Mod
                    | Token::Power
            )
            || (matches!(token, Token::Minus) && after_operand);
        // A member may be called like an operator.
        let is_member = matches!(previous, Some(Token::Dot));
        if (binary || sign) && !is_member {
            operators += 1;
            if operators > EXPRESSION_OPERATORS_MAX {
                let message = format!("more than {EXPRESSION_OPERATORS_MAX} operators in one expression");
                return Err(ReadError::new(ErrorKind::TooMany, operand.locate(start, end), message));
            }
        }
        if let Some(level) = levels.last_mut().filter(|_| binary && !is_member) {
            if token.is_relation() {
                if level.relation.is_some() {
                    return Err(ambiguous(operand, place, "two relations between the same parentheses"));
                }
                level.relation = place;
            } else if !matches!(token, Token::Star | Token::Slash | Token::Mod | Token::Power) {
                level.mixed = place;
            }
            if level.relation.is_some() && level.mixed.is_some() {
                let place = if token.is_relation() { level.relation } else { level.mixed };
                let what = "a relation and another operator between the same parentheses; \
                            controllers differ in which comes first";
                return Err(ambiguous(operand, place, what));
            }
        }
        previous = Some(token);
    }
    Ok(())
}

fn ambiguous(operand: &Operand, place: Option<(usize, usize)>, message: &str) -> ReadError {
    let (start, end) = place.unwrap_or((0, operand.text.len()));
    ReadError::new(ErrorKind::AmbiguousRelation, operand.locate(start, end), message)
        .with_help("put parentheses around the part that is to be computed first")
}
