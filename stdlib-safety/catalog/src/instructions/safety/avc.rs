//! AVC. v14-and-metal-form.md 8.

use super::choices::{DELAY_TYPE, FEEDBACK, TRUTH};
use super::codes::{self, feedback};
use crate::code::diagnostic;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::press::AUX_VALVE_CONTROL;

/// Auxiliary Valve Control.
pub static AVC: Instruction = Instruction {
    opcode: Opcode::Avc,
    mnemonic: "AVC",
    also: &[],
    name: "Auxiliary Valve Control",
    group: Group::MetalForm,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11b",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("AVC", Structure(&AUX_VALVE_CONTROL, Access::ReadWrite)),
        operand("Feedback Type", Choice(&FEEDBACK)),
        operand("Feedback Reaction Time", milliseconds(5, 1000)),
        operand("Delay Type", Choice(&DELAY_TYPE)),
        operand("Delay Time", milliseconds(0, 5000)),
        operand("Output Follows Actuate", Choice(&TRUTH)),
        operand("Actuate", TAG_OR_IMMEDIATE),
        operand("Delay Enable", TAG_OR_IMMEDIATE),
        operand("Feedback 1", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Output Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Drives an auxiliary valve with a delay, for soft starting or stopping, and watches its feedback.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &AUX_VALVE_CONTROL,
        mirrored: &[
            "FeedbackType",
            "FeedbackReactionTime",
            "DelayType",
            "DelayTime",
            "OutputFollowsActuate",
            "Actuate",
            "DelayEnable",
            "Feedback1",
            "InputStatus",
            "OutputStatus",
            "Reset",
        ],
        decides: &["Actuate"],
        channels: &[],
        safety_only: &["Feedback 1"],
        relations: &[],
        codes: &[
            codes::INPUT_STATUS_LOST,
            codes::OUTPUT_STATUS_LOST,
            feedback::ONE_TURNED_OFF,
            feedback::ONE_TURNED_ON,
            feedback::ONE_DID_NOT_TURN_ON,
            feedback::ONE_DID_NOT_TURN_OFF,
            codes::INPUT_STATUS_OFF,
            codes::OUTPUT_STATUS_OFF,
            codes::RESET_HELD,
            diagnostic(0xF401, "Actuate must go off first.", "Turn Actuate off.", "decided"),
        ],
        reference: "v14-and-metal-form.md 8",
        purpose: "Stands beside the main valve: one call delays the start, another the stop. Delay Enable \
                  off suspends the delay, since soft braking is not allowed in the downstroke. The \
                  feedback must follow every change of O1 within the Feedback Reaction Time and then \
                  stay. Actuate that is on at start or through a fault must drop first.",
    }),
};
