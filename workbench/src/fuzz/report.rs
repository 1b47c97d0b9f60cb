//! What a campaign amounted to, for a machine: reports of several campaigns add up.

use std::time::Duration;

use serde::{Deserialize, Serialize};

use super::coverage::Coverage;
use super::{Campaign, Plan};

/// The totals of one campaign, or of several.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The release that ran it.
    pub version: String,
    /// The first seed of each campaign.
    pub seeds: Vec<u64>,
    /// Whether programs were made of those that reached something new.
    pub guided: bool,
    /// How long it took, each campaign by itself.
    pub seconds: f64,
    /// The same on one thread: time by threads.
    pub thread_seconds: f64,
    /// Programs generated.
    pub programs: u64,
    /// Programs that the compiler refused.
    pub refused: u64,
    /// Scans and prescans.
    pub scans: u64,
    /// Rungs that each evaluator executed.
    pub rungs: u64,
    /// Instructions that each evaluator executed.
    pub instructions: u64,
    /// Pairs of instructions one after the other on a rung; of several campaigns the most that one has reached.
    pub instruction_pairs: usize,
    /// Instruction by operand by form, value and outcome: how many can be reached.
    pub points_reachable: usize,
    /// Those of them that were not reached.
    pub points_missing: Vec<String>,
    /// What differed.
    pub differences: Vec<DifferenceFound>,
}

/// A difference.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DifferenceFound {
    /// Which program of its campaign, counted from the seed.
    pub program: u64,
    /// When it was found, from the start.
    pub after_seconds: f64,
    /// Programs that had been run by then.
    pub after_programs: u64,
    /// What differed.
    pub difference: String,
}

impl Report {
    /// The totals of a campaign that took so long.
    pub fn new(campaign: &Campaign, plan: &Plan, took: Duration) -> Report {
        let total = &campaign.total;
        let coverage = &total.executions.coverage;
        let differences = campaign.failures.iter().map(|failure| {
            let found = failure.found.unwrap_or_default();
            DifferenceFound {
                program: failure.number,
                after_seconds: found.after.as_secs_f64(),
                after_programs: found.programs,
                difference: failure.report.trim_end().to_owned(),
            }
        });
        Report {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            seeds: vec![plan.seed],
            guided: plan.guided,
            seconds: took.as_secs_f64(),
            thread_seconds: took.as_secs_f64() * plan.jobs as f64,
            programs: campaign.programs,
            refused: campaign.refused,
            scans: total.scans,
            rungs: total.executions.rungs,
            instructions: total.instructions,
            instruction_pairs: coverage.pairs(),
            points_reachable: Coverage::reachable(),
            points_missing: coverage.missing().iter().map(ToString::to_string).collect(),
            differences: differences.collect(),
        }
    }

    /// Adds another campaign of the same release.
    pub fn add(&mut self, other: &Report) {
        self.seeds.extend(&other.seeds);
        self.guided |= other.guided;
        self.seconds += other.seconds;
        self.thread_seconds += other.thread_seconds;
        self.programs += other.programs;
        self.refused += other.refused;
        self.scans += other.scans;
        self.rungs += other.rungs;
        self.instructions += other.instructions;
        self.instruction_pairs = self.instruction_pairs.max(other.instruction_pairs);
        self.points_missing.retain(|point| other.points_missing.contains(point));
        self.differences.extend_from_slice(&other.differences);
    }
}
