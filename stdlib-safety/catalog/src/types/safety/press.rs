//! Backing types of the metal-form set. v14-and-metal-form.md 5 to 11.

use crate::predefined::{
    MemberRole::{Configuration, Input, Internal, Output},
    PredefinedType, flag, word,
};

/// Backing type of EPMS.
pub static EIGHT_POS_MODE_SELECTOR: PredefinedType = PredefinedType {
    name: "EIGHT_POS_MODE_SELECTOR",
    bytes: 44,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("Input1", 0, 1, Input, "position 1 of the switch"),
        flag("Input2", 0, 2, Input, "position 2 of the switch"),
        flag("Input3", 0, 3, Input, "position 3 of the switch"),
        flag("Input4", 0, 4, Input, "position 4 of the switch"),
        flag("Input5", 0, 5, Input, "position 5 of the switch"),
        flag("Input6", 0, 6, Input, "position 6 of the switch"),
        flag("Input7", 0, 7, Input, "position 7 of the switch"),
        flag("Input8", 0, 8, Input, "position 8 of the switch"),
        flag("InputStatus", 0, 9, Input, "1 = the inputs' data is valid"),
        flag("Lock", 0, 10, Input, "1 = the mode may not change"),
        flag("Reset", 0, 11, Input, "a rising edge clears a fault"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("O1", 4, 1, Output, "position 1 is selected"),
        flag("O2", 4, 2, Output, "position 2 is selected"),
        flag("O3", 4, 3, Output, "position 3 is selected"),
        flag("O4", 4, 4, Output, "position 4 is selected"),
        flag("O5", 4, 5, Output, "position 5 is selected"),
        flag("O6", 4, 6, Output, "position 6 is selected"),
        flag("O7", 4, 7, Output, "position 7 is selected"),
        flag("O8", 4, 8, Output, "position 8 is selected"),
        flag("FP", 4, 9, Output, "a fault is latched"),
        word("FaultCode", 8, Output, "first fault since the last reset"),
        word("DiagnosticCode", 12, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 5",
};

/// Backing type of CPM.
pub static CB_CRANKSHAFT_POS_MONITOR: PredefinedType = PredefinedType {
    name: "CB_CRANKSHAFT_POS_MONITOR",
    bytes: 48,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("CamProfile", 0, 1, Configuration, "0 profile A, 1 profile B"),
        flag("Enable", 0, 2, Input, "1 = the dynamic cam is used"),
        flag("BrakeCam", 0, 3, Input, "brake cam"),
        flag("TakeoverCam", 0, 4, Input, "takeover cam"),
        flag("DynamicCam", 0, 5, Input, "dynamic cam; 0 in the Up zone reports Top early"),
        flag("InputStatus", 0, 6, Input, "1 = the cams' data is valid"),
        flag("Reverse", 0, 7, Input, "1 = the press is driven in reverse"),
        flag("Reset", 0, 8, Input, "a rising edge clears a fault"),
        flag("PressMotionStatus", 0, 9, Input, "1 = the press moves"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("TZ", 4, 1, Output, "top zone"),
        flag("DZ", 4, 2, Output, "down zone"),
        flag("UZ", 4, 3, Output, "up zone"),
        flag("FP", 4, 4, Output, "a fault is latched"),
        word("SlideZone", 8, Output, "1 top, 2 down, 4 up, 0 unknown (decided)"),
        word("FaultCode", 12, Output, "first fault since the last reset"),
        word("DiagnosticCode", 16, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 6",
};

/// Backing type of CSM.
pub static CAMSHAFT_MONITOR: PredefinedType = PredefinedType {
    name: "CAMSHAFT_MONITOR",
    bytes: 92,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("MotionRequest", 0, 1, Input, "1 = the valve is energized"),
        flag("ChannelA", 0, 2, Input, "pulses of channel A"),
        flag("ChannelB", 0, 3, Input, "pulses of channel B"),
        flag("InputStatus", 0, 4, Input, "1 = the pulses' data is valid"),
        flag("Reset", 0, 5, Input, "a rising edge clears a fault"),
        word("MechanicalDelayTime", 4, Input, "longest start or stop in ms"),
        word("MaxPulsePeriod", 8, Input, "longest time between pulses of a channel in ms"),
        flag("EnableOut", 12, 0, Output, "rung condition of the last execution"),
        flag("O1", 12, 1, Output, "the camshaft moves"),
        flag("FP", 12, 2, Output, "a fault is latched"),
        word("MeasuredStartTime", 16, Output, "last start in ms"),
        word("MeasuredStopTime", 20, Output, "last stop in ms"),
        word("FaultCode", 24, Output, "first fault since the last reset"),
        word("DiagnosticCode", 28, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 7",
};

/// Backing type of AVC.
pub static AUX_VALVE_CONTROL: PredefinedType = PredefinedType {
    name: "AUX_VALVE_CONTROL",
    bytes: 68,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("Actuate", 0, 1, Input, "1 commands the valve"),
        flag("DelayType", 0, 2, Configuration, "0 on delay, 1 off delay"),
        flag("OutputFollowsActuate", 0, 3, Configuration, "1 = O1 follows Actuate, 0 = O1 is its opposite"),
        flag("DelayEnable", 0, 4, Input, "0 = no delay"),
        flag("FeedbackType", 0, 5, Configuration, "1 positive, 0 negative"),
        flag("Feedback1", 0, 6, Input, "feedback of the valve as it was read"),
        flag("InputStatus", 0, 7, Input, "1 = the feedback's data is valid"),
        flag("OutputStatus", 0, 8, Input, "1 = the output point is good"),
        flag("Reset", 0, 9, Input, "a rising edge clears a fault"),
        word("DelayTime", 4, Configuration, "delay in ms"),
        word("FeedbackReactionTime", 8, Configuration, "longest wait for the feedback in ms"),
        flag("EnableOut", 12, 0, Output, "rung condition of the last execution"),
        flag("O1", 12, 1, Output, "safety output"),
        flag("FP", 12, 2, Output, "a fault is latched"),
        word("FaultCode", 16, Output, "first fault since the last reset"),
        word("DiagnosticCode", 20, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 8",
};

/// Backing type of MVC.
pub static MAIN_VALVE_CONTROL: PredefinedType = PredefinedType {
    name: "MAIN_VALVE_CONTROL",
    bytes: 52,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("Actuate", 0, 1, Input, "1 commands the valve on"),
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
    source: "v14-and-metal-form.md 9",
};

/// Backing type of MMVC.
pub static MANUAL_VALVE_CONTROL: PredefinedType = PredefinedType {
    name: "MANUAL_VALVE_CONTROL",
    bytes: 32,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("Enable", 0, 1, Input, "1 = maintenance mode is selected"),
        flag("Keyswitch", 0, 2, Input, "1 = the key is turned"),
        flag("Bottom", 0, 3, Input, "1 = the slide is at the bottom"),
        flag("FlywheelStopped", 0, 4, Input, "1 = the flywheel stands still"),
        flag("SafetyEnable", 0, 5, Input, "1 = guards and E-stops allow motion"),
        flag("Actuate", 0, 6, Input, "hold to run"),
        flag("InputStatus", 0, 7, Input, "1 = the inputs' data is valid"),
        flag("OutputStatus", 0, 8, Input, "1 = the output point is good"),
        flag("Reset", 0, 9, Input, "a rising edge clears a fault"),
        flag("EnableOut", 4, 0, Output, "rung condition of the last execution"),
        flag("O1", 4, 1, Output, "safety output"),
        flag("FP", 4, 2, Output, "a fault is latched"),
        word("FaultCode", 8, Output, "first fault since the last reset"),
        word("DiagnosticCode", 12, Output, "why an output is off or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 10",
};

/// Backing type of CBIM.
pub static CB_INCH_MODE: PredefinedType = PredefinedType {
    name: "CB_INCH_MODE",
    bytes: 44,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("AckType", 0, 1, Configuration, "0 automatic, 1 manual acknowledgment of Safety Enable"),
        flag("Enable", 0, 2, Input, "1 = this mode is selected"),
        flag("SafetyEnable", 0, 3, Input, "1 = guards and E-stops allow motion"),
        flag("StandardEnable", 0, 4, Input, "1 = production conditions allow motion"),
        flag("Start", 0, 5, Input, "hold-to-run or two-hand signal"),
        flag("PressInMotion", 0, 6, Input, "1 = the press moves"),
        flag("MotionMonitorFault", 0, 7, Input, "1 = the camshaft monitor has a fault"),
        flag("SafetyEnableAck", 0, 8, Input, "a rising edge acknowledges Safety Enable (manual)"),
        word("SlideZone", 4, Input, "1 top, 2 down, 4 up, from CPM"),
        word("InchTime", 8, Configuration, "longest inch in ms"),
        flag("EnableOut", 12, 0, Output, "rung condition of the last execution"),
        flag("O1", 12, 1, Output, "safety output: clutch engaged"),
        word("DiagnosticCode", 16, Output, "why the press stands or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 11",
};

/// Backing type of CBSSM.
pub static CB_SINGLE_STROKE_MODE: PredefinedType = PredefinedType {
    name: "CB_SINGLE_STROKE_MODE",
    bytes: 36,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("AckType", 0, 1, Configuration, "0 automatic, 1 manual acknowledgment of Safety Enable"),
        flag("TakeoverMode", 0, 2, Configuration, "1 = Start may be released in the Up zone"),
        flag("Enable", 0, 3, Input, "1 = this mode is selected"),
        flag("SafetyEnable", 0, 4, Input, "1 = guards and E-stops allow motion"),
        flag("StandardEnable", 0, 5, Input, "1 = production conditions allow motion"),
        flag("Start", 0, 6, Input, "hold-to-run or two-hand signal"),
        flag("PressInMotion", 0, 7, Input, "1 = the press moves"),
        flag("MotionMonitorFault", 0, 8, Input, "1 = the camshaft monitor has a fault"),
        flag("SafetyEnableAck", 0, 9, Input, "a rising edge acknowledges Safety Enable (manual)"),
        word("SlideZone", 4, Input, "1 top, 2 down, 4 up, from CPM"),
        flag("EnableOut", 8, 0, Output, "rung condition of the last execution"),
        flag("O1", 8, 1, Output, "safety output: clutch engaged"),
        word("DiagnosticCode", 12, Output, "why the press stands or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 11",
};

/// Backing type of CBCM.
pub static CB_CONTINUOUS_MODE: PredefinedType = PredefinedType {
    name: "CB_CONTINUOUS_MODE",
    bytes: 52,
    members: &[
        flag("EnableIn", 0, 0, Internal, "rung condition"),
        flag("AckType", 0, 1, Configuration, "0 automatic, 1 manual acknowledgment of Safety Enable"),
        flag("TakeoverMode", 0, 2, Configuration, "1 = Start may be released in the Up zone"),
        flag("Enable", 0, 3, Input, "1 = this mode is selected"),
        flag("SafetyEnable", 0, 4, Input, "1 = guards and E-stops allow motion"),
        flag("StandardEnable", 0, 5, Input, "1 = production conditions allow motion"),
        flag("ArmContinuous", 0, 6, Input, "a rising edge opens the 5 s window for Start"),
        flag("Start", 0, 7, Input, "hold-to-run or two-hand signal"),
        flag("StopAtTop", 0, 8, Input, "1 = stop at the next entry into Top"),
        flag("PressInMotion", 0, 9, Input, "1 = the press moves"),
        flag("MotionMonitorFault", 0, 10, Input, "1 = the camshaft monitor has a fault"),
        flag("SafetyEnableAck", 0, 11, Input, "a rising edge acknowledges Safety Enable (manual)"),
        word("Mode", 4, Configuration, "0 immediate, 1 with arming, 2 half stroke, 3 stroke and a half"),
        word("SlideZone", 8, Input, "1 top, 2 down, 4 up, from CPM"),
        flag("EnableOut", 12, 0, Output, "rung condition of the last execution"),
        flag("O1", 12, 1, Output, "safety output: clutch engaged"),
        flag("CA", 12, 2, Output, "continuous armed"),
        word("DiagnosticCode", 16, Output, "why the press stands or a start was refused, or 0"),
    ],
    backs_one_call: true,
    source: "v14-and-metal-form.md 11",
};
