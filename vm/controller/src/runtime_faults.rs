//! Runtime faults: type, code, what they mean, and whether anything here can raise them. general-instructions.md 2.5 and B.7.

/// Whether a fault can happen in this project.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Raised {
    /// Safety logic raises it.
    ByLogic,
    /// The controller raises it.
    ByController,
    /// It cannot happen here, for this reason.
    Never(&'static str),
}

/// A fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RuntimeFault {
    /// Its type: 4 of the program, 14 of the safety task.
    pub fault_type: u16,
    /// Its first code.
    pub first: u16,
    /// Its last code; the same as the first where it has one.
    pub last: u16,
    /// Whether it is a minor fault: it is counted, and nothing stops.
    pub minor: bool,
    /// What it means.
    pub meaning: &'static str,
    /// Whether it can happen.
    pub raised: Raised,
    /// Where it is from.
    pub source: &'static str,
}

const fn major(code: u16, meaning: &'static str, raised: Raised) -> RuntimeFault {
    RuntimeFault {
        fault_type: 4,
        first: code,
        last: code,
        minor: false,
        meaning,
        raised,
        source: "general-instructions.md 2.5",
    }
}

const fn minor(code: u16, meaning: &'static str, raised: Raised) -> RuntimeFault {
    RuntimeFault { minor: true, ..major(code, meaning, raised) }
}

const fn safety(code: u16, meaning: &'static str, raised: Raised) -> RuntimeFault {
    RuntimeFault { fault_type: 14, source: "general-instructions.md B.7", ..major(code, meaning, raised) }
}

const CHECKED: &str = "the compiler refuses it, and so does the loader";
const ONE_MACHINE: &str = "both channels are parts of one program on one computer";

/// Every fault that the reference names for safety logic and the safety task, minor ones after the major ones of their type.
pub static RUNTIME_FAULTS: &[RuntimeFault] = &[
    major(16, "unknown instruction", Raised::Never(CHECKED)),
    major(20, "a subscript is out of range, or LEN or POS of a CONTROL", Raised::ByLogic),
    major(21, "LEN or POS of a CONTROL is below 0", Raised::ByLogic),
    major(31, "the parameters of JSR do not match those of SBR or RET", Raised::Never(CHECKED)),
    major(34, "PRE or ACC of a timer is below 0", Raised::ByLogic),
    major(42, "JMP to a label that does not exist", Raised::Never(CHECKED)),
    major(83, "data is not inside required limits", Raised::Never("no admitted instruction tests data for limits")),
    major(
        84,
        "the stack overflows",
        Raised::Never("calls are acyclic and no deeper than a limit that is checked before"),
    ),
    major(90, "a safety instruction outside the safety task", Raised::Never("standard logic is not executed")),
    major(94, "one JMP has jumped backward too often in one execution", Raised::ByLogic),
    RuntimeFault { last: 999, ..major(990, "of the user: JSR to the fault routine with this number", Raised::ByLogic) },
    minor(4, "an arithmetic result does not fit", Raised::ByLogic),
    minor(5, "GSV or SSV: the instance does not exist", Raised::Never(CHECKED)),
    minor(6, "GSV or SSV: class or attribute do not exist, or there is too little data", Raised::Never(CHECKED)),
    minor(7, "GSV: the destination is too small", Raised::Never(CHECKED)),
    safety(1, "the watchdog of the safety task expired", Raised::ByController),
    safety(2, "a fault in a routine of the safety task that no fault routine cleared", Raised::ByController),
    safety(3, "the safety partner is missing", Raised::Never(ONE_MACHINE)),
    safety(4, "the safety partner is not available", Raised::ByController),
    safety(5, "the hardware of the safety partner is incompatible", Raised::Never(ONE_MACHINE)),
    safety(6, "the firmware of the safety partner is incompatible", Raised::Never(ONE_MACHINE)),
    safety(7, "the safety task is inoperable: the channels differ, or memory is corrupt", Raised::ByController),
    safety(8, "there is no master of the coordinated system time", Raised::Never("time is an argument of a scan")),
    safety(9, "a nonrecoverable controller fault: the partnership is lost", Raised::ByController),
];
