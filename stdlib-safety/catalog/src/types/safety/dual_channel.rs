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
        word("DiagnosticCode", 24, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "dual-channel-inputs.md 2",
};

/// Backing type of DCST.
pub static DCI_STOP_TEST: PredefinedType = PredefinedType {
    name: "DCI_STOP_TEST",
    bytes: 92,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ChannelA", 0, 1, Input, "channel A as it was read"),
        flag("ChannelB", 0, 2, Input, "channel B as it was read"),
        flag("InputStatus", 0, 3, Input, "1 = the channels' data is valid"),
        flag("Reset", 0, 4, Input, "a rising edge clears a fault or restarts"),
        flag("RestartType", 0, 5, Configuration, "0 manual, 1 automatic"),
        flag("ColdStartType", 0, 6, Configuration, "0 manual, 1 automatic"),
        flag("TestRequest", 0, 7, Input, "a rising edge demands a functional test"),
        word("SafetyFunction", 4, Configuration, "which device it is; no effect"),
        word("InputType", 8, Configuration, "0 both active at 1, 2 complementary"),
        word("DiscrepancyTime", 12, Configuration, "longest disagreement of the channels in ms"),
        flag("EnableOut", 16, 0, Output, "rung condition of the last execution"),
        flag("O1", 16, 1, Output, "safety output"),
        flag("FP", 16, 2, Output, "a fault is latched"),
        flag("TC", 16, 3, Output, "test command: a functional test is outstanding"),
        word("FaultCode", 20, Output, "first fault since the last reset"),
        word("DiagnosticCode", 24, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "dual-channel-inputs.md 2",
};

/// Backing type of DCSTL.
pub static DCI_STOP_TEST_LOCK: PredefinedType = PredefinedType {
    name: "DCI_STOP_TEST_LOCK",
    bytes: 92,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ChannelA", 0, 1, Input, "channel A as it was read"),
        flag("ChannelB", 0, 2, Input, "channel B as it was read"),
        flag("InputStatus", 0, 3, Input, "1 = the channels' data is valid"),
        flag("Reset", 0, 4, Input, "a rising edge clears a fault or restarts"),
        flag("RestartType", 0, 5, Configuration, "0 manual, 1 automatic"),
        flag("ColdStartType", 0, 6, Configuration, "0 manual, 1 automatic"),
        flag("TestRequest", 0, 7, Input, "a rising edge demands a functional test"),
        flag("UnlockRequest", 0, 8, Input, "1 = the operator wants access"),
        flag("LockFeedback", 0, 9, Input, "1 = the device is locked"),
        flag("HazardStopped", 0, 10, Input, "1 = the hazard has ended"),
        word("SafetyFunction", 4, Configuration, "which device it is; no effect"),
        word("InputType", 8, Configuration, "0 both active at 1, 2 complementary"),
        word("DiscrepancyTime", 12, Configuration, "longest disagreement of the channels in ms"),
        flag("EnableOut", 16, 0, Output, "rung condition of the last execution"),
        flag("O1", 16, 1, Output, "safety output"),
        flag("FP", 16, 2, Output, "a fault is latched"),
        flag("TC", 16, 3, Output, "test command: a functional test is outstanding"),
        flag("ULC", 16, 4, Output, "unlock command: 1 = release the lock"),
        word("FaultCode", 20, Output, "first fault since the last reset"),
        word("DiagnosticCode", 24, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "dual-channel-inputs.md 2",
};

/// Backing type of DCSTM.
pub static DCI_STOP_TEST_MUTE: PredefinedType = PredefinedType {
    name: "DCI_STOP_TEST_MUTE",
    bytes: 100,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ChannelA", 0, 1, Input, "channel A as it was read"),
        flag("ChannelB", 0, 2, Input, "channel B as it was read"),
        flag("InputStatus", 0, 3, Input, "1 = the channels' data is valid"),
        flag("Reset", 0, 4, Input, "a rising edge clears a fault or restarts"),
        flag("RestartType", 0, 5, Configuration, "0 manual, 1 automatic"),
        flag("ColdStartType", 0, 6, Configuration, "0 manual, 1 automatic"),
        flag("TestRequest", 0, 7, Input, "a rising edge demands a functional test"),
        flag("Mute", 0, 8, Input, "1 = muting is asked for"),
        flag("MutingLampStatus", 0, 9, Input, "1 = the muting lamp is good"),
        word("SafetyFunction", 4, Configuration, "which device it is; no effect"),
        word("InputType", 8, Configuration, "0 both active at 1, 2 complementary"),
        word("DiscrepancyTime", 12, Configuration, "longest disagreement of the channels in ms"),
        word("TestType", 16, Configuration, "0 manual, 1 automatic"),
        word("TestTime", 20, Configuration, "longest answer to an automatic test in ms"),
        flag("EnableOut", 24, 0, Output, "rung condition of the last execution"),
        flag("O1", 24, 1, Output, "safety output"),
        flag("FP", 24, 2, Output, "a fault is latched"),
        flag("TC", 24, 3, Output, "test command: a functional test is outstanding"),
        flag("ML", 24, 4, Output, "muting lamp command: the device is muted"),
        flag("SS", 24, 5, Output, "sensing field clear and healthy (decided D27)"),
        word("FaultCode", 28, Output, "first fault since the last reset"),
        word("DiagnosticCode", 32, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "dual-channel-inputs.md 2",
};

/// Backing type of DCM.
pub static DCI_MONITOR: PredefinedType = PredefinedType {
    name: "DCI_MONITOR",
    bytes: 72,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ChannelA", 0, 1, Input, "channel A as it was read"),
        flag("ChannelB", 0, 2, Input, "channel B as it was read"),
        flag("InputStatus", 0, 3, Input, "1 = the channels' data is valid"),
        flag("Reset", 0, 4, Input, "a rising edge clears a fault"),
        word("SafetyFunction", 4, Configuration, "which device it is; no effect"),
        word("InputType", 8, Configuration, "0 both active at 1, 1 both active at 0, 2 complementary"),
        word("DiscrepancyTime", 12, Configuration, "longest disagreement of the channels in ms"),
        flag("EnableOut", 16, 0, Output, "rung condition of the last execution"),
        flag("O1", 16, 1, Output, "safety output"),
        flag("FP", 16, 2, Output, "a fault is latched"),
        flag("IS", 16, 3, Output, "O1 is trustworthy: inputs valid and no fault (decided D31)"),
        word("FaultCode", 20, Output, "first fault since the last reset"),
        word("DiagnosticCode", 24, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "dual-channel-inputs.md 2",
};

/// Backing type of DCSRT.
pub static DCI_START: PredefinedType = PredefinedType {
    name: "DCI_START",
    bytes: 80,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("ChannelA", 0, 1, Input, "channel A as it was read"),
        flag("ChannelB", 0, 2, Input, "channel B as it was read"),
        flag("InputStatus", 0, 3, Input, "1 = the channels' data is valid"),
        flag("Reset", 0, 4, Input, "a rising edge clears a fault"),
        flag("Enable", 0, 5, Input, "1 = the device may start"),
        word("SafetyFunction", 4, Configuration, "which device it is; no effect"),
        word("InputType", 8, Configuration, "0 both active at 1, 2 complementary"),
        word("DiscrepancyTime", 12, Configuration, "longest disagreement of the channels in ms"),
        flag("EnableOut", 16, 0, Output, "rung condition of the last execution"),
        flag("O1", 16, 1, Output, "safety output"),
        flag("FP", 16, 2, Output, "a fault is latched"),
        word("FaultCode", 20, Output, "first fault since the last reset"),
        word("DiagnosticCode", 24, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "dual-channel-inputs.md 2",
};

/// Backing type of SMAT.
pub static SAFETY_MAT: PredefinedType = PredefinedType {
    name: "SAFETY_MAT",
    bytes: 44,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("RestartType", 0, 1, Configuration, "0 manual, 1 automatic"),
        flag("ChannelA", 0, 2, Input, "far end of plate A as it was read"),
        flag("ChannelB", 0, 3, Input, "far end of plate B as it was read"),
        flag("InputStatus", 0, 4, Input, "1 = the channels' data is valid"),
        flag("Reset", 0, 5, Input, "a rising edge clears a fault or restarts"),
        word("ShortCircuitDetectDelayTime", 4, Configuration, "diagnostic delay in ms"),
        flag("EnableOut", 8, 0, Output, "rung condition of the last execution"),
        flag("O1", 8, 1, Output, "safety output: the mat is verified and not occupied"),
        flag("SRCA", 8, 2, Output, "source of plate A, to a test output"),
        flag("SRCB", 8, 3, Output, "source of plate B, to a test output"),
        flag("FP", 8, 4, Output, "a fault is latched"),
        word("FaultCode", 12, Output, "first fault since the last reset"),
        word("DiagnosticCode", 16, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "dual-channel-inputs.md 2",
};

/// Backing type of THRSe.
pub static THRS_ENHANCED: PredefinedType = PredefinedType {
    name: "THRS_ENHANCED",
    bytes: 92,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("Enable", 0, 1, Input, "1 = the station may start"),
        flag("Disconnected", 0, 2, Input, "1 = the station is unplugged"),
        flag("RightButtonNormallyOpen", 0, 3, Input, "right button, N.O. contact"),
        flag("RightButtonNormallyClosed", 0, 4, Input, "right button, N.C. contact"),
        flag("LeftButtonNormallyOpen", 0, 5, Input, "left button, N.O. contact"),
        flag("LeftButtonNormallyClosed", 0, 6, Input, "left button, N.C. contact"),
        flag("InputStatus", 0, 7, Input, "1 = the contacts' data is valid"),
        flag("Reset", 0, 8, Input, "a rising edge clears a fault"),
        word("DiscrepancyTime", 4, Configuration, "longest disagreement of one button's contacts in ms"),
        flag("EnableOut", 8, 0, Output, "rung condition of the last execution"),
        flag("O1", 8, 1, Output, "safety output: both buttons pressed together"),
        flag("FP", 8, 2, Output, "a fault is latched"),
        flag("BR", 8, 3, Output, "buttons released: ready for a start"),
        flag("SB", 8, 4, Output, "station bypassed: properly disconnected"),
        word("FaultCode", 12, Output, "first fault since the last reset"),
        word("DiagnosticCode", 16, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "dual-channel-inputs.md 2",
};
