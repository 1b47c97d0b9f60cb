//! The one table of what no valid program can reach, each row with its reason.

use twinrung_catalog::{Element, Opcode, OperandKind};

use super::form::Form;
use super::universe::{Point, What};

/// Points that cannot be reached.
#[derive(Debug, Clone, Copy)]
pub struct Unreachable {
    /// Which; the kind is that of the operand that is meant.
    covers: fn(Opcode, What, Option<OperandKind>) -> bool,
    /// Why.
    pub reason: &'static str,
}

/// The form of an operand that a point is about.
fn form(what: What) -> Option<Form> {
    match what {
        What::Operand(_, form) => Some(form),
        What::Outcome(..) | What::Value(..) => None,
    }
}

/// The table.
pub static UNREACHABLE: &[Unreachable] = &[
    Unreachable {
        covers: |opcode, what, _| opcode == Opcode::Afi && what == What::Outcome(true, true),
        reason: "AFI makes every rung false",
    },
    Unreachable {
        covers: |opcode, what, kind| {
            opcode.instruction().safety.is_some()
                && matches!(kind, Some(OperandKind::Structure(..)))
                && matches!(form(what), Some(Form::ElementByTag | Form::ElementByExpression))
        },
        reason: "S0601: no variable subscript selects a backing tag",
    },
    Unreachable {
        covers: |opcode, what, _| {
            matches!(opcode, Opcode::Jsr | Opcode::Sbr | Opcode::Ret)
                && matches!(form(what), Some(Form::InOut | Form::Instance))
        },
        reason: "an Add-On Instruction has no subroutines, and its routines receive and return nothing",
    },
    Unreachable {
        covers: |opcode, what, _| {
            opcode == Opcode::Swpb && matches!(form(what), Some(Form::Of(Element::Sint) | Form::Integer | Form::Real))
        },
        reason: "S0605: SWPB takes INT, DINT or REAL tags",
    },
    Unreachable {
        covers: |_, what, kind| kind == Some(OperandKind::Array) && form(what) == Some(Form::Tag),
        reason: "E0302: SIZE measures an array, or that of an element",
    },
    Unreachable {
        covers: |_, what, kind| {
            matches!(kind, Some(OperandKind::SystemData(_))) && form(what) == Some(Form::Of(Element::Real))
        },
        reason: "E0302: GSV and SSV take integers and structures",
    },
];

/// Why a point cannot be reached; none where it can.
pub fn reason(point: &Point) -> Option<&'static str> {
    let kind = match point.what {
        What::Operand(position, _) | What::Value(position, _) => {
            point.opcode.instruction().operands.get(usize::from(position)).map(|operand| operand.kind)
        }
        What::Outcome(..) => None,
    };
    UNREACHABLE.iter().find(|row| (row.covers)(point.opcode, point.what, kind)).map(|row| row.reason)
}
