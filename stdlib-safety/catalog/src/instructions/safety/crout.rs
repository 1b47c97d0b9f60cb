//! CROUT. muting-and-outputs.md 6.

use super::choices::FEEDBACK;
use super::codes::{self, feedback};
use crate::code::diagnostic;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG, TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::output::CONFIGURABLE_ROUT;

/// Configurable redundant output.
pub static CROUT: Instruction = Instruction {
    opcode: Opcode::Crout,
    mnemonic: "CROUT",
    also: &[],
    name: "Configurable Redundant Output",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("CROUT", Structure(&CONFIGURABLE_ROUT, Access::ReadWrite)),
        operand("Feedback Type", Choice(&FEEDBACK)),
        operand("Feedback Reaction Time", milliseconds(5, 1000)),
        operand("Actuate", TAG),
        operand("Feedback 1", TAG),
        operand("Feedback 2", TAG),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Output Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Drives two redundant outputs and watches one feedback of each.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &CONFIGURABLE_ROUT,
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
                0xF180,
                "The outputs are off and a feedback still says on; the reaction time is running.",
                "Wait; check the switching device and the Feedback Type if it stays.",
                "decided",
            ),
            diagnostic(
                0x5000,
                "Actuate is held ON and must be cycled: it was ON at start-up or through a fault.",
                "Turn Actuate OFF, then ON.",
                "recalled 55 %",
            ),
        ],
        reference: "muting-and-outputs.md 6",
        purpose: "Switches two contactors or valves together and proves that each follows: its feedback must show the \
                  commanded state within the Feedback Reaction Time after every change, and keep showing it. A \
                  feedback that changes by itself, or does not follow, turns both outputs off and latches a fault. \
                  The outputs come on again only after Reset with both feedbacks off and a fresh Actuate.",
    }),
};
