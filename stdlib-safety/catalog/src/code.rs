//! Fault and diagnostic codes of safety application instructions.

/// Which word of the backing tag shows a code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CodeWord {
    /// `FaultCode`.
    Fault,
    /// `DiagnosticCode`.
    Diagnostic,
    /// Not a code word but a flag member of the backing tag (older instructions), named here.
    Flag(&'static str),
}

/// One code with its meaning. A code is keyed by its instruction: the same number may mean another thing elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Code {
    /// The number that the word shows; 1 for a flag.
    pub value: i32,
    /// Which word shows it.
    pub word: CodeWord,
    /// What happened.
    pub cause: &'static str,
    /// What to do.
    pub remedy: &'static str,
    /// Origin mark of the number and of its meaning in the reference (`recalled-high`, `decided D15`, ...).
    pub origin: &'static str,
}

/// Declares a code of `FaultCode`.
pub const fn fault(value: i32, cause: &'static str, remedy: &'static str, origin: &'static str) -> Code {
    Code { value, word: CodeWord::Fault, cause, remedy, origin }
}

/// Declares a code of `DiagnosticCode`.
pub const fn diagnostic(value: i32, cause: &'static str, remedy: &'static str, origin: &'static str) -> Code {
    Code { value, word: CodeWord::Diagnostic, cause, remedy, origin }
}

/// Declares a flag member that stands in place of a code.
pub const fn flag_code(member: &'static str, cause: &'static str, remedy: &'static str, origin: &'static str) -> Code {
    Code { value: 1, word: CodeWord::Flag(member), cause, remedy, origin }
}
