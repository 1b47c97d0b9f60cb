//! System values. general-instructions.md A.10.

use crate::execution::{LEFT, NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, base};
use crate::operand::{
    Access,
    OperandKind::{SystemAttribute, SystemClass, SystemData, SystemInstance},
    operand,
};

/// Get system value.
pub static GSV: Instruction = Instruction {
    opcode: Opcode::Gsv,
    mnemonic: "GSV",
    name: "Get System Value",
    operands: &[
        operand("Class Name", SystemClass),
        operand("Instance Name", SystemInstance),
        operand("Attribute Name", SystemAttribute),
        operand("Dest", SystemData(Access::Write)),
    ],
    summary: "Reads an attribute of a safety object.",
    execution: execution(
        "Writes the bytes of the attribute over those of Dest, low byte first, as COP does; what Dest has beyond them stays. \
         Both channels get one sample.",
        LEFT,
        NOTHING,
        "An object or an attribute that is not there and a Dest that is too small are refused when the program is compiled. \
         Major fault 4/20 when a tag subscript in Dest leaves too few bytes; nothing is then written.",
    ),
    ..base(Group::InputOutput, Position::Output)
};

/// Set system value.
pub static SSV: Instruction = Instruction {
    opcode: Opcode::Ssv,
    mnemonic: "SSV",
    name: "Set System Value",
    operands: &[
        operand("Class Name", SystemClass),
        operand("Instance Name", SystemInstance),
        operand("Attribute Name", SystemAttribute),
        operand("Source", SystemData(Access::Read)),
    ],
    summary: "Writes an attribute of a safety object.",
    execution: execution(
        "Writes the bytes of Source to the attribute, low byte first, as COP does.",
        "Nothing.",
        NOTHING,
        "An object or an attribute that is not there or cannot be set so and a Source that is too small are refused when the \
         program is compiled. Major fault 4/20 when a tag subscript in Source leaves too few bytes.",
    ),
    ..base(Group::InputOutput, Position::Output)
};

/// An attribute that GSV or SSV can reach from the safety task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Attribute {
    /// Number in an image.
    pub number: u8,
    /// Object class as text writes it.
    pub class: &'static str,
    /// Attribute name as text writes it.
    pub name: &'static str,
    /// Type of one element.
    pub element: crate::predefined::Element,
    /// How many elements.
    pub length: u32,
    /// Whether the instance operand names an object (else it is empty).
    pub has_instance: bool,
    /// Whether SSV may write it.
    pub writable: bool,
    /// What a controller must offer to read it.
    pub requires: Requires,
}

const fn attribute(
    number: u8,
    class: &'static str,
    name: &'static str,
    element: crate::predefined::Element,
    length: u32,
) -> Attribute {
    Attribute { number, class, name, element, length, has_instance: true, writable: false, requires: Requires::Any }
}

/// Every attribute of a safety object that the safety task can reach. general-instructions.md A.10; times in us
/// (decided: as the general Task object has them).
pub static ATTRIBUTES: &[Attribute] = {
    use crate::predefined::Element::{Dint, Int, Sint};
    &[
        attribute(1, "TASK", "Instance", Dint, 1),
        attribute(2, "TASK", "MaximumInterval", Dint, 2),
        attribute(3, "TASK", "MinimumInterval", Dint, 2),
        attribute(4, "TASK", "MaximumScanTime", Dint, 1),
        attribute(5, "TASK", "Priority", Int, 1),
        attribute(6, "TASK", "Rate", Dint, 1),
        attribute(7, "TASK", "Watchdog", Dint, 1),
        attribute(8, "PROGRAM", "Instance", Dint, 1),
        Attribute { writable: true, ..attribute(9, "PROGRAM", "MajorFaultRecord", Dint, 11) },
        attribute(10, "PROGRAM", "MaximumScanTime", Dint, 1),
        attribute(11, "ROUTINE", "Instance", Dint, 1),
        Attribute { has_instance: false, requires: Requires::L7x, ..attribute(12, "SAFETY", "SafetyLocked", Sint, 1) },
        Attribute { has_instance: false, ..attribute(13, "SAFETY", "SafetySignatureExists", Sint, 1) },
    ]
};
