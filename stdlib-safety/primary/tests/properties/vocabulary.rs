//! What happens at the inputs of each instruction: events as they occur at a machine, so that random runs have its
//! rhythm and not only noise.

/// The inputs at the first scan, and the events of a run; each sets members that mirror operands.
pub struct Vocabulary {
    /// Inputs at the first scan.
    pub start: &'static str,
    /// Events, one of which happens at a time.
    pub events: &'static [&'static str],
    /// Outputs that are wired to inputs: the input follows the output of the previous scan, unless an event sets it.
    pub wires: &'static [(&'static str, &'static str)],
}

const MAT_WIRES: &[(&str, &str)] = &[("SRCA", "ChannelA"), ("SRCB", "ChannelB")];

const STOP: &[&str] = &[
    "ChannelA=1 ChannelB=1",
    "ChannelA=0 ChannelB=0",
    "ChannelA=1 ChannelB=0",
    "ChannelA=0 ChannelB=1",
    "ChannelA=1",
    "ChannelB=0",
    "Reset=1",
    "Reset=0",
    "Reset=1",
    "Reset=0",
    "InputStatus=0 ChannelA=0 ChannelB=0",
    "InputStatus=1",
    "InputStatus=1 ChannelA=1 ChannelB=1",
    "Mute=1",
    "Mute=0",
    "MutingLampStatus=0",
    "MutingLampStatus=1",
    "TestRequest=1",
    "TestRequest=0",
    "UnlockRequest=1",
    "UnlockRequest=0",
    "UnlockRequest=0 LockFeedback=1",
    "LockFeedback=0",
    "LockFeedback=1",
    "HazardStopped=1",
    "HazardStopped=0",
    "Enable=1",
    "Enable=0",
];

const HANDS: &[&str] = &[
    "RightButtonNormallyOpen=1 RightButtonNormallyClosed=0",
    "RightButtonNormallyOpen=0 RightButtonNormallyClosed=1",
    "LeftButtonNormallyOpen=1 LeftButtonNormallyClosed=0",
    "LeftButtonNormallyOpen=0 LeftButtonNormallyClosed=1",
    "RightButtonNormallyOpen=1 RightButtonNormallyClosed=0 LeftButtonNormallyOpen=1 LeftButtonNormallyClosed=0",
    "RightButtonNormallyOpen=0 RightButtonNormallyClosed=1 LeftButtonNormallyOpen=0 LeftButtonNormallyClosed=1",
    "RightButtonNormallyOpen=0 RightButtonNormallyClosed=1 LeftButtonNormallyOpen=0 LeftButtonNormallyClosed=1",
    "RightButtonNormallyClosed=1",
    "LeftButtonNormallyClosed=0",
    "Disconnected=1 RightButtonNormallyClosed=0 LeftButtonNormallyClosed=0",
    "Disconnected=0",
    "ActivePin=0 RightButtonNormallyClosed=0 LeftButtonNormallyClosed=0",
    "ActivePin=1",
    "Enable=0",
    "Enable=1",
    "Reset=1",
    "Reset=0",
    "FaultReset=1",
    "FaultReset=0",
    "InputStatus=0",
    "InputStatus=1",
];

const MAT: &[&str] = &[
    "ChannelA=0 ChannelB=0",
    "ChannelA=1",
    "ChannelB=0",
    "ChannelA=1 ChannelB=1",
    "Reset=1",
    "Reset=0",
    "Reset=1",
    "Reset=0",
    "Reset=1",
    "Reset=0",
    "Reset=1",
    "Reset=0",
    "Reset=1",
    "Reset=0",
    "InputStatus=0",
    "InputStatus=1",
    "InputStatus=1",
];

const MUTING: &[&str] = &[
    "Sensor1=0",
    "Sensor1=1",
    "Sensor2=0",
    "Sensor2=1",
    "Sensor3=0",
    "Sensor3=1",
    "Sensor4=0",
    "Sensor4=1",
    "LightCurtain=0",
    "LightCurtain=1",
    "Sensor1=1 Sensor2=1 Sensor3=1 Sensor4=1 LightCurtain=1",
    "Sensor1=1 Sensor2=1 Sensor3=1 Sensor4=1 LightCurtain=1 Reset=0",
    "Reset=1",
    "Reset=0",
    "Override=1",
    "Override=0",
    "EnableMute=0",
    "EnableMute=1",
    "MutingLampStatus=0",
    "MutingLampStatus=1",
    "InputStatus=0",
    "InputStatus=1",
    "Direction=0",
    "Direction=1",
];

const OUTPUT: &[&str] = &[
    "Actuate=1 Enable=1",
    "Actuate=0 Enable=0",
    "Feedback1=0 Feedback2=0",
    "Feedback1=1 Feedback2=1",
    "Feedback1=0 Feedback2=0",
    "Feedback1=1 Feedback2=1",
    "Feedback1=0",
    "Feedback1=1",
    "Feedback2=0",
    "Feedback2=1",
    "Reset=1 FaultReset=1",
    "Reset=0 FaultReset=0",
    "InputStatus=0",
    "OutputStatus=0",
    "InputStatus=1 OutputStatus=1",
    "DelayEnable=1",
    "DelayEnable=0",
];

const ANALOG: &[&str] = &[
    "ChannelA=500 ChannelB=505",
    "ChannelA=500 ChannelB=505",
    "ChannelA=500 ChannelB=510",
    "ChannelA=500 ChannelB=511",
    "ChannelA=1000 ChannelB=1000",
    "ChannelA=1001 ChannelB=1000",
    "ChannelA=100 ChannelB=100",
    "ChannelA=99 ChannelB=100",
    "ChannelA=2147483647 ChannelB=-2147483648",
    "Tolerance=-1",
    "Tolerance=10",
    "HighLimit=50",
    "HighLimit=1000",
    "Reset=1",
    "Reset=0",
    "Reset=1",
    "Reset=0",
    "InputStatus=0",
    "InputStatus=1",
];

const ANALOG_REAL: &[&str] = &[
    "ChannelA=50.0 ChannelB=50.5",
    "ChannelA=50.0 ChannelB=50.25",
    "ChannelA=50.0 ChannelB=50.500004",
    "ChannelA=100.0 ChannelB=100.0",
    "ChannelA=100.00001 ChannelB=100.0",
    "ChannelA=10.0 ChannelB=10.0",
    "ChannelA=9.999999 ChannelB=10.0",
    "ChannelA=NaN",
    "ChannelB=inf",
    "Tolerance=-1.0",
    "Tolerance=0.5",
    "HighLimit=NaN",
    "HighLimit=100.0",
    "Reset=1",
    "Reset=0",
    "Reset=1",
    "Reset=0",
    "InputStatus=0",
    "InputStatus=1",
];

const CIRCUIT: &[&str] = &[
    "ChannelA=1 ChannelB=1",
    "ChannelA=0 ChannelB=0",
    "ChannelA=1 ChannelB=0",
    "ChannelA=0 ChannelB=1",
    "ChannelA=0",
    "ChannelB=1",
    "CircuitReset=1",
    "CircuitReset=0",
    "FaultReset=1",
    "FaultReset=0",
    "MuteLightCurtain=1",
    "MuteLightCurtain=0",
    "InputFilterTime=0",
    "InputFilterTime=30",
    "InputFilterTime=251",
];

const SELECTOR: &[&str] = &[
    "Input1=1 Input2=0 Input3=0 Input5=0 Input8=0",
    "Input1=0 Input2=1 Input3=0 Input5=0 Input8=0",
    "Input1=0 Input2=0 Input3=1 Input5=0 Input8=0",
    "Input1=0 Input2=0 Input3=0 Input5=1 Input8=0",
    "Input1=0 Input2=0 Input3=0 Input5=0 Input8=1",
    "Input1=0 Input2=0 Input3=0 Input5=0 Input8=0",
    "Input2=1",
    "Lock=1",
    "Lock=0",
    "Reset=1 FaultReset=1",
    "Reset=0 FaultReset=0",
    "InputStatus=0",
    "InputStatus=1",
];

const CRANKSHAFT: &[&str] = &[
    "BrakeCam=0 TakeoverCam=0",
    "BrakeCam=1 TakeoverCam=0",
    "BrakeCam=1 TakeoverCam=1",
    "BrakeCam=0 TakeoverCam=1",
    "DynamicCam=0",
    "DynamicCam=1",
    "Enable=0",
    "Enable=1",
    "Reverse=0",
    "Reverse=1",
    "PressMotionStatus=1",
    "PressMotionStatus=0",
    "Reset=1",
    "Reset=0",
    "InputStatus=0",
    "InputStatus=1",
];

const CAMSHAFT: &[&str] = &[
    "MotionRequest=1",
    "MotionRequest=0",
    "ChannelA=1 ChannelB=1",
    "ChannelA=0 ChannelB=0",
    "ChannelA=1 ChannelB=1",
    "ChannelA=0 ChannelB=0",
    "ChannelA=1",
    "ChannelB=1",
    "Reset=1",
    "Reset=0",
    "InputStatus=0",
    "InputStatus=1",
    "MaxPulsePeriod=0",
    "MaxPulsePeriod=100",
];

const MANUAL_VALVE: &[&str] = &[
    "Actuate=1",
    "Actuate=0",
    "Actuate=1",
    "Actuate=0",
    "Enable=0",
    "Keyswitch=0",
    "Bottom=0",
    "FlywheelStopped=0",
    "SafetyEnable=0",
    "Enable=1 Keyswitch=1 Bottom=1 FlywheelStopped=1 SafetyEnable=1",
    "Enable=1 Keyswitch=1 Bottom=1 FlywheelStopped=1 SafetyEnable=1",
    "InputStatus=0",
    "OutputStatus=0",
    "InputStatus=1 OutputStatus=1",
    "Reset=1",
    "Reset=0",
];

const PRESS: &[&str] = &[
    "Start=1",
    "Start=0",
    "Start=1 PressInMotion=0 SlideZone=1",
    "Start=0 PressInMotion=0 SlideZone=1",
    "PressInMotion=1 SlideZone=2",
    "PressInMotion=1 SlideZone=4",
    "SlideZone=1",
    "SlideZone=0",
    "PressInMotion=0",
    "Enable=0",
    "SafetyEnable=0",
    "StandardEnable=0",
    "MotionMonitorFault=1",
    "Enable=1 SafetyEnable=1 StandardEnable=1 MotionMonitorFault=0",
    "Enable=1 SafetyEnable=1 StandardEnable=1 MotionMonitorFault=0",
    "SafetyEnableAck=1",
    "SafetyEnableAck=0",
    "ArmContinuous=1",
    "ArmContinuous=0",
    "StopAtTop=1",
    "StopAtTop=0",
];

/// The vocabulary of an instruction.
pub fn of(mnemonic: &str) -> Vocabulary {
    let (start, events) = match mnemonic {
        "DCS" | "DCST" | "DCSTL" | "DCSTM" | "DCM" | "DCSRT" => {
            ("InputStatus=1 MutingLampStatus=1 LockFeedback=1 Enable=1", STOP)
        }
        "SMAT" => ("InputStatus=1", MAT),
        "THRSe" | "THRS" => {
            ("InputStatus=1 Enable=1 ActivePin=1 RightButtonNormallyClosed=1 LeftButtonNormallyClosed=1", HANDS)
        }
        "TSAM" | "TSSM" | "FSBM" => (
            "InputStatus=1 MutingLampStatus=1 EnableMute=1 LightCurtain=1 Sensor1=1 Sensor2=1 Sensor3=1 Sensor4=1 Direction=1",
            MUTING,
        ),
        "CROUT" | "ROUT" | "AVC" | "MVC" => ("InputStatus=1 OutputStatus=1 DelayEnable=1", OUTPUT),
        "DCA" => ("InputStatus=1 ChannelA=500 ChannelB=505 Tolerance=10 HighLimit=1000 LowLimit=100", ANALOG),
        "DCAF" => {
            ("InputStatus=1 ChannelA=50.0 ChannelB=50.5 Tolerance=0.5 HighLimit=100.0 LowLimit=10.0", ANALOG_REAL)
        }
        "DIN" | "RIN" | "ENPEND" | "ESTOP" | "LC" => ("", CIRCUIT),
        "FPMS" | "EPMS" => ("InputStatus=1 Input1=1", SELECTOR),
        "CPM" => ("InputStatus=1 PressMotionStatus=1 DynamicCam=1", CRANKSHAFT),
        "CSM" => ("InputStatus=1 MechanicalDelayTime=200 MaxPulsePeriod=100", CAMSHAFT),
        "MMVC" => (
            "InputStatus=1 OutputStatus=1 Enable=1 Keyswitch=1 Bottom=1 FlywheelStopped=1 SafetyEnable=1",
            MANUAL_VALVE,
        ),
        "CBIM" | "CBSSM" | "CBCM" => ("Enable=1 SafetyEnable=1 StandardEnable=1 SlideZone=1", PRESS),
        other => panic!("no vocabulary for {other}"),
    };
    let wires = if mnemonic == "SMAT" { MAT_WIRES } else { &[] };
    Vocabulary { start, events, wires }
}
