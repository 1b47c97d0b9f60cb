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
    #[serde(default, deserialize_with = "lines")]
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

/// One line, or several.
fn lines<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Lines {
        One(String),
        Several(Vec<String>),
    }
    Ok(match Lines::deserialize(deserializer)? {
        Lines::One(line) => line,
        Lines::Several(lines) => lines.join("\n"),
    })
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
        let seen = run.caught + run.timeout + run.unviable;
        if ![run.missed, run.missed_first].map(|missed| seen + missed).contains(&run.tried)
            || run.missed > run.missed_first
        {
            return Err(file.wrong(format_args!(
                "caught, timeout, unviable and missed are not the {} that were tried",
                run.tried
            )));
        }
        origins.push(file.origin(Vec::new()));
        scores.push(MutationScore { first: run.score(run.missed_first), now: run.score(run.missed), survivors, run });
    }
    Ok(scores)
}

impl MutationRun {
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

pub(super) fn value(scores: &[MutationScore], figure: &str) -> Option<f64> {
    let measured = || MUTATED.iter().filter_map(|folder| of(scores, folder));
    match figure {
        "sample" | "survivors" if measured().next().is_none() => None,
        "sample" => Some((MUTATED.len() - measured().filter(|score| score.run.is_enough()).count()) as f64),
        "survivors" => Some(measured().map(MutationScore::without_a_reason).sum::<u64>() as f64),
        _ => {
            let folder = MUTATED.iter().find(|folder| folder.rsplit('/').next() == Some(figure))?;
            of(scores, folder).map(|score| score.now.share * 100.0)
        }
    }
}

impl MutationScore {
    /// Survivors that nobody has argued.
    fn without_a_reason(&self) -> u64 {
        let argued = self.survivors.iter().filter(|survivor| survivor.is_argued()).count() as u64;
        self.run.missed.saturating_sub(argued)
    }
}
