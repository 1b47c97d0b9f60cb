//! Arithmetic. general-instructions.md A.9.

use crate::instruction::{Group, Instruction, Opcode, Position, Requires};
use crate::operand::{
    Access,
    OperandKind::{Expression, Number},
    operand,
};

/// Add.
pub static ADD: Instruction = Instruction {
    opcode: Opcode::Add,
    mnemonic: "ADD",
    also: &[],
    name: "Add",
    group: Group::Math,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source A", Number(Access::Read)),
        operand("Source B", Number(Access::Read)),
        operand("Dest", Number(Access::Write)),
    ],
    summary: "Stores A + B.",
    safety: None,
};

/// Subtract.
pub static SUB: Instruction = Instruction {
    opcode: Opcode::Sub,
    mnemonic: "SUB",
    also: &[],
    name: "Subtract",
    group: Group::Math,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source A", Number(Access::Read)),
        operand("Source B", Number(Access::Read)),
        operand("Dest", Number(Access::Write)),
    ],
    summary: "Stores A - B.",
    safety: None,
};

/// Multiply.
pub static MUL: Instruction = Instruction {
    opcode: Opcode::Mul,
    mnemonic: "MUL",
    also: &[],
    name: "Multiply",
    group: Group::Math,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source A", Number(Access::Read)),
        operand("Source B", Number(Access::Read)),
        operand("Dest", Number(Access::Write)),
    ],
    summary: "Stores A x B.",
    safety: None,
};

/// Divide.
pub static DIV: Instruction = Instruction {
    opcode: Opcode::Div,
    mnemonic: "DIV",
    also: &[],
    name: "Divide",
    group: Group::Math,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source A", Number(Access::Read)),
        operand("Source B", Number(Access::Read)),
        operand("Dest", Number(Access::Write)),
    ],
    summary: "Stores A / B, truncated where all operands are integers.",
    safety: None,
};

/// Modulo.
pub static MOD: Instruction = Instruction {
    opcode: Opcode::Mod,
    mnemonic: "MOD",
    also: &[],
    name: "Modulo",
    group: Group::Math,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[
        operand("Source A", Number(Access::Read)),
        operand("Source B", Number(Access::Read)),
        operand("Dest", Number(Access::Write)),
    ],
    summary: "Stores the remainder of A / B with the sign of A.",
    safety: None,
};

/// Square root.
pub static SQR: Instruction = Instruction {
    opcode: Opcode::Sqr,
    mnemonic: "SQR",
    also: &["SQRT"],
    name: "Square Root",
    group: Group::Math,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Source", Number(Access::Read)), operand("Dest", Number(Access::Write))],
    summary: "Stores the square root of the absolute value.",
    safety: None,
};

/// Negate.
pub static NEG: Instruction = Instruction {
    opcode: Opcode::Neg,
    mnemonic: "NEG",
    also: &[],
    name: "Negate",
    group: Group::Math,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Source", Number(Access::Read)), operand("Dest", Number(Access::Write))],
    summary: "Stores 0 - source.",
    safety: None,
};

/// Absolute value.
pub static ABS: Instruction = Instruction {
    opcode: Opcode::Abs,
    mnemonic: "ABS",
    also: &[],
    name: "Absolute Value",
    group: Group::Math,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Source", Number(Access::Read)), operand("Dest", Number(Access::Write))],
    summary: "Stores the value without its sign.",
    safety: None,
};

/// Compute.
pub static CPT: Instruction = Instruction {
    opcode: Opcode::Cpt,
    mnemonic: "CPT",
    also: &[],
    name: "Compute",
    group: Group::Math,
    first_version: 20,
    requires: Requires::L7x,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Dest", Number(Access::Write)), operand("Expression", Expression)],
    summary: "Stores the value of the expression.",
    safety: None,
};
