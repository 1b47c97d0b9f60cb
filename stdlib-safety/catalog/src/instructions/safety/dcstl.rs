//! DCSTL. dual-channel-inputs.md 6.

use super::choices::{COLD_START, INPUT_TYPE, RESTART, STOP_FUNCTION};
use super::codes;
use crate::code::{diagnostic, fault};
use crate::execution::KEEPS_FAULT;
use crate::instruction::{Group, Instruction, Opcode, Position, Relation, Requires, SafetyApplication};
use crate::operand::{
    Access,
    OperandKind::{Choice, Structure},
    TAG, TAG_OR_IMMEDIATE, milliseconds, operand,
};
use crate::types::safety::dual_channel::DCI_STOP_TEST_LOCK;

/// Dual Channel Input - Stop With Test and Lock.
pub static DCSTL: Instruction = Instruction {
    opcode: Opcode::Dcstl,
    mnemonic: "DCSTL",
    also: &[],
    name: "Dual Channel Input - Stop With Test and Lock",
    group: Group::SafetyApplication,
    first_version: 17,
    requires: Requires::Any,
    source: "1756-RM093 Table 11",
    position: Position::Output,
    transitional: true,
    operands: &[
        operand("DCSTL", Structure(&DCI_STOP_TEST_LOCK, Access::ReadWrite)),
        operand("Safety Function", Choice(&STOP_FUNCTION)),
        operand("Input Type", Choice(&INPUT_TYPE)),
        operand("Discrepancy Time", milliseconds(5, 3000)),
        operand("Restart Type", Choice(&RESTART)),
        operand("Cold Start Type", Choice(&COLD_START)),
        operand("Channel A", TAG),
        operand("Channel B", TAG),
        operand("Test Request", TAG_OR_IMMEDIATE),
        operand("Unlock Request", TAG_OR_IMMEDIATE),
        operand("Lock Feedback", TAG_OR_IMMEDIATE),
        operand("Hazard Stopped", TAG_OR_IMMEDIATE),
        operand("Input Status", TAG_OR_IMMEDIATE),
        operand("Reset", TAG_OR_IMMEDIATE),
    ],
    summary: "DCST with a guard lock: it unlocks only while the hazard is absent, and O1 needs the lock.",
    execution: KEEPS_FAULT,
    safety: Some(&SafetyApplication {
        backing: &DCI_STOP_TEST_LOCK,
        mirrored: &[
            "SafetyFunction",
            "InputType",
            "DiscrepancyTime",
            "RestartType",
            "ColdStartType",
            "ChannelA",
            "ChannelB",
            "TestRequest",
            "UnlockRequest",
            "LockFeedback",
            "HazardStopped",
            "InputStatus",
            "Reset",
        ],
        decides: &["Channel A", "Channel B"],
        channels: &["Channel A", "Channel B"],
        safety_only: &["Channel A", "Channel B", "Lock Feedback", "Hazard Stopped"],
        relations: &[Relation::DifferentTags("Channel A", "Channel B")],
        codes: &[
            codes::INPUT_STATUS_LOST,
            codes::A_ACTIVE_ALONE,
            codes::B_ACTIVE_ALONE,
            codes::A_CYCLED_ALONE,
            codes::B_CYCLED_ALONE,
            fault(
                0xF010,
                "Lock Feedback turned OFF while O1 was on and no unlock was commanded.",
                "Check the lock, bring Lock Feedback ON, then give Reset a rising edge.",
                "condition decided D24, number D15",
            ),
            codes::RESET_HELD,
            codes::INPUT_STATUS_OFF,
            codes::TEST_OUTSTANDING,
            diagnostic(
                0xF111,
                "Unlock is requested and the hazard has not stopped.",
                "Wait until the hazard has stopped, or stop it.",
                "decided",
            ),
            diagnostic(0xF112, "Unlock Command is on and Lock Feedback is still ON.", "Check the lock.", "decided"),
            diagnostic(
                0xF113,
                "Lock Feedback is OFF: the device is not locked.",
                "Close and lock the gate.",
                "decided",
            ),
        ],
        reference: "dual-channel-inputs.md 6",
        purpose: "Guards a gate that is locked while the hazard exists. An Unlock Request drops O1 at \
                  once; the unlock command ULC follows when Hazard Stopped is on, and falls in the scan \
                  in which it is lost. O1 needs Lock Feedback and no Unlock Request. Lock Feedback that \
                  disappears while O1 is on, without a command, is a fault. De-energized means locked: \
                  ULC is off with the rung false or Input Status off.",
    }),
};
