//! MMVC. v14-and-metal-form.md 10.

use super::codes;
use crate::code::diagnostic;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{Access, OperandKind::Structure, TAG_OR_IMMEDIATE, operand};
use crate::types::safety::press::MANUAL_VALVE_CONTROL;

/// Maintenance Manual Valve Control.
pub static MMVC: Instruction = Instruction {
    opcode: Opcode::Mmvc,
    mnemonic: "MMVC",
    also: &[],
    name: "Maintenance Manual Valve Control",
    group: Group::MetalForm,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11b",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("MMVC", Structure(&MANUAL_VALVE_CONTROL, Access::ReadWrite)),
        operand("Enable", TAG_OR_IMMEDIATE),
        operand("Keyswitch", TAG_OR_IMMEDIATE),
        operand("Bottom", TAG_OR_IMMEDIATE),
        operand("Flywheel Stopped", TAG_OR_IMMEDIATE),
        operand("Safety Enable", TAG_OR_IMMEDIATE),
        operand("Actuate", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Output Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Drives a valve by hand during maintenance, hold to run.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &MANUAL_VALVE_CONTROL,
        mirrored: &[
            "Enable",
            "Keyswitch",
            "Bottom",
            "FlywheelStopped",
            "SafetyEnable",
            "Actuate",
            "InputStatus",
            "OutputStatus",
            "Reset",
        ],
        decides: &["Safety Enable", "Actuate"],
        channels: &[],
        safety_only: &["Keyswitch", "Bottom", "Flywheel Stopped", "Safety Enable"],
        relations: &[],
        codes: &[
            codes::INPUT_STATUS_LOST,
            codes::OUTPUT_STATUS_LOST,
            codes::INPUT_STATUS_OFF,
            codes::OUTPUT_STATUS_OFF,
            codes::RESET_HELD,
            diagnostic(0xF601, "Enable is off.", "Select maintenance mode.", "decided"),
            diagnostic(0xF602, "Keyswitch is off.", "Turn the key.", "decided"),
            diagnostic(0xF603, "Safety Enable is off.", "Close guards and E-stop circuits.", "decided"),
            diagnostic(0xF604, "The flywheel has not stopped.", "Stop the flywheel.", "decided"),
            diagnostic(0xF605, "The slide is not at the bottom.", "Move the slide to the bottom.", "decided"),
            diagnostic(
                0xF606,
                "Actuate is on but was not given afresh.",
                "Release Actuate, then press it again.",
                "decided",
            ),
        ],
        reference: "v14-and-metal-form.md 10",
        purpose: "Opens a valve while Actuate is held, with the mode enabled, the key turned, the slide \
                  at the bottom, the flywheel stopped and the safety circuits good. Losing one of these \
                  drops O1 without a fault; Actuate must then be released and given again.",
    }),
};
