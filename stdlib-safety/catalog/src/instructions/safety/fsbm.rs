//! FSBM. muting-and-outputs.md 5.

use super::choices::RESTART;
use super::codes;
use crate::code::fault;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Literal, Structure},
    TAG, TAG_OR_IMMEDIATE, operand,
};
use crate::types::safety::muting::MUTING_FOUR_SENSOR_BIDIR;

/// Four Sensor Bidirectional Muting.
pub static FSBM: Instruction = Instruction {
    opcode: Opcode::Fsbm,
    mnemonic: "FSBM",
    also: &[],
    name: "Four Sensor Bidirectional Muting",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("FSBM", Structure(&MUTING_FOUR_SENSOR_BIDIR, Access::ReadWrite)),
        operand("Restart Type", Choice(&RESTART)),
        operand("S1-S2 Time", Literal { or_zero: true, least: 5, greatest: 180000, step: 1, unit: "ms" }),
        operand("S2-LC Time", Literal { or_zero: true, least: 5, greatest: 180000, step: 1, unit: "ms" }),
        operand("LC-S3 Time", Literal { or_zero: true, least: 5, greatest: 180000, step: 1, unit: "ms" }),
        operand("S3-S4 Time", Literal { or_zero: true, least: 5, greatest: 180000, step: 1, unit: "ms" }),
        operand("Maximum Mute Time", Literal { or_zero: false, least: 0, greatest: 3600, step: 1, unit: "s" }),
        operand("Maximum Override Time", Literal { or_zero: false, least: 0, greatest: 30, step: 1, unit: "s" }),
        operand("Direction", TAG_OR_IMMEDIATE),
        operand("Light Curtain", TAG),
        operand("Sensor 1", TAG),
        operand("Sensor 2", TAG),
        operand("Sensor 3", TAG),
        operand("Sensor 4", TAG),
        operand("Enable Mute", TAG_OR_IMMEDIATE),
        operand("Override", TAG),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Muting Lamp Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Mutes a light curtain for material that passes four sensors in a row, either way.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &MUTING_FOUR_SENSOR_BIDIR,
        mirrored: &[
            "RestartType",
            "S1S2Time",
            "S2LCTime",
            "LCS3Time",
            "S3S4Time",
            "MaximumMuteTime",
            "MaximumOverrideTime",
            "Direction",
            "LightCurtain",
            "Sensor1",
            "Sensor2",
            "Sensor3",
            "Sensor4",
            "EnableMute",
            "Override",
            "InputStatus",
            "MutingLampStatus",
            "Reset",
        ],
        decides: &["Light Curtain"],
        channels: &[],
        safety_only: &[
            "Light Curtain",
            "Sensor 1",
            "Sensor 2",
            "Sensor 3",
            "Sensor 4",
            "Override",
            "Muting Lamp Status",
        ],
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
            fault(
                0xF05A,
                "LC-S3 Time was reached.",
                "Clear the area, adjust time, speed or distance, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF05B,
                "S3-S4 Time was reached.",
                "Clear the area, adjust time, speed or distance, then give Reset a rising edge.",
                "decided",
            ),
            codes::MAXIMUM_MUTE_TIME,
            codes::MAXIMUM_OVERRIDE_TIME,
            codes::INPUT_STATUS_OFF,
            codes::RESET_HELD,
            codes::OVERRIDE_HELD,
            codes::AREA_NOT_CLEAR,
            codes::LAMP_STATUS_OFF,
            codes::MUTING_RESET_AWAITED,
        ],
        reference: "muting-and-outputs.md 5",
        purpose: "Four sensors stand in a row, two before and two after the curtain. Direction tells from \
                  which side material is expected; it is read before a sequence begins. Each element must \
                  change in its turn, one per scan; the material may stop and go back. The load must be \
                  long enough to block all four sensors together. A wrong side, a wrong order or a late \
                  change is a fault.",
    }),
};
