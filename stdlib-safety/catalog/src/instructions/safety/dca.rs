//! DCA. muting-and-outputs.md 8.

use super::choices::{COLD_START, RESTART};
use super::codes;
use crate::code::{diagnostic, fault};
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, SafetyInteger, Structure},
    TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::analog::DCA_INPUT;

/// Dual Channel Input - Analog (integer).
pub static DCA: Instruction = Instruction {
    opcode: Opcode::Dca,
    mnemonic: "DCA",
    also: &[],
    name: "Dual Channel Input - Analog (integer)",
    group: Group::SafetyApplication,
    first_version: 20,
    requires: Requires::Any,
    source: "1756-RM093 Table 10",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("DCA", Structure(&DCA_INPUT, Access::ReadWrite)),
        operand("Restart Type", Choice(&RESTART)),
        operand("Cold Start Type", Choice(&COLD_START)),
        operand("Discrepancy Time", milliseconds(5, 3000)),
        operand("Tolerance", SafetyInteger { immediate: Some((0, i32::MAX)), unit: "" }),
        operand("High Limit", SafetyInteger { immediate: Some((i32::MIN, i32::MAX)), unit: "" }),
        operand("Low Limit", SafetyInteger { immediate: Some((i32::MIN, i32::MAX)), unit: "" }),
        operand("Channel A", SafetyInteger { immediate: None, unit: "" }),
        operand("Channel B", SafetyInteger { immediate: None, unit: "" }),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "O1 is on while two integer channels agree and lie within limits.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &DCA_INPUT,
        mirrored: &[
            "RestartType",
            "ColdStartType",
            "DiscrepancyTime",
            "Tolerance",
            "HighLimit",
            "LowLimit",
            "ChannelA",
            "ChannelB",
            "InputStatus",
            "Reset",
        ],
        decides: &["Channel A", "Channel B"],
        channels: &["Channel A", "Channel B"],
        safety_only: &["Channel A", "Channel B", "Tolerance", "High Limit", "Low Limit"],
        relations: &[Relation::NotAbove("Low Limit", "High Limit")],
        codes: &[
            codes::INPUT_STATUS_LOST,
            fault(
                0xF071,
                "Tolerance or the limits are not usable: Tolerance below 0, High Limit below Low Limit.",
                "Correct the values, then give Reset a rising edge.",
                "decided",
            ),
            codes::CHANNELS_DIFFERED,
            codes::INPUT_STATUS_OFF,
            codes::RESET_HELD,
            diagnostic(
                0xF170,
                "A channel is above High Limit.",
                "Bring the measured value back into its range.",
                "decided",
            ),
            codes::BELOW_LOW_LIMIT,
            codes::CHANNELS_DIFFER,
            codes::COLD_START_RESET_AWAITED,
            codes::ANALOG_RESET_AWAITED,
        ],
        reference: "muting-and-outputs.md 8",
        purpose: "Compares two analog channels of one quantity. O1 is on while both lie within the limits \
                  (a value equal to a limit is inside) and within Tolerance of each other. A value \
                  outside the limits, or a difference above Tolerance, drops O1 in that scan; the \
                  difference becomes a fault when it lasts for the Discrepancy Time. Restart Type and \
                  Cold Start Type say when O1 returns. HTP and LTP tell which limit was passed. Set the \
                  module's own dual-channel mode off.",
    }),
};
