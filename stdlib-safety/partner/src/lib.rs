//! The safety partner's half of the instruction library: every safety application instruction as a safety Add-On
//! Instruction in ladder, one `.rll` file each under `rll/`, named `Safety_<MNEMONIC>`.
//!
//! The ladder is written from the reference alone. Parts that several instructions share (the pair evaluator, the
//! millisecond clock) are Add-On Instructions of their own, in files named after them, and are called nested.
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

/// The Add-On Instructions in source form: the definition's name and its text, parts before the instructions that call
/// them.
pub static SOURCES: &[(&str, &str)] = &[];
