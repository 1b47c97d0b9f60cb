//! Expressions: one value is left, operands are numbers, operators are known.

use super::operands::Fact;
use crate::error::ImageError;
use crate::format::*;
use crate::index::OperandIndex;
use crate::limits;
use crate::operand::Operation;

/// What an expression holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Expression {
    /// A relation: only CMP and FSC take it.
    pub(super) has_relation: bool,
    /// Only integers and the operators that a subscript may have (general-instructions.md 2.6).
    pub(super) is_subscript: bool,
}

pub(super) fn check_expression(
    operand: OperandIndex,
    operations: &[Operation],
    fact_of: &mut dyn FnMut(OperandIndex) -> Result<Fact, ImageError>,
) -> Result<Expression, ImageError> {
    let wrong = ImageError::ExpressionShape { operand };
    if operations.len() > limits::EXPRESSION_OPERATIONS {
        return Err(ImageError::ExpressionLength { operand });
    }
    let mut expression = Expression { has_relation: false, is_subscript: true };
    let mut open = 0usize;
    for operation in operations {
        match operation {
            Operation::Push(pushed) => {
                match fact_of(*pushed)? {
                    Fact::Integer(_) => {}
                    Fact::Real(_) => expression.is_subscript = false,
                    Fact::Reference(place) if place.word().is_some() => {
                        expression.is_subscript &= place.word() != Some(twinrung_catalog::Element::Real);
                    }
                    _ => return Err(ImageError::ExpressionOperand { operand }),
                }
                open = open.saturating_add(1);
                if open > limits::EXPRESSION_DEPTH {
                    return Err(ImageError::ExpressionDepth { operand });
                }
            }
            Operation::Apply(operator) => {
                let takes = match *operator {
                    OPERATION_NEGATE..=OPERATION_ABSOLUTE => 1,
                    OPERATION_SQUARE_ROOT => {
                        expression.is_subscript = false;
                        1
                    }
                    OPERATION_LESS..=OPERATION_NOT_EQUAL => {
                        expression.has_relation = true;
                        expression.is_subscript = false;
                        2
                    }
                    OPERATION_MULTIPLY..=OPERATION_OR => 2,
                    _ => return Err(wrong),
                };
                open = open.checked_sub(takes).ok_or(wrong.clone())?.saturating_add(1);
            }
        }
    }
    if open == 1 { Ok(expression) } else { Err(wrong) }
}
