//! Random programs, and evaluators that run them against each other: what is generated, how its inputs move, what is
//! reached, and what they differ in; and the names of the values that an evaluator holds.
//!
//! It may use the compiler, the catalog, the vectors and the interface of a channel. It never names a channel: whoever holds
//! a contest brings the evaluators.

#![forbid(unsafe_code)]

pub mod cells;
pub mod fuzz;
pub mod generate;
pub mod names;
pub mod signal;

pub use signal::{Signal, SignalError, Value};
