//! CSM. v14-and-metal-form.md 7.

use super::codes;
use crate::code::{diagnostic, fault};
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{SafetyInteger, Structure},
    TAG_OR_IMMEDIATE, operand,
};
use crate::types::safety::press::CAMSHAFT_MONITOR;

/// Camshaft Monitor.
pub static CSM: Instruction = Instruction {
    opcode: Opcode::Csm,
    mnemonic: "CSM",
    also: &[],
    name: "Camshaft Monitor",
    group: Group::MetalForm,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11b",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("CSM", Structure(&CAMSHAFT_MONITOR, Access::ReadWrite)),
        operand("Mechanical Delay Time", SafetyInteger { immediate: Some((1, 5000)), unit: "ms" }),
        operand("Max Pulse Period", SafetyInteger { immediate: Some((1, 5000)), unit: "ms" }),
        operand("Motion Request", TAG_OR_IMMEDIATE),
        operand("Channel A", TAG_OR_IMMEDIATE),
        operand("Channel B", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Watches the start, run and stop of a camshaft by two pulse trains.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &CAMSHAFT_MONITOR,
        mirrored: &[
            "MechanicalDelayTime",
            "MaxPulsePeriod",
            "MotionRequest",
            "ChannelA",
            "ChannelB",
            "InputStatus",
            "Reset",
        ],
        decides: &["Channel A", "Channel B"],
        channels: &["Channel A", "Channel B"],
        safety_only: &["Channel A", "Channel B", "Mechanical Delay Time", "Max Pulse Period"],
        relations: &[],
        codes: &[
            codes::INPUT_STATUS_LOST,
            fault(
                0xF301,
                "Mechanical Delay Time or Max Pulse Period is outside 1 to 5000 ms.",
                "Correct the value, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF302,
                "Motion without a request.",
                "Check the valve and the pulse sensors; give Reset a rising edge at rest.",
                "decided",
            ),
            fault(
                0xF303,
                "No pulse of Channel A within the Mechanical Delay Time after the request.",
                "Check clutch, sensor and wiring; give Reset a rising edge at rest with the request off.",
                "decided",
            ),
            fault(
                0xF304,
                "No pulse of Channel B within the Mechanical Delay Time after the request.",
                "Check clutch, sensor and wiring; give Reset a rising edge at rest with the request off.",
                "decided",
            ),
            fault(
                0xF305,
                "No pulse of either channel within the Mechanical Delay Time after the request.",
                "Check clutch, sensors and wiring; give Reset a rising edge at rest with the request off.",
                "decided",
            ),
            fault(
                0xF306,
                "The pulses of Channel A were lost while running.",
                "Check sensor and wiring; give Reset a rising edge at rest with the request off.",
                "decided",
            ),
            fault(
                0xF307,
                "The pulses of Channel B were lost while running.",
                "Check sensor and wiring; give Reset a rising edge at rest with the request off.",
                "decided",
            ),
            fault(
                0xF308,
                "The pulses of both channels were lost while running.",
                "Check shaft, sensors and wiring; give Reset a rising edge at rest with the request off.",
                "decided",
            ),
            fault(
                0xF309,
                "The shaft still moved when the Mechanical Delay Time after the request was over.",
                "Check the brake; give Reset a rising edge at rest with the request off.",
                "decided",
            ),
            codes::INPUT_STATUS_OFF,
            codes::RESET_HELD,
            diagnostic(0xF30A, "Motion Request was already on at start.", "Switch the request off first.", "decided"),
        ],
        reference: "v14-and-metal-form.md 7",
        purpose: "After a Motion Request both channels must pulse within the Mechanical Delay Time; while \
                  running each must pulse again within Max Pulse Period; after the request ends the \
                  pulses must end within the Mechanical Delay Time. Motion without a request is a fault. \
                  O1 tells that the shaft moves; the measured start and stop times show how worn the \
                  clutch and the brake are.",
    }),
};
