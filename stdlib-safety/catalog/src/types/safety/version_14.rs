//! Backing types of the version-14 set. v14-and-metal-form.md 2 and 3.

use crate::predefined::{
    MemberRole::{Configuration, Input, Internal, Output},
    PredefinedType, flag, word,
};

/// Backing type of DIN.
pub static DIVERSE_INPUT: PredefinedType = PredefinedType {
    name: "DIVERSE_INPUT",
    bytes: 52,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ResetType", 0, 1, Configuration, "1 manual, 0 automatic"),
        flag("ChannelA", 0, 2, Input, "channel A as it was read"),
        flag("ChannelB", 0, 3, Input, "channel B as it was read"),
        flag("CircuitReset", 0, 4, Input, "a rising edge turns O1 on (manual reset)"),
        flag("FaultReset", 0, 5, Input, "a rising edge clears a fault"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("O1", 4, 1, Output, "safety output"),
        flag("CI", 4, 2, Output, "cycle inputs: both channels must be seen safe together"),
        flag("CRHO", 4, 3, Output, "circuit reset held on: release it"),
        flag("II", 4, 4, Output, "inputs inconsistent: a fault"),
        flag("FP", 4, 5, Output, "a fault is latched"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 2",
};

/// Backing type of RIN.
pub static REDUNDANT_INPUT: PredefinedType = PredefinedType {
    name: "REDUNDANT_INPUT",
    bytes: 52,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ResetType", 0, 1, Configuration, "1 manual, 0 automatic"),
        flag("ChannelA", 0, 2, Input, "channel A as it was read"),
        flag("ChannelB", 0, 3, Input, "channel B as it was read"),
        flag("CircuitReset", 0, 4, Input, "a rising edge turns O1 on (manual reset)"),
        flag("FaultReset", 0, 5, Input, "a rising edge clears a fault"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("O1", 4, 1, Output, "safety output"),
        flag("CI", 4, 2, Output, "cycle inputs: both channels must be seen safe together"),
        flag("CRHO", 4, 3, Output, "circuit reset held on: release it"),
        flag("II", 4, 4, Output, "inputs inconsistent: a fault"),
        flag("FP", 4, 5, Output, "a fault is latched"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 2",
};

/// Backing type of ENPEND.
pub static ENABLE_PENDANT: PredefinedType = PredefinedType {
    name: "ENABLE_PENDANT",
    bytes: 52,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ResetType", 0, 1, Configuration, "1 manual, 0 automatic"),
        flag("ChannelA", 0, 2, Input, "channel A as it was read"),
        flag("ChannelB", 0, 3, Input, "channel B as it was read"),
        flag("CircuitReset", 0, 4, Input, "a rising edge turns O1 on (manual reset)"),
        flag("FaultReset", 0, 5, Input, "a rising edge clears a fault"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("O1", 4, 1, Output, "safety output"),
        flag("CI", 4, 2, Output, "cycle inputs: both channels must be seen safe together"),
        flag("CRHO", 4, 3, Output, "circuit reset held on: release it"),
        flag("II", 4, 4, Output, "inputs inconsistent: a fault"),
        flag("FP", 4, 5, Output, "a fault is latched"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 2",
};

/// Backing type of ESTOP.
pub static EMERGENCY_STOP: PredefinedType = PredefinedType {
    name: "EMERGENCY_STOP",
    bytes: 52,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ResetType", 0, 1, Configuration, "1 manual, 0 automatic"),
        flag("ChannelA", 0, 2, Input, "channel A as it was read"),
        flag("ChannelB", 0, 3, Input, "channel B as it was read"),
        flag("CircuitReset", 0, 4, Input, "a rising edge turns O1 on (manual reset)"),
        flag("FaultReset", 0, 5, Input, "a rising edge clears a fault"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("O1", 4, 1, Output, "safety output"),
        flag("CI", 4, 2, Output, "cycle inputs: both channels must be seen safe together"),
        flag("CRHO", 4, 3, Output, "circuit reset held on: release it"),
        flag("II", 4, 4, Output, "inputs inconsistent: a fault"),
        flag("FP", 4, 5, Output, "a fault is latched"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 2",
};

/// Backing type of LC.
pub static LIGHT_CURTAIN: PredefinedType = PredefinedType {
    name: "LIGHT_CURTAIN",
    bytes: 52,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ResetType", 0, 1, Configuration, "1 manual, 0 automatic"),
        flag("ChannelA", 0, 2, Input, "channel A as it was read"),
        flag("ChannelB", 0, 3, Input, "channel B as it was read"),
        flag("MuteLightCurtain", 0, 4, Input, "1 = a broken field does not turn O1 off"),
        flag("CircuitReset", 0, 5, Input, "a rising edge turns O1 on (manual reset)"),
        flag("FaultReset", 0, 6, Input, "a rising edge clears a fault"),
        word("InputFilterTime", 4, Input, "low pulses up to this are ignored, in ms; outside 0 to 250 as 0"),
        flag("EnableOut", 8, 0, Output, "rung condition of the last execution"),
        flag("O1", 8, 1, Output, "safety output"),
        flag("CI", 8, 2, Output, "cycle inputs: both channels must be seen safe together"),
        flag("CRHO", 8, 3, Output, "circuit reset held on: release it"),
        flag("LCB", 8, 4, Output, "light curtain blocked"),
        flag("LCM", 8, 5, Output, "light curtain muted"),
        flag("II", 8, 6, Output, "inputs inconsistent: a fault"),
        flag("FP", 8, 7, Output, "a fault is latched"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 3.1",
};

/// Backing type of FPMS.
pub static FIVE_POS_MODE_SELECTOR: PredefinedType = PredefinedType {
    name: "FIVE_POS_MODE_SELECTOR",
    bytes: 36,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("Input1", 0, 1, Input, "position 1 of the switch"),
        flag("Input2", 0, 2, Input, "position 2 of the switch"),
        flag("Input3", 0, 3, Input, "position 3 of the switch"),
        flag("Input4", 0, 4, Input, "position 4 of the switch"),
        flag("Input5", 0, 5, Input, "position 5 of the switch"),
        flag("FaultReset", 0, 6, Input, "a rising edge clears a fault"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("O1", 4, 1, Output, "position 1 is selected"),
        flag("O2", 4, 2, Output, "position 2 is selected"),
        flag("O3", 4, 3, Output, "position 3 is selected"),
        flag("O4", 4, 4, Output, "position 4 is selected"),
        flag("O5", 4, 5, Output, "position 5 is selected"),
        flag("NM", 4, 6, Output, "no mode selected: a fault"),
        flag("MMS", 4, 7, Output, "more than one mode selected: a fault"),
        flag("FP", 4, 8, Output, "a fault is latched"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 3.2",
};

/// Backing type of THRS.
pub static TWO_HAND_RUN_STATION: PredefinedType = PredefinedType {
    name: "TWO_HAND_RUN_STATION",
    bytes: 48,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ActivePinType", 0, 1, Configuration, "1 enabled, 0 disabled"),
        flag("ActivePin", 0, 2, Input, "1 = the station is plugged in"),
        flag("RightButtonNormallyOpen", 0, 3, Input, "right button, N.O. contact"),
        flag("RightButtonNormallyClosed", 0, 4, Input, "right button, N.C. contact"),
        flag("LeftButtonNormallyOpen", 0, 5, Input, "left button, N.O. contact"),
        flag("LeftButtonNormallyClosed", 0, 6, Input, "left button, N.C. contact"),
        flag("FaultReset", 0, 7, Input, "a rising edge clears a fault"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("BP", 4, 1, Output, "buttons pressed: the safety output"),
        flag("SA", 4, 2, Output, "station active"),
        flag("BT", 4, 3, Output, "button tied down: release both"),
        flag("CB", 4, 4, Output, "cycle buttons: release both"),
        flag("SAF", 4, 5, Output, "station active fault: an unplugged station shows a contact"),
        flag("RBF", 4, 6, Output, "right button fault"),
        flag("LBF", 4, 7, Output, "left button fault"),
        flag("FP", 4, 8, Output, "a fault is latched"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 3.3",
};
