//! THRS. v14-and-metal-form.md 3.3.

use super::choices::ENABLED;
use crate::code::flag_code;
use crate::execution::BEGINS_ANEW;
use crate::instruction::{Group, Instruction, Opcode, Position, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG_OR_IMMEDIATE, operand,
};
use crate::types::safety::version_14::TWO_HAND_RUN_STATION;

/// Two-Hand Run Station.
pub static THRS: Instruction = Instruction {
    opcode: Opcode::Thrs,
    mnemonic: "THRS",
    also: &[],
    name: "Two-Hand Run Station",
    group: Group::SafetyApplicationV14,
    first_version: 14,
    requires: Requires::Any,
    source: "1756-RM093 Appendix F",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("THRS", Structure(&TWO_HAND_RUN_STATION, Access::ReadWrite)),
        operand("Active Pin Type", Choice(&ENABLED)),
        operand("Active Pin", TAG_OR_IMMEDIATE),
        operand("Right Button Normally Open", TAG_OR_IMMEDIATE),
        operand("Right Button Normally Closed", TAG_OR_IMMEDIATE),
        operand("Left Button Normally Open", TAG_OR_IMMEDIATE),
        operand("Left Button Normally Closed", TAG_OR_IMMEDIATE),
        operand("Fault Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "BP is on while two buttons, pressed within 500 ms of each other, are held.",
    execution: BEGINS_ANEW,
    safety: Some(&SafetyApplication {
        backing: &TWO_HAND_RUN_STATION,
        mirrored: &[
            "ActivePinType",
            "ActivePin",
            "RightButtonNormallyOpen",
            "RightButtonNormallyClosed",
            "LeftButtonNormallyOpen",
            "LeftButtonNormallyClosed",
            "FaultReset",
        ],
        decides: &[
            "Right Button Normally Open",
            "Right Button Normally Closed",
            "Left Button Normally Open",
            "Left Button Normally Closed",
        ],
        channels: &[
            "Right Button Normally Open",
            "Right Button Normally Closed",
            "Left Button Normally Open",
            "Left Button Normally Closed",
        ],
        safety_only: &[
            "Right Button Normally Open",
            "Right Button Normally Closed",
            "Left Button Normally Open",
            "Left Button Normally Closed",
        ],
        relations: &[],
        codes: &[
            flag_code(
                "SAF",
                "The station is unplugged and a contact read 1 for 500 ms.",
                "Unplug the station properly, then give Fault Reset a rising edge.",
                "decided",
            ),
            flag_code(
                "RBF",
                "The contacts of the right button agreed for 250 ms.",
                "Repair the right button or its wiring, then give Fault Reset a rising edge.",
                "recalled 60 %",
            ),
            flag_code(
                "LBF",
                "The contacts of the left button agreed for 250 ms.",
                "Repair the left button or its wiring, then give Fault Reset a rising edge.",
                "recalled 60 %",
            ),
            flag_code(
                "BT",
                "A button is tied down: the other came later than 500 ms.",
                "Release both buttons.",
                "recalled 70 %, prompt decided",
            ),
            flag_code(
                "CB",
                "Both buttons must be released before the next start.",
                "Release both buttons.",
                "recalled 70 %, prompt decided",
            ),
        ],
        reference: "v14-and-metal-form.md 3.3",
        purpose: "Keeps both hands on two buttons, each with one N.O. and one N.C. contact. Both must be \
                  released, then pressed within 500 ms of each other, and held; releasing either drops \
                  BP, and both must be released before the next start. Contacts of one button that agree \
                  for 250 ms are a fault of that button. With the active pin enabled the station can be \
                  unplugged: a contact that reads 1 for 500 ms then is a fault.",
    }),
};
