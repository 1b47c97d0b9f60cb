//! Differences between the evaluators that were found while the project grew, and what became of each.

use serde::{Deserialize, Serialize};

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
    /// What was mended, and the test that keeps it so; empty while it is open.
    #[serde(default)]
    pub mended: String,
    /// The report that names it, where one does: its path in the project.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub report: Option<String>,
    /// The program in that report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<u64>,
}

impl Difference {
    /// Whether it is not mended.
    pub fn is_open(&self) -> bool {
        self.mended.trim().is_empty()
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

/// Those that somebody has written down, and those of the reports that nobody has.
pub(super) fn accounted(mut recorded: Vec<Difference>, campaign: Option<&CampaignEvidence>) -> Vec<Difference> {
    for (file, program, text) in campaign.iter().flat_map(|campaign| &campaign.reported) {
        let is_it = |one: &Difference| one.report.as_ref() == Some(file) && one.program == Some(*program);
        if !recorded.iter().any(is_it) {
            recorded.push(Difference {
                what: text.clone(),
                found_by: "twinrung fuzz".to_owned(),
                wrong: String::new(),
                mended: String::new(),
                report: Some(file.clone()),
                program: Some(*program),
            });
        }
    }
    recorded
}
