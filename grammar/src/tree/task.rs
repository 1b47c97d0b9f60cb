//! Tasks.

use super::{Attribute, Class, Name, Span, Spanned, Text, Trivia};

/// A `TASK`. Times in microseconds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Task {
    /// The task's name.
    pub name: Name,
    /// `CONTINUOUS`, `PERIODIC`, `EVENT`.
    pub task_type: Option<Name>,
    /// Standard or safety; standard when the file is silent.
    pub class: Option<Spanned<Class>>,
    /// Period, µs (written in ms, decimals allowed).
    pub rate_us: Option<Spanned<u64>>,
    /// Priority, 1 highest.
    pub priority: Option<Spanned<u32>>,
    /// Watchdog, µs (written in ms, decimals allowed).
    pub watchdog_us: Option<Spanned<u64>>,
    /// Outputs are not sent at the end of the task.
    pub disable_update_outputs: Option<Spanned<bool>>,
    /// The task is not executed.
    pub inhibited: Option<Spanned<bool>>,
    /// Its programs in the order of execution.
    pub programs: Vec<Name>,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}
