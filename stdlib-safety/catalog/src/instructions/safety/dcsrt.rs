//! DCSRT. dual-channel-inputs.md 8B.

use super::choices::{INPUT_TYPE, START_FUNCTION};
use super::codes;
use crate::code::diagnostic;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG, TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::dual_channel::DCI_START;

/// Dual Channel Input - Start.
pub static DCSRT: Instruction = Instruction {
    opcode: Opcode::Dcsrt,
    mnemonic: "DCSRT",
    also: &[],
    name: "Dual Channel Input - Start",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("DCSRT", Structure(&DCI_START, Access::ReadWrite)),
        operand("Safety Function", Choice(&START_FUNCTION)),
        operand("Input Type", Choice(&INPUT_TYPE)),
        operand("Discrepancy Time", milliseconds(5, 3000)),
        operand("Enable", TAG_OR_IMMEDIATE),
        operand("Channel A", TAG),
        operand("Channel B", TAG),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "O1 starts when both channels become active together while enabled.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &DCI_START,
        mirrored: &[
            "SafetyFunction",
            "InputType",
            "DiscrepancyTime",
            "Enable",
            "ChannelA",
            "ChannelB",
            "InputStatus",
            "Reset",
        ],
        decides: &["Channel A", "Channel B"],
        channels: &["Channel A", "Channel B"],
        safety_only: &["Channel A", "Channel B"],
        relations: &[Relation::DifferentTags("Channel A", "Channel B")],
        codes: &[
            codes::INPUT_STATUS_LOST,
            codes::A_ACTIVE_ALONE,
            codes::B_ACTIVE_ALONE,
            codes::A_CYCLED_ALONE,
            codes::B_CYCLED_ALONE,
            codes::RESET_HELD,
            codes::INPUT_STATUS_OFF,
            diagnostic(0xF130, "The device is actuated but was not armed.", "Release the device first.", "decided"),
        ],
        reference: "dual-channel-inputs.md 8B",
        purpose: "For devices that start, such as an enabling pendant or a start button. While Enable is \
                  on, both channels must first be seen released; when both then become active within the \
                  Discrepancy Time, O1 comes on. Any channel that leaves, or Enable off, turns O1 off, \
                  and both channels must be released before the next start. A device that is held at \
                  power-up, at Enable or through a fault reset never starts.",
    }),
};
