//! DCST. dual-channel-inputs.md 5.

use super::choices::{COLD_START, INPUT_TYPE, RESTART, STOP_FUNCTION};
use super::codes;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG, TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::dual_channel::DCI_STOP_TEST;

/// Dual Channel Input - Stop With Test.
pub static DCST: Instruction = Instruction {
    opcode: Opcode::Dcst,
    mnemonic: "DCST",
    also: &[],
    name: "Dual Channel Input - Stop With Test",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("DCST", Structure(&DCI_STOP_TEST, Access::ReadWrite)),
        operand("Safety Function", Choice(&STOP_FUNCTION)),
        operand("Input Type", Choice(&INPUT_TYPE)),
        operand("Discrepancy Time", milliseconds(5, 3000)),
        operand("Restart Type", Choice(&RESTART)),
        operand("Cold Start Type", Choice(&COLD_START)),
        operand("Channel A", TAG),
        operand("Channel B", TAG),
        operand("Test Request", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG),
    ],
    summary: "DCS with a functional test of the device on request.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &DCI_STOP_TEST,
        mirrored: &[
            "SafetyFunction",
            "InputType",
            "DiscrepancyTime",
            "RestartType",
            "ColdStartType",
            "ChannelA",
            "ChannelB",
            "TestRequest",
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
        reference: "dual-channel-inputs.md 5",
        purpose: "As DCS, and a rising edge of Test Request drops O1 and demands that the device is \
                  operated once: TC is on until both channels were seen safe together. A request that is \
                  held does not demand a second test, and Reset alone never completes one. TC also shows \
                  the test that a manual cold start demands.",
    }),
};
