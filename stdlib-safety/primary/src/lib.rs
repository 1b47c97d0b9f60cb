//! The primary channel's half of the safety instruction library: every safety application instruction as a state
//! machine.
//!
//! Written from the reference alone, by a hand that has not read the partner's half; where the halves differ the
//! reference decides. Each instruction's file reads like the pseudo-code of the section that it cites, each constant
//! carries its origin mark.
//!
//! This crate depends on the catalog only. It allocates nothing, keeps no time of its own (the scan's millisecond is an
//! argument), cannot panic, touches no arithmetic status flag and raises no fault of a controller.

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

mod analog;
mod codes;
mod dual_channel;
mod edge;
#[doc(hidden)]
pub mod injection;
mod members;
mod metal_form;
mod muting;
mod outputs;
mod restart;
mod selector;
mod state;
mod timer;
mod version_14;

pub use state::State;
