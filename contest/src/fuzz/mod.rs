//! Differential fuzzing: random valid programs run on evaluators that compare themselves after every scan, and what they
//! differ in is shrunk to the smallest program and inputs that still show it.
//!
//! Which evaluators is a [`Contest`], which the user brings: the workbench the two channels, a test a third opinion as well.

mod campaign;
mod case;
mod cases;
mod contest;
mod coverage;
mod executions;
mod guided;
mod listing;
mod plan;
mod replay;
mod shrink;
mod subject;
mod system_values;

pub use campaign::Campaign;
pub use case::{Case, CaseError};
pub use cases::{Failure, Found, Ran, ran, size_of};
pub use contest::{Contest, Ended, Evaluators};
pub use coverage::{Bits, Coverage, Point, Universe, What, reason as unreachable};
pub use executions::Executions;
pub use plan::{Plan, Told};
pub use replay::{Counts, Outcome, is_replaying, replay};
pub use shrink::shrink;
pub use subject::Subject;
pub use system_values::{SystemSample, system_samples};
