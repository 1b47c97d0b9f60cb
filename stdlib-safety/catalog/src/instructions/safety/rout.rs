//! ROUT. muting-and-outputs.md 7.

use super::choices::FEEDBACK;
use crate::code::flag_code;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG, TAG_OR_IMMEDIATE, operand,
};
use crate::types::safety::output::REDUNDANT_OUTPUT;

/// Redundant Output.
pub static ROUT: Instruction = Instruction {
    opcode: Opcode::Rout,
    mnemonic: "ROUT",
    also: &[],
    name: "Redundant Output",
    group: Group::SafetyApplicationV14,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Appendix F",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("ROUT", Structure(&REDUNDANT_OUTPUT, Access::ReadWrite)),
        operand("Feedback Type", Choice(&FEEDBACK)),
        operand("Enable", TAG),
        operand("Feedback 1", TAG),
        operand("Feedback 2", TAG),
        operand("Fault Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Drives two redundant outputs and watches one feedback of each with a fixed time.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &REDUNDANT_OUTPUT,
        mirrored: &["FeedbackType", "Enable", "Feedback1", "Feedback2", "FaultReset"],
        decides: &["Enable"],
        channels: &[],
        safety_only: &["Feedback 1", "Feedback 2"],
        relations: &[],
        codes: &[
            flag_code(
                "O1FF",
                "Feedback 1 was not right within 250 ms.",
                "Check device 1, its wiring and the Feedback Type; bring the feedback to off, give Fault \
                 Reset a rising edge, cycle Enable.",
                "recalled 85 %, time recalled 50 %",
            ),
            flag_code(
                "O2FF",
                "Feedback 2 was not right within 250 ms.",
                "Check device 2, its wiring and the Feedback Type; bring the feedback to off, give Fault \
                 Reset a rising edge, cycle Enable.",
                "recalled 85 %, time recalled 50 %",
            ),
        ],
        reference: "muting-and-outputs.md 7",
        purpose: "The output side of a safety relay. Both feedbacks must say off before the outputs come \
                  on; after that each must agree with its output, and a disagreement that lasts 250 ms is \
                  a fault of that channel. Enable that is on at power-up or through a fault must be \
                  cycled. There is no Input Status: gate Enable with the status of the I/O.",
    }),
};
