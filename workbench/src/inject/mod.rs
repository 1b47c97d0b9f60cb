//! Fault injection: a running project is disturbed in one place at a time, and what becomes of it is compared with the same
//! run undisturbed. A fault is masked, detected, or it lets a wrong output out.
//!
//! [`Class`] says what can be disturbed, [`Fault`] one disturbance with its place and scan, [`Subject`] the project with its
//! inputs and its undisturbed run, [`Campaign`] which faults are injected, [`Report`] what became of them.
//!
//! Nothing here knows the inside of a channel: bits are reached through [`twinrung_bytecode::injection::Injectable`] and
//! through the controller's own, an execution is upset through the observer, and what a channel says through a wrapper
//! around it.

mod campaign;
mod channel;
mod clock;
mod fault;
mod interval;
mod once;
mod page;
mod recorded;
mod report;
mod stimulus;
mod subject;
mod upset;

pub use campaign::{Campaign, Plan};
pub use channel::Disturbed;
pub use fault::{Class, Fault, Group};
pub use interval::Coverage;
pub use once::{Mechanism, Outcome, is_injecting};
pub use page::{classes_table, groups_table, mechanisms_table, page};
pub use recorded::{Recorded, SCHEMA};
pub use report::{ClassReport, MechanismReport, Report, Summary, mechanisms, summaries, together};
pub use stimulus::random;
pub use subject::{Subject, SubjectError};
