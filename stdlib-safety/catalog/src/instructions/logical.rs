//! Bitwise logic. general-instructions.md A.7.

use crate::execution::{LEFT, NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, base};
use crate::operand::{Access, OperandKind::Integer, operand};

/// Bitwise and.
pub static AND: Instruction = Instruction {
    opcode: Opcode::And,
    mnemonic: "AND",
    name: "Bitwise AND",
    operands: &[
        operand("Source A", Integer(Access::Read)),
        operand("Source B", Integer(Access::Read)),
        operand("Dest", Integer(Access::Write)),
    ],
    summary: "Stores the bits set in both sources.",
    execution: execution(
        "Stores A AND B, bit by bit. SINT and INT are filled with zeros.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value; S:V and S:C are cleared.",
    ),
    ..base(Group::Logical, Position::Output)
};

/// Bitwise or.
pub static OR: Instruction = Instruction {
    opcode: Opcode::Or,
    mnemonic: "OR",
    name: "Bitwise OR",
    operands: &[
        operand("Source A", Integer(Access::Read)),
        operand("Source B", Integer(Access::Read)),
        operand("Dest", Integer(Access::Write)),
    ],
    summary: "Stores the bits set in either source.",
    execution: execution(
        "Stores A OR B, bit by bit. SINT and INT are filled with zeros.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value; S:V and S:C are cleared.",
    ),
    ..base(Group::Logical, Position::Output)
};

/// Bitwise exclusive or.
pub static XOR: Instruction = Instruction {
    opcode: Opcode::Xor,
    mnemonic: "XOR",
    name: "Bitwise Exclusive OR",
    operands: &[
        operand("Source A", Integer(Access::Read)),
        operand("Source B", Integer(Access::Read)),
        operand("Dest", Integer(Access::Write)),
    ],
    summary: "Stores the bits in which the sources differ.",
    execution: execution(
        "Stores A XOR B, bit by bit. SINT and INT are filled with zeros.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value; S:V and S:C are cleared.",
    ),
    ..base(Group::Logical, Position::Output)
};

/// Bitwise not.
pub static NOT: Instruction = Instruction {
    opcode: Opcode::Not,
    mnemonic: "NOT",
    name: "Bitwise NOT",
    operands: &[operand("Source", Integer(Access::Read)), operand("Dest", Integer(Access::Write))],
    summary: "Stores the inverted bits of the source.",
    execution: execution(
        "Stores Source with every bit inverted. SINT and INT are filled with zeros.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value; S:V and S:C are cleared.",
    ),
    ..base(Group::Logical, Position::Output)
};
