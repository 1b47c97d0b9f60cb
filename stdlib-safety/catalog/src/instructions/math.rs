//! Arithmetic. general-instructions.md A.9.

use crate::execution::{LEFT, NOTHING, execution};
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
    execution: execution(
        "Stores A + B. It is REAL where an operand or Dest is REAL, else DINT.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored. S:C is the carry of integers.",
    ),
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
    execution: execution(
        "Stores A - B. It is REAL where an operand or Dest is REAL, else DINT.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored. S:C is the carry of integers.",
    ),
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
    execution: execution(
        "Stores A * B. It is REAL where an operand or Dest is REAL, else DINT.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored.",
    ),
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
    execution: execution(
        "Stores A / B. Integers are divided toward zero; a REAL quotient for an integer Dest is rounded, halves to \
         even. Integer B = 0: stores A. REAL B = 0: stores infinity with the sign of A.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored. A division by 0 does so too.",
    ),
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
    execution: execution(
        "Stores the remainder of A / B, with the sign of A. B = 0: stores 0.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored. A division by 0 does so too.",
    ),
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
    execution: execution(
        "Stores the square root of the absolute value of Source: truncated for integers, rounded for a REAL Source \
         and an integer Dest.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored.",
    ),
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
    execution: execution(
        "Stores 0 - Source; -2147483648 stays as it is.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored.",
    ),
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
    execution: execution(
        "Stores the absolute value of Source; -2147483648 stays as it is.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored.",
    ),
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
    execution: execution(
        "Stores the value of the expression. It is REAL throughout where any operand or Dest is REAL, else DINT; \
         AND, OR, XOR and NOT are DINT always.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored.",
    ),
    safety: None,
};
