//! Channel 2: the safety partner interpreter.
//!
//! It runs an admitted image beside the primary, from memory of its own that holds every cell complemented. It is
//! written from the reference alone and shares nothing with the primary but the image's records and the interface
//! `twinrung_bytecode::channel`.
//!
//! - `load` decodes the image: every routine, and every call of an Add-On Instruction or of a safety application
//!   instruction (whose ladder comes from the partner's half of the library), becomes a body of steps with resolved cells;
//! - `panel` takes what can neither fault nor jump as regions: series/parallel networks as conduction tables over
//!   six contacts, timers, comparisons and sums as uniform records, in an order that keeps every dependency;
//! - `walk` executes what is left step by step: jumps, calls, subscripts, faults, prescan, and everything while an
//!   observer looks on.
//!
//! With the feature `injection` every bit of it can be turned round
//! (`twinrung_bytecode::injection`). Whatever they are then, an execution neither panics nor allocates, and it ends.
//!
//! It may depend on the catalog, the image's records and the partner's half of the library; never on the primary, on
//! the primary's half, or on anything that compiles. After loading it allocates nothing, and an admitted image makes it
//! neither panic nor read outside its memory.

#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(
    not(test),
    deny(
        clippy::indexing_slicing,
        clippy::arithmetic_side_effects,
        clippy::panic,
        clippy::unwrap_used,
        clippy::expect_used
    )
)]

extern crate alloc;
#[cfg(test)]
#[macro_use]
extern crate std;

mod channel;
#[cfg(feature = "injection")]
mod injection;
mod ladder;
mod load;
mod memory;
mod panel;
mod real;
mod stack;
mod state;
mod timer;
mod walk;

pub use channel::Partner;
pub use load::LoadError;
