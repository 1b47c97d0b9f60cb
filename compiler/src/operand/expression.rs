//! Expressions of CMP, CPT, FAL, FSC and of subscripts. general-instructions.md A.9, 2.6.

use twinrung_bytecode::limits;
use twinrung_catalog::Element;
use twinrung_grammar::tree::{self, BinaryOperator as Shown, UnaryOperator as ShownUnary};

use super::reference::{Reference, Shape};
use super::resolve;
use super::{Literal, Scope, literal_of};
use crate::diagnostic::{Finding, OPERAND_TYPE, OVER_LIMIT};
use crate::project::reading::{Context, Refusal};
use crate::rules;

/// An expression.
#[derive(Debug, Clone, PartialEq)]
pub enum Expression {
    /// An integer literal.
    Integer {
        /// Its value.
        value: i32,
        /// 10, 16, 8 or 2.
        radix: u8,
    },
    /// A REAL literal: its bits.
    Real(u32),
    /// A number in memory.
    Reference(Box<Reference>),
    /// One operand.
    Unary(UnaryOperator, Box<Expression>),
    /// Two operands.
    Binary(BinaryOperator, Box<Expression>, Box<Expression>),
}

/// Operators and functions of one operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum UnaryOperator {
    /// `-a`
    Negate,
    /// `NOT a`
    Not,
    /// `ABS(a)`
    Absolute,
    /// `SQR(a)`
    SquareRoot,
}

/// Operators of two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BinaryOperator {
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `MOD`
    Modulo,
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `AND`
    And,
    /// `XOR`
    Xor,
    /// `OR`
    Or,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// `=`
    Equal,
    /// `<>`
    NotEqual,
}

/// What an expression is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ExpressionKind {
    /// CPT, FAL: a number.
    Value,
    /// CMP, FSC: a truth value.
    Condition,
    /// A subscript or bit number: an integer.
    Subscript,
}

impl Expression {
    /// Its value, when only integer literals and signs make it.
    pub fn constant(&self) -> Option<i64> {
        match self {
            Expression::Integer { value, .. } => Some(i64::from(*value)),
            Expression::Unary(UnaryOperator::Negate, operand) => operand.constant().map(|value| -value),
            _ => None,
        }
    }

    /// Visits every reference, subscripts of references included, left to right.
    pub fn visit(&self, visitor: &mut impl FnMut(&Reference)) {
        match self {
            Expression::Integer { .. } | Expression::Real(_) => {}
            Expression::Reference(reference) => reference.visit(visitor),
            Expression::Unary(_, operand) => operand.visit(visitor),
            Expression::Binary(_, left, right) => {
                left.visit(visitor);
                right.visit(visitor);
            }
        }
    }

    /// Whether a REAL takes part in it (what subscripts hold does not count).
    pub fn holds_real(&self) -> bool {
        match self {
            Expression::Integer { .. } => false,
            Expression::Real(_) => true,
            Expression::Reference(reference) => reference.element() == Some(Element::Real),
            Expression::Unary(_, operand) => operand.holds_real(),
            Expression::Binary(_, left, right) => left.holds_real() || right.holds_real(),
        }
    }
}

impl Reference {
    /// Visits this reference and those of its subscripts and bit number, those first.
    pub fn visit(&self, visitor: &mut dyn FnMut(&Reference)) {
        for step in &self.steps {
            match step {
                super::Step::Subscript(subscripts) => {
                    for subscript in subscripts {
                        if let super::Subscript::Expression(expression) = subscript {
                            expression.visit(&mut |inner| visitor(inner));
                        }
                    }
                }
                super::Step::BitExpression(expression) => expression.visit(&mut |inner| visitor(inner)),
                super::Step::Member(_) | super::Step::Bit(_) => {}
            }
        }
        visitor(self);
    }
}

/// Reads an operand as an expression.
pub(crate) fn read(
    context: &Context<'_>,
    scope: Scope,
    operand: &tree::Operand,
    kind: ExpressionKind,
) -> Result<Expression, Refusal> {
    let shown = twinrung_grammar::read_expression(operand).map_err(|error| Refusal::from(&error))?;
    let expression = expression(context, scope, &shown, kind, 0)?;
    let (operations, depth) = size(&expression);
    if operations > limits::EXPRESSION_OPERATIONS || depth > limits::EXPRESSION_DEPTH {
        let message = format!(
            "an expression has at most {} operations and {} values open at once",
            limits::EXPRESSION_OPERATIONS,
            limits::EXPRESSION_DEPTH
        );
        return Err(Finding::new(&OVER_LIMIT, operand.span, message).help("split it with an intermediate tag").into());
    }
    Ok(expression)
}

/// Operations in postfix order, and how many values are open at once. The grammar bounds the recursion.
fn size(expression: &Expression) -> (usize, usize) {
    match expression {
        Expression::Integer { .. } | Expression::Real(_) | Expression::Reference(_) => (1, 1),
        Expression::Unary(_, operand) => {
            let (operations, depth) = size(operand);
            (operations + 1, depth)
        }
        Expression::Binary(_, left, right) => {
            let (left, right) = (size(left), size(right));
            (left.0 + right.0 + 1, left.1.max(right.1 + 1))
        }
    }
}

/// Resolves an expression of the grammar. `depth` counts subscripts within subscripts.
pub(crate) fn expression(
    context: &Context<'_>,
    scope: Scope,
    shown: &tree::Expression,
    kind: ExpressionKind,
    depth: usize,
) -> Result<Expression, Refusal> {
    if depth > limits::SUBSCRIPT_DEPTH {
        let message = format!("subscripts within subscripts go at most {} deep", limits::SUBSCRIPT_DEPTH);
        return Err(Finding::new(&OVER_LIMIT, shown.span(), message).into());
    }
    match shown {
        tree::Expression::Immediate(immediate) => match literal_of(immediate)? {
            Literal::Integer { value, radix } => Ok(Expression::Integer { value, radix }),
            Literal::Real(_) if kind == ExpressionKind::Subscript => {
                Err(Finding::new(&OPERAND_TYPE, immediate.span, "a subscript is an integer").into())
            }
            Literal::Real(bits) => {
                context.require_real(immediate.span)?;
                Ok(Expression::Real(bits))
            }
        },
        tree::Expression::Tag(tag) => {
            let reference = resolve::resolve(context, scope, tag, false, depth)?;
            let fits = reference.shape() == Shape::Word
                && (kind != ExpressionKind::Subscript || reference.element() != Some(Element::Real));
            if fits {
                return Ok(Expression::Reference(Box::new(reference)));
            }
            let wanted = if kind == ExpressionKind::Subscript { "SINT, INT or DINT" } else { "a number" };
            let found = resolve::describe_reference(context, &reference);
            Err(Finding::new(&OPERAND_TYPE, tag.span, format!("expected {wanted}, found {found}")).into())
        }
        tree::Expression::Unary { operator, operand, .. } => {
            let operand = expression(context, scope, operand, kind, depth)?;
            Ok(match (operator, operand) {
                // A literal in parentheses: the canonical text has a negative number, which is decimal.
                (ShownUnary::Negate, Expression::Integer { value, .. }) => match value.checked_neg() {
                    Some(value) => Expression::Integer { value, radix: 10 },
                    None => {
                        let least = Expression::Integer { value, radix: 10 };
                        Expression::Unary(UnaryOperator::Negate, Box::new(least))
                    }
                },
                (ShownUnary::Negate, Expression::Real(bits)) => Expression::Real(bits ^ 0x8000_0000),
                (ShownUnary::Negate, operand) => Expression::Unary(UnaryOperator::Negate, Box::new(operand)),
                (ShownUnary::Not, operand) => Expression::Unary(UnaryOperator::Not, Box::new(operand)),
            })
        }
        tree::Expression::Binary { operator, left, right, span } => {
            let Some(admitted) = binary(*operator, kind) else {
                return Err(rules::expression_operator::operator(*operator, kind, *span).into());
            };
            let left = expression(context, scope, left, kind, depth)?;
            let right = expression(context, scope, right, kind, depth)?;
            Ok(Expression::Binary(admitted, Box::new(left), Box::new(right)))
        }
        tree::Expression::Call { function, arguments, span } => {
            let unary = match function.text.to_ascii_uppercase().as_str() {
                "ABS" => Some(UnaryOperator::Absolute),
                "SQR" | "SQRT" if kind != ExpressionKind::Subscript => Some(UnaryOperator::SquareRoot),
                _ => None,
            };
            match (unary, arguments.as_slice()) {
                (Some(operator), [argument]) => {
                    let operand = expression(context, scope, argument, kind, depth)?;
                    Ok(Expression::Unary(operator, Box::new(operand)))
                }
                _ => Err(rules::expression_operator::function(function, *span).into()),
            }
        }
    }
}

fn binary(shown: Shown, kind: ExpressionKind) -> Option<BinaryOperator> {
    if shown.is_relation() && kind != ExpressionKind::Condition {
        return None;
    }
    Some(match shown {
        Shown::Power => return None,
        Shown::Multiply => BinaryOperator::Multiply,
        Shown::Divide => BinaryOperator::Divide,
        Shown::Modulo => BinaryOperator::Modulo,
        Shown::Less => BinaryOperator::Less,
        Shown::LessOrEqual => BinaryOperator::LessOrEqual,
        Shown::Greater => BinaryOperator::Greater,
        Shown::GreaterOrEqual => BinaryOperator::GreaterOrEqual,
        Shown::Equal => BinaryOperator::Equal,
        Shown::NotEqual => BinaryOperator::NotEqual,
        Shown::Subtract => BinaryOperator::Subtract,
        Shown::Add => BinaryOperator::Add,
        Shown::And => BinaryOperator::And,
        Shown::Xor => BinaryOperator::Xor,
        Shown::Or => BinaryOperator::Or,
    })
}
