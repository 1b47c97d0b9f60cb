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

/// FaultCode 16#F070 of the analog pair.
pub const CHANNELS_DIFFERED: Code = fault(
    0xF070,
    "The channels differed by more than Tolerance for the Discrepancy Time.",
    "Check the sensors and Tolerance; give Reset a rising edge when the channels agree.",
    "number decided, cause recalled 85 %",
);

/// DiagnosticCode 16#F171 of the analog pair.
pub const BELOW_LOW_LIMIT: Code =
    diagnostic(0xF171, "A channel is below Low Limit.", "Bring the measured value back into its range.", "decided");

/// DiagnosticCode 16#F172 of the analog pair.
pub const CHANNELS_DIFFER: Code = diagnostic(
    0xF172,
    "The channels differ by more than Tolerance now.",
    "Check the sensors and Tolerance.",
    "decided",
);

/// DiagnosticCode 16#F174 of the analog pair.
pub const COLD_START_RESET_AWAITED: Code =
    diagnostic(0xF174, "Cold start: a reset is awaited.", "Give Reset a rising edge.", "decided");

/// DiagnosticCode 16#F173 of the analog pair.
pub const ANALOG_RESET_AWAITED: Code =
    diagnostic(0xF173, "A reset is awaited after a stop or a fault.", "Give Reset a rising edge.", "decided");

/// FaultCode 16#F06F of the muting instructions.
pub const CONFIGURATION_OUT_OF_RANGE: Code = fault(
    0xF06F,
    "A configuration value of the image is out of its range.",
    "Download again; Reset does not clear this.",
    "decided",
);

/// FaultCode 16#F051 of the muting instructions.
pub const ENABLE_MUTE_LOST: Code = fault(
    0xF051,
    "Enable Mute went OFF while the curtain was muted and blocked.",
    "Clear the area, correct the enable logic, then give Reset a rising edge.",
    "decided",
);

/// FaultCode 16#F052 of the muting instructions.
pub const WRONG_SENSOR_ORDER: Code = fault(
    0xF052,
    "Sensors changed in a wrong order, together where the order matters, or from the wrong \
                 side; curtain clear.",
    "Clear the area, check alignment, load shape and speed, then give Reset a rising edge.",
    "decided",
);

/// FaultCode 16#F053 of the muting instructions.
pub const BLOCKED_NOT_MUTED: Code = fault(
    0xF053,
    "The curtain was blocked during a sequence although it was not muted: a person, or \
                 sensors too late.",
    "Clear the area, make sure that nobody is inside, then give Reset a rising edge.",
    "decided",
);

/// FaultCode 16#F054 of the muting instructions.
pub const WRONG_SENSOR_WHILE_MUTED: Code = fault(
    0xF054,
    "A sensor changed wrongly while muted with the curtain blocked.",
    "Clear the area, check the sensor under the load, then give Reset a rising edge.",
    "decided",
);

/// FaultCode 16#F050 of the muting instructions.
pub const MUTING_LAMP_BAD: Code = fault(
    0xF050,
    "The muting lamp was bad when a mute started, or during it.",
    "Repair the lamp (its detection takes up to 6 s); give Reset a rising edge when Muting \
                 Lamp Status is ON.",
    "decided",
);

/// FaultCode 16#F058 of the muting instructions.
pub const S1_S2_TIME: Code = fault(
    0xF058,
    "S1-S2 Time was reached.",
    "Clear the area, adjust time, speed or distance, then give Reset a rising edge.",
    "decided",
);

/// FaultCode 16#F059 of the muting instructions.
pub const S2_LC_TIME: Code = fault(
    0xF059,
    "S2-LC Time was reached.",
    "Clear the area, adjust time, speed or distance, then give Reset a rising edge.",
    "decided",
);

/// FaultCode 16#F060 of the muting instructions.
pub const MAXIMUM_MUTE_TIME: Code = fault(
    0xF060,
    "Maximum Mute Time was reached.",
    "Remove the load, check the conveyor, then give Reset a rising edge.",
    "decided",
);

/// FaultCode 16#F061 of the muting instructions.
pub const MAXIMUM_OVERRIDE_TIME: Code = fault(
    0xF061,
    "Maximum Override Time was reached.",
    "Release Override, press it again if needed; clear the area, then give Reset a rising edge.",
    "decided",
);

/// DiagnosticCode 16#F153 of the muting instructions.
pub const OVERRIDE_HELD: Code =
    diagnostic(0xF153, "Override is ON but no override is active and O1 is off.", "Release Override.", "decided");

/// DiagnosticCode 16#F150 of the muting instructions.
pub const AREA_NOT_CLEAR: Code =
    diagnostic(0xF150, "Clear Area is on.", "Clear the curtain and the sensors.", "decided");

/// DiagnosticCode 16#F152 of the muting instructions.
pub const LAMP_STATUS_OFF: Code = diagnostic(0xF152, "Muting Lamp Status is OFF.", "Repair the lamp.", "decided");

/// DiagnosticCode 16#F151 of the muting instructions.
pub const MUTING_RESET_AWAITED: Code =
    diagnostic(0xF151, "A reset is awaited.", "Give Reset a rising edge.", "decided");
