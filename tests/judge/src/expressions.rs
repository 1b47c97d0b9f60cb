//! Expressions of CMP, CPT, FAL, FSC and subscripts. general-instructions.md A.9.

use twinrung_catalog::Element;
use twinrung_compiler::operand::{BinaryOperator, Expression, UnaryOperator};

use crate::arithmetic::{Number, Operation, absolute, apply, negate, square_root, zero_filled};
use crate::evaluator::{Exit, Judge};
use crate::memory::Frame;

/// Whether REAL occurs anywhere in an expression.
pub(crate) fn holds_real(expression: &Expression) -> bool {
    match expression {
        Expression::Integer { .. } => false,
        Expression::Real(_) => true,
        Expression::Reference(reference) => reference.element() == Some(Element::Real),
        Expression::Unary(_, inner) => holds_real(inner),
        Expression::Binary(_, left, right) => holds_real(left) || holds_real(right),
    }
}

impl Judge<'_> {
    /// The value of a subscript or bit number.
    pub(crate) fn subscript_value(&mut self, frame: &Frame<'_>, expression: &Expression) -> Result<i32, Exit> {
        let before = std::mem::take(&mut self.subscript_overflow);
        let value = self.expression(frame, expression, false)?.to_integer().0;
        let overflowed = std::mem::replace(&mut self.subscript_overflow, before);
        // An overflow while computing a subscript is the fault of the subscript, too (2.6).
        if overflowed { Err(Exit::Fault(20)) } else { Ok(value) }
    }

    /// The value of an expression; overflow sets S:V.
    pub(crate) fn expression(
        &mut self,
        frame: &Frame<'_>,
        expression: &Expression,
        real: bool,
    ) -> Result<Number, Exit> {
        match expression {
            Expression::Integer { value, .. } => Ok(Number::Integer(*value)),
            Expression::Real(bits) => Ok(Number::Real(f32::from_bits(*bits))),
            Expression::Reference(reference) => {
                let target = self.locate(frame, reference)?;
                Ok(self.number_at(&target))
            }
            Expression::Unary(UnaryOperator::Not, inner) => {
                let pattern = self.bitwise(frame, inner, real)?;
                Ok(Number::Integer(!pattern))
            }
            Expression::Unary(operator, inner) => {
                let value = self.expression(frame, inner, real)?;
                let (value, overflow) = match operator {
                    UnaryOperator::Negate => negate(value, real),
                    UnaryOperator::Absolute => absolute(value, real),
                    _ => (square_root(value, real), false),
                };
                if overflow {
                    self.overflow(frame);
                }
                Ok(value)
            }
            Expression::Binary(operator, left, right) => self.binary(frame, *operator, left, right, real),
        }
    }

    fn binary(
        &mut self,
        frame: &Frame<'_>,
        operator: BinaryOperator,
        left: &Expression,
        right: &Expression,
        real: bool,
    ) -> Result<Number, Exit> {
        if matches!(operator, BinaryOperator::And | BinaryOperator::Or | BinaryOperator::Xor) {
            let a = self.bitwise(frame, left, real)?;
            let b = self.bitwise(frame, right, real)?;
            return Ok(Number::Integer(match operator {
                BinaryOperator::And => a & b,
                BinaryOperator::Or => a | b,
                _ => a ^ b,
            }));
        }
        let a = self.expression(frame, left, real)?;
        let b = self.expression(frame, right, real)?;
        let operation = match operator {
            BinaryOperator::Add => Operation::Add,
            BinaryOperator::Subtract => Operation::Subtract,
            BinaryOperator::Multiply => Operation::Multiply,
            BinaryOperator::Divide => Operation::Divide,
            BinaryOperator::Modulo => Operation::Modulo,
            relation => return Ok(Number::Integer(i32::from(related(relation, a, b, real)))),
        };
        let (value, overflow) = apply(operation, a, b, real);
        if overflow {
            self.overflow(frame);
        }
        Ok(value)
    }

    /// An operand of AND, OR, XOR or NOT: DINT, zero-filled where it is a SINT or INT in memory.
    fn bitwise(&mut self, frame: &Frame<'_>, expression: &Expression, real: bool) -> Result<i32, Exit> {
        let value = self.expression(frame, expression, real)?;
        let (integer, overflow) = value.to_integer();
        if overflow {
            self.overflow(frame);
        }
        Ok(match expression {
            Expression::Reference(reference) => zero_filled(reference.element().unwrap_or(Element::Dint), integer),
            _ => integer,
        })
    }
}

/// A relation between two numbers.
pub(crate) fn related(relation: BinaryOperator, a: Number, b: Number, real: bool) -> bool {
    let ordering =
        if real { a.to_real().partial_cmp(&b.to_real()) } else { Some(a.to_integer().0.cmp(&b.to_integer().0)) };
    match relation {
        BinaryOperator::Less => ordering.is_some_and(|order| order.is_lt()),
        BinaryOperator::LessOrEqual => ordering.is_some_and(|order| order.is_le()),
        BinaryOperator::Greater => ordering.is_some_and(|order| order.is_gt()),
        BinaryOperator::GreaterOrEqual => ordering.is_some_and(|order| order.is_ge()),
        BinaryOperator::Equal => ordering.is_some_and(|order| order.is_eq()),
        BinaryOperator::NotEqual => !ordering.is_some_and(|order| order.is_eq()),
        other => panic!("not a relation: {other:?}"),
    }
}
