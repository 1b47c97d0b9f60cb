//! What is fuzzed: evaluators that run one program and compare themselves.

use crate::generate::Random;
use crate::signal::{Signal, Value};

use super::{Executions, Subject};

/// How an execution ended, all evaluators agreeing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// All programs ran.
    Completed,
    /// A major fault 4/code that nothing cleared.
    Fault(u16),
    /// The budget ran out.
    BudgetExceeded,
}

/// Evaluators that have loaded one program.
pub trait Evaluators {
    /// Sets values in all of them.
    fn set(&mut self, values: &[(Signal, Value)]);

    /// Draws what GSV reads from here on.
    fn set_system_values(&mut self, random: &mut Random);

    /// Prescans all of them, at a time in ms.
    ///
    /// # Errors
    ///
    /// What they differ in, for a person.
    fn prescan(&mut self, now_ms: i64) -> Result<Ended, String>;

    /// One scan of all of them, at a time in ms.
    ///
    /// # Errors
    ///
    /// What they differ in, for a person.
    fn scan(&mut self, now_ms: i64) -> Result<Ended, String>;

    /// Instructions that each has executed.
    fn executed(&self) -> u64;

    /// Faults that a fault routine cleared.
    fn cleared_faults(&self) -> u64;

    /// What one of them executed.
    fn executions(&self) -> &Executions;
}

/// Which evaluators run against each other.
pub trait Contest {
    /// They, with a program.
    type Evaluators<'s>: Evaluators;

    /// Loads a program into all of them. Panics where one refuses an image that was admitted: that is a defect.
    fn load(subject: &Subject, budget: u64) -> Self::Evaluators<'_>;
}
