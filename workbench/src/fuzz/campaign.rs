//! Many random programs, one after the other, and what they amounted to.

use std::collections::BTreeMap;
use std::fmt;
use std::time::Duration;

use crate::generate::{self, Size};

use super::{Case, Contest, Counts, Outcome, replay, shrink};

/// What came of the program of one seed.
#[derive(Debug)]
pub enum Ran {
    /// The evaluators agreed.
    Agreed(Box<Counts>),
    /// The compiler refused the program: its first finding.
    Refused(String),
    /// They did not agree.
    Failed(Box<Failure>),
}

/// A program on which the evaluators do not agree.
#[derive(Debug)]
pub struct Failure {
    /// The seed of the program.
    pub seed: u64,
    /// What they differed in at first.
    pub report: String,
    /// The smallest case found.
    pub case: Case,
    /// What they differ in there.
    pub smallest: String,
    /// When it was found.
    pub found: Found,
}

/// How far a campaign had come when something was found.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Found {
    /// Time since it began.
    pub after: Duration,
    /// Programs that were done.
    pub programs: u64,
}

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
    /// The seeds on which the evaluators do not agree.
    pub failures: Vec<Failure>,
}

/// The size that the program of a seed has where nothing else is asked for: one in four is large.
pub fn size_of(seed: u64) -> Size {
    if seed.is_multiple_of(4) { Size::LARGE } else { Size::SMALL }
}

/// Runs the program of one seed for so many scans; a failure is made small, or left as it was found.
pub fn ran<C: Contest>(seed: u64, size: Size, scans: usize, as_found: bool) -> Ran {
    let generated = generate::program(seed, size);
    let stimulus = generate::stimulus(seed, &generated, scans);
    match replay::<C>(&generated.text, &stimulus) {
        Outcome::Agreed(counts) => Ran::Agreed(counts),
        Outcome::Refused(findings) => Ran::Refused(findings.into_iter().next().unwrap_or_default()),
        Outcome::Failed { report, .. } => {
            let whole = Case { text: generated.text, stimulus };
            let (case, smallest) = if as_found { (whole, report.clone()) } else { shrink::<C>(whole) };
            Ran::Failed(Box::new(Failure { seed, report, case, smallest, found: Found::default() }))
        }
    }
}

impl Campaign {
    /// Runs the program of one seed for so many scans; a failure is shrunk and kept.
    pub fn run<C: Contest>(&mut self, seed: u64, size: Size, scans: usize) {
        self.add(seed, ran::<C>(seed, size, scans, false), Duration::ZERO);
    }

    /// Adds what came of a seed, so long after the campaign began.
    pub fn add(&mut self, seed: u64, ran: Ran, after: Duration) {
        self.programs += 1;
        match ran {
            Ran::Agreed(counts) => self.total.add(&counts),
            Ran::Refused(finding) => {
                self.refused += 1;
                self.reasons.entry(finding).or_insert((0, seed)).0 += 1;
            }
            Ran::Failed(failure) => {
                let found = Found { after, programs: self.programs };
                self.failures.push(Failure { found, ..*failure });
            }
        }
    }

    /// The failures as text; empty where there is none.
    pub fn failures_shown(&self) -> String {
        self.failures.iter().map(|failure| format!("{failure}\n\n")).collect()
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Failure { seed, report, case, smallest, .. } = self;
        writeln!(f, "seed {seed}: {}", report.trim_end())?;
        writeln!(f, "\nthe smallest program that still shows it:\n\n{}", case.text)?;
        writeln!(f, "its inputs:\n\n{}", case.to_csv())?;
        f.write_str(smallest)
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
