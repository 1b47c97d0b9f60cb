//! DCM. dual-channel-inputs.md 8A.

use super::choices::{MONITOR_FUNCTION, MONITOR_INPUT_TYPE};
use super::codes;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG, TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::dual_channel::DCI_MONITOR;

/// Dual Channel Input - Monitor.
pub static DCM: Instruction = Instruction {
    opcode: Opcode::Dcm,
    mnemonic: "DCM",
    also: &[],
    name: "Dual Channel Input - Monitor",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("DCM", Structure(&DCI_MONITOR, Access::ReadWrite)),
        operand("Safety Function", Choice(&MONITOR_FUNCTION)),
        operand("Input Type", Choice(&MONITOR_INPUT_TYPE)),
        operand("Discrepancy Time", milliseconds(5, 3000)),
        operand("Channel A", TAG),
        operand("Channel B", TAG),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "O1 follows two channels that agree; no restart logic.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &DCI_MONITOR,
        mirrored: &["SafetyFunction", "InputType", "DiscrepancyTime", "ChannelA", "ChannelB", "InputStatus", "Reset"],
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
        ],
        reference: "dual-channel-inputs.md 8A",
        purpose: "Reads a position with two channels, for instance a cam or limit switch. O1 is on while \
                  both channels are active and follows them without any reset. Disagreement for the \
                  Discrepancy Time, or one channel that leaves and returns alone, is a fault that Reset \
                  clears after both channels were seen safe. IS tells whether O1 can be trusted.",
    }),
};
