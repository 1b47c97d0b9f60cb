//! Comparisons. general-instructions.md A.4.

use crate::execution::{NOT_READ, NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, base};
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
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A equals B.",
    execution: execution(
        "Passes on when A equals B. The comparison is REAL where an operand is REAL, else DINT. NaN equals nothing.",
        NOT_READ,
        NOTHING,
        "",
    ),
    ..base(Group::Compare, Position::Input)
};

/// Not equal to.
pub static NEQ: Instruction = Instruction {
    opcode: Opcode::Neq,
    mnemonic: "NEQ",
    also: &["NE"],
    name: "Not Equal To",
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A differs from B.",
    execution: execution(
        "Passes on when A differs from B. The comparison is REAL where an operand is REAL, else DINT. NaN differs \
         from everything.",
        NOT_READ,
        NOTHING,
        "",
    ),
    ..base(Group::Compare, Position::Input)
};

/// Greater than.
pub static GRT: Instruction = Instruction {
    opcode: Opcode::Grt,
    mnemonic: "GRT",
    also: &["GT"],
    name: "Greater Than",
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A is greater than B.",
    execution: execution(
        "Passes on when A is above B. The comparison is REAL where an operand is REAL, else DINT. With NaN it is \
         false.",
        NOT_READ,
        NOTHING,
        "",
    ),
    ..base(Group::Compare, Position::Input)
};

/// Greater than or equal to.
pub static GEQ: Instruction = Instruction {
    opcode: Opcode::Geq,
    mnemonic: "GEQ",
    also: &["GE"],
    name: "Greater Than Or Equal To",
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A is greater than or equal to B.",
    execution: execution(
        "Passes on when A is B or above. The comparison is REAL where an operand is REAL, else DINT. With NaN it \
         is false.",
        NOT_READ,
        NOTHING,
        "",
    ),
    ..base(Group::Compare, Position::Input)
};

/// Less than.
pub static LES: Instruction = Instruction {
    opcode: Opcode::Les,
    mnemonic: "LES",
    also: &["LT"],
    name: "Less Than",
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A is less than B.",
    execution: execution(
        "Passes on when A is below B. The comparison is REAL where an operand is REAL, else DINT. With NaN it is \
         false.",
        NOT_READ,
        NOTHING,
        "",
    ),
    ..base(Group::Compare, Position::Input)
};

/// Less than or equal to.
pub static LEQ: Instruction = Instruction {
    opcode: Opcode::Leq,
    mnemonic: "LEQ",
    also: &["LE"],
    name: "Less Than Or Equal To",
    operands: &[operand("Source A", Number(Access::Read)), operand("Source B", Number(Access::Read))],
    summary: "Passes while A is less than or equal to B.",
    execution: execution(
        "Passes on when A is B or below. The comparison is REAL where an operand is REAL, else DINT. With NaN it \
         is false.",
        NOT_READ,
        NOTHING,
        "",
    ),
    ..base(Group::Compare, Position::Input)
};

/// Limit test.
pub static LIM: Instruction = Instruction {
    opcode: Opcode::Lim,
    mnemonic: "LIM",
    also: &["LIMIT"],
    name: "Limit Test",
    operands: &[
        operand("Low Limit", Number(Access::Read)),
        operand("Test", Number(Access::Read)),
        operand("High Limit", Number(Access::Read)),
    ],
    summary: "Passes while the test value lies within the limits; with low above high, while it lies outside the open gap.",
    execution: execution(
        "Low Limit at most High Limit: passes on when Test lies between them, both ends included. Low Limit above \
         High Limit: when Test is at least Low Limit or at most High Limit.",
        NOT_READ,
        NOTHING,
        "",
    ),
    ..base(Group::Compare, Position::Input)
};

/// Masked comparison for equal.
pub static MEQ: Instruction = Instruction {
    opcode: Opcode::Meq,
    mnemonic: "MEQ",
    name: "Masked Comparison for Equal",
    operands: &[
        operand("Source", Integer(Access::Read)),
        operand("Mask", Integer(Access::Read)),
        operand("Compare", Integer(Access::Read)),
    ],
    summary: "Passes while source and compare agree in the bits that the mask sets.",
    execution: execution(
        "Passes on when Source and Compare agree in every bit that Mask sets. SINT and INT are filled with zeros.",
        NOT_READ,
        NOTHING,
        "",
    ),
    ..base(Group::Compare, Position::Input)
};

/// Compare by expression.
pub static CMP: Instruction = Instruction {
    opcode: Opcode::Cmp,
    mnemonic: "CMP",
    name: "Compare",
    first_version: 20,
    requires: Requires::L7x,
    operands: &[operand("Expression", Condition)],
    summary: "Passes while the expression is true.",
    execution: execution(
        "Passes on when the relation holds; without a relation, when the value is not 0.",
        NOT_READ,
        NOTHING,
        "Arithmetic that overflows sets S:V and logs minor fault 4/4; the other flags stay.",
    ),
    ..base(Group::Compare, Position::Input)
};
