//! Many programs, one after the other or on several threads, and what they amounted to.

use std::collections::BTreeMap;
use std::fmt;
use std::time::Duration;

use crate::generate::{Genome, Size};

use super::cases::{Failure, Found, Ran, ran};
use super::{Contest, Counts};

/// A run over many programs.
#[derive(Debug, Default)]
pub struct Campaign {
    /// Programs generated.
    pub programs: u64,
    /// Programs that the compiler refused.
    pub refused: u64,
    /// What the others executed, all together.
    pub total: Counts,
    /// For each finding that refused a program: how many, and the number of the first.
    pub reasons: BTreeMap<String, (u64, u64)>,
    /// The programs on which the evaluators do not agree.
    pub failures: Vec<Failure>,
    /// Genomes that reached something new.
    pub kept: usize,
}

impl Campaign {
    /// Runs the program of one seed for so many scans; a failure is made small and kept.
    pub fn run<C: Contest>(&mut self, seed: u64, size: Size, scans: usize) {
        let mut ran = ran::<C>(seed, &Genome::of_seed(seed), size, scans);
        if let Ran::Failed(failure) = &mut ran {
            failure.shrink::<C>();
        }
        self.add(ran, Duration::ZERO);
    }

    /// Adds what came of a program, so long after the campaign began.
    pub fn add(&mut self, ran: Ran, after: Duration) {
        self.programs += 1;
        match ran {
            Ran::Agreed(counts) => self.total.add(&counts),
            Ran::Refused { number, finding } => {
                self.refused += 1;
                self.reasons.entry(finding).or_insert((0, number)).0 += 1;
            }
            Ran::Failed(failure) => {
                let found = failure.found.unwrap_or(Found { after, programs: self.programs });
                self.failures.push(Failure { found: Some(found), ..*failure });
            }
        }
    }

    /// The failures as text; empty where there is none.
    pub fn failures_shown(&self) -> String {
        self.failures.iter().map(|failure| format!("{failure}\n\n")).collect()
    }
}

impl fmt::Display for Campaign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Counts { scans, faulted, over_budget, cleared, instructions, executions } = &self.total;
        write!(
            f,
            "{} programs, {} refused, {scans} scans, {instructions} instructions, {} rung executions, {} failures; on purpose \
             {faulted} scans end in a major fault and {over_budget} at the budget, and {cleared} faults are cleared",
            self.programs,
            self.refused,
            executions.rungs,
            self.failures.len(),
        )
    }
}
