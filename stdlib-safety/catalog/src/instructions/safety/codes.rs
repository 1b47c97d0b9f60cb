//! Codes that several safety application instructions share. Each number stands here once, beside its origin mark.

use crate::code::{Code, diagnostic, fault};

/// FaultCode 16#20.
pub const INPUT_STATUS_LOST: Code = fault(
    0x20,
    "Input Status went from ON to OFF while the instruction executed.",
    "Check the module's connection or the logic that feeds Input Status, then give Reset a rising edge.",
    "recalled-high",
);

/// FaultCode 16#21.
pub const OUTPUT_STATUS_LOST: Code = fault(
    0x21,
    "Output Status went from ON to OFF while the instruction executed.",
    "Check the output module, its connection or the logic that feeds Output Status, then give Reset a rising edge.",
    "recalled 75 %",
);

/// DiagnosticCode 16#20.
pub const INPUT_STATUS_OFF: Code = diagnostic(
    0x20,
    "Input Status is OFF.",
    "Check the module's connection or the logic that feeds Input Status.",
    "recalled-high",
);

/// DiagnosticCode 16#21.
pub const OUTPUT_STATUS_OFF: Code = diagnostic(
    0x21,
    "Output Status is OFF.",
    "Check the output module, its connection or the logic that feeds Output Status.",
    "recalled 75 %",
);

/// DiagnosticCode 16#05.
pub const RESET_HELD: Code = diagnostic(
    0x05,
    "Reset is ON in a scan where an edge of Reset is awaited and none was used.",
    "Release Reset, then press it again.",
    "number recalled-high, when shown decided D17",
);

/// The channel faults of the pair evaluator. dual-channel-inputs.md 1.9 and 3.
pub const A_ACTIVE_ALONE: Code = fault(
    0x4000,
    "The channels disagreed for the Discrepancy Time; Channel A was active, Channel B safe.",
    "Check the wiring and the device, bring both channels to the safe state, then give Reset a rising edge.",
    "recalled-high",
);

/// FaultCode 16#4001.
pub const B_ACTIVE_ALONE: Code = fault(
    0x4001,
    "The channels disagreed for the Discrepancy Time; Channel B was active, Channel A safe.",
    "Check the wiring and the device, bring both channels to the safe state, then give Reset a rising edge.",
    "recalled-high",
);

/// FaultCode 16#4002.
pub const A_CYCLED_ALONE: Code = fault(
    0x4002,
    "Channel A went safe and came back active while Channel B stayed active.",
    "Check the wiring and the device, bring both channels to the safe state, then give Reset a rising edge.",
    "recalled-high",
);

/// FaultCode 16#4003.
pub const B_CYCLED_ALONE: Code = fault(
    0x4003,
    "Channel B went safe and came back active while Channel A stayed active.",
    "Check the wiring and the device, bring both channels to the safe state, then give Reset a rising edge.",
    "recalled-high",
);

/// DiagnosticCode 16#4000 of the stop family.
pub const TEST_OUTSTANDING: Code = diagnostic(
    0x4000,
    "A functional test of the device is outstanding.",
    "Bring both channels to the safe state: open the gate, press the button, break the field.",
    "number recalled-low, use decided D18",
);

/// Feedback codes of CROUT and MVC, named after the raw value of the feedback. muting-and-outputs.md 6.4.
pub mod feedback {
    use crate::code::{Code, fault};

    const CHECK: &str = "Check the switching device, its wiring and the Feedback Type, then give Reset a rising edge.";
    const CHECK_TIME: &str = "Check the switching device (a welded contact?), its wiring and the Feedback Reaction Time, then give Reset a rising edge.";
    const RECALLED: &str = "recalled 70 %";

    /// FaultCode 16#5000.
    pub const BOTH_TURNED_OFF: Code = fault(0x5000, "Feedback 1 and 2 turned OFF unexpectedly.", CHECK, RECALLED);
    /// FaultCode 16#5001.
    pub const ONE_TURNED_OFF: Code = fault(0x5001, "Feedback 1 turned OFF unexpectedly.", CHECK, RECALLED);
    /// FaultCode 16#5002.
    pub const TWO_TURNED_OFF: Code = fault(0x5002, "Feedback 2 turned OFF unexpectedly.", CHECK, RECALLED);
    /// FaultCode 16#5003.
    pub const BOTH_TURNED_ON: Code = fault(0x5003, "Feedback 1 and 2 turned ON unexpectedly.", CHECK, "doc S11 (weak)");
    /// FaultCode 16#5004.
    pub const ONE_TURNED_ON: Code = fault(0x5004, "Feedback 1 turned ON unexpectedly.", CHECK, RECALLED);
    /// FaultCode 16#5005.
    pub const TWO_TURNED_ON: Code = fault(0x5005, "Feedback 2 turned ON unexpectedly.", CHECK, RECALLED);
    /// FaultCode 16#5006.
    pub const BOTH_DID_NOT_TURN_ON: Code =
        fault(0x5006, "Feedback 1 and 2 did not turn ON within the reaction time.", CHECK_TIME, RECALLED);
    /// FaultCode 16#5007.
    pub const ONE_DID_NOT_TURN_ON: Code =
        fault(0x5007, "Feedback 1 did not turn ON within the reaction time.", CHECK_TIME, RECALLED);
    /// FaultCode 16#5008.
    pub const TWO_DID_NOT_TURN_ON: Code =
        fault(0x5008, "Feedback 2 did not turn ON within the reaction time.", CHECK_TIME, RECALLED);
    /// FaultCode 16#5009.
    pub const BOTH_DID_NOT_TURN_OFF: Code =
        fault(0x5009, "Feedback 1 and 2 did not turn OFF within the reaction time.", CHECK_TIME, RECALLED);
    /// FaultCode 16#500A.
    pub const ONE_DID_NOT_TURN_OFF: Code =
        fault(0x500A, "Feedback 1 did not turn OFF within the reaction time.", CHECK_TIME, RECALLED);
    /// FaultCode 16#500B.
    pub const TWO_DID_NOT_TURN_OFF: Code =
        fault(0x500B, "Feedback 2 did not turn OFF within the reaction time.", CHECK_TIME, RECALLED);
}
