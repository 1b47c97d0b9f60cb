//! CBIM. v14-and-metal-form.md 11.2.

use super::choices::ACK_TYPE;
use super::codes::permissive;
use crate::code::diagnostic;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, SafetyInteger, Structure},
    TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::press::CB_INCH_MODE;

/// Clutch Brake Inch Mode.
pub static CBIM: Instruction = Instruction {
    opcode: Opcode::Cbim,
    mnemonic: "CBIM",
    also: &[],
    name: "Clutch Brake Inch Mode",
    group: Group::MetalForm,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11b",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("CBIM", Structure(&CB_INCH_MODE, Access::ReadWrite)),
        operand("Ack Type", Choice(&ACK_TYPE)),
        operand("Inch Time", milliseconds(1, 10000)),
        operand("Enable", TAG_OR_IMMEDIATE),
        operand("Safety Enable", TAG_OR_IMMEDIATE),
        operand("Standard Enable", TAG_OR_IMMEDIATE),
        operand("Start", TAG_OR_IMMEDIATE),
        operand("Press In Motion", TAG_OR_IMMEDIATE),
        operand("Motion Monitor Fault", TAG_OR_IMMEDIATE),
        operand("Slide Zone", SafetyInteger { immediate: None, unit: "" }),
        operand("Safety Enable Ack", TAG_OR_IMMEDIATE),
    ],
    summary: "Moves a press a little while Start is held, for set-up.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &CB_INCH_MODE,
        mirrored: &[
            "AckType",
            "InchTime",
            "Enable",
            "SafetyEnable",
            "StandardEnable",
            "Start",
            "PressInMotion",
            "MotionMonitorFault",
            "SlideZone",
            "SafetyEnableAck",
        ],
        decides: &["Enable", "Safety Enable", "Start"],
        channels: &[],
        safety_only: &["Safety Enable", "Press In Motion", "Motion Monitor Fault", "Slide Zone"],
        relations: &[],
        codes: &[
            permissive::ENABLE_OFF,
            permissive::SAFETY_ENABLE_OFF,
            permissive::ACK_AWAITED,
            permissive::ACK_HELD,
            permissive::STANDARD_ENABLE_OFF,
            permissive::MOTION_MONITOR_FAULT,
            permissive::SLIDE_ZONE_INVALID,
            permissive::PRESS_IN_MOTION,
            permissive::START_HELD,
            permissive::START_RELEASED,
            diagnostic(
                0xF00C,
                "Stopped: Inch Time is over.",
                "Release Start; press again for a further inch.",
                "decided",
            ),
            permissive::STOPPED_AT_TOP,
            permissive::CONFIGURATION_CHANGED,
            permissive::TOO_EARLY,
        ],
        reference: "v14-and-metal-form.md 11.2",
        purpose: "Inching: O1 is on from a fresh Start until Start is released, Inch Time is over or the \
                  slide enters Top, whichever comes first. Every further inch needs a new press. Guards, \
                  production conditions, the camshaft monitor and the slide zone must be good in this and \
                  the previous scan. It has no fault word: it stops and tells why.",
    }),
};
