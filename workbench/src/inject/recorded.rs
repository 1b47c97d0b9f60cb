//! A report on disk: what became of the faults, and all that is needed to make it again.

use serde::{Deserialize, Serialize};

use crate::provenance::Provenance;

use super::report::Report;

/// The form of reports that this release writes, and the only one that it reads. Form 1 had no number, and neither the project
/// nor the build in it.
pub const SCHEMA: u32 = 2;

/// A report with its project and its build.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Recorded {
    /// The form of this: [`SCHEMA`].
    pub schema: u32,
    /// The project, as it was given.
    pub project: String,
    /// The signature of its safety application, in the short form.
    pub signature: String,
    /// What drove its inputs.
    pub stimulus: String,
    /// Faults that were asked for.
    pub injections: u64,
    /// The command that injects one fault again, without the fault.
    pub replay: String,
    /// Which build, which machine, when, how long.
    pub provenance: Provenance,
    /// What became of the faults.
    #[serde(flatten)]
    pub report: Report,
}
