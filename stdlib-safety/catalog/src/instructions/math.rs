//! Arithmetic. general-instructions.md A.9.

use crate::execution::{LEFT, NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, base};
use crate::operand::{
    Access,
    OperandKind::{Expression, Number},
    operand,
};

/// Add.
pub static ADD: Instruction = Instruction {
    opcode: Opcode::Add,
    mnemonic: "ADD",
    name: "Add",
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
    ..base(Group::Math, Position::Output)
};

/// Subtract.
pub static SUB: Instruction = Instruction {
    opcode: Opcode::Sub,
    mnemonic: "SUB",
    name: "Subtract",
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
    ..base(Group::Math, Position::Output)
};

/// Multiply.
pub static MUL: Instruction = Instruction {
    opcode: Opcode::Mul,
    mnemonic: "MUL",
    name: "Multiply",
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
    ..base(Group::Math, Position::Output)
};

/// Divide.
pub static DIV: Instruction = Instruction {
    opcode: Opcode::Div,
    mnemonic: "DIV",
    name: "Divide",
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
    ..base(Group::Math, Position::Output)
};

/// Modulo.
pub static MOD: Instruction = Instruction {
    opcode: Opcode::Mod,
    mnemonic: "MOD",
    name: "Modulo",
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
    ..base(Group::Math, Position::Output)
};

/// Square root.
pub static SQR: Instruction = Instruction {
    opcode: Opcode::Sqr,
    mnemonic: "SQR",
    also: &["SQRT"],
    name: "Square Root",
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
    ..base(Group::Math, Position::Output)
};

/// Negate.
pub static NEG: Instruction = Instruction {
    opcode: Opcode::Neg,
    mnemonic: "NEG",
    name: "Negate",
    operands: &[operand("Source", Number(Access::Read)), operand("Dest", Number(Access::Write))],
    summary: "Stores 0 - source.",
    execution: execution(
        "Stores 0 - Source; -2147483648 stays as it is.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored.",
    ),
    ..base(Group::Math, Position::Output)
};

/// Absolute value.
pub static ABS: Instruction = Instruction {
    opcode: Opcode::Abs,
    mnemonic: "ABS",
    name: "Absolute Value",
    operands: &[operand("Source", Number(Access::Read)), operand("Dest", Number(Access::Write))],
    summary: "Stores the value without its sign.",
    execution: execution(
        "Stores the absolute value of Source; -2147483648 stays as it is.",
        LEFT,
        NOTHING,
        "S:Z and S:N tell the stored value. A result that does not fit sets S:V and logs minor fault 4/4; its low \
         bits are stored.",
    ),
    ..base(Group::Math, Position::Output)
};

/// Compute.
pub static CPT: Instruction = Instruction {
    opcode: Opcode::Cpt,
    mnemonic: "CPT",
    name: "Compute",
    first_version: 20,
    requires: Requires::L7x,
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
    ..base(Group::Math, Position::Output)
};
