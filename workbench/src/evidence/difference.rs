//! Differences between the evaluators that were found while the project grew, and what became of each.

use serde::{Deserialize, Serialize};

use crate::fuzz::DifferenceFound;

use super::{CampaignEvidence, EvidenceError, Origin, Sources};

/// A difference that was found.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Difference {
    /// What differed.
    pub what: String,
    /// How it was found.
    #[serde(default)]
    pub found_by: String,
    /// Who was wrong by the reference; empty where nobody has judged it.
    #[serde(default)]
    pub wrong: String,
    /// What was mended; empty while it is open.
    #[serde(default)]
    pub mended: String,
    /// The tests that keep it so: `FILE: NAME`, the name that of a case, a vector or a function in the file.
    #[serde(default)]
    pub kept_by: Vec<String>,
    /// The report that names it, where one does: its path in the project.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub report: Option<String>,
    /// The seed of the campaign in that report, where it says one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// The program in that campaign.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<u64>,
    /// What the report says of it, in its words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
}

/// A difference that a report names.
#[derive(Debug, Clone, PartialEq)]
pub struct Reported {
    /// The report: its path in the project.
    pub file: String,
    /// What it says.
    pub found: DifferenceFound,
}

impl Reported {
    /// Whether an entry is about this: reports add up campaigns, and one program of one campaign may differ in several ways.
    fn is_that_of(&self, entry: &Difference) -> bool {
        entry.report.as_ref() == Some(&self.file)
            && entry.seed == self.found.seed
            && entry.program == Some(self.found.program)
            && entry.text.as_deref().map(str::trim) == Some(self.found.difference.trim())
    }
}

impl Difference {
    /// Whether it is not mended, or no test is named that keeps it so.
    pub fn is_open(&self) -> bool {
        self.mended.trim().is_empty() || self.kept_by.is_empty()
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct List {
    #[serde(default)]
    difference: Vec<Difference>,
}

pub(super) fn read(sources: &Sources, origins: &mut Vec<Origin>) -> Result<Vec<Difference>, EvidenceError> {
    let Some(file) = &sources.differences else { return Ok(Vec::new()) };
    let list: List = file.toml()?;
    origins.push(file.origin(Vec::new()));
    Ok(list.difference)
}

/// Those that somebody has written down, and those of the reports that nobody has. An entry accounts for one difference.
pub(super) fn accounted(mut recorded: Vec<Difference>, campaign: Option<&CampaignEvidence>) -> Vec<Difference> {
    let mut free: Vec<bool> = vec![true; recorded.len()];
    for reported in campaign.iter().flat_map(|campaign| &campaign.reported) {
        let entry = recorded.iter().zip(&free).position(|(entry, is_free)| *is_free && reported.is_that_of(entry));
        if let Some(entry) = entry {
            free[entry] = false;
            continue;
        }
        let Reported { file, found } = reported;
        free.push(false);
        recorded.push(Difference {
            what: found.difference.clone(),
            found_by: "twinrung fuzz".to_owned(),
            wrong: String::new(),
            mended: String::new(),
            kept_by: Vec::new(),
            report: Some(file.clone()),
            seed: found.seed,
            program: Some(found.program),
            text: Some(found.difference.clone()),
        });
    }
    recorded
}
