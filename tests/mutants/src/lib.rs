//! Mutants of a crate, all of them in one build.
//!
//! A changed copy of its function for each mutant is woven into the sources; these are built once, and what was built is run with
//! one mutant switched on at a time. What is built while none is switched on (the ladder half of the safety library is, by the
//! compiler) is not changed by a mutant.
//!
//! [`Loom`] changes the sources of the folder that it is given and puts them back when it is dropped. This crate may depend on
//! nothing of this project, judges no mutant, and no release may use it.

#![forbid(unsafe_code)]

mod build;
mod list;
mod loom;
mod weave;

pub use build::{BuildError, Built, Tests, build};
pub use list::{Function, Mutant, Place, Span};
pub use loom::{Loom, LoomError};
pub use weave::{SWITCH, Unwoven};
