//! Expressions: postfix records to infix text with the fewest parentheses.
//!
//! Precedence is the table of general-instructions.md A.9. A relation stands in parentheses wherever it is not the
//! whole expression: two published tables rank it differently. What begins with a minus sign stands in parentheses
//! after `+` and `-`.

use alloc::vec::Vec;

use super::operand::Piece;
use crate::error::ImageError;
use crate::format::*;
use crate::index::OperandIndex;
use crate::limits;
use crate::operand::Operation;

/// How an operator is written.
enum Spelling {
    Prefix(&'static str),
    Function(&'static str),
    Infix(&'static str),
}

use Spelling::{Function, Infix, Prefix};

/// How tightly what stands there binds: a larger rank binds tighter.
const RANK_OPERAND: u8 = 9;
const RANK_SIGN: u8 = 8;
const RANK_RELATION: u8 = 6;
const RANK_SUM: u8 = 5;

fn spelling(operator: u8) -> Option<(Spelling, u8)> {
    Some(match operator {
        OPERATION_NEGATE => (Prefix("-"), RANK_SIGN),
        OPERATION_NOT => (Prefix("NOT "), RANK_SIGN),
        OPERATION_ABSOLUTE => (Function("ABS("), RANK_OPERAND),
        OPERATION_SQUARE_ROOT => (Function("SQR("), RANK_OPERAND),
        OPERATION_MULTIPLY => (Infix("*"), 7),
        OPERATION_DIVIDE => (Infix("/"), 7),
        OPERATION_MODULO => (Infix(" MOD "), 7),
        OPERATION_LESS => (Infix("<"), RANK_RELATION),
        OPERATION_LESS_OR_EQUAL => (Infix("<="), RANK_RELATION),
        OPERATION_GREATER => (Infix(">"), RANK_RELATION),
        OPERATION_GREATER_OR_EQUAL => (Infix(">="), RANK_RELATION),
        OPERATION_EQUAL => (Infix("="), RANK_RELATION),
        OPERATION_NOT_EQUAL => (Infix("<>"), RANK_RELATION),
        OPERATION_ADD => (Infix("+"), RANK_SUM),
        OPERATION_SUBTRACT => (Infix("-"), RANK_SUM),
        OPERATION_AND => (Infix(" AND "), 4),
        OPERATION_XOR => (Infix(" XOR "), 3),
        OPERATION_OR => (Infix(" OR "), 2),
        _ => return None,
    })
}

/// A node of the tree that the postfix form describes; children are positions of earlier nodes.
struct Node {
    content: Content,
    rank: u8,
    begins_with_minus: bool,
}

enum Content {
    Operand(OperandIndex),
    One(&'static str, usize, bool),
    Two(usize, &'static str, usize),
    Call(&'static str, usize),
}

/// Appends the pieces of an expression in the order of the text. `is_negative` says whether an operand is a literal
/// with a minus sign.
pub(super) fn pieces<'a>(
    expression: OperandIndex,
    operations: &[Operation],
    depth: usize,
    is_negative: &dyn Fn(OperandIndex) -> bool,
    out: &mut Vec<Piece<'a>>,
) -> Result<(), ImageError> {
    let nodes = tree(expression, operations, is_negative)?;
    enum Task {
        Node(usize, bool),
        Word(&'static str),
    }
    let mut tasks = alloc::vec![Task::Node(nodes.len().saturating_sub(1), false)];
    while let Some(task) = tasks.pop() {
        let (position, wrapped) = match task {
            Task::Word(word) => {
                out.push(Piece::Text(word));
                continue;
            }
            Task::Node(position, wrapped) => (position, wrapped),
        };
        let Some(node) = nodes.get(position) else { continue };
        if wrapped {
            out.push(Piece::Text("("));
            tasks.push(Task::Word(")"));
        }
        let rank_of = |child: &usize| nodes.get(*child).map_or((0, false), |node| (node.rank, node.begins_with_minus));
        match &node.content {
            Content::Operand(operand) => out.push(Piece::Operand(*operand, depth)),
            Content::Call(name, child) => {
                out.push(Piece::Text(name));
                tasks.push(Task::Word(")"));
                tasks.push(Task::Node(*child, false));
            }
            Content::One(sign, child, is_minus) => {
                let (rank, minus) = rank_of(child);
                out.push(Piece::Text(sign));
                tasks.push(Task::Node(*child, rank < RANK_SIGN || (*is_minus && minus)));
            }
            Content::Two(left, sign, right) => {
                let (left_rank, _) = rank_of(left);
                let (right_rank, right_minus) = rank_of(right);
                let sum = node.rank == RANK_SUM;
                tasks.push(Task::Node(
                    *right,
                    right_rank == RANK_RELATION || right_rank <= node.rank || (sum && right_minus),
                ));
                tasks.push(Task::Word(sign));
                tasks.push(Task::Node(*left, left_rank == RANK_RELATION || left_rank < node.rank));
            }
        }
    }
    Ok(())
}

fn tree(
    expression: OperandIndex,
    operations: &[Operation],
    is_negative: &dyn Fn(OperandIndex) -> bool,
) -> Result<Vec<Node>, ImageError> {
    let wrong = ImageError::ExpressionShape { operand: expression };
    if operations.len() > limits::EXPRESSION_OPERATIONS {
        return Err(wrong);
    }
    let mut nodes: Vec<Node> = Vec::with_capacity(operations.len());
    let mut open: Vec<usize> = Vec::new();
    for operation in operations {
        let node = match operation {
            Operation::Push(operand) => Node {
                content: Content::Operand(*operand),
                rank: RANK_OPERAND,
                begins_with_minus: is_negative(*operand),
            },
            Operation::Apply(operator) => {
                let Some((spelling, rank)) = spelling(*operator) else { return Err(wrong) };
                let Some(last) = open.pop() else { return Err(wrong) };
                match spelling {
                    Prefix(sign) => {
                        let minus = *operator == OPERATION_NEGATE;
                        Node { content: Content::One(sign, last, minus), rank, begins_with_minus: minus }
                    }
                    Function(name) => Node { content: Content::Call(name, last), rank, begins_with_minus: false },
                    Infix(sign) => {
                        let Some(left) = open.pop() else { return Err(wrong) };
                        let begins = nodes.get(left).is_some_and(|left| {
                            left.begins_with_minus && left.rank >= rank && left.rank != RANK_RELATION
                        });
                        Node { content: Content::Two(left, sign, last), rank, begins_with_minus: begins }
                    }
                }
            }
        };
        open.push(nodes.len());
        nodes.push(node);
    }
    if open.len() == 1 { Ok(nodes) } else { Err(wrong) }
}
