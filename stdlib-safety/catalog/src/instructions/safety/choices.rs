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
