//! Tasks.

use twinrung_grammar::tree::{CompactString, Span};

use super::{ProgramId, TagClass};

/// A task.
#[derive(Debug, Clone)]
pub struct Task {
    /// Its name.
    pub name: CompactString,
    /// Where it is declared.
    pub span: Span,
    /// Standard or safety.
    pub class: TagClass,
    /// `PERIODIC`, `CONTINUOUS`, `EVENT`; upper case.
    pub task_type: CompactString,
    /// Period in µs.
    pub period_us: Option<(u64, Span)>,
    /// Watchdog in µs.
    pub watchdog_us: Option<(u64, Span)>,
    /// Priority, 1 highest, and where the declaration says it.
    pub priority: (u32, Span),
    /// Whether it is not executed.
    pub inhibited: Option<Span>,
    /// What it runs, in order.
    pub schedule: Vec<Scheduled>,
}

/// A program that a task schedules.
#[derive(Debug, Clone)]
pub struct Scheduled {
    /// Its name.
    pub name: CompactString,
    /// Where the schedule says so.
    pub span: Span,
    /// The safety program of this name; nothing for a standard or an unknown one.
    pub program: Option<ProgramId>,
}
