//! What an instruction does in each kind of execution, in sentences for `explain`.

/// What an instruction does in each kind of execution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Execution {
    /// With a true rung condition.
    pub on_true: &'static str,
    /// With a false rung condition.
    pub on_false: &'static str,
    /// While the controller prescans: at power-up in Run and at each change to Run.
    pub prescan: &'static str,
    /// Which faults it raises and which status flags it changes; empty where it does neither.
    pub faults: &'static str,
}

/// Declares what a base instruction does.
pub const fn execution(
    on_true: &'static str,
    on_false: &'static str,
    prescan: &'static str,
    faults: &'static str,
) -> Execution {
    Execution { on_true, on_false, prescan, faults }
}

/// Nothing happens in a prescan.
pub const NOTHING: &str = "Nothing.";

/// A false rung that leaves everything.
pub const LEFT: &str = "Nothing: what it writes keeps its value.";

/// A false rung before an input instruction.
pub const NOT_READ: &str = "Is false; the operands are not read.";

/// What is written in every safety application instruction's table of executions.
const COPIED: &str = "Copies the operands into the backing tag's members, then does what stands above.";

/// The instructions of dual-channel-inputs.md 1.8 and muting-and-outputs.md 1.3: a false rung hides a fault and keeps it.
pub const KEEPS_FAULT: Execution = execution(
    COPIED,
    "Outputs are off, FP and both codes read 0, timers and sequences are dropped. A latched fault is kept and shown \
     again when the rung is true; what follows is a normal restart, never a cold start.",
    "Outputs are off, a latched fault is forgotten, the configuration is taken over. Reset that is already ON is no \
     rising edge.",
    "",
);

/// The instructions of v14-and-metal-form.md 1.3: a false rung begins anew.
pub const BEGINS_ANEW: Execution = execution(
    COPIED,
    "Outputs are off, prompts, faults and codes read 0, and the instruction begins anew: a latched fault is \
     forgotten, and start-up asks for fresh evidence (cycled inputs, a rising edge).",
    "As a false rung. An input that is already ON is no rising edge.",
    "",
);
