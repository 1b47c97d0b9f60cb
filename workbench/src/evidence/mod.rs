//! What was measured of a release, added up and held against its floors.
//!
//! Reports are files that stand in the project, because nobody can build them: they were measured. This reads them as bytes
//! that the command gives it, and says what they show and what they do not; [`page`] writes it for a reviewer. What is
//! missing or too little is said and never left out.

mod campaign;
mod defects;
mod difference;
mod floors;
mod independence;
mod injection;
mod mutants;
mod page;
mod sources;
mod times;

use serde::Serialize;

pub use campaign::{CampaignEvidence, InstructionCoverage, Share};
pub use defects::{DefectEvidence, SeededDefect};
pub use difference::{Difference, Reported};
pub use floors::{Bound, FLOORS, Floor, Judged, State, Unit};
pub use independence::{Area, Independence};
pub use injection::InjectionEvidence;
pub use mutants::{MutationRun, MutationScore, Survivor};
pub use page::page;
pub use sources::{EvidenceError, File, Sources};
pub use times::{Conditions, Measured, Method, OtherConditions, Times};

use crate::inject::Group;
use crate::provenance::Provenance;

/// The form of the JSON that [`Evidence`] is written as.
pub const SCHEMA: u32 = 1;

/// A file that figures were taken from.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Origin {
    /// Its path in the project.
    pub file: String,
    /// The SHA-256 of its bytes, as hexadecimal digits.
    pub sha256: String,
    /// The measurements in it, where they were recorded.
    pub measurements: Vec<Provenance>,
}

/// What was measured of a release.
#[derive(Debug, Clone, Serialize)]
pub struct Evidence {
    /// The form of this.
    pub schema: u32,
    /// Whether all floors are met.
    pub is_met: bool,
    /// Each floor, and what was found.
    pub floors: Vec<Judged>,
    /// The differential campaign; nothing where no report of one is there.
    pub campaign: Option<CampaignEvidence>,
    /// Differences that campaigns and tests have found, and what became of them.
    pub differences: Vec<Difference>,
    /// The seeded defects.
    pub defects: DefectEvidence,
    /// Fault injection; nothing where no report of it is there.
    pub injection: Option<InjectionEvidence>,
    /// Mutation testing, by crate.
    pub mutants: Vec<MutationScore>,
    /// What the channels share; nothing where the review is not there.
    pub independence: Option<Independence>,
    /// The files that all this was read from.
    pub origins: Vec<Origin>,
}

impl Evidence {
    /// Reads the reports, adds them up, and judges them.
    ///
    /// # Errors
    ///
    /// A report cannot be read: it is no report, or of a form that this release does not know.
    pub fn read(sources: &Sources) -> Result<Evidence, EvidenceError> {
        let mut origins = Vec::new();
        let recorded = difference::read(sources, &mut origins)?;
        let campaign = CampaignEvidence::read(sources, &mut origins)?;
        let differences = difference::accounted(recorded, campaign.as_ref());
        let defects = DefectEvidence::read(sources, &mut origins)?;
        let injection = InjectionEvidence::read(sources, &mut origins)?;
        let mutants = mutants::read(sources, &mut origins)?;
        let independence = Independence::read(sources, &mut origins)?;
        let mut evidence = Evidence {
            schema: SCHEMA,
            is_met: false,
            floors: Vec::new(),
            campaign,
            differences,
            defects,
            injection,
            mutants,
            independence,
            origins,
        };
        evidence.floors = FLOORS.iter().map(|floor| floor.judge((floor.value)(&evidence))).collect();
        evidence.is_met = evidence.floors.iter().all(|judged| judged.state == State::Met);
        Ok(evidence)
    }

    /// Differences that are not mended, or that nobody has accounted for.
    pub fn open(&self) -> usize {
        self.differences.iter().filter(|one| one.is_open()).count()
    }

    /// Wrong outputs that faults of a group let out; nothing where none was injected.
    fn let_out(&self, group: Group) -> Option<f64> {
        Some(self.injection.as_ref()?.group(group)?.let_out as f64)
    }

    /// Floors that are not met: those that nobody has measured among them.
    pub fn unmet(&self) -> impl Iterator<Item = &Judged> {
        self.floors.iter().filter(|judged| judged.state != State::Met)
    }
}
