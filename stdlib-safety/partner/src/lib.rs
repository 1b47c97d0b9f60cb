//! The safety partner's half of the instruction library: every safety application instruction as a safety Add-On
//! Instruction in ladder, one `.rll` file each under `rll/`, named `Safety_<MNEMONIC>`.
//!
//! The ladder is written from the reference alone. Parts that several instructions share (the pair evaluator, the fault
//! latch) are Add-On Instructions of their own, in files named after them, and are called nested.
//!
//! This crate holds text and data; it executes nothing. It depends on nothing at run time, and must never depend on
//! the primary half or on an interpreter.
#![no_std]
#![forbid(unsafe_code)]
#![deny(
    clippy::indexing_slicing,
    clippy::arithmetic_side_effects,
    clippy::panic,
    clippy::unwrap_used,
    clippy::expect_used
)]

mod sources;

pub use sources::SOURCES;

/// What the name of a definition has before the mnemonic: `Safety_DCS` is DCS.
pub const PREFIX: &str = "Safety_";

/// The library compiled: the image of all definitions, shared parts included. `twinrung_bytecode::admit_library` admitted
/// it when this crate was built.
pub static LIBRARY: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/library.image"));

/// The image signature of [`LIBRARY`] when it was admitted: bytes that still have it need not be verified again.
pub static SIGNATURE: &[u8; 32] = include_bytes!(concat!(env!("OUT_DIR"), "/library.signature"));

/// The mnemonic of the instruction that a definition stands for; `None` for a shared part.
pub fn mnemonic(definition: &str) -> Option<&str> {
    definition.strip_prefix(PREFIX)
}

/// The text that defines an instruction, by its mnemonic, or a shared part, by its name; upper and lower case are the
/// same.
pub fn source(name: &str) -> Option<&'static str> {
    SOURCES.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, text)| *text)
}
