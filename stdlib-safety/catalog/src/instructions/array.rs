//! Array (file) instructions. general-instructions.md A.6.

use crate::instruction::{Group, Instruction, Opcode, Position, Requires};
use crate::operand::{
    Access,
    OperandKind::{
        Array, Condition, ConstantLength, Dimension, Expression, FileMode, FillDestination, Number, Pseudo, Structure,
    },
    operand,
};
use crate::types::base::CONTROL;

/// File arithmetic and logic.
pub static FAL: Instruction = Instruction {
    opcode: Opcode::Fal,
    mnemonic: "FAL",
    also: &[],
    name: "File Arithmetic and Logic",
    group: Group::Array,
    first_version: 20,
    requires: Requires::L7x,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("Control", Structure(&CONTROL, Access::ReadWrite)),
        operand("Length", Pseudo("LEN")),
        operand("Position", Pseudo("POS")),
        operand("Mode", FileMode),
        operand("Dest", Number(Access::Write)),
        operand("Expression", Expression),
    ],
    summary: "Stores an expression for each element.",
    safety: None,
};

/// File search and compare.
pub static FSC: Instruction = Instruction {
    opcode: Opcode::Fsc,
    mnemonic: "FSC",
    also: &[],
    name: "File Search and Compare",
    group: Group::Array,
    first_version: 20,
    requires: Requires::L7x,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("Control", Structure(&CONTROL, Access::ReadWrite)),
        operand("Length", Pseudo("LEN")),
        operand("Position", Pseudo("POS")),
        operand("Mode", FileMode),
        operand("Expression", Condition),
    ],
    summary: "Looks for the first element for which the expression is true.",
    safety: None,
};

/// File fill.
pub static FLL: Instruction = Instruction {
    opcode: Opcode::Fll,
    mnemonic: "FLL",
    also: &[],
    name: "File Fill",
    group: Group::Array,
    first_version: 20,
    requires: Requires::L7x,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source", Number(Access::Read)),
        operand("Dest", FillDestination),
        operand("Length", ConstantLength),
    ],
    summary: "Stores one value into consecutive elements.",
    safety: None,
};

/// Size in elements.
pub static SIZE: Instruction = Instruction {
    opcode: Opcode::Size,
    mnemonic: "SIZE",
    also: &[],
    name: "Size In Elements",
    group: Group::Array,
    first_version: 20,
    requires: Requires::L7x,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source", Array),
        operand("Dimension to Vary", Dimension),
        operand("Size", Number(Access::Write)),
    ],
    summary: "Stores the number of elements of a dimension.",
    safety: None,
};
