//! Tag references and expressions, with no more parentheses than needed.
//!
//! Symbols have no blanks around them, words have one on each side: `a*(b+1)`, `a AND NOT b`.
//! Parentheses stand wherever precedence (reference A.9) would read the text differently, and
//! around a relation beside any other operator, because controllers differ there.

use crate::tree::{BinaryOperator, Expression, Part, TagReference, UnaryOperator};

/// The text of a tag reference.
pub fn print_tag(tag: &TagReference) -> String {
    let mut out = String::new();
    push_tag(tag, &mut out);
    out
}

/// The text of an expression.
pub fn print_expression(expression: &Expression) -> String {
    let mut out = String::new();
    push(expression, &mut out);
    out
}

fn push_tag(tag: &TagReference, out: &mut String) {
    if let Some(program) = &tag.program {
        out.push('\\');
        out.push_str(&program.text);
        out.push('.');
    }
    out.push_str(&tag.base.text);
    for part in &tag.parts {
        match part {
            Part::Member(name) => {
                out.push('.');
                out.push_str(&name.text);
            }
            Part::Bit { number, .. } => {
                out.push('.');
                out.push_str(&number.to_string());
            }
            Part::BitSubscript { index, .. } => {
                out.push_str(".[");
                push(index, out);
                out.push(']');
            }
            Part::Subscripts { subscripts, .. } => {
                out.push('[');
                list(subscripts, out);
                out.push(']');
            }
        }
    }
}

fn list(expressions: &[Expression], out: &mut String) {
    for (index, expression) in expressions.iter().enumerate() {
        if index > 0 {
            out.push(',');
        }
        push(expression, out);
    }
}

/// How tightly an expression holds together; a higher one needs no parentheses.
fn rank(expression: &Expression) -> u8 {
    const SIGN: u8 = 8;
    const OPERAND: u8 = 10;
    match expression {
        // A negative number begins with a sign.
        Expression::Immediate(immediate) if immediate.text.starts_with('-') => SIGN,
        Expression::Immediate(_) | Expression::Tag(_) | Expression::Call { .. } => OPERAND,
        Expression::Unary { .. } => SIGN,
        Expression::Binary { operator, .. } => operator_rank(*operator),
    }
}

fn operator_rank(operator: BinaryOperator) -> u8 {
    use BinaryOperator::*;
    match operator {
        Power => 9,
        Multiply | Divide | Modulo => 7,
        Less | LessOrEqual | Greater | GreaterOrEqual | Equal | NotEqual => 6,
        Subtract | Add => 5,
        And => 4,
        Xor => 3,
        Or => 2,
    }
}

impl BinaryOperator {
    /// As it is written, without blanks.
    pub fn symbol(self) -> &'static str {
        use BinaryOperator::*;
        match self {
            Power => "**",
            Multiply => "*",
            Divide => "/",
            Modulo => "MOD",
            Less => "<",
            LessOrEqual => "<=",
            Greater => ">",
            GreaterOrEqual => ">=",
            Equal => "=",
            NotEqual => "<>",
            Subtract => "-",
            Add => "+",
            And => "AND",
            Xor => "XOR",
            Or => "OR",
        }
    }
}

/// Whether a relation is on one side and an operator that controllers rank differently on the other.
fn is_ambiguous(outer: BinaryOperator, inner: &Expression) -> bool {
    let Expression::Binary { operator, .. } = inner else { return false };
    let mixes = |operator: BinaryOperator| operator_rank(operator) <= 6;
    mixes(outer) && mixes(*operator) && (outer.is_relation() || operator.is_relation())
}

/// Recurses as deep as expressions are, which has a limit.
fn push(expression: &Expression, out: &mut String) {
    match expression {
        Expression::Immediate(immediate) => out.push_str(&immediate.text),
        Expression::Tag(tag) => push_tag(tag, out),
        Expression::Call { function, arguments, .. } => {
            out.push_str(&function.text);
            out.push('(');
            list(arguments, out);
            out.push(')');
        }
        Expression::Unary { operator, operand, .. } => {
            out.push_str(match operator {
                UnaryOperator::Negate => "-",
                UnaryOperator::Not => "NOT ",
            });
            // `-5` would be a number, not the negation of one.
            let number = matches!((operator, &**operand), (UnaryOperator::Negate, Expression::Immediate(_)));
            parenthesised(operand, number || rank(operand) < rank(expression), out);
        }
        Expression::Binary { operator, left, right, .. } => {
            let own = operator_rank(*operator);
            let parentheses_left = rank(left) < own || is_ambiguous(*operator, left);
            // Equal ranks group to the left.
            let parentheses_right = rank(right) <= own || is_ambiguous(*operator, right);
            parenthesised(left, parentheses_left, out);
            let symbol = operator.symbol();
            if symbol.starts_with(|character: char| character.is_ascii_alphabetic()) {
                out.push(' ');
                out.push_str(symbol);
                out.push(' ');
            } else {
                out.push_str(symbol);
            }
            parenthesised(right, parentheses_right, out);
        }
    }
}

fn parenthesised(expression: &Expression, parentheses: bool, out: &mut String) {
    if parentheses {
        out.push('(');
    }
    push(expression, out);
    if parentheses {
        out.push(')');
    }
}
