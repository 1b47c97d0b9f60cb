//! One program, three evaluators: primary, partner and judge execute the same scans, and every tag, flag, count, fault
//! record and event is compared after each. No execution test can forget an engine, since there is no other way to run one.
//!
//! For tests, `fuzz/` and, behind the feature `judge`, `twinrung fuzz`. It may use everything; no release may use it.

#![forbid(unsafe_code)]

mod compare;
mod disagreement;
pub mod instructions;
mod library;
mod trio;

pub use disagreement::Disagreement;
pub use library::library;
pub use trio::{Trio, Trios};
pub use twinrung_contest::fuzz::{Ended, Subject};
