//! EPMS. v14-and-metal-form.md 5.

use super::codes;
use crate::code::{diagnostic, fault};
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{Access, OperandKind::Structure, TAG_OR_IMMEDIATE, operand};
use crate::types::safety::press::EIGHT_POS_MODE_SELECTOR;

/// Eight-position Mode Selector.
pub static EPMS: Instruction = Instruction {
    opcode: Opcode::Epms,
    mnemonic: "EPMS",
    also: &[],
    name: "Eight-position Mode Selector",
    group: Group::MetalForm,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11b",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("EPMS", Structure(&EIGHT_POS_MODE_SELECTOR, Access::ReadWrite)),
        operand("Input 1", TAG_OR_IMMEDIATE),
        operand("Input 2", TAG_OR_IMMEDIATE),
        operand("Input 3", TAG_OR_IMMEDIATE),
        operand("Input 4", TAG_OR_IMMEDIATE),
        operand("Input 5", TAG_OR_IMMEDIATE),
        operand("Input 6", TAG_OR_IMMEDIATE),
        operand("Input 7", TAG_OR_IMMEDIATE),
        operand("Input 8", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Lock", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Turns on the one output whose position of a selector switch is active, unless locked.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &EIGHT_POS_MODE_SELECTOR,
        mirrored: &[
            "Input1",
            "Input2",
            "Input3",
            "Input4",
            "Input5",
            "Input6",
            "Input7",
            "Input8",
            "InputStatus",
            "Lock",
            "Reset",
        ],
        decides: &["Input 1", "Input 2", "Input 3", "Input 4", "Input 5", "Input 6", "Input 7", "Input 8"],
        channels: &[],
        safety_only: &["Input 1", "Input 2", "Input 3", "Input 4", "Input 5", "Input 6", "Input 7", "Input 8"],
        relations: &[],
        codes: &[
            codes::INPUT_STATUS_LOST,
            fault(
                0xF101,
                "No input was on for 250 ms.",
                "Turn the selector to a position, then give Reset a rising edge.",
                "condition H-EPMS, number decided",
            ),
            fault(
                0xF102,
                "More than one input is on.",
                "Check the selector and its wiring, then give Reset a rising edge.",
                "condition H-EPMS, number decided",
            ),
            codes::INPUT_STATUS_OFF,
            codes::RESET_HELD,
            diagnostic(
                0xF103,
                "The position was changed while the selector is locked.",
                "Turn Lock off.",
                "condition H-EPMS, number decided",
            ),
        ],
        reference: "v14-and-metal-form.md 5",
        purpose: "Reads a break-before-make selector switch of up to eight positions; unused inputs are \
                  the immediate 0. Never more than one output is on. No input for 250 ms, or more than \
                  one input, is a fault. While Lock is on the mode may not change: a change of position \
                  turns all outputs off until Lock is off again.",
    }),
};
