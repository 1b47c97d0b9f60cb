//! Contacts, coils and one-shots. general-instructions.md A.1.

use crate::execution::{LEFT, NOT_READ, NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, base};
use crate::operand::{Access, OperandKind::Bit, operand};

/// Examine if closed.
pub static XIC: Instruction = Instruction {
    opcode: Opcode::Xic,
    mnemonic: "XIC",
    name: "Examine If Closed",
    operands: &[operand("Data Bit", Bit(Access::Read))],
    summary: "Passes the rung condition while the bit is set.",
    execution: execution("Passes on while the bit is 1.", NOT_READ, NOTHING, ""),
    ..base(Group::Bit, Position::Input)
};

/// Examine if open.
pub static XIO: Instruction = Instruction {
    opcode: Opcode::Xio,
    mnemonic: "XIO",
    name: "Examine If Open",
    operands: &[operand("Data Bit", Bit(Access::Read))],
    summary: "Passes the rung condition while the bit is clear.",
    execution: execution("Passes on while the bit is 0.", NOT_READ, NOTHING, ""),
    ..base(Group::Bit, Position::Input)
};

/// Output energize.
pub static OTE: Instruction = Instruction {
    opcode: Opcode::Ote,
    mnemonic: "OTE",
    name: "Output Energize",
    transitional: true,
    operands: &[operand("Data Bit", Bit(Access::Write))],
    summary: "Sets the bit to the rung condition.",
    execution: execution("Sets the bit.", "Clears the bit.", "Clears the bit.", ""),
    ..base(Group::Bit, Position::Output)
};

/// Output latch.
pub static OTL: Instruction = Instruction {
    opcode: Opcode::Otl,
    mnemonic: "OTL",
    name: "Output Latch",
    operands: &[operand("Data Bit", Bit(Access::Write))],
    summary: "Sets the bit while the rung is true; a false rung leaves it.",
    execution: execution("Sets the bit.", LEFT, NOTHING, ""),
    ..base(Group::Bit, Position::Output)
};

/// Output unlatch.
pub static OTU: Instruction = Instruction {
    opcode: Opcode::Otu,
    mnemonic: "OTU",
    name: "Output Unlatch",
    operands: &[operand("Data Bit", Bit(Access::Write))],
    summary: "Clears the bit while the rung is true; a false rung leaves it.",
    execution: execution("Clears the bit.", LEFT, NOTHING, ""),
    ..base(Group::Bit, Position::Output)
};

/// One shot.
pub static ONS: Instruction = Instruction {
    opcode: Opcode::Ons,
    mnemonic: "ONS",
    name: "One Shot",
    transitional: true,
    operands: &[operand("Storage Bit", Bit(Access::ReadWrite))],
    summary: "Passes a true rung condition for one execution after it rose.",
    execution: execution(
        "Storage bit 0: sets it and passes on. Storage bit 1: is false.",
        "Clears the storage bit and is false.",
        "Sets the storage bit: an input that is on at the first scan gives no pulse.",
        "",
    ),
    ..base(Group::Bit, Position::Input)
};

/// One shot rising.
pub static OSR: Instruction = Instruction {
    opcode: Opcode::Osr,
    mnemonic: "OSR",
    name: "One Shot Rising",
    transitional: true,
    operands: &[operand("Storage Bit", Bit(Access::ReadWrite)), operand("Output Bit", Bit(Access::Write))],
    summary: "Sets the output bit for one execution after the rung rose.",
    execution: execution(
        "Storage bit 0: sets it and the output bit. Storage bit 1: clears the output bit.",
        "Clears both bits.",
        "Sets the storage bit, clears the output bit.",
        "",
    ),
    ..base(Group::Bit, Position::Output)
};

/// One shot falling.
pub static OSF: Instruction = Instruction {
    opcode: Opcode::Osf,
    mnemonic: "OSF",
    name: "One Shot Falling",
    transitional: true,
    operands: &[operand("Storage Bit", Bit(Access::ReadWrite)), operand("Output Bit", Bit(Access::Write))],
    summary: "Sets the output bit for one execution after the rung fell.",
    execution: execution(
        "Sets the storage bit, clears the output bit.",
        "Storage bit 1: clears it and sets the output bit. Storage bit 0: clears the output bit.",
        "Clears both bits.",
        "",
    ),
    ..base(Group::Bit, Position::Output)
};
