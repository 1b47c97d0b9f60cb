//! DCAF. muting-and-outputs.md 8.

use super::choices::{COLD_START, RESTART};
use super::codes;
use crate::code::{diagnostic, fault};
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, SafetyReal, Structure},
    TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::analog::DCAF_INPUT;

/// Dual Channel Input - Analog (floating point).
pub static DCAF: Instruction = Instruction {
    opcode: Opcode::Dcaf,
    mnemonic: "DCAF",
    also: &[],
    name: "Dual Channel Input - Analog (floating point)",
    group: Group::SafetyApplication,
    first_version: 20,
    requires: Requires::Real,
    source: "1756-RM093 Table 10",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("DCAF", Structure(&DCAF_INPUT, Access::ReadWrite)),
        operand("Restart Type", Choice(&RESTART)),
        operand("Cold Start Type", Choice(&COLD_START)),
        operand("Discrepancy Time", milliseconds(5, 3000)),
        operand("Tolerance", SafetyReal { immediate: true, not_negative: true }),
        operand("High Limit", SafetyReal { immediate: true, not_negative: false }),
        operand("Low Limit", SafetyReal { immediate: true, not_negative: false }),
        operand("Channel A", SafetyReal { immediate: false, not_negative: false }),
        operand("Channel B", SafetyReal { immediate: false, not_negative: false }),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "O1 is on while two REAL channels agree and lie within limits.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &DCAF_INPUT,
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
                "Tolerance or the limits are not usable: Tolerance below 0, High Limit below Low Limit, \
                 or a value that is not finite.",
                "Correct the values, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF072,
                "A channel value is NaN or infinite.",
                "Repair the source of the value, then give Reset a rising edge.",
                "decided",
            ),
            codes::CHANNELS_DIFFERED,
            codes::INPUT_STATUS_OFF,
            codes::RESET_HELD,
            diagnostic(
                0xF170,
                "A channel is above High Limit, or not finite.",
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
                  module's own dual-channel mode off. A channel that is NaN or infinite is a fault at \
                  once; every comparison is decided exactly, without rounding.",
    }),
};
