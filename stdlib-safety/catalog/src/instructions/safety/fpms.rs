//! FPMS. v14-and-metal-form.md 3.2.

use crate::code::flag_code;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{Access, OperandKind::Structure, TAG_OR_IMMEDIATE, operand};
use crate::types::safety::version_14::FIVE_POS_MODE_SELECTOR;

/// Five Position Mode Selector.
pub static FPMS: Instruction = Instruction {
    opcode: Opcode::Fpms,
    mnemonic: "FPMS",
    also: &[],
    name: "Five Position Mode Selector",
    group: Group::SafetyApplicationV14,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Appendix F",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("FPMS", Structure(&FIVE_POS_MODE_SELECTOR, Access::ReadWrite)),
        operand("Input 1", TAG_OR_IMMEDIATE),
        operand("Input 2", TAG_OR_IMMEDIATE),
        operand("Input 3", TAG_OR_IMMEDIATE),
        operand("Input 4", TAG_OR_IMMEDIATE),
        operand("Input 5", TAG_OR_IMMEDIATE),
        operand("Fault Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Turns on the one output whose position of a selector switch is active.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &FIVE_POS_MODE_SELECTOR,
        mirrored: &["Input1", "Input2", "Input3", "Input4", "Input5", "FaultReset"],
        decides: &["Input 1", "Input 2", "Input 3", "Input 4", "Input 5"],
        channels: &[],
        safety_only: &["Input 1", "Input 2", "Input 3", "Input 4", "Input 5"],
        relations: &[],
        codes: &[
            flag_code(
                "NM",
                "No mode was selected for 250 ms.",
                "Turn the selector to a position, then give Fault Reset a rising edge.",
                "recalled 80 %",
            ),
            flag_code(
                "MMS",
                "More than one mode was selected.",
                "Check the selector and its wiring, then give Fault Reset a rising edge.",
                "decided",
            ),
        ],
        reference: "v14-and-metal-form.md 3.2",
        purpose: "Reads a selector switch of three to five positions; unused inputs are the immediate 0. \
                  Output n is on while input n is the only one that is on. No input for 250 ms, or more \
                  than one input, is a fault that Fault Reset clears when the selector is right.",
    }),
};
