//! What came of the scenarios of a project, as data; and as text, as a page, as JUnit XML.

mod html;
mod human;
mod junit;

pub use html::page;
pub use human::text;
pub use junit::junit;

use serde::{Serialize, Serializer};
use twinrung_controller::StopReason;

use super::Decision;
use crate::coverage::{Item, Kind, Share};
use crate::recording::Recording;

/// What came of the scenarios of one project.
#[derive(Debug, Serialize)]
pub struct ProjectReport {
    /// The project's file or folder.
    pub project: String,
    /// Short form of the safety application signature.
    pub signature: String,
    /// Whether every scenario was met.
    pub passed: bool,
    /// The scenarios in order.
    pub scenarios: Vec<ScenarioReport>,
    /// What they cover together.
    pub coverage: CoverageReport,
}

/// What came of one scenario.
#[derive(Debug, Serialize)]
pub struct ScenarioReport {
    /// Its name.
    pub name: String,
    /// Its file.
    pub file: String,
    /// The line of its name.
    pub line: u32,
    /// Whether it was met.
    pub passed: bool,
    /// Scans that were passed.
    pub scans: u64,
    /// Time of the last one in ms.
    pub end_ms: u64,
    /// Expectations.
    pub expectations: usize,
    /// What was not met.
    pub failures: Vec<FailureReport>,
    /// Why the controller stopped although nobody expected it; the time in ms.
    #[serde(skip)]
    pub stopped: Option<(u64, StopReason)>,
}

/// Something that was not met.
#[derive(Debug, Serialize)]
pub struct FailureReport {
    /// What was expected.
    pub expected: String,
    /// The line where that stands.
    pub line: u32,
    /// What was found.
    pub found: String,
    /// Time of the scan that shows it, in ms.
    pub at_ms: u64,
    /// The rung that decided it.
    pub decision: Option<Decision>,
    /// The scans around it.
    #[serde(skip)]
    pub recording: Recording,
}

/// What the scenarios of a project cover.
#[derive(Debug, Serialize)]
pub struct CoverageReport {
    /// Percent of what is to be shown, rounded down.
    pub percent: u8,
    /// The least that is accepted, in percent.
    pub minimum: Option<u8>,
    /// Whether that is reached.
    pub enough: bool,
    /// Shares by kind.
    #[serde(serialize_with = "by_kind")]
    pub kinds: Vec<(Kind, Share)>,
    /// What is missing, with the way to it.
    pub missing: Vec<Item>,
    /// What is excluded, with the reason.
    pub excluded: Vec<Excluded>,
    /// Exclusions of what was shown all the same.
    pub needless: Vec<String>,
    /// Writes that the observer did not tell, and evaluations that do not agree with their wires: defects of this tool.
    #[serde(skip)]
    pub doubts: (u64, u64),
}

/// What need not be shown.
#[derive(Debug, Serialize)]
pub struct Excluded {
    /// The item.
    pub item: String,
    /// Why.
    pub reason: String,
}

fn by_kind<S: Serializer>(kinds: &[(Kind, Share)], serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Row {
        kind: Kind,
        #[serde(flatten)]
        share: Share,
    }
    serializer.collect_seq(kinds.iter().map(|(kind, share)| Row { kind: *kind, share: *share }))
}

impl ProjectReport {
    /// Whether every scenario was met and the coverage is enough.
    pub fn is_good(&self) -> bool {
        self.passed && self.coverage.enough
    }

    /// Scenarios that were not met.
    pub fn failed(&self) -> usize {
        self.scenarios.iter().filter(|scenario| !scenario.passed).count()
    }
}
