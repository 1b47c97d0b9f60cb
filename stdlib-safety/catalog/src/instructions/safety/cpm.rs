//! CPM. v14-and-metal-form.md 6.

use super::choices::CAM_PROFILE;
use super::codes;
use crate::code::fault;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG_OR_IMMEDIATE, operand,
};
use crate::types::safety::press::CB_CRANKSHAFT_POS_MONITOR;

/// Crankshaft Position Monitor.
pub static CPM: Instruction = Instruction {
    opcode: Opcode::Cpm,
    mnemonic: "CPM",
    also: &[],
    name: "Crankshaft Position Monitor",
    group: Group::MetalForm,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11b",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("CPM", Structure(&CB_CRANKSHAFT_POS_MONITOR, Access::ReadWrite)),
        operand("Cam Profile", Choice(&CAM_PROFILE)),
        operand("Enable", TAG_OR_IMMEDIATE),
        operand("Brake Cam", TAG_OR_IMMEDIATE),
        operand("Takeover Cam", TAG_OR_IMMEDIATE),
        operand("Dynamic Cam", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reverse", TAG_OR_IMMEDIATE),
        operand("Press Motion Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "Tells the slide position of a press as Top, Down or Up from its cams.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &CB_CRANKSHAFT_POS_MONITOR,
        mirrored: &[
            "CamProfile",
            "Enable",
            "BrakeCam",
            "TakeoverCam",
            "DynamicCam",
            "InputStatus",
            "Reverse",
            "PressMotionStatus",
            "Reset",
        ],
        decides: &["Brake Cam", "Takeover Cam", "Dynamic Cam"],
        channels: &[],
        safety_only: &["Brake Cam", "Takeover Cam", "Dynamic Cam"],
        relations: &[],
        codes: &[
            codes::INPUT_STATUS_LOST,
            fault(
                0xF201,
                "The cam pattern is not possible in this profile.",
                "Check the cam switches and the profile, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF202,
                "The zones followed each other in a wrong order (forward).",
                "Check the cam switches and the direction, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF203,
                "Top was left in reverse, or another zone change that reverse does not allow.",
                "Drive in reverse only from Down to Top, then give Reset a rising edge.",
                "condition H-CPM, number decided",
            ),
            fault(
                0xF204,
                "The zone changed without motion.",
                "Check the camshaft and its monitor, then give Reset a rising edge.",
                "decided",
            ),
            fault(
                0xF205,
                "The dynamic cam did not operate.",
                "Check the dynamic cam, then give Reset a rising edge.",
                "decided",
            ),
            codes::INPUT_STATUS_OFF,
            codes::RESET_HELD,
        ],
        reference: "v14-and-metal-form.md 6",
        purpose: "Decodes the brake cam and the takeover cam into the slide zone and checks that zones \
                  follow each other: Top, Down, Up, Top forward, Down to Top in reverse. With Enable the \
                  dynamic cam reports Top early, for a press that needs a longer way to stop. A zone that \
                  changes without motion, out of order, or with an impossible pattern is a fault; all \
                  zones are then off and the clutch instructions stop the press.",
    }),
};
