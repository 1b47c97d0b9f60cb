//! One program, three evaluators: primary, partner and judge execute the same scans, and every tag, flag, count, fault
//! record and event is compared after each. No execution test can forget an engine, since there is no other way to run one.
//!
//! For tests, fuzzing and, behind a feature, the command. It may use everything; nothing but tests may use it.

#![forbid(unsafe_code)]

mod campaign;
pub mod cells;
mod compare;
mod disagreement;
mod executions;
pub mod generate;
pub mod instructions;
mod replay;
mod subject;
mod trio;

pub use campaign::Campaign;
pub use disagreement::Disagreement;
pub use executions::Executions;
pub use replay::{Counts, Outcome, replay, shrink};
pub use subject::{Subject, library};
pub use trio::{Ended, Trio};
