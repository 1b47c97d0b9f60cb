//! Bitwise logic. general-instructions.md A.7.

use crate::instruction::{Group, Instruction, Opcode, Position, Requires};
use crate::operand::{Access, OperandKind::Integer, operand};

/// Bitwise and.
pub static AND: Instruction = Instruction {
    opcode: Opcode::And,
    mnemonic: "AND",
    also: &[],
    name: "Bitwise AND",
    group: Group::Logical,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source A", Integer(Access::Read)),
        operand("Source B", Integer(Access::Read)),
        operand("Dest", Integer(Access::Write)),
    ],
    summary: "Stores the bits set in both sources.",
    safety: None,
};

/// Bitwise or.
pub static OR: Instruction = Instruction {
    opcode: Opcode::Or,
    mnemonic: "OR",
    also: &[],
    name: "Bitwise OR",
    group: Group::Logical,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source A", Integer(Access::Read)),
        operand("Source B", Integer(Access::Read)),
        operand("Dest", Integer(Access::Write)),
    ],
    summary: "Stores the bits set in either source.",
    safety: None,
};

/// Bitwise exclusive or.
pub static XOR: Instruction = Instruction {
    opcode: Opcode::Xor,
    mnemonic: "XOR",
    also: &[],
    name: "Bitwise Exclusive OR",
    group: Group::Logical,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source A", Integer(Access::Read)),
        operand("Source B", Integer(Access::Read)),
        operand("Dest", Integer(Access::Write)),
    ],
    summary: "Stores the bits in which the sources differ.",
    safety: None,
};

/// Bitwise not.
pub static NOT: Instruction = Instruction {
    opcode: Opcode::Not,
    mnemonic: "NOT",
    also: &[],
    name: "Bitwise NOT",
    group: Group::Logical,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Source", Integer(Access::Read)), operand("Dest", Integer(Access::Write))],
    summary: "Stores the inverted bits of the source.",
    safety: None,
};
