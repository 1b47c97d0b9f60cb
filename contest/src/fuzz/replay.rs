//! Runs a program against its stimulus on all evaluators of a contest.

use std::cell::Cell;
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::generate::{Random, Stimulus};
use crate::names;
use crate::signal::Signal;

use super::{Contest, Ended, Evaluators, Executions, Subject};

/// What came of a run.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// They agreed after every scan.
    Agreed(Box<Counts>),
    /// The compiler refuses the program: its findings.
    Refused(Vec<String>),
    /// They disagree, or one of them panicked: what is to be said about it, and after how many steps.
    Failed {
        /// The disagreement or the panic, as text.
        report: String,
        /// Steps until it showed.
        steps: usize,
    },
}

/// How much was executed.
#[derive(Debug, Clone, Default)]
pub struct Counts {
    /// Scans and prescans.
    pub scans: u64,
    /// Those that a major fault ended.
    pub faulted: u64,
    /// Those that ended because the budget ran out.
    pub over_budget: u64,
    /// Faults that a fault routine cleared.
    pub cleared: u64,
    /// Instructions that each evaluator executed.
    pub instructions: u64,
    /// Rungs, and what was reached.
    pub executions: Executions,
}

impl Counts {
    /// Adds those of another run.
    pub fn add(&mut self, other: &Counts) {
        self.scans += other.scans;
        self.faulted += other.faulted;
        self.over_budget += other.over_budget;
        self.cleared += other.cleared;
        self.instructions += other.instructions;
        self.executions.add(&other.executions);
    }
}

thread_local! {
    static REPLAYING: Cell<bool> = const { Cell::new(false) };
}

/// Whether this thread replays: a panic is then caught, and said as what came of the run.
pub fn is_replaying() -> bool {
    REPLAYING.get()
}

/// Runs all steps, or until the evaluators disagree.
pub fn replay<C: Contest>(text: &str, stimulus: &Stimulus) -> Outcome {
    let mut steps = 0;
    let within = REPLAYING.replace(true);
    let run = catch_unwind(AssertUnwindSafe(|| run::<C>(text, stimulus, &mut steps)));
    REPLAYING.set(within);
    match run {
        Ok(outcome) => outcome,
        Err(panic) => {
            let words = panic.downcast_ref::<String>().cloned();
            let words = words.or_else(|| panic.downcast_ref::<&str>().map(|words| (*words).to_owned()));
            Outcome::Failed { report: format!("panic: {}", words.unwrap_or_default()), steps }
        }
    }
}

fn run<C: Contest>(text: &str, stimulus: &Stimulus, steps: &mut usize) -> Outcome {
    let subject = match Subject::from_text(text) {
        Ok(subject) => subject,
        Err(findings) => return Outcome::Refused(findings),
    };
    let mut evaluators = C::load(&subject, stimulus.budget);
    let mut counts = Counts::default();
    let mut signals: HashMap<&str, Signal> = HashMap::new();
    let mut values = Vec::new();
    for step in &stimulus.steps {
        *steps += 1;
        values.clear();
        for (name, value) in &step.values {
            let look_up = || names::signal(&subject.image, name).unwrap_or_else(|error| panic!("{error}"));
            values.push((*signals.entry(name).or_insert_with(look_up), *value));
        }
        evaluators.set(&values);
        if let Some(seed) = step.system_values {
            evaluators.set_system_values(&mut Random::new(seed));
        }
        let ended = if step.prescan { evaluators.prescan(step.now_ms) } else { evaluators.scan(step.now_ms) };
        match ended {
            Ok(Ended::Completed) => {}
            Ok(Ended::Fault(_)) => counts.faulted += 1,
            Ok(Ended::BudgetExceeded) => counts.over_budget += 1,
            Err(report) => return Outcome::Failed { report, steps: *steps },
        }
        counts.scans += 1;
    }
    counts.instructions = evaluators.executed();
    counts.cleared = evaluators.cleared_faults();
    counts.executions = evaluators.executions().clone();
    Outcome::Agreed(Box::new(counts))
}
