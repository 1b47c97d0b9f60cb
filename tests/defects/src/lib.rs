//! Plausible mistakes of a programmer, put into one channel at a time, and how long the fuzzer takes to find each: what
//! `twinrung fuzz` can find is worth only as much as what it was seen to find.
//!
//! `primary.toml` and `partner.toml` beside this crate hold the mistakes; the authors of the two channels write them. Each is
//! a text that stands exactly once in a file of that channel, and what is to stand there instead:
//!
//! ```toml
//! [[defect]]
//! name = "timer-done-one-scan-late"
//! file = "vm/primary/src/timer.rs"
//! find = "accumulated >= preset"
//! replace = "accumulated > preset"
//! why = "the preset itself is taken as not yet reached"
//! ```
//!
//! The binary `seeded_defects` puts them into a copy of the tree, builds it, and runs the fuzzer until it finds a difference.
//! It depends on the form in which times are kept (`twinrung_workbench::evidence`), on the weaving of mutants (`twinrung_mutants`)
//! and on nothing else of this project, changes nothing outside its copy but the times, and judges no defect.

#![forbid(unsafe_code)]

mod list;
mod measure;
mod tree;
mod woven;

pub use list::{Channel, Defect, ListError, Misfit, read};
pub use measure::{Bench, MeasureError};
pub use tree::{Applied, ScratchTree};
pub use woven::mutant;
