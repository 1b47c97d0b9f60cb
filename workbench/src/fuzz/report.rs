//! What a campaign amounted to, for a machine: reports of several campaigns add up.

use std::sync::OnceLock;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use twinrung_bytecode::signature::long_form;

use crate::provenance::Provenance;

use super::{Campaign, Coverage, Plan, Universe, unreachable};

/// The form of reports that this release writes. Form 1 had no number and no [`Report::runs`], form 2 neither
/// [`Report::table`] nor [`DifferenceFound::seed`].
pub const SCHEMA: u32 = 3;

/// The form of reports that say none.
const fn first_schema() -> u32 {
    1
}

/// The totals of one campaign, or of several.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The form of this report: [`SCHEMA`].
    #[serde(default = "first_schema")]
    pub schema: u32,
    /// The release that ran it, or the first of several.
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
    /// The table of the points that can be reached: the SHA-256 of their names, as hexadecimal digits; nothing where a
    /// release wrote the report that did not record it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<String>,
    /// Instruction by operand by form, value and outcome: how many can be reached.
    pub points_reachable: usize,
    /// Those of them that were not reached.
    pub points_missing: Vec<String>,
    /// What differed.
    pub differences: Vec<DifferenceFound>,
    /// Each campaign by itself; fewer than seeds where a release ran it that did not record that.
    #[serde(default)]
    pub runs: Vec<Run>,
}

/// One campaign of those that a report adds up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Its first seed.
    pub seed: u64,
    /// Whether programs were made of those that reached something new.
    pub guided: bool,
    /// Whether a third evaluator took part.
    pub judged: bool,
    /// Programs generated.
    pub programs: u64,
    /// Differences found.
    pub differences: usize,
    /// Which build, which machine, when, how long.
    #[serde(flatten)]
    pub provenance: Provenance,
}

/// A difference.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DifferenceFound {
    /// The first seed of its campaign; nothing where a release found it that did not record it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
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
    /// The totals of a campaign, and whether a third evaluator took part in it.
    pub fn new(campaign: &Campaign, plan: &Plan, judged: bool, provenance: Provenance) -> Report {
        let total = &campaign.total;
        let coverage = &total.executions.coverage;
        let differences = campaign.failures.iter().map(|failure| {
            let found = failure.found.unwrap_or_default();
            DifferenceFound {
                seed: Some(plan.seed),
                program: failure.number,
                after_seconds: found.after.as_secs_f64(),
                after_programs: found.programs,
                difference: failure.report.trim_end().to_owned(),
            }
        });
        Report {
            schema: SCHEMA,
            version: provenance.version.clone(),
            seeds: vec![plan.seed],
            guided: plan.guided,
            seconds: provenance.seconds,
            thread_seconds: provenance.seconds * plan.jobs as f64,
            programs: campaign.programs,
            refused: campaign.refused,
            scans: total.scans,
            rungs: total.executions.rungs,
            instructions: total.instructions,
            instruction_pairs: coverage.pairs(),
            table: Some(Report::table_here().to_owned()),
            points_reachable: Coverage::reachable(),
            points_missing: coverage.missing().iter().map(ToString::to_string).collect(),
            differences: differences.collect(),
            runs: vec![Run {
                seed: plan.seed,
                guided: plan.guided,
                judged,
                programs: campaign.programs,
                differences: campaign.failures.len(),
                provenance,
            }],
        }
    }

    /// The table of the points that can be reached in this release.
    pub fn table_here() -> &'static str {
        static TABLE: OnceLock<String> = OnceLock::new();
        TABLE.get_or_init(|| {
            let mut hash = Sha256::new();
            for point in Universe::get().points().iter().filter(|point| unreachable(point).is_none()) {
                hash.update(format!("{point}\n"));
            }
            long_form(&hash.finalize())
        })
    }

    /// Whether both knew the same points; where one did not record its table, whether they knew as many.
    fn has_table_of(&self, other: &Report) -> bool {
        self.points_reachable == other.points_reachable
            && (self.table.is_none() || other.table.is_none() || self.table == other.table)
    }

    /// Whether it is known to have this release's table.
    fn is_of_this_table(&self) -> bool {
        self.table.as_deref() == Some(Report::table_here())
    }

    /// Adds another campaign. What is missing is missing in both; where they had different tables of what there is to reach,
    /// what is missing is that of this release's table, else that of the larger one, since the other may not have known it.
    pub fn add(&mut self, other: &Report) {
        self.schema = self.schema.max(other.schema);
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
        let is_better = |one: &Report| (one.is_of_this_table(), one.points_reachable);
        if self.has_table_of(other) {
            self.points_missing.retain(|point| other.points_missing.contains(point));
            // What one of them alone has recorded is not known of both.
            self.table = self.table.take().filter(|table| other.table.as_ref() == Some(table));
        } else if is_better(other) > is_better(self) {
            self.table.clone_from(&other.table);
            self.points_reachable = other.points_reachable;
            self.points_missing.clone_from(&other.points_missing);
        }
        self.differences.extend_from_slice(&other.differences);
        self.runs.extend_from_slice(&other.runs);
    }

    /// Whether this release knows the form of a report that was read.
    pub fn is_known(&self) -> bool {
        self.schema <= SCHEMA
    }
}
