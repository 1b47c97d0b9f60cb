//! TSAM. muting-and-outputs.md 3.

use super::choices::RESTART;
use super::codes;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Literal, Structure},
    TAG, TAG_OR_IMMEDIATE, operand,
};
use crate::types::safety::muting::MUTING_TWO_SENSOR_ASYM;

/// Two Sensor Asymmetrical Muting.
pub static TSAM: Instruction = Instruction {
    opcode: Opcode::Tsam,
    mnemonic: "TSAM",
    also: &[],
    name: "Two Sensor Asymmetrical Muting",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("TSAM", Structure(&MUTING_TWO_SENSOR_ASYM, Access::ReadWrite)),
        operand("Restart Type", Choice(&RESTART)),
        operand("S1-S2 Time", Literal { or_zero: true, least: 5, greatest: 180000, step: 1, unit: "ms" }),
        operand("S2-LC Time", Literal { or_zero: true, least: 5, greatest: 180000, step: 1, unit: "ms" }),
        operand("Maximum Mute Time", Literal { or_zero: false, least: 0, greatest: 3600, step: 1, unit: "s" }),
        operand("Maximum Override Time", Literal { or_zero: false, least: 0, greatest: 30, step: 1, unit: "s" }),
        operand("Light Curtain", TAG),
        operand("Sensor 1", TAG),
        operand("Sensor 2", TAG),
        operand("Enable Mute", TAG_OR_IMMEDIATE),
        operand("Override", TAG),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Muting Lamp Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Mutes a light curtain for material that blocks two sensors in a fixed order.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &MUTING_TWO_SENSOR_ASYM,
        mirrored: &[
            "RestartType",
            "S1S2Time",
            "S2LCTime",
            "MaximumMuteTime",
            "MaximumOverrideTime",
            "LightCurtain",
            "Sensor1",
            "Sensor2",
            "EnableMute",
            "Override",
            "InputStatus",
            "MutingLampStatus",
            "Reset",
        ],
        decides: &["Light Curtain"],
        channels: &[],
        safety_only: &["Light Curtain", "Sensor 1", "Sensor 2", "Override", "Muting Lamp Status"],
        relations: &[],
        codes: &[
            codes::INPUT_STATUS_LOST,
            codes::CONFIGURATION_OUT_OF_RANGE,
            codes::ENABLE_MUTE_LOST,
            codes::WRONG_SENSOR_ORDER,
            codes::BLOCKED_NOT_MUTED,
            codes::WRONG_SENSOR_WHILE_MUTED,
            codes::MUTING_LAMP_BAD,
            codes::S1_S2_TIME,
            codes::S2_LC_TIME,
            codes::MAXIMUM_MUTE_TIME,
            codes::MAXIMUM_OVERRIDE_TIME,
            codes::INPUT_STATUS_OFF,
            codes::RESET_HELD,
            codes::OVERRIDE_HELD,
            codes::AREA_NOT_CLEAR,
            codes::LAMP_STATUS_OFF,
            codes::MUTING_RESET_AWAITED,
        ],
        reference: "muting-and-outputs.md 3",
        purpose: "Lets material through a light curtain and stops for people: they are told apart by the \
                  order in which two sensors and the curtain change. Sensor 1 is blocked first and clears \
                  last; the mute begins when both beams are blocked and ends when one of them clears. A \
                  wrong order, a late change or a bad muting lamp is a fault, and everything must be \
                  cleared before Reset. A blocked curtain without a sequence is a plain stop. Override \
                  drives material out while it is held, for a limited time.",
    }),
};
