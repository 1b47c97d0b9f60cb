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

/// Why the clutch/brake modes stand. v14-and-metal-form.md 11.1.
pub mod permissive {
    use crate::code::{Code, diagnostic};

    /// DiagnosticCode 16#F001.
    pub const ENABLE_OFF: Code = diagnostic(0xF001, "Enable is off.", "Select this mode.", "decided");

    /// DiagnosticCode 16#F002.
    pub const SAFETY_ENABLE_OFF: Code =
        diagnostic(0xF002, "Safety Enable is off.", "Close the guards and the E-stop circuits.", "decided");

    /// DiagnosticCode 16#F003.
    pub const ACK_AWAITED: Code =
        diagnostic(0xF003, "Safety Enable Ack is awaited.", "Give Safety Enable Ack a rising edge.", "decided");

    /// DiagnosticCode 16#F004.
    pub const ACK_HELD: Code = diagnostic(
        0xF004,
        "Safety Enable Ack is held ON.",
        "Release Safety Enable Ack, then press it again.",
        "decided",
    );

    /// DiagnosticCode 16#F005.
    pub const STANDARD_ENABLE_OFF: Code =
        diagnostic(0xF005, "Standard Enable is off.", "Establish the production conditions.", "decided");

    /// DiagnosticCode 16#F006.
    pub const MOTION_MONITOR_FAULT: Code =
        diagnostic(0xF006, "The camshaft monitor has a fault.", "Clear the fault of the camshaft monitor.", "decided");

    /// DiagnosticCode 16#F007.
    pub const SLIDE_ZONE_INVALID: Code =
        diagnostic(0xF007, "Slide Zone is invalid.", "Clear the fault of the crankshaft position monitor.", "decided");

    /// DiagnosticCode 16#F008.
    pub const PRESS_IN_MOTION: Code = diagnostic(
        0xF008,
        "Start or Arm was refused: the press is in motion.",
        "Wait until the press stands, then press again.",
        "decided",
    );

    /// DiagnosticCode 16#F009.
    pub const START_HELD: Code = diagnostic(0xF009, "Start is held ON.", "Release Start.", "decided");

    /// DiagnosticCode 16#F00A.
    pub const NOT_IN_TOP: Code = diagnostic(
        0xF00A,
        "Start or Arm was refused: the slide is not in Top.",
        "Move the slide to Top in inch mode.",
        "decided",
    );

    /// DiagnosticCode 16#F00B.
    pub const START_RELEASED: Code =
        diagnostic(0xF00B, "Stopped: Start was released too early.", "Press Start again and hold it.", "decided");

    /// DiagnosticCode 16#F00D.
    pub const STOPPED_AT_TOP: Code =
        diagnostic(0xF00D, "Stopped at Top: the normal end.", "Press Start for the next stroke.", "decided");

    /// DiagnosticCode 16#F00E.
    pub const CONFIGURATION_CHANGED: Code = diagnostic(
        0xF00E,
        "The configuration is out of range or changed at run time.",
        "Correct it; the rung must be false once.",
        "decided",
    );

    /// DiagnosticCode 16#F011.
    pub const ZONES_OUT_OF_ORDER: Code = diagnostic(
        0xF011,
        "Stopped: the slide zones came out of order.",
        "Check the crankshaft position monitor and its cams.",
        "decided",
    );

    /// DiagnosticCode 16#F012.
    pub const TOO_EARLY: Code = diagnostic(
        0xF012,
        "Start or Arm came in the very scan in which the permissives came.",
        "Press again.",
        "decided",
    );
}
