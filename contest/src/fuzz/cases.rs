//! One program of a campaign, and what came of it.

use std::fmt;
use std::time::Duration;

use crate::generate::{self, Genome, Size};

use super::coverage::Bits;
use super::{Case, Contest, Counts, Outcome, replay, shrink};

/// What came of a program.
#[derive(Debug)]
pub enum Ran {
    /// The evaluators agreed.
    Agreed(Box<Counts>),
    /// The compiler refused it.
    Refused {
        /// Which program of the campaign.
        number: u64,
        /// The first finding.
        finding: String,
    },
    /// They did not agree.
    Failed(Box<Failure>),
}

/// A program on which the evaluators do not agree.
#[derive(Debug)]
pub struct Failure {
    /// Which program of the campaign; the seed where it came from a seed alone.
    pub number: u64,
    /// What they differed in at first.
    pub report: String,
    /// The smallest case found.
    pub case: Case,
    /// What they differ in there.
    pub smallest: String,
    /// When it was found.
    pub found: Option<Found>,
}

/// How far a campaign had come when something was found.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Found {
    /// Time since it began.
    pub after: Duration,
    /// Programs that were done.
    pub programs: u64,
}

/// The size that the program of a seed has where nothing else is asked for: one in four is large.
pub fn size_of(seed: u64) -> Size {
    if seed.is_multiple_of(4) { Size::LARGE } else { Size::SMALL }
}

/// Runs the program of a genome for so many scans. A failure is left as it was found.
pub fn ran<C: Contest>(number: u64, genome: &Genome, size: Size, scans: usize) -> Ran {
    completed::<C>(number, genome, size, scans).0
}

/// As [`ran`], with the genome completed by the choices that it did not give.
pub(super) fn completed<C: Contest>(number: u64, genome: &Genome, size: Size, scans: usize) -> (Ran, Genome) {
    let (generated, stimulus, genome) = generate::of_genome(genome, size, scans);
    let ran = match replay::<C>(&generated.text, &stimulus) {
        Outcome::Agreed(counts) => Ran::Agreed(counts),
        Outcome::Refused(findings) => Ran::Refused { number, finding: findings.into_iter().next().unwrap_or_default() },
        Outcome::Failed { report, .. } => {
            let case = Case { text: generated.text, stimulus };
            Ran::Failed(Box::new(Failure { number, smallest: report.clone(), report, case, found: None }))
        }
    };
    (ran, genome)
}

impl Ran {
    /// What it reached; nothing where it was refused or failed.
    pub(super) fn features(&self) -> Option<&Bits> {
        match self {
            Ran::Agreed(counts) => Some(&counts.executions.features),
            Ran::Refused { .. } | Ran::Failed(_) => None,
        }
    }
}

impl Failure {
    /// Makes the case as small as it gets.
    pub fn shrink<C: Contest>(&mut self) {
        (self.case, self.smallest) = shrink::<C>(self.case.clone());
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Failure { number, report, case, smallest, .. } = self;
        writeln!(f, "program {number}: {}", report.trim_end())?;
        writeln!(f, "\nthe smallest program that still shows it:\n\n{}", case.text)?;
        writeln!(f, "its inputs:\n\n{}", case.to_csv())?;
        f.write_str(smallest)
    }
}
