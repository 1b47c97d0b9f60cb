//! Moves and copies. general-instructions.md A.5 and A.6.

use crate::execution::{LEFT, NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, base};
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
    operands: &[operand("Source", Number(Access::Read)), operand("Dest", Number(Access::Write))],
    summary: "Stores the converted source.",
    execution: execution(
        "Converts Source to the type of Dest and stores it.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A value that does not fit Dest sets S:V and logs minor fault 4/4; its \
         low bits are stored.",
    ),
    ..base(Group::Move, Position::Output)
};

/// Masked move.
pub static MVM: Instruction = Instruction {
    opcode: Opcode::Mvm,
    mnemonic: "MVM",
    name: "Masked Move",
    operands: &[
        operand("Source", Integer(Access::Read)),
        operand("Mask", Integer(Access::Read)),
        operand("Dest", Integer(Access::ReadWrite)),
    ],
    summary: "Stores the bits of the source that the mask sets.",
    execution: execution(
        "Stores the bits of Source that Mask sets; the other bits of Dest stay. SINT and INT are filled with zeros.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value; S:V and S:C are cleared.",
    ),
    ..base(Group::Move, Position::Output)
};

/// Clear.
pub static CLR: Instruction = Instruction {
    opcode: Opcode::Clr,
    mnemonic: "CLR",
    name: "Clear",
    operands: &[operand("Dest", Number(Access::Write))],
    summary: "Stores 0.",
    execution: execution("Stores 0.", LEFT, NOTHING, "S:Z is set; S:N, S:V and S:C are cleared."),
    ..base(Group::Move, Position::Output)
};

/// Copy.
pub static COP: Instruction = Instruction {
    opcode: Opcode::Cop,
    mnemonic: "COP",
    name: "Copy",
    operands: &[operand("Source", CopySource), operand("Dest", CopyDestination), operand("Length", ConstantLength)],
    summary: "Copies bytes without conversion; the length is a constant and both sides have the same size.",
    execution: execution(
        "Copies Length elements of Dest byte by byte, first to last, without conversion.",
        LEFT,
        NOTHING,
        "Major fault 4/20 when a subscript leads out of its array. The flags stay.",
    ),
    ..base(Group::Move, Position::Output)
};

/// Swap byte.
pub static SWPB: Instruction = Instruction {
    opcode: Opcode::Swpb,
    mnemonic: "SWPB",
    name: "Swap Byte",
    first_version: 20,
    requires: Requires::L7x,
    operands: &[
        operand("Source", Number(Access::Read)),
        operand("Order Mode", ByteOrder),
        operand("Dest", Number(Access::Write)),
    ],
    summary: "Stores the source with its bytes in another order.",
    execution: execution(
        "Stores the bytes in another order. Four bytes ABCD become DCBA (REVERSE), CDAB (WORD) or BADC (HIGH/LOW); \
         two bytes AB become BA.",
        LEFT,
        NOTHING,
        "The flags stay.",
    ),
    ..base(Group::Move, Position::Output)
};
