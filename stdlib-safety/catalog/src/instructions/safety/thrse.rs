//! THRSe. dual-channel-inputs.md 10.

use super::codes;
use crate::code::{diagnostic, fault};
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{Access, OperandKind::Structure, TAG_OR_IMMEDIATE, milliseconds, operand};
use crate::types::safety::dual_channel::THRS_ENHANCED;

/// Two-Hand Run Station - Enhanced.
pub static THRSE: Instruction = Instruction {
    opcode: Opcode::Thrse,
    mnemonic: "THRSe",
    also: &[],
    name: "Two-Hand Run Station - Enhanced",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("THRSe", Structure(&THRS_ENHANCED, Access::ReadWrite)),
        operand("Discrepancy Time", milliseconds(5, 3000)),
        operand("Enable", TAG_OR_IMMEDIATE),
        operand("Disconnected", TAG_OR_IMMEDIATE),
        operand("Right Button Normally Open", TAG_OR_IMMEDIATE),
        operand("Right Button Normally Closed", TAG_OR_IMMEDIATE),
        operand("Left Button Normally Open", TAG_OR_IMMEDIATE),
        operand("Left Button Normally Closed", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "O1 is on while two buttons, pressed within 500 ms of each other, are held.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &THRS_ENHANCED,
        mirrored: &[
            "DiscrepancyTime",
            "Enable",
            "Disconnected",
            "RightButtonNormallyOpen",
            "RightButtonNormallyClosed",
            "LeftButtonNormallyOpen",
            "LeftButtonNormallyClosed",
            "InputStatus",
            "Reset",
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
        relations: &[Relation::PeriodAtMost(40)],
        codes: &[
            codes::INPUT_STATUS_LOST,
            fault(
                0xF030,
                "Right button: both contacts are OFF.",
                "Check the station and its wiring, release the buttons, then give Reset a rising edge.",
                "decided D15",
            ),
            fault(
                0xF031,
                "Right button: both contacts are ON.",
                "Check the station and its wiring, release the buttons, then give Reset a rising edge.",
                "decided D15",
            ),
            fault(
                0xF032,
                "Left button: both contacts are OFF.",
                "Check the station and its wiring, release the buttons, then give Reset a rising edge.",
                "decided D15",
            ),
            fault(
                0xF033,
                "Left button: both contacts are ON.",
                "Check the station and its wiring, release the buttons, then give Reset a rising edge.",
                "decided D15",
            ),
            fault(
                0xF034,
                "Disconnected is on and a contact is still ON.",
                "Unplug the station properly or turn Disconnected off, then give Reset a rising edge.",
                "decided D15",
            ),
            codes::RESET_HELD,
            codes::INPUT_STATUS_OFF,
            diagnostic(
                0xF130,
                "A button is actuated but both were not released first.",
                "Release both buttons.",
                "decided",
            ),
            diagnostic(
                0xF131,
                "The second button came later than 500 ms after the first.",
                "Release both buttons, then press them together.",
                "decided",
            ),
        ],
        reference: "dual-channel-inputs.md 10",
        purpose: "Keeps both hands on two buttons, each with one N.O. and one N.C. contact. Both must be \
                  released (BR), then pressed within 500 ms of each other, and held. Releasing either \
                  drops O1, and both must be released before the next start. Contacts of one button that \
                  agree for the Discrepancy Time are a fault. A station may be unplugged: with \
                  Disconnected on and all contacts off, SB is on.",
    }),
};
