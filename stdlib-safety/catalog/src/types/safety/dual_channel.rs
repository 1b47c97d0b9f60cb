//! Backing types of the dual-channel input family. dual-channel-inputs.md 2.

use crate::predefined::{
    MemberRole::{Configuration, Input, Internal, Output},
    PredefinedType, flag, word,
};

/// Backing type of DCS.
pub static DCI_STOP: PredefinedType = PredefinedType {
    name: "DCI_STOP",
    bytes: 80,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ChannelA", 0, 1, Input, "channel A as it was read"),
        flag("ChannelB", 0, 2, Input, "channel B as it was read"),
        flag("InputStatus", 0, 3, Input, "1 = the channels' data is valid"),
        flag("Reset", 0, 4, Input, "a rising edge clears a fault or restarts"),
        flag("RestartType", 0, 5, Configuration, "0 manual, 1 automatic"),
        flag("ColdStartType", 0, 6, Configuration, "0 manual, 1 automatic"),
        word("SafetyFunction", 4, Configuration, "which device it is; no effect"),
        word("InputType", 8, Configuration, "0 both active at 1, 2 complementary"),
        word("DiscrepancyTime", 12, Configuration, "longest disagreement of the channels in ms"),
        flag("EnableOut", 16, 0, Output, "rung condition of the last execution"),
        flag("O1", 16, 1, Output, "safety output"),
        flag("FP", 16, 2, Output, "a fault is latched"),
        word("FaultCode", 20, Output, "first fault since the last reset"),
        word("DiagnosticCode", 24, Output, "why the output is off, or 0"),
    ],
    backs_one_call: true,
    source: "dual-channel-inputs.md 2",
};
