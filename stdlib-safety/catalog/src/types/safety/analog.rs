//! Backing types of the analog inputs. muting-and-outputs.md 8.2.

use crate::predefined::{
    MemberRole::{Configuration, Input, Internal, Output},
    PredefinedType, flag, real, word,
};

/// Backing type of DCA.
pub static DCA_INPUT: PredefinedType = PredefinedType {
    name: "DCA_INPUT",
    bytes: 108,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("InputStatus", 0, 1, Input, "1 = both channels' data is valid"),
        flag("Reset", 0, 2, Input, "a rising edge clears a fault or restarts"),
        flag("RestartType", 0, 3, Configuration, "0 manual, 1 automatic"),
        flag("ColdStartType", 0, 4, Configuration, "0 manual, 1 automatic"),
        word("ChannelA", 4, Input, "channel A as it was read"),
        word("ChannelB", 8, Input, "channel B as it was read"),
        word("Tolerance", 12, Input, "greatest difference of the channels that is good"),
        word("HighLimit", 16, Input, "greatest value inside the range"),
        word("LowLimit", 20, Input, "least value inside the range"),
        word("DiscrepancyTime", 24, Configuration, "longest difference above Tolerance in ms"),
        flag("EnableOut", 28, 0, Output, "rung condition of the last execution"),
        flag("O1", 28, 1, Output, "safety output"),
        flag("FP", 28, 2, Output, "a fault is latched"),
        flag("HTP", 28, 3, Output, "high trip point: a channel is above HighLimit"),
        flag("LTP", 28, 4, Output, "low trip point: a channel is below LowLimit"),
        word("O1OnTime", 32, Output, "elapsed part of the 50 ms on-delay, 50 while O1 is on (decided)"),
        word("FaultCode", 36, Output, "first fault since the last reset"),
        word("DiagnosticCode", 40, Output, "why an output is off or a start was refused, or 0"),
        word("Revision", 44, Output, "constant 1 (decided)"),
    ],
    backs_one_call: true,
    source: "muting-and-outputs.md 8.2",
};

/// Backing type of DCAF: holds REAL.
pub static DCAF_INPUT: PredefinedType = PredefinedType {
    name: "DCAF_INPUT",
    bytes: 108,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("InputStatus", 0, 1, Input, "1 = both channels' data is valid"),
        flag("Reset", 0, 2, Input, "a rising edge clears a fault or restarts"),
        flag("RestartType", 0, 3, Configuration, "0 manual, 1 automatic"),
        flag("ColdStartType", 0, 4, Configuration, "0 manual, 1 automatic"),
        real("ChannelA", 4, Input, "channel A as it was read"),
        real("ChannelB", 8, Input, "channel B as it was read"),
        real("Tolerance", 12, Input, "greatest difference of the channels that is good"),
        real("HighLimit", 16, Input, "greatest value inside the range"),
        real("LowLimit", 20, Input, "least value inside the range"),
        word("DiscrepancyTime", 24, Configuration, "longest difference above Tolerance in ms"),
        flag("EnableOut", 28, 0, Output, "rung condition of the last execution"),
        flag("O1", 28, 1, Output, "safety output"),
        flag("FP", 28, 2, Output, "a fault is latched"),
        flag("HTP", 28, 3, Output, "high trip point: a channel is above HighLimit"),
        flag("LTP", 28, 4, Output, "low trip point: a channel is below LowLimit"),
        word("O1OnTime", 32, Output, "elapsed part of the 50 ms on-delay, 50 while O1 is on (decided)"),
        word("FaultCode", 36, Output, "first fault since the last reset"),
        word("DiagnosticCode", 40, Output, "why an output is off or a start was refused, or 0"),
        word("Revision", 44, Output, "constant 1 (decided)"),
    ],
    backs_one_call: true,
    source: "muting-and-outputs.md 8.2",
};
