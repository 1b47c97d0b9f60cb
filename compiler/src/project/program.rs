//! Safety programs and routines.

use twinrung_grammar::tree::{CompactString, Span};

use super::{AddOnId, ProgramId, RoutineId, Rung};

/// A safety program.
#[derive(Debug)]
pub struct Program {
    /// Its name.
    pub name: CompactString,
    /// Where it is declared.
    pub span: Span,
    /// The routine that the task runs.
    pub main: Option<RoutineId>,
    /// The routine that handles its recoverable faults.
    pub fault: Option<RoutineId>,
    /// Whether the task skips it.
    pub disabled: bool,
    /// Its routines.
    pub routines: Vec<RoutineId>,
}

/// Who owns a routine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RoutineOwner {
    /// A safety program.
    Program(ProgramId),
    /// An Add-On Instruction.
    AddOn(AddOnId),
}

/// A ladder routine.
#[derive(Debug)]
pub struct Routine {
    /// Its name.
    pub name: CompactString,
    /// Where it is declared.
    pub span: Span,
    /// Who owns it.
    pub owner: RoutineOwner,
    /// Its rungs.
    pub rungs: Vec<Rung>,
}
