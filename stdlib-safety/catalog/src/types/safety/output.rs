//! Backing types of the redundant outputs. muting-and-outputs.md 6.2 and 7.2.

use crate::predefined::{
    MemberRole::{Configuration, Input, Internal, Output},
    PredefinedType, flag, word,
};

/// Backing type of CROUT.
pub static CONFIGURABLE_ROUT: PredefinedType = PredefinedType {
    name: "CONFIGURABLE_ROUT",
    bytes: 52,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("Actuate", 0, 1, Input, "1 commands the outputs on"),
        flag("FeedbackType", 0, 2, Configuration, "1 positive, 0 negative"),
        flag("Feedback1", 0, 3, Input, "feedback of output 1 as it was read"),
        flag("Feedback2", 0, 4, Input, "feedback of output 2 as it was read"),
        flag("InputStatus", 0, 5, Input, "1 = the feedbacks' data is valid"),
        flag("OutputStatus", 0, 6, Input, "1 = the output points are good"),
        flag("Reset", 0, 7, Input, "a rising edge clears a fault"),
        word("FeedbackReactionTime", 4, Configuration, "longest wait for the feedbacks in ms"),
        flag("EnableOut", 8, 0, Output, "rung condition of the last execution"),
        flag("O1", 8, 1, Output, "safety output 1"),
        flag("O2", 8, 2, Output, "safety output 2, always equal to O1"),
        flag("FP", 8, 3, Output, "a fault is latched"),
        word("FaultCode", 12, Output, "first fault since the last reset"),
        word("DiagnosticCode", 16, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "muting-and-outputs.md 6.2",
};

/// Backing type of ROUT.
pub static REDUNDANT_OUTPUT: PredefinedType = PredefinedType {
    name: "REDUNDANT_OUTPUT",
    bytes: 36,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("FeedbackType", 0, 1, Configuration, "1 positive (ROPF), 0 negative (RONF)"),
        flag("Enable", 0, 2, Input, "1 commands the outputs on"),
        flag("Feedback1", 0, 3, Input, "feedback of output 1 as it was read"),
        flag("Feedback2", 0, 4, Input, "feedback of output 2 as it was read"),
        flag("FaultReset", 0, 5, Input, "a rising edge clears a fault"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("O1", 4, 1, Output, "safety output 1"),
        flag("O2", 4, 2, Output, "safety output 2, always equal to O1"),
        flag("O1FF", 4, 3, Output, "feedback 1 failed"),
        flag("O2FF", 4, 4, Output, "feedback 2 failed"),
        flag("FP", 4, 5, Output, "a fault is latched"),
    ],
    backs_one_call: true,
    source: "muting-and-outputs.md 7.2",
};
