//! Operands as trees: what an instruction's operand says, with every name resolved. Nothing here knows the image.

mod argument;
mod expression;
mod fit;
mod literal;
mod reference;
mod resolve;
mod special;
mod system;

pub(crate) use argument::{read_argument, read_instance};
pub(crate) use expression::ExpressionKind;
pub use expression::{BinaryOperator, Expression, UnaryOperator};
pub(crate) use fit::operand as read;
pub(crate) use literal::{Literal, literal_of};
pub use reference::{BitPlace, Location, LocationBase, Reference, Root, Shape, Step, Subscript, Term};
pub(crate) use reference::{Scope, Walk};
pub(crate) use resolve::{alias_target, reference as read_reference};
pub use system::{SystemInstance, SystemValue};

use twinrung_grammar::tree::CompactString;

use crate::project::RoutineId;

/// One operand. Operands that say the same within one scope are one entry of [`crate::Project::operands`].
#[derive(Debug, Clone, PartialEq)]
pub enum Operand {
    /// An integer literal.
    Integer {
        /// Its value: 32 bits as written.
        value: i32,
        /// 10, 16, 8 or 2: how the text writes it.
        radix: u8,
    },
    /// A REAL literal: the bits of the binary32.
    Real(u32),
    /// The value of a word out of a list. File mode: 0 = ALL, -1 = INC, n = n; byte order: 0 = REVERSE, 1 = WORD, 2 =
    /// HIGH/LOW.
    Choice(i32),
    /// `?`, or nothing in the place of a GSV instance.
    Unassigned,
    /// A label, an object class or an object's name.
    Text(CompactString),
    /// A routine of the same program.
    Routine(RoutineId),
    /// A status keyword: its number in [`twinrung_bytecode::format::STATUS_KEYWORDS`].
    Status(u8),
    /// An attribute of a system object.
    SystemValue(SystemValue),
    /// A standard event task.
    EventTask(CompactString),
    /// An expression of CMP, CPT, FAL or FSC.
    Expression(Expression),
    /// Data.
    Reference(Reference),
}

impl Operand {
    /// The reference, when it is one.
    pub fn reference(&self) -> Option<&Reference> {
        match self {
            Operand::Reference(reference) => Some(reference),
            _ => None,
        }
    }
}
