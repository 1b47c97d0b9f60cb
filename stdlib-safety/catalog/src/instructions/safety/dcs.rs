//! DCS. dual-channel-inputs.md 4.

use super::choices::{COLD_START, INPUT_TYPE, RESTART, STOP_FUNCTION};
use super::codes;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG, TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::dual_channel::DCI_STOP;

/// Dual channel input stop.
pub static DCS: Instruction = Instruction {
    opcode: Opcode::Dcs,
    mnemonic: "DCS",
    also: &[],
    name: "Dual Channel Input - Stop",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("DCS", Structure(&DCI_STOP, Access::ReadWrite)),
        operand("Safety Function", Choice(&STOP_FUNCTION)),
        operand("Input Type", Choice(&INPUT_TYPE)),
        operand("Discrepancy Time", milliseconds(5, 3000)),
        operand("Restart Type", Choice(&RESTART)),
        operand("Cold Start Type", Choice(&COLD_START)),
        operand("Channel A", TAG),
        operand("Channel B", TAG),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG),
    ],
    summary: "O1 is on only while both channels of a stop device are active and the reset actions were done.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &DCI_STOP,
        mirrored: &[
            "SafetyFunction",
            "InputType",
            "DiscrepancyTime",
            "RestartType",
            "ColdStartType",
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
            codes::TEST_OUTSTANDING,
        ],
        reference: "dual-channel-inputs.md 4",
        purpose: "Monitors a stop device with two channels: an E-stop button, a gate switch, a light curtain, a \
                  scanner, a mat, a rope pull. O1 falls in the scan in which either channel leaves the active state, \
                  Input Status is lost or the rung is false. A disagreement for the Discrepancy Time, or one channel \
                  that leaves and returns alone, is a fault: both channels must then be seen safe before Reset clears \
                  it. After a stop, Restart Type says whether Reset is needed or O1 returns by itself after 50 ms; \
                  Cold Start Type says whether the device must be tested once after power-up.",
    }),
};
