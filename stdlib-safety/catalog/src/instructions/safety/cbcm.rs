//! CBCM. v14-and-metal-form.md 11.4.

use super::choices::{ACK_TYPE, CONTINUOUS_MODE, TAKEOVER};
use super::codes::permissive;
use crate::code::diagnostic;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, SafetyInteger, Structure},
    TAG_OR_IMMEDIATE, operand,
};
use crate::types::safety::press::CB_CONTINUOUS_MODE;

/// Clutch Brake Continuous Mode.
pub static CBCM: Instruction = Instruction {
    opcode: Opcode::Cbcm,
    mnemonic: "CBCM",
    also: &[],
    name: "Clutch Brake Continuous Mode",
    group: Group::MetalForm,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11b",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("CBCM", Structure(&CB_CONTINUOUS_MODE, Access::ReadWrite)),
        operand("Ack Type", Choice(&ACK_TYPE)),
        operand("Mode", Choice(&CONTINUOUS_MODE)),
        operand("Takeover Mode", Choice(&TAKEOVER)),
        operand("Enable", TAG_OR_IMMEDIATE),
        operand("Safety Enable", TAG_OR_IMMEDIATE),
        operand("Standard Enable", TAG_OR_IMMEDIATE),
        operand("Arm Continuous", TAG_OR_IMMEDIATE),
        operand("Start", TAG_OR_IMMEDIATE),
        operand("Stop At Top", TAG_OR_IMMEDIATE),
        operand("Press In Motion", TAG_OR_IMMEDIATE),
        operand("Motion Monitor Fault", TAG_OR_IMMEDIATE),
        operand("Slide Zone", SafetyInteger { immediate: None, unit: "" }),
        operand("Safety Enable Ack", TAG_OR_IMMEDIATE),
    ],
    summary: "Drives a press stroke after stroke until Stop At Top.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &CB_CONTINUOUS_MODE,
        mirrored: &[
            "AckType",
            "Mode",
            "TakeoverMode",
            "Enable",
            "SafetyEnable",
            "StandardEnable",
            "ArmContinuous",
            "Start",
            "StopAtTop",
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
            diagnostic(
                0xF00F,
                "Start without arming, or the arming ran out.",
                "Give Arm Continuous, then Start within 5 s.",
                "condition H-CBCM, number decided",
            ),
            diagnostic(
                0xF010,
                "Stop At Top is pending, or Start was refused because of it.",
                "Wait for Top; turn Stop At Top off before the next Start.",
                "decided",
            ),
            permissive::ZONES_OUT_OF_ORDER,
            permissive::TOO_EARLY,
        ],
        reference: "v14-and-metal-form.md 11.4",
        purpose: "Continuous strokes. Modes 1 to 3 must be armed: Arm Continuous opens a window of 5 s \
                  for Start, and CA is on. Immediate modes run on when Start is released; half stroke \
                  needs Start until the Up zone is reached once, stroke-and-a-half until it is reached \
                  the second time. Stop At Top ends the run at the next entry into Top; losing a \
                  permissive ends it at once. It has no fault word: it stops and tells why.",
    }),
};
