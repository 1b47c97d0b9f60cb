//! Contacts, coils and one-shots. general-instructions.md A.1.

use crate::execution::{LEFT, NOT_READ, NOTHING, execution};
use crate::instruction::{Group, Instruction, Opcode, Position, Requires};
use crate::operand::{Access, OperandKind::Bit, operand};

/// Examine if closed.
pub static XIC: Instruction = Instruction {
    opcode: Opcode::Xic,
    mnemonic: "XIC",
    also: &[],
    name: "Examine If Closed",
    group: Group::Bit,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[operand("Data Bit", Bit(Access::Read))],
    summary: "Passes the rung condition while the bit is set.",
    execution: execution("Passes on while the bit is 1.", NOT_READ, NOTHING, ""),
    safety: None,
};

/// Examine if open.
pub static XIO: Instruction = Instruction {
    opcode: Opcode::Xio,
    mnemonic: "XIO",
    also: &[],
    name: "Examine If Open",
    group: Group::Bit,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: false,
    operands: &[operand("Data Bit", Bit(Access::Read))],
    summary: "Passes the rung condition while the bit is clear.",
    execution: execution("Passes on while the bit is 0.", NOT_READ, NOTHING, ""),
    safety: None,
};

/// Output energize.
pub static OTE: Instruction = Instruction {
    opcode: Opcode::Ote,
    mnemonic: "OTE",
    also: &[],
    name: "Output Energize",
    group: Group::Bit,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[operand("Data Bit", Bit(Access::Write))],
    summary: "Sets the bit to the rung condition.",
    execution: execution("Sets the bit.", "Clears the bit.", "Clears the bit.", ""),
    safety: None,
};

/// Output latch.
pub static OTL: Instruction = Instruction {
    opcode: Opcode::Otl,
    mnemonic: "OTL",
    also: &[],
    name: "Output Latch",
    group: Group::Bit,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Data Bit", Bit(Access::Write))],
    summary: "Sets the bit while the rung is true; a false rung leaves it.",
    execution: execution("Sets the bit.", LEFT, NOTHING, ""),
    safety: None,
};

/// Output unlatch.
pub static OTU: Instruction = Instruction {
    opcode: Opcode::Otu,
    mnemonic: "OTU",
    also: &[],
    name: "Output Unlatch",
    group: Group::Bit,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: false,
    operands: &[operand("Data Bit", Bit(Access::Write))],
    summary: "Clears the bit while the rung is true; a false rung leaves it.",
    execution: execution("Clears the bit.", LEFT, NOTHING, ""),
    safety: None,
};

/// One shot.
pub static ONS: Instruction = Instruction {
    opcode: Opcode::Ons,
    mnemonic: "ONS",
    also: &[],
    name: "One Shot",
    group: Group::Bit,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Input,
    transitional: true,
    operands: &[operand("Storage Bit", Bit(Access::ReadWrite))],
    summary: "Passes a true rung condition for one execution after it rose.",
    execution: execution(
        "Storage bit 0: sets it and passes on. Storage bit 1: is false.",
        "Clears the storage bit and is false.",
        "Sets the storage bit: an input that is on at the first scan gives no pulse.",
        "",
    ),
    safety: None,
};

/// One shot rising.
pub static OSR: Instruction = Instruction {
    opcode: Opcode::Osr,
    mnemonic: "OSR",
    also: &[],
    name: "One Shot Rising",
    group: Group::Bit,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[operand("Storage Bit", Bit(Access::ReadWrite)), operand("Output Bit", Bit(Access::Write))],
    summary: "Sets the output bit for one execution after the rung rose.",
    execution: execution(
        "Storage bit 0: sets it and the output bit. Storage bit 1: clears the output bit.",
        "Clears both bits.",
        "Sets the storage bit, clears the output bit.",
        "",
    ),
    safety: None,
};

/// One shot falling.
pub static OSF: Instruction = Instruction {
    opcode: Opcode::Osf,
    mnemonic: "OSF",
    also: &[],
    name: "One Shot Falling",
    group: Group::Bit,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Table 12",
    position: Position::Output,
    transitional: true,
    operands: &[operand("Storage Bit", Bit(Access::ReadWrite)), operand("Output Bit", Bit(Access::Write))],
    summary: "Sets the output bit for one execution after the rung fell.",
    execution: execution(
        "Sets the storage bit, clears the output bit.",
        "Storage bit 1: clears it and sets the output bit. Storage bit 0: clears the output bit.",
        "Clears both bits.",
        "",
    ),
    safety: None,
};
