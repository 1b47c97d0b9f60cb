//! Runs a generated program against its stimulus on all three evaluators, and shrinks what they disagree in.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use twinrung_workbench::Signal;

use crate::generate::{Generated, Random, Stimulus};
use crate::{Ended, Executions, Subject, Trio};

/// What came of a run.
#[derive(Debug, Clone)]
pub enum Outcome {
    /// All three agreed after every scan.
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
    /// Rungs and instructions that the primary executed.
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

/// Runs all steps, or until the evaluators disagree.
pub fn replay(text: &str, stimulus: &Stimulus) -> Outcome {
    let mut steps = 0;
    let run = catch_unwind(AssertUnwindSafe(|| run(text, stimulus, &mut steps)));
    match run {
        Ok(outcome) => outcome,
        Err(panic) => {
            let words = panic.downcast_ref::<String>().cloned();
            let words = words.or_else(|| panic.downcast_ref::<&str>().map(|words| (*words).to_owned()));
            Outcome::Failed { report: format!("panic: {}", words.unwrap_or_default()), steps }
        }
    }
}

fn run(text: &str, stimulus: &Stimulus, steps: &mut usize) -> Outcome {
    let subject = match Subject::from_text(text) {
        Ok(subject) => subject,
        Err(findings) => return Outcome::Refused(findings),
    };
    let mut trio = Trio::new(&subject);
    trio.budget = stimulus.budget;
    trio.count_executions();
    let mut counts = Counts::default();
    let mut signals: HashMap<&str, Signal> = HashMap::new();
    let mut values = Vec::new();
    for step in &stimulus.steps {
        *steps += 1;
        values.clear();
        for (name, value) in &step.values {
            let signal = *signals.entry(name).or_insert_with(|| trio.signal(name));
            values.push((signal, *value));
        }
        trio.set_signals(&values);
        if let Some(seed) = step.system_values {
            trio.set_system_values(&mut Random::new(seed));
        }
        let ended = if step.prescan { trio.prescan(step.now_ms) } else { trio.scan(step.now_ms) };
        match ended {
            Ok(Ended::Completed) => {}
            Ok(Ended::Fault(_)) => counts.faulted += 1,
            Ok(Ended::BudgetExceeded) => counts.over_budget += 1,
            Err(disagreement) => return Outcome::Failed { report: disagreement.to_string(), steps: *steps },
        }
        counts.scans += 1;
    }
    counts.instructions = trio.executed();
    counts.cleared = u64::from(trio.status().cleared_faults);
    counts.executions = trio.executions().cloned().unwrap_or_default();
    Outcome::Agreed(Box::new(counts))
}

/// The smallest program and stimulus found on which the evaluators still fail, and their report.
pub fn shrink(generated: &Generated, stimulus: &Stimulus) -> (String, Stimulus, String) {
    let mut text = generated.text.clone();
    let mut stimulus = stimulus.clone();
    let mut report = String::new();
    if let Outcome::Failed { report: first, steps } = replay(&text, &stimulus) {
        report = first;
        stimulus.steps.truncate(steps);
    }
    let mut attempt = |text: &mut String, stimulus: &mut Stimulus, smaller: String| {
        let declared = only_declared(stimulus, &smaller);
        if let Outcome::Failed { report: found, steps } = replay(&smaller, &declared)
            && same_kind(&report, &found)
        {
            report = found;
            *text = smaller;
            *stimulus = declared;
            stimulus.steps.truncate(steps);
            return true;
        }
        false
    };
    // Runs of lines, long ones first, then instructions, until nothing more can go.
    let mut length = 32;
    while length > 0 {
        let mut at = 0;
        while at < text.lines().count() {
            let removed = without_lines(&text, at, length);
            if !attempt(&mut text, &mut stimulus, removed) {
                at += length;
            }
        }
        length /= 2;
    }
    for part in [without_instruction, without_branch] {
        let mut at = 0;
        while let Some(smaller) = part(&text, at) {
            if !attempt(&mut text, &mut stimulus, smaller) {
                at += 1;
            }
        }
    }
    let mut at = 0;
    while at < text.lines().count() {
        let removed = without_lines(&text, at, 1);
        if !attempt(&mut text, &mut stimulus, removed) {
            at += 1;
        }
    }
    let mut at = 0;
    while at < stimulus.steps.len() {
        let mut fewer = stimulus.clone();
        fewer.steps.remove(at);
        let same = text.clone();
        let mut kept = text.clone();
        let mut tried = fewer;
        if attempt(&mut kept, &mut tried, same) {
            stimulus = tried;
        } else {
            at += 1;
        }
    }
    (text, stimulus, report)
}

/// Whether two reports tell of the same kind of failure; a panic that shrinking caused is none.
fn same_kind(first: &str, second: &str) -> bool {
    let panics = |report: &str| report.starts_with("panic: ");
    if panics(first) { first == second } else { !panics(second) }
}

fn without_lines(text: &str, from: usize, count: usize) -> String {
    let kept = text.lines().enumerate().filter(|(at, _)| *at < from || *at >= from + count);
    kept.map(|(_, line)| format!("{line}\n")).collect()
}

/// The text without the brackets number `at` and all within them; nothing where there are not as many. Every bracket of a
/// rung is tried; taking the subscript of an operand away is refused or fails differently, and is undone then.
fn without_branch(text: &str, at: usize) -> Option<String> {
    let (open, _) = text.match_indices('[').nth(at)?;
    let mut depth = 0;
    let close = text[open..].find(|one| {
        depth += i32::from(one == '[') - i32::from(one == ']');
        depth == 0
    })?;
    Some(format!("{}{}", &text[..open], &text[open + close + 1..]))
}

/// The text without its instruction number `at`; nothing where there are not as many.
fn without_instruction(text: &str, at: usize) -> Option<String> {
    let bytes = text.as_bytes();
    let mut number = 0;
    let mut line_start = 0;
    for line in text.split_inclusive('\n') {
        let body = line.trim_start();
        let begin = line_start + (line.len() - body.len());
        line_start += line.len();
        if !body.starts_with("N: ") {
            continue;
        }
        let end = begin + body.trim_end().len();
        let mut position = begin + 3;
        while position < end {
            let opens = bytes[position].is_ascii_alphabetic();
            if !opens {
                position += 1;
                continue;
            }
            let (mut depth, mut close) = (0, position);
            while close < end {
                match bytes[close] {
                    b'(' => depth += 1,
                    b')' if depth == 1 => break,
                    b')' => depth -= 1,
                    _ => {}
                }
                close += 1;
            }
            if number == at {
                return Some(format!("{}{}", &text[..position], text.get(close + 1..).unwrap_or_default()));
            }
            number += 1;
            position = close + 1;
        }
    }
    None
}

/// The stimulus without tags that the text declares no more.
fn only_declared(stimulus: &Stimulus, text: &str) -> Stimulus {
    let declared = |name: &str| {
        let base = name.split(['.', '[']).next().unwrap_or(name);
        text.lines().any(|line| line.trim_start().strip_prefix(base).is_some_and(|rest| rest.starts_with(" : ")))
    };
    let mut kept = stimulus.clone();
    for step in &mut kept.steps {
        step.values.retain(|(name, _)| declared(name));
    }
    kept
}
