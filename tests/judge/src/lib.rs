//! The judge: a third evaluator, slow and plain, that walks the checked tree.
//!
//! It judges the compiler and both interpreters: it knows nothing of the image, its code or its cells, and shares no
//! code with either channel. Safety application instructions it executes from the ladder half of the library, as a
//! tree. It is used by tests alone; plainness comes before speed everywhere.

#![forbid(unsafe_code)]

mod arithmetic;
mod copy;
mod counters;
mod evaluator;
mod expressions;
mod file_instructions;
mod instructions;
mod memory;
mod program_control;
mod safety;
mod timers;
mod value;

pub use evaluator::{End, Fault, Flags, Judge};
pub use value::Value;
