//! TSAM. muting-and-outputs.md 3.

use super::choices::RESTART;
use super::codes;
use crate::code::{diagnostic, fault};
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
        safety_only: &["Light Curtain", "Sensor 1", "Sensor 2", "Override", "Muting Lamp Status"],
        relations: &[],
        codes: &[
            codes::INPUT_STATUS_LOST,
            fault(
                0xF06F,
                "A configuration value of the image is out of its range.",
                "Download again; Reset does not clear this.",
                "decided",
            ),
            fault(
                0xF051,
                "Enable Mute went OFF while the curtain was muted and blocked.",
                "Clear the area, correct the enable logic, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF052,
                "Sensors changed in a wrong order, together where the order matters, or from the wrong \
                 side; curtain clear.",
                "Clear the area, check alignment, load shape and speed, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF053,
                "The curtain was blocked during a sequence although it was not muted: a person, or \
                 sensors too late.",
                "Clear the area, make sure that nobody is inside, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF054,
                "A sensor changed wrongly while muted with the curtain blocked.",
                "Clear the area, check the sensor under the load, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF050,
                "The muting lamp was bad when a mute started, or during it.",
                "Repair the lamp (its detection takes up to 6 s); give Reset a rising edge when Muting \
                 Lamp Status is ON.",
                "decided",
            ),
            fault(
                0xF058,
                "S1-S2 Time was reached.",
                "Clear the area, adjust time, speed or distance, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF059,
                "S2-LC Time was reached.",
                "Clear the area, adjust time, speed or distance, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF060,
                "Maximum Mute Time was reached.",
                "Remove the load, check the conveyor, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF061,
                "Maximum Override Time was reached.",
                "Release Override, press it again if needed; clear the area, then give Reset a rising edge.",
                "decided",
            ),
            codes::INPUT_STATUS_OFF,
            codes::RESET_HELD,
            diagnostic(
                0xF153,
                "Override is ON but no override is active and O1 is off.",
                "Release Override.",
                "decided",
            ),
            diagnostic(0xF150, "Clear Area is on.", "Clear the curtain and the sensors.", "decided"),
            diagnostic(0xF152, "Muting Lamp Status is OFF.", "Repair the lamp.", "decided"),
            diagnostic(0xF151, "A reset is awaited.", "Give Reset a rising edge.", "decided"),
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
