//! Many random programs, one after the other, and what they amounted to.

use std::collections::BTreeMap;
use std::fmt;

use crate::generate::{self, Size};
use crate::replay::{Counts, Outcome, replay, shrink};

/// A run over many seeds.
#[derive(Debug, Default)]
pub struct Campaign {
    /// Programs generated.
    pub programs: u64,
    /// Programs that the compiler refused.
    pub refused: u64,
    /// What the others executed, all together.
    pub total: Counts,
    /// For each finding that refused a program: how many, and the seed of the first.
    pub reasons: BTreeMap<String, (u64, u64)>,
    /// For each seed on which the evaluators disagree: the smallest program found, its stimulus, and their values.
    pub failures: Vec<String>,
}

impl Campaign {
    /// Runs the program of one seed for so many scans; a failure is shrunk and kept.
    pub fn run(&mut self, seed: u64, size: Size, scans: usize) {
        let generated = generate::program(seed, size);
        let stimulus = generate::stimulus(seed, &generated, scans);
        self.programs += 1;
        match replay(&generated.text, &stimulus) {
            Outcome::Agreed(counts) => self.total.add(&counts),
            Outcome::Refused(findings) => {
                self.refused += 1;
                if let Some(finding) = findings.into_iter().next() {
                    self.reasons.entry(finding).or_insert((0, seed)).0 += 1;
                }
            }
            Outcome::Failed { report, steps } => {
                let (text, stimulus, smallest) = shrink(&generated, &stimulus);
                let mut words =
                    format!("seed {seed}, step {steps}: {report}\nshrunk, budget {}:\n{text}", stimulus.budget);
                for step in &stimulus.steps {
                    let kind = if step.prescan { "prescan" } else { "scan" };
                    let values: Vec<String> =
                        step.values.iter().map(|(name, value)| format!("{name} := {value}")).collect();
                    let system =
                        step.system_values.map_or(String::new(), |seed| format!("; system values of seed {seed}"));
                    words.push_str(&format!("  {kind} at {} ms: {}{system}\n", step.now_ms, values.join(", ")));
                }
                words.push_str(&smallest);
                self.failures.push(words);
            }
        }
    }
}

impl fmt::Display for Campaign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Counts { scans, faulted, over_budget, cleared, instructions, executions } = &self.total;
        write!(
            f,
            "{} programs, {} refused, {scans} scans ({faulted} faulted, {over_budget} over budget, {cleared} faults cleared), \
             {instructions} instructions, {} rung executions, {} failures",
            self.programs,
            self.refused,
            executions.rungs,
            self.failures.len()
        )
    }
}
