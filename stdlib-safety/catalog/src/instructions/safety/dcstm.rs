//! DCSTM. dual-channel-inputs.md 7.

use super::choices::{COLD_START, INPUT_TYPE, RESTART, STOP_FUNCTION, TEST_TYPE};
use super::codes;
use crate::code::fault;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Literal, Structure},
    TAG, TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::dual_channel::DCI_STOP_TEST_MUTE;

/// Dual Channel Input - Stop With Test and Mute.
pub static DCSTM: Instruction = Instruction {
    opcode: Opcode::Dcstm,
    mnemonic: "DCSTM",
    also: &[],
    name: "Dual Channel Input - Stop With Test and Mute",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("DCSTM", Structure(&DCI_STOP_TEST_MUTE, Access::ReadWrite)),
        operand("Safety Function", Choice(&STOP_FUNCTION)),
        operand("Input Type", Choice(&INPUT_TYPE)),
        operand("Discrepancy Time", milliseconds(5, 3000)),
        operand("Restart Type", Choice(&RESTART)),
        operand("Cold Start Type", Choice(&COLD_START)),
        operand("Test Type", Choice(&TEST_TYPE)),
        operand("Test Time", Literal { or_zero: true, least: 5, greatest: 3000, step: 1, unit: "ms" }),
        operand("Channel A", TAG),
        operand("Channel B", TAG),
        operand("Test Request", TAG_OR_IMMEDIATE),
        operand("Mute", TAG_OR_IMMEDIATE),
        operand("Muting Lamp Status", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "DCST with muting: while muted, a broken field does not drop O1.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &DCI_STOP_TEST_MUTE,
        mirrored: &[
            "SafetyFunction",
            "InputType",
            "DiscrepancyTime",
            "RestartType",
            "ColdStartType",
            "TestType",
            "TestTime",
            "ChannelA",
            "ChannelB",
            "TestRequest",
            "Mute",
            "MutingLampStatus",
            "InputStatus",
            "Reset",
        ],
        decides: &["Channel A", "Channel B"],
        channels: &["Channel A", "Channel B"],
        safety_only: &["Channel A", "Channel B", "Mute", "Muting Lamp Status"],
        relations: &[
            Relation::DifferentTags("Channel A", "Channel B"),
            Relation::NotZeroWhen("Test Time", "Test Type", 1),
        ],
        codes: &[
            codes::INPUT_STATUS_LOST,
            codes::A_ACTIVE_ALONE,
            codes::B_ACTIVE_ALONE,
            codes::A_CYCLED_ALONE,
            codes::B_CYCLED_ALONE,
            fault(
                0xF020,
                "Muting Lamp Status is OFF.",
                "Repair the lamp or its wiring, then give Reset a rising edge.",
                "condition doc HELP-DCSTM, number decided D15",
            ),
            fault(
                0xF021,
                "Automatic test: the device did not become safe within Test Time.",
                "Repair the device, cycle it, then give Reset a rising edge.",
                "decided D28",
            ),
            fault(
                0xF022,
                "Automatic test: the device did not become active again within Test Time.",
                "Repair the device, cycle it, then give Reset a rising edge.",
                "decided D28",
            ),
            codes::RESET_HELD,
            codes::INPUT_STATUS_OFF,
            codes::TEST_OUTSTANDING,
        ],
        reference: "dual-channel-inputs.md 7",
        purpose: "Guards a field that may be broken for a while when other protection exists. A rising \
                  edge of Mute while O1 is on and the field is clear mutes: both channels may then be \
                  safe without a stop, and ML is on. Muting never energizes O1. Disagreeing channels, \
                  Input Status and a bad muting lamp still stop. Mute that ends with the field broken \
                  drops O1 in that scan; the instruction has no mute time limit. With the automatic test \
                  type, the answer to a Test Request is timed.",
    }),
};
