//! What a vector holds.

use alloc::vec::Vec;
use twinrung_catalog::operand::OperandKind;
use twinrung_catalog::{Code, CodeWord, Opcode, SafetyApplication};

/// One run of one instruction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Vector {
    /// The instruction.
    pub opcode: Opcode,
    /// The vector's name, unique in its instruction.
    pub name: &'static str,
    /// What it shows.
    pub shows: &'static str,
    /// File and section of the reference, and the trace where one was taken over.
    pub source: &'static str,
    /// The reference's origin mark of what is expected.
    pub mark: &'static str,
    /// What to see in it, where this is the vector of normal operation: the instruction's page draws it. Empty elsewhere.
    pub normal: &'static str,
    /// The scan periods with which it may be run, in ms.
    pub periods_ms: Vec<u32>,
    /// The configuration operands.
    pub configuration: Vec<Setting>,
    /// What changes, in ascending time.
    pub steps: Vec<Step>,
    /// The time of the last scan, in ms.
    pub end_ms: u32,
}

/// What changes at one time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// Time in ms since the first scan.
    pub at_ms: u32,
    /// How much later than the times of the vector the scan at this time and those after it come, in ms; leaps add up.
    pub leap_ms: u32,
    /// Whether a prescan comes before the scan at this time.
    pub prescan: bool,
    /// The rung condition from this scan on, where it is set.
    pub rung: Option<bool>,
    /// Operands that change before the scan at this time.
    pub inputs: Vec<Setting>,
    /// Members that have a new value from this scan on.
    pub expected: Vec<Expectation>,
}

/// A value of an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Setting {
    /// Which operand, counted from 0 after the backing tag.
    pub operand: usize,
    /// The member that mirrors it.
    pub name: &'static str,
    /// BOOL 0 or 1, DINT, or the bits of a REAL.
    pub value: i32,
}

/// A value that a member must have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Expectation {
    /// Which member of the backing type, counted from 0.
    pub member: usize,
    /// Its name.
    pub name: &'static str,
    /// BOOL 0 or 1, DINT, or the bits of a REAL.
    pub value: i32,
}

impl Vector {
    /// The declaration of the instruction; `None` cannot occur in a vector that was parsed.
    pub fn declaration(&self) -> Option<&'static SafetyApplication> {
        self.opcode.instruction().safety
    }

    /// The declared codes that this vector expects to see, in the order of the declaration.
    pub fn expected_codes(&self) -> impl Iterator<Item = &'static Code> {
        let codes = self.declaration().map_or(&[][..], |declaration| declaration.codes);
        codes.iter().filter(|code| self.expects(code))
    }

    fn expects(&self, code: &Code) -> bool {
        let member = match code.word {
            CodeWord::Fault => "FaultCode",
            CodeWord::Diagnostic => "DiagnosticCode",
            CodeWord::Flag(member) => member,
        };
        self.steps
            .iter()
            .flat_map(|step| &step.expected)
            .any(|expectation| expectation.name == member && expectation.value == code.value)
    }

    /// Whether a call with this configuration can be compiled: every configuration operand is in its range and none
    /// changes at run time. The other vectors show what happens when an image was corrupted; only the halves
    /// themselves can run them.
    pub fn is_admissible(&self) -> bool {
        let operands = self.opcode.instruction().operands.get(1..).unwrap_or_default();
        let kind = |setting: &Setting| operands.get(setting.operand).map(|operand| operand.kind);
        let changes = self
            .steps
            .iter()
            .flat_map(|step| &step.inputs)
            .any(|setting| matches!(kind(setting), Some(OperandKind::Choice(_) | OperandKind::Literal { .. })));
        !changes
            && self.configuration.iter().all(|setting| match kind(setting) {
                Some(OperandKind::Choice(list)) => list.word(setting.value).is_some(),
                Some(OperandKind::Literal { or_zero, least, greatest, .. }) => {
                    (least..=greatest).contains(&setting.value) || (or_zero && setting.value == 0)
                }
                _ => true,
            })
    }
}
