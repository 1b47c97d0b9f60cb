//! The differential campaign: reports of `twinrung fuzz`, added up.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;
use twinrung_catalog::Opcode;

use crate::fuzz::{Coverage, DifferenceFound, Point, Report, SCHEMA, Universe, What, unreachable};

use super::difference::Reported;
use super::{EvidenceError, Origin, Sources};

/// So many of so many.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Share {
    /// Reached.
    pub reached: usize,
    /// To be reached.
    pub of: usize,
}

impl Share {
    fn count(&mut self, is_missing: bool) {
        self.of += 1;
        self.reached += usize::from(!is_missing);
    }
}

/// What was reached of an instruction.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct InstructionCoverage {
    /// The instruction.
    pub mnemonic: &'static str,
    /// Outcomes: rung false, rung true, and what it passes on.
    pub outcomes: Share,
    /// Operands by their forms.
    pub forms: Share,
    /// Operands by the classes of their values.
    pub values: Share,
}

/// All campaigns together.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CampaignEvidence {
    /// The reports, added up.
    pub total: Report,
    /// The differences that the reports name.
    #[serde(skip)]
    pub reported: Vec<Reported>,
    /// Processor time, as far as it was recorded.
    pub processor_seconds: f64,
    /// Campaigns whose processor time was recorded, of all.
    pub processor_recorded: Share,
    /// By instruction.
    pub coverage: Vec<InstructionCoverage>,
    /// Points that cannot be reached, by the reason.
    pub unreachable: BTreeMap<&'static str, usize>,
    /// Points to be reached in the release that judges; other than those of the reports where they are of another release.
    pub points_reachable_here: usize,
}

impl CampaignEvidence {
    pub(super) fn read(
        sources: &Sources,
        origins: &mut Vec<Origin>,
    ) -> Result<Option<CampaignEvidence>, EvidenceError> {
        let mut total: Option<Report> = None;
        let mut reported = Vec::new();
        let mut read: Vec<(&str, Report)> = Vec::with_capacity(sources.fuzz.len());
        for file in &sources.fuzz {
            let report: Report = serde_json::from_slice(&file.bytes)
                .map_err(|error| file.wrong(format_args!("no report of `twinrung fuzz --report`: {error}")))?;
            if !report.is_known() {
                return Err(file.wrong(format_args!(
                    "a report of form {}, and this release knows {SCHEMA}: use the release that wrote it",
                    report.schema
                )));
            }
            if let Some((other, _)) = read.iter().find(|(_, other)| is_again(&report, other)) {
                return Err(file.wrong(format_args!(
                    "holds a campaign that {other} holds as well, and it would count twice: take one of them away"
                )));
            }
            origins.push(file.origin(report.runs.iter().map(|run| run.provenance.clone()).collect()));
            reported.extend(report.differences.iter().map(|found| Reported {
                file: file.name.clone(),
                // A report of one campaign that recorded no seed of a difference has only one that it can be of.
                found: DifferenceFound { seed: found.seed.or_else(|| only(&report.seeds)), ..found.clone() },
            }));
            match &mut total {
                Some(total) => total.add(&report),
                None => total = Some(report.clone()),
            }
            read.push((&file.name, report));
        }
        Ok(total.map(|total| CampaignEvidence::of(total, reported)))
    }

    fn of(total: Report, reported: Vec<Reported>) -> CampaignEvidence {
        let recorded: Vec<f64> = total.runs.iter().filter_map(|run| run.provenance.processor_seconds).collect();
        let mut unreachable_points: BTreeMap<&'static str, usize> = BTreeMap::new();
        for reason in Universe::get().points().iter().filter_map(unreachable) {
            *unreachable_points.entry(reason).or_default() += 1;
        }
        CampaignEvidence {
            coverage: coverage(&total.points_missing),
            reported,
            processor_seconds: recorded.iter().sum(),
            processor_recorded: Share { reached: recorded.len(), of: total.seeds.len() },
            unreachable: unreachable_points,
            points_reachable_here: Coverage::reachable(),
            total,
        }
    }

    /// Points of which nobody can tell whether they were reached: all of this release where the campaigns knew another
    /// table; where they did not record which, those that only the larger of the two holds.
    pub fn unknown(&self) -> usize {
        match self.total.table.as_deref() {
            Some(table) if table == Report::table_here() => 0,
            Some(_) => self.points_reachable_here,
            None => self.total.points_reachable.abs_diff(self.points_reachable_here),
        }
    }

    /// Points that were not reached, as far as it is known.
    pub(super) fn missing(&self) -> usize {
        match self.total.table.as_deref() {
            Some(table) if table != Report::table_here() => self.unknown(),
            _ => self.total.points_missing.len() + self.unknown(),
        }
    }
}

/// Whether two reports hold one campaign.
fn is_again(one: &Report, other: &Report) -> bool {
    let is_the_same_run = one.runs.iter().any(|run| other.runs.contains(run));
    is_the_same_run || one == other
}

/// The one that there is.
fn only(seeds: &[u64]) -> Option<u64> {
    match seeds {
        [seed] => Some(*seed),
        _ => None,
    }
}

/// What was reached, by instruction.
fn coverage(missing: &[String]) -> Vec<InstructionCoverage> {
    let missing: BTreeSet<&str> = missing.iter().map(String::as_str).collect();
    let mut all: BTreeMap<Opcode, InstructionCoverage> = BTreeMap::new();
    for point in Universe::get().points().iter().filter(|point| unreachable(point).is_none()) {
        let Point { opcode, what } = *point;
        let of = all.entry(opcode).or_insert_with(|| InstructionCoverage {
            mnemonic: opcode.instruction().mnemonic,
            outcomes: Share::default(),
            forms: Share::default(),
            values: Share::default(),
        });
        let share = match what {
            What::Outcome(..) => &mut of.outcomes,
            What::Operand(..) => &mut of.forms,
            What::Value(..) => &mut of.values,
        };
        share.count(missing.contains(point.to_string().as_str()));
    }
    let mut all: Vec<InstructionCoverage> = all.into_values().collect();
    all.sort_by_key(|one| one.mnemonic);
    all
}
