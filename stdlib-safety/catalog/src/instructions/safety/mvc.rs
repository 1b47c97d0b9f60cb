//! MVC. v14-and-metal-form.md 9.

use super::choices::FEEDBACK;
use super::codes::{self, feedback};
use crate::code::diagnostic;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::press::MAIN_VALVE_CONTROL;

/// Main Valve Control.
pub static MVC: Instruction = Instruction {
    opcode: Opcode::Mvc,
    mnemonic: "MVC",
    also: &[],
    name: "Main Valve Control",
    group: Group::MetalForm,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11b",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("MVC", Structure(&MAIN_VALVE_CONTROL, Access::ReadWrite)),
        operand("Feedback Type", Choice(&FEEDBACK)),
        operand("Feedback Reaction Time", milliseconds(5, 1000)),
        operand("Actuate", TAG_OR_IMMEDIATE),
        operand("Feedback 1", TAG_OR_IMMEDIATE),
        operand("Feedback 2", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Output Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Drives the two outputs of a main valve and watches a feedback of each.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &MAIN_VALVE_CONTROL,
        mirrored: &[
            "FeedbackType",
            "FeedbackReactionTime",
            "Actuate",
            "Feedback1",
            "Feedback2",
            "InputStatus",
            "OutputStatus",
            "Reset",
        ],
        decides: &["Actuate"],
        channels: &[],
        safety_only: &["Feedback 1", "Feedback 2"],
        relations: &[],
        codes: &[
            codes::INPUT_STATUS_LOST,
            codes::OUTPUT_STATUS_LOST,
            feedback::BOTH_TURNED_OFF,
            feedback::ONE_TURNED_OFF,
            feedback::TWO_TURNED_OFF,
            feedback::BOTH_TURNED_ON,
            feedback::ONE_TURNED_ON,
            feedback::TWO_TURNED_ON,
            feedback::BOTH_DID_NOT_TURN_ON,
            feedback::ONE_DID_NOT_TURN_ON,
            feedback::TWO_DID_NOT_TURN_ON,
            feedback::BOTH_DID_NOT_TURN_OFF,
            feedback::ONE_DID_NOT_TURN_OFF,
            feedback::TWO_DID_NOT_TURN_OFF,
            codes::INPUT_STATUS_OFF,
            codes::OUTPUT_STATUS_OFF,
            codes::RESET_HELD,
            diagnostic(
                0xF501,
                "Actuate is on and the outputs are off: a fresh Actuate or closed feedbacks are missing.",
                "Turn Actuate off, check that the valve is closed, then turn it on.",
                "decided",
            ),
        ],
        reference: "v14-and-metal-form.md 9",
        purpose: "Drives a monitored double valve. Each feedback must follow every change within the \
                  Feedback Reaction Time and then stay. Every start needs a fresh Actuate and both \
                  feedbacks off: after power-up, after a fault and after each stop, so that a press never \
                  starts by a reset.",
    }),
};
