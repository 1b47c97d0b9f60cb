//! CBSSM. v14-and-metal-form.md 11.3.

use super::choices::{ACK_TYPE, TAKEOVER};
use super::codes::permissive;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, SafetyInteger, Structure},
    TAG_OR_IMMEDIATE, operand,
};
use crate::types::safety::press::CB_SINGLE_STROKE_MODE;

/// Clutch Brake Single Stroke Mode.
pub static CBSSM: Instruction = Instruction {
    opcode: Opcode::Cbssm,
    mnemonic: "CBSSM",
    also: &[],
    name: "Clutch Brake Single Stroke Mode",
    group: Group::MetalForm,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11b",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("CBSSM", Structure(&CB_SINGLE_STROKE_MODE, Access::ReadWrite)),
        operand("Ack Type", Choice(&ACK_TYPE)),
        operand("Takeover Mode", Choice(&TAKEOVER)),
        operand("Enable", TAG_OR_IMMEDIATE),
        operand("Safety Enable", TAG_OR_IMMEDIATE),
        operand("Standard Enable", TAG_OR_IMMEDIATE),
        operand("Start", TAG_OR_IMMEDIATE),
        operand("Press In Motion", TAG_OR_IMMEDIATE),
        operand("Motion Monitor Fault", TAG_OR_IMMEDIATE),
        operand("Slide Zone", SafetyInteger { immediate: None, unit: "" }),
        operand("Safety Enable Ack", TAG_OR_IMMEDIATE),
    ],
    summary: "Drives a press through one stroke for each press of Start.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &CB_SINGLE_STROKE_MODE,
        mirrored: &[
            "AckType",
            "TakeoverMode",
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
            permissive::NOT_IN_TOP,
            permissive::START_RELEASED,
            permissive::STOPPED_AT_TOP,
            permissive::CONFIGURATION_CHANGED,
            permissive::ZONES_OUT_OF_ORDER,
            permissive::TOO_EARLY,
        ],
        reference: "v14-and-metal-form.md 11.3",
        purpose: "Single stroke: from Top, O1 is on from a fresh Start until the slide is back in Top. \
                  Start must be held through the downstroke, and in the Up zone too unless Takeover Mode \
                  is enabled. Start that stays pressed does not repeat the stroke. It has no fault word: \
                  it stops and tells why.",
    }),
};
