//! Array (file) instructions. general-instructions.md A.6.

use crate::execution::{LEFT, NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, base};
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
    name: "File Arithmetic and Logic",
    first_version: 20,
    requires: Requires::L7x,
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
    execution: execution(
        "A rising rung begins, ALL and a number n at POS 0. ALL: every element in that scan. INC: one element for \
         each rising rung. A number n: n elements in each scan until done. DN is set after the last element.",
        "Clears EN; when DN is set, DN and POS too. A number n goes on until it is done.",
        "Clears EN, DN and ER; POS stays.",
        "An overflow sets ER, POS stays on that element, and nothing runs until ER is cleared. Major fault 4/21 \
         when LEN or POS is negative, 4/20 when a subscript leads out of its array.",
    ),
    ..base(Group::Array, Position::Output)
};

/// File search and compare.
pub static FSC: Instruction = Instruction {
    opcode: Opcode::Fsc,
    mnemonic: "FSC",
    name: "File Search and Compare",
    first_version: 20,
    requires: Requires::L7x,
    transitional: true,
    operands: &[
        operand("Control", Structure(&CONTROL, Access::ReadWrite)),
        operand("Length", Pseudo("LEN")),
        operand("Position", Pseudo("POS")),
        operand("Mode", FileMode),
        operand("Expression", Condition),
    ],
    summary: "Looks for the first element for which the expression is true.",
    execution: execution(
        "A rising rung begins, ALL and a number n at POS 0. ALL: every element in that scan. INC: one element for \
         each rising rung. A number n: n elements in each scan. A hit sets FD and IN, POS stays on it, and nothing \
         runs until IN is cleared; then the search goes on behind it. DN is set after the last element.",
        "Clears EN; when DN is set, DN and POS too. A number n goes on until it is done.",
        "Clears EN, DN and ER; POS, IN and FD stay.",
        "Arithmetic that overflows sets S:V and logs minor fault 4/4. Major fault 4/21 when LEN or POS is \
         negative, 4/20 when a subscript leads out of its array.",
    ),
    ..base(Group::Array, Position::Output)
};

/// File fill.
pub static FLL: Instruction = Instruction {
    opcode: Opcode::Fll,
    mnemonic: "FLL",
    name: "File Fill",
    first_version: 20,
    requires: Requires::L7x,
    operands: &[
        operand("Source", Number(Access::Read)),
        operand("Dest", FillDestination),
        operand("Length", ConstantLength),
    ],
    summary: "Stores one value into consecutive elements.",
    execution: execution(
        "Converts Source and stores it into Length elements, beginning with Dest.",
        LEFT,
        NOTHING,
        "Major fault 4/20 when a subscript leads out of its array. A value that does not fit sets S:V and logs \
         minor fault 4/4.",
    ),
    ..base(Group::Array, Position::Output)
};

/// Size in elements.
pub static SIZE: Instruction = Instruction {
    opcode: Opcode::Size,
    mnemonic: "SIZE",
    name: "Size In Elements",
    first_version: 20,
    requires: Requires::L7x,
    operands: &[
        operand("Source", Array),
        operand("Dimension to Vary", Dimension),
        operand("Size", Number(Access::Write)),
    ],
    summary: "Stores the number of elements of a dimension.",
    execution: execution("Stores the number of elements of the dimension.", LEFT, NOTHING, "The flags stay."),
    ..base(Group::Array, Position::Output)
};
