//! DIN. v14-and-metal-form.md 2.

use super::choices::RESET_TYPE;
use crate::code::flag_code;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG_OR_IMMEDIATE, operand,
};
use crate::types::safety::version_14::DIVERSE_INPUT;

/// Diverse Input.
pub static DIN: Instruction = Instruction {
    opcode: Opcode::Din,
    mnemonic: "DIN",
    also: &[],
    name: "Diverse Input",
    group: Group::SafetyApplicationV14,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Appendix F",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("DIN", Structure(&DIVERSE_INPUT, Access::ReadWrite)),
        operand("Reset Type", Choice(&RESET_TYPE)),
        operand("Channel A", TAG_OR_IMMEDIATE),
        operand("Channel B", TAG_OR_IMMEDIATE),
        operand("Circuit Reset", TAG_OR_IMMEDIATE),
        operand("Fault Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "O1 is on while a diverse pair of channels is active and reset.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &DIVERSE_INPUT,
        mirrored: &["ResetType", "ChannelA", "ChannelB", "CircuitReset", "FaultReset"],
        decides: &["Channel A", "Channel B"],
        channels: &["Channel A", "Channel B"],
        safety_only: &["Channel A", "Channel B"],
        relations: &[],
        codes: &[
            flag_code(
                "II",
                "The channels disagreed for 500 ms.",
                "Correct the device or its wiring until the channels agree, give Fault Reset a rising \
                 edge, then bring both channels to the safe state.",
                "recalled 95 %, time recalled",
            ),
            flag_code(
                "CI",
                "Both channels must be seen safe together before O1 can turn on.",
                "Operate the device once so that both channels are safe.",
                "recalled 90 %",
            ),
            flag_code(
                "CRHO",
                "Circuit Reset was ON when the channels became active.",
                "Release Circuit Reset, then press it again.",
                "recalled 95 %",
            ),
        ],
        reference: "v14-and-metal-form.md 2",
        purpose: "Reads a device with one N.O. channel (A, active at 1) and one N.C. channel (B, active \
                  at 0). O1 falls in the scan in which either channel is seen safe. With manual reset, a \
                  rising edge of Circuit Reset turns O1 on while both channels are active; with automatic \
                  reset O1 follows. A channel that leaves and returns alone, or active channels at the \
                  first scan, ask for a cycle (CI); channels that disagree for 500 ms are a fault (II) \
                  that Fault Reset clears, and they must then be cycled.",
    }),
};
