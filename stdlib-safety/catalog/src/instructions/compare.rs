//! Comparisons. general-instructions.md A.4.

use crate::instruction::{Group, Instruction, Opcode, Position, Requires};
use crate::operand::{
    Access,
    OperandKind::{Condition, Integer, Number},
    operand,
};

/// Equal to.
pub static EQU: Instruction = Instruction {
    opcode: Opcode::Equ,
    mnemonic: "EQU",
    also: &["EQ"],
    name: "Equal To",
    group: Group::Compare,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A equals B.",
    safety: None,
};

/// Not equal to.
pub static NEQ: Instruction = Instruction {
    opcode: Opcode::Neq,
    mnemonic: "NEQ",
    also: &["NE"],
    name: "Not Equal To",
    group: Group::Compare,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A differs from B.",
    safety: None,
};

/// Greater than.
pub static GRT: Instruction = Instruction {
    opcode: Opcode::Grt,
    mnemonic: "GRT",
    also: &["GT"],
    name: "Greater Than",
    group: Group::Compare,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A is greater than B.",
    safety: None,
};

/// Greater than or equal to.
pub static GEQ: Instruction = Instruction {
    opcode: Opcode::Geq,
    mnemonic: "GEQ",
    also: &["GE"],
    name: "Greater Than Or Equal To",
    group: Group::Compare,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A is greater than or equal to B.",
    safety: None,
};

/// Less than.
pub static LES: Instruction = Instruction {
    opcode: Opcode::Les,
    mnemonic: "LES",
    also: &["LT"],
    name: "Less Than",
    group: Group::Compare,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A is less than B.",
    safety: None,
};

/// Less than or equal to.
pub static LEQ: Instruction = Instruction {
    opcode: Opcode::Leq,
    mnemonic: "LEQ",
    also: &["LE"],
    name: "Less Than Or Equal To",
    group: Group::Compare,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A is less than or equal to B.",
    safety: None,
};

/// Limit test.
pub static LIM: Instruction = Instruction {
    opcode: Opcode::Lim,
    mnemonic: "LIM",
    also: &["LIMIT"],
    name: "Limit Test",
    group: Group::Compare,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[
        operand("Low Limit", Number(Access::Read)),
        operand("Test", Number(Access::Read)),
        operand("High Limit", Number(Access::Read)),
    ],
    summary: "Passes while the test value lies within the limits; with low above high, while it lies outside the open gap.",
    safety: None,
};

/// Masked comparison for equal.
pub static MEQ: Instruction = Instruction {
    opcode: Opcode::Meq,
    mnemonic: "MEQ",
    also: &[],
    name: "Masked Comparison for Equal",
    group: Group::Compare,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[
        operand("Source", Integer(Access::Read)),
        operand("Mask", Integer(Access::Read)),
        operand("Compare", Integer(Access::Read)),
    ],
    summary: "Passes while source and compare agree in the bits that the mask sets.",
    safety: None,
};

/// Compare by expression.
pub static CMP: Instruction = Instruction {
    opcode: Opcode::Cmp,
    mnemonic: "CMP",
    also: &[],
    name: "Compare",
    group: Group::Compare,
    first_version: 20,
    requires: Requires::L7x,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[operand("Expression", Condition)],
    summary: "Passes while the expression is true.",
    safety: None,
};
