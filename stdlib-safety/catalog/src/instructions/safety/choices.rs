//! The words of choice operands. The first spelling of a value is the one that is printed.
//!
//! MANUAL and AUTOMATIC are 0 and 1 in the version-17 instructions and 1 and 0 in the version-14 set: two lists, never
//! to be joined (dual-channel-inputs.md 1.3, v14-and-metal-form.md 1.5).

use crate::operand::ChoiceList;

/// Safety Function of DCS, DCST, DCSTL and DCSTM. No effect. Values: decided D2.
pub static STOP_FUNCTION: ChoiceList = ChoiceList {
    name: "Safety Function",
    words: &[
        ("E-STOP", 1),
        ("ESTOP", 1),
        ("E STOP", 1),
        ("EMERGENCY STOP", 1),
        ("SAFETY GATE", 2),
        ("GATE", 2),
        ("LIGHT CURTAIN", 3),
        ("AREA SCANNER", 4),
        ("SAFETY MAT", 5),
        ("CABLE (ROPE) PULL SWITCH", 6),
        ("CABLE PULL SWITCH", 6),
        ("ROPE PULL SWITCH", 6),
        ("CABLE ROPE PULL SWITCH", 6),
        ("CABLE/ROPE PULL SWITCH", 6),
        ("USER-DEFINED", 100),
        ("USER DEFINED", 100),
    ],
};

/// Input Type of DCS, DCST, DCSTL, DCSTM and DCSRT: active low is refused, a broken wire would read as active (D3).
pub static INPUT_TYPE: ChoiceList = ChoiceList {
    name: "Input Type",
    words: &[
        ("EQUIVALENT - ACTIVE HIGH", 0),
        ("EQUIVALENT-ACTIVE HIGH", 0),
        ("EQUIVALENT ACTIVE HIGH", 0),
        ("COMPLEMENTARY", 2),
    ],
};

/// Restart Type and Cold Start Type of the version-17 instructions.
pub static RESTART: ChoiceList = ChoiceList { name: "Restart Type", words: &[("MANUAL", 0), ("AUTOMATIC", 1)] };

/// Cold Start Type of the version-17 instructions.
pub static COLD_START: ChoiceList = ChoiceList { name: "Cold Start Type", words: &[("MANUAL", 0), ("AUTOMATIC", 1)] };

/// Feedback Type of CROUT, ROUT, AVC and MVC: positive means that feedback 1 is read while the output is on.
pub static FEEDBACK: ChoiceList = ChoiceList { name: "Feedback Type", words: &[("NEGATIVE", 0), ("POSITIVE", 1)] };

/// Test Type of DCSTM. Names and values: decided D26.
pub static TEST_TYPE: ChoiceList = ChoiceList { name: "Test Type", words: &[("MANUAL", 0), ("AUTOMATIC", 1)] };

/// Safety Function of DCM. No effect.
pub static MONITOR_FUNCTION: ChoiceList = ChoiceList {
    name: "Safety Function",
    words: &[
        ("CAM SWITCH", 40),
        ("POSITION LIMIT SWITCH", 41),
        ("LIMIT SWITCH", 41),
        ("USER-DEFINED", 100),
        ("USER DEFINED", 100),
    ],
};

/// Input Type of DCM: it follows a position, so active low is admitted too.
pub static MONITOR_INPUT_TYPE: ChoiceList = ChoiceList {
    name: "Input Type",
    words: &[
        ("EQUIVALENT - ACTIVE HIGH", 0),
        ("EQUIVALENT-ACTIVE HIGH", 0),
        ("EQUIVALENT ACTIVE HIGH", 0),
        ("EQUIVALENT - ACTIVE LOW", 1),
        ("EQUIVALENT-ACTIVE LOW", 1),
        ("EQUIVALENT ACTIVE LOW", 1),
        ("COMPLEMENTARY", 2),
    ],
};

/// Safety Function of DCSRT. No effect.
pub static START_FUNCTION: ChoiceList = ChoiceList {
    name: "Safety Function",
    words: &[("ENABLE PENDANT", 20), ("START BUTTON", 21), ("USER-DEFINED", 100), ("USER DEFINED", 100)],
};

/// Reset Type of the version-14 set: Manual is 1.
pub static RESET_TYPE: ChoiceList = ChoiceList { name: "Reset Type", words: &[("MANUAL", 1), ("AUTOMATIC", 0)] };

/// Ack Type of the clutch/brake modes: Manual is 1. Numbers: decided.
pub static ACK_TYPE: ChoiceList = ChoiceList { name: "Ack Type", words: &[("AUTOMATIC", 0), ("MANUAL", 1)] };

/// Active Pin Type of THRS.
pub static ENABLED: ChoiceList = ChoiceList { name: "Active Pin Type", words: &[("DISABLED", 0), ("ENABLED", 1)] };

/// Takeover Mode of CBSSM and CBCM.
pub static TAKEOVER: ChoiceList = ChoiceList { name: "Takeover Mode", words: &[("DISABLED", 0), ("ENABLED", 1)] };

/// Cam Profile of CPM. Recalled 70 %.
pub static CAM_PROFILE: ChoiceList = ChoiceList { name: "Cam Profile", words: &[("A", 0), ("B", 1)] };

/// Delay Type of AVC. Numbers: decided.
pub static DELAY_TYPE: ChoiceList =
    ChoiceList { name: "Delay Type", words: &[("ON DELAY", 0), ("ON-DELAY", 0), ("OFF DELAY", 1), ("OFF-DELAY", 1)] };

/// Output Follows Actuate of AVC.
pub static TRUTH: ChoiceList = ChoiceList { name: "Output Follows Actuate", words: &[("FALSE", 0), ("TRUE", 1)] };

/// Mode of CBCM. Names: H-CBCM; numbers recalled 60 %.
pub static CONTINUOUS_MODE: ChoiceList = ChoiceList {
    name: "Mode",
    words: &[
        ("IMMEDIATE", 0),
        ("IMMEDIATE WITH ARMING", 1),
        ("HALF STROKE WITH ARMING", 2),
        ("HALF-STROKE WITH ARMING", 2),
        ("STROKE AND A HALF WITH ARMING", 3),
        ("STROKE-AND-A-HALF WITH ARMING", 3),
    ],
};
