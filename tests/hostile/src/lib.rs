//! Hostile input: the three targets that the fuzzers and the seeded test share, seeds for them, and a mutator that is a
//! function of its seed.
//!
//! Each target takes any bytes and returns; a panic, a hang or memory beyond the bound is a defect. It may use
//! everything that reads, compiles, admits and runs; nothing but tests and fuzzers may use it.

#![forbid(unsafe_code)]

mod mutator;
mod seeds;
mod targets;

pub use mutator::Mutator;
pub use seeds::seeds;
pub use targets::Target;
