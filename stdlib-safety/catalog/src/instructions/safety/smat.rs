//! SMAT. dual-channel-inputs.md 9.

use super::choices::RESTART;
use super::codes;
use crate::code::{diagnostic, fault};
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG, TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::dual_channel::SAFETY_MAT;

/// Safety Mat.
pub static SMAT: Instruction = Instruction {
    opcode: Opcode::Smat,
    mnemonic: "SMAT",
    also: &[],
    name: "Safety Mat",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("SMAT", Structure(&SAFETY_MAT, Access::ReadWrite)),
        operand("Restart Type", Choice(&RESTART)),
        operand("Short Circuit Detect Delay Time", milliseconds(5, 3000)),
        operand("Channel A", TAG),
        operand("Channel B", TAG),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "O1 is on while a mat is verified and nobody stands on it.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &SAFETY_MAT,
        mirrored: &["RestartType", "ShortCircuitDetectDelayTime", "ChannelA", "ChannelB", "InputStatus", "Reset"],
        decides: &["Channel A", "Channel B"],
        channels: &["Channel A", "Channel B"],
        safety_only: &["Channel A", "Channel B"],
        relations: &[Relation::DifferentTags("Channel A", "Channel B")],
        codes: &[
            codes::INPUT_STATUS_LOST,
            fault(
                0xF040,
                "Channel A is shorted to power.",
                "Repair the wiring of the mat, then give Reset a rising edge.",
                "class study ST-SMAT, number decided D15",
            ),
            fault(
                0xF041,
                "Channel B is shorted to power.",
                "Repair the wiring of the mat, then give Reset a rising edge.",
                "class study ST-SMAT, number decided D15",
            ),
            fault(
                0xF042,
                "Both channels are shorted to power.",
                "Repair the wiring of the mat, then give Reset a rising edge.",
                "class study ST-SMAT, number decided D15",
            ),
            fault(
                0xF043,
                "Channel A is shorted to power and Channel B is open or shorted to ground.",
                "Repair the wiring of the mat, then give Reset a rising edge.",
                "class study ST-SMAT, number decided D15",
            ),
            fault(
                0xF044,
                "Channel B is shorted to power and Channel A is open or shorted to ground.",
                "Repair the wiring of the mat, then give Reset a rising edge.",
                "class study ST-SMAT, number decided D15",
            ),
            fault(
                0xF045,
                "Channel A is open or shorted to ground.",
                "Repair the wiring of the mat, then give Reset a rising edge.",
                "class study ST-SMAT, number decided D15",
            ),
            fault(
                0xF046,
                "Channel B is open or shorted to ground.",
                "Repair the wiring of the mat, then give Reset a rising edge.",
                "class study ST-SMAT, number decided D15",
            ),
            codes::RESET_HELD,
            codes::INPUT_STATUS_OFF,
            diagnostic(0xF140, "The mat is occupied, or its plates are shorted together.", "Clear the mat.", "decided"),
            diagnostic(0xF141, "The circuit verification is not complete.", "Wait.", "decided"),
        ],
        reference: "dual-channel-inputs.md 9",
        purpose: "Feeds the two plates of a mat in turn through SRCA and SRCB, with gaps in which both \
                  are off, and reads their far ends. Somebody on the mat joins the plates: O1 falls at \
                  once, no fault. A plate that is open, shorted to ground or to power is a fault after \
                  the delay time. O1 needs one complete clean pass over both plates, then the Restart \
                  Type rule. Put one gap, the delay and one scan into the reaction time.",
    }),
};
