//! Moves and copies. general-instructions.md A.5 and A.6.

use crate::instruction::{Group, Instruction, Opcode, Position, Requires};
use crate::operand::{
    Access,
    OperandKind::{ByteOrder, ConstantLength, CopyDestination, CopySource, Integer, Number},
    operand,
};

/// Move.
pub static MOV: Instruction = Instruction {
    opcode: Opcode::Mov,
    mnemonic: "MOV",
    also: &["MOVE"],
    name: "Move",
    group: Group::Move,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Source", Number(Access::Read)), operand("Dest", Number(Access::Write))],
    summary: "Stores the converted source.",
    safety: None,
};

/// Masked move.
pub static MVM: Instruction = Instruction {
    opcode: Opcode::Mvm,
    mnemonic: "MVM",
    also: &[],
    name: "Masked Move",
    group: Group::Move,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source", Integer(Access::Read)),
        operand("Mask", Integer(Access::Read)),
        operand("Dest", Integer(Access::ReadWrite)),
    ],
    summary: "Stores the bits of the source that the mask sets.",
    safety: None,
};

/// Clear.
pub static CLR: Instruction = Instruction {
    opcode: Opcode::Clr,
    mnemonic: "CLR",
    also: &[],
    name: "Clear",
    group: Group::Move,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Dest", Number(Access::Write))],
    summary: "Stores 0.",
    safety: None,
};

/// Copy.
pub static COP: Instruction = Instruction {
    opcode: Opcode::Cop,
    mnemonic: "COP",
    also: &[],
    name: "Copy",
    group: Group::Move,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Source", CopySource), operand("Dest", CopyDestination), operand("Length", ConstantLength)],
    summary: "Copies bytes without conversion; the length is a constant and both sides have the same size.",
    safety: None,
};

/// Swap byte.
pub static SWPB: Instruction = Instruction {
    opcode: Opcode::Swpb,
    mnemonic: "SWPB",
    also: &[],
    name: "Swap Byte",
    group: Group::Move,
    first_version: 20,
    requires: Requires::L7x,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source", Number(Access::Read)),
        operand("Order Mode", ByteOrder),
        operand("Dest", Number(Access::Write)),
    ],
    summary: "Stores the source with its bytes in another order.",
    safety: None,
};
