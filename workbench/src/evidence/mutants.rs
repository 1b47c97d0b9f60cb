//! Mutation testing: how many small changes of a crate its tests notice.

use serde::{Deserialize, Serialize};

use crate::inject::Coverage;

use super::floors::{MUTATED, MUTATION_SAMPLE};
use super::{EvidenceError, Origin, Sources};

/// How a crate was mutated, and what came of it, as `tests/mutants/*.toml` says it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct MutationRun {
    /// The crate: its folder or its name.
    #[serde(rename = "crate")]
    pub name: String,
    /// The tool and its version.
    #[serde(default)]
    pub tool: String,
    /// The command that makes it again.
    #[serde(default)]
    pub command: String,
    /// The commit whose sources were mutated.
    #[serde(default)]
    pub commit: String,
    /// How the sample was drawn, and what was left out.
    #[serde(default)]
    pub sample: String,
    /// Mutants that the crate has.
    pub of: u64,
    /// Mutants that were tried.
    pub tried: u64,
    /// Those that a test noticed.
    pub caught: u64,
    /// Those that made a test run on and on.
    #[serde(default)]
    pub timeout: u64,
    /// Those that do not compile.
    #[serde(default)]
    pub unviable: u64,
    /// Those that no test noticed at first.
    pub missed_first: u64,
    /// Those that none notices now.
    pub missed: u64,
}

/// A mutant that no test notices.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Survivor {
    /// What was changed, and where.
    pub mutant: String,
    /// Why nothing has to notice it.
    #[serde(default)]
    pub why: String,
}

impl Survivor {
    /// Whether somebody has said why nothing has to notice it; a reason that begins with "open" says that nobody has.
    pub fn is_argued(&self) -> bool {
        let why = self.why.trim();
        !why.is_empty() && !why.get(..4).is_some_and(|word| word.eq_ignore_ascii_case("open"))
    }
}

/// The score of a crate.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MutationScore {
    /// How it was measured.
    pub run: MutationRun,
    /// Those that were noticed, among those that compile, with the tests that were there before.
    pub first: Coverage,
    /// The same with the tests of now.
    pub now: Coverage,
    /// Those that no test notices.
    pub survivors: Vec<Survivor>,
}

#[derive(Deserialize)]
struct Outcome {
    run: MutationRun,
    #[serde(default, rename = "survivor")]
    survivors: Vec<Survivor>,
}

pub(super) fn read(sources: &Sources, origins: &mut Vec<Origin>) -> Result<Vec<MutationScore>, EvidenceError> {
    let mut scores = Vec::with_capacity(sources.mutants.len());
    for file in &sources.mutants {
        let Outcome { run, survivors } = file.toml()?;
        run.consistent(survivors.len()).map_err(|what| file.wrong(what))?;
        origins.push(file.origin(Vec::new()));
        scores.push(MutationScore { first: run.score(run.missed_first), now: run.score(run.missed), survivors, run });
    }
    Ok(scores)
}

impl MutationRun {
    /// Whether the numbers are those of one run; if not, what is wrong with them, and the way out.
    fn consistent(&self, survivors: usize) -> Result<(), String> {
        let MutationRun { of, tried, caught, timeout, unviable, missed_first, missed, .. } = *self;
        let sum = |missed: u64| [timeout, unviable, missed].iter().try_fold(caught, |sum, one| sum.checked_add(*one));
        if missed > missed_first || ![missed, missed_first].into_iter().any(|missed| sum(missed) == Some(tried)) {
            return Err(format!(
                "caught, timeout, unviable and missed are not the {tried} that were tried: caught, timeout and unviable are those of one \
                 run, and with the missed of that run (missed_first before tests were added, else missed, which is no more) they make tried"
            ));
        }
        if tried > of {
            return Err(format!("{tried} were tried of {of}: `of` counts all mutants that the crate has"));
        }
        if self.viable() == 0 {
            return Err("no mutant compiled, and none is no result: try more, or take the file away".to_owned());
        }
        if survivors as u64 > missed {
            return Err(format!(
                "{survivors} survivors are named and {missed} were missed: take out those that a test notices now, or count them"
            ));
        }
        Ok(())
    }

    /// Mutants that compile.
    pub fn viable(&self) -> u64 {
        self.tried.saturating_sub(self.unviable)
    }

    /// The share that was noticed where so many were missed, with the interval of Wilson; a crate that was mutated as a whole
    /// is no sample, and its share is what it is.
    fn score(&self, missed: u64) -> Coverage {
        let viable = self.viable();
        let noticed = viable.saturating_sub(missed);
        if self.is_whole() && viable > 0 {
            let share = noticed as f64 / viable as f64;
            return Coverage { share, lower: share, upper: share };
        }
        Coverage::wilson(noticed, viable)
    }

    /// Whether every mutant was tried.
    pub fn is_whole(&self) -> bool {
        self.tried >= self.of
    }

    /// Whether enough were tried to say something.
    pub fn is_enough(&self) -> bool {
        self.is_whole() || self.viable() >= MUTATION_SAMPLE
    }

    /// Whether it is the crate of this folder.
    fn is_of(&self, folder: &str) -> bool {
        let short = folder.rsplit('/').next().unwrap_or(folder);
        self.name == folder || self.name == short || self.name.strip_prefix("twinrung-") == Some(short)
    }
}

/// The score of a crate of [`MUTATED`], where there is one.
pub(super) fn of<'s>(scores: &'s [MutationScore], folder: &str) -> Option<&'s MutationScore> {
    scores.iter().find(|score| score.run.is_of(folder))
}

/// The score of a crate of [`MUTATED`], in percent.
pub(super) fn percent(scores: &[MutationScore], folder: &str) -> Option<f64> {
    of(scores, folder).map(|score| score.now.share * 100.0)
}

/// Those of [`MUTATED`] that were measured; nothing where none was.
fn measured(scores: &[MutationScore]) -> Option<Vec<&MutationScore>> {
    let measured: Vec<&MutationScore> = MUTATED.iter().filter_map(|folder| of(scores, folder)).collect();
    (!measured.is_empty()).then_some(measured)
}

/// Crates of [`MUTATED`] of which too few mutants were tried.
pub(super) fn too_small(scores: &[MutationScore]) -> Option<f64> {
    let enough = measured(scores)?.iter().filter(|score| score.run.is_enough()).count();
    Some((MUTATED.len() - enough) as f64)
}

/// Survivors of [`MUTATED`] without a reason.
pub(super) fn without_a_reason(scores: &[MutationScore]) -> Option<f64> {
    Some(measured(scores)?.into_iter().map(MutationScore::without_a_reason).sum::<u64>() as f64)
}

impl MutationScore {
    /// Survivors that nobody has argued.
    fn without_a_reason(&self) -> u64 {
        let argued = self.survivors.iter().filter(|survivor| survivor.is_argued()).count() as u64;
        self.run.missed.saturating_sub(argued)
    }
}
