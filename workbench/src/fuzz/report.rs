//! What a campaign amounted to, for a machine: reports of several campaigns add up.

use std::time::Duration;

use serde::Serialize;

use super::Campaign;

/// The totals of a campaign.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Report {
    /// The release that ran it.
    pub version: &'static str,
    /// The first seed.
    pub seed: u64,
    /// How long it took.
    pub seconds: f64,
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
    /// What differed.
    pub differences: Vec<DifferenceFound>,
}

/// A difference.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DifferenceFound {
    /// The seed of the program.
    pub seed: u64,
    /// When it was found, from the start.
    pub after_seconds: f64,
    /// Programs that had been run by then.
    pub after_programs: u64,
    /// What differed.
    pub difference: String,
}

impl Report {
    /// The totals of a campaign that began with a seed and took so long.
    pub fn new(campaign: &Campaign, seed: u64, took: Duration) -> Report {
        let total = &campaign.total;
        let differences = campaign.failures.iter().map(|failure| DifferenceFound {
            seed: failure.seed,
            after_seconds: failure.found.after.as_secs_f64(),
            after_programs: failure.found.programs,
            difference: failure.report.trim_end().to_owned(),
        });
        Report {
            version: env!("CARGO_PKG_VERSION"),
            seed,
            seconds: took.as_secs_f64(),
            programs: campaign.programs,
            refused: campaign.refused,
            scans: total.scans,
            rungs: total.executions.rungs,
            instructions: total.instructions,
            differences: differences.collect(),
        }
    }
}
