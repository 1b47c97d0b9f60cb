//! TSSM. muting-and-outputs.md 4.

use super::choices::RESTART;
use super::codes;
use crate::code::fault;
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Literal, Structure},
    TAG, TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::muting::MUTING_TWO_SENSOR_SYM;

/// Two Sensor Symmetrical Muting.
pub static TSSM: Instruction = Instruction {
    opcode: Opcode::Tssm,
    mnemonic: "TSSM",
    also: &[],
    name: "Two Sensor Symmetrical Muting",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("TSSM", Structure(&MUTING_TWO_SENSOR_SYM, Access::ReadWrite)),
        operand("Restart Type", Choice(&RESTART)),
        operand("S1S2 Discrepancy Time", Literal { or_zero: true, least: 5, greatest: 180000, step: 1, unit: "ms" }),
        operand("S1S2-LC Minimum Time", milliseconds(0, 180000)),
        operand("S1S2-LC Maximum Time", Literal { or_zero: true, least: 5, greatest: 180000, step: 1, unit: "ms" }),
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
    summary: "Mutes a light curtain for material that blocks two crossed beams at nearly the same time.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &MUTING_TWO_SENSOR_SYM,
        mirrored: &[
            "RestartType",
            "S1S2DiscrepancyTime",
            "S1S2LCMinimumTime",
            "S1S2LCMaximumTime",
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
        relations: &[Relation::BelowUnlessZero("S1S2-LC Minimum Time", "S1S2-LC Maximum Time")],
        codes: &[
            codes::INPUT_STATUS_LOST,
            codes::CONFIGURATION_OUT_OF_RANGE,
            codes::ENABLE_MUTE_LOST,
            codes::WRONG_SENSOR_ORDER,
            codes::BLOCKED_NOT_MUTED,
            codes::WRONG_SENSOR_WHILE_MUTED,
            fault(
                0xF05D,
                "S1S2-LC Minimum Time was violated.",
                "Clear the area, check for tampering or a wrong distance, then give Reset a rising edge.",
                "decided",
            ),
            codes::MUTING_LAMP_BAD,
            fault(
                0xF05C,
                "S1S2 Discrepancy Time was reached.",
                "Clear the area, adjust time, speed or distance, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF05E,
                "S1S2-LC Maximum Time was reached.",
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
        reference: "muting-and-outputs.md 4",
        purpose: "As TSAM with sensors that stand symmetrically: either may be blocked first, the other \
                  must follow within the discrepancy time, and the curtain must follow both not earlier \
                  than the minimum and not later than the maximum time. The same times hold on the way \
                  out. Set a minimum time above 0: it is the guard against one cause that blocks \
                  everything at once.",
    }),
};
