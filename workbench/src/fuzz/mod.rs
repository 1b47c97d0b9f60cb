//! Differential fuzzing of the two channels: the contest of [`twinrung_contest::fuzz`] between them, and what a campaign
//! amounted to.

mod pair;
mod report;

pub use pair::{Pair, Pairs};
pub use report::{DifferenceFound, Report, Run, SCHEMA};
pub use twinrung_contest::fuzz::*;
