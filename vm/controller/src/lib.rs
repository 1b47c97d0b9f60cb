//! The controller around the two channels: it freezes inputs, lets both channels execute, compares every named cell
//! after every scan, and publishes outputs that it holds apart from both.
//!
//! It depends on the image crate and on the two channels, whose insides it never sees: all that it knows of a channel is
//! [`twinrung_bytecode::channel::Channel`]. It never executes logic, and it never repairs a difference: a difference,
//! a budget that ran out or a corrupted image is a nonrecoverable safety fault, and outputs are off in that same scan.
//!
//! What it needs itself it holds in two halves, one for each channel and in different form; outputs leave it only where both
//! halves say the same. `docs/independence.md` says what each mechanism covers.

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

mod clock;
mod compare;
#[cfg(test)]
mod comparisons;
mod controller;
mod fault;
mod half;
#[cfg(test)]
mod holding;
mod image_check;
#[cfg(feature = "injection")]
mod injection;
mod mode;
mod online_edit;
pub mod protection;
mod reciprocal;
mod runtime_faults;
mod self_test;
mod time;
mod verdict;

pub use twinrung_bytecode::CellRange;

pub use clock::{Moment, NoClock, Part, ScanClock, Simulated};
pub use compare::{Difference, compare};
pub use controller::{Controller, LoadError, ScanReport};
pub use fault::{SafetyFault, StopReason};
pub use image_check::IMAGE_CHECK_BYTES_PER_SCAN;
#[cfg(feature = "injection")]
pub use injection::{Shared, SharedMemory, Side};
pub use mode::{Mode, ModeRequest};
pub use online_edit::{Unfit, fits};
pub use runtime_faults::{RUNTIME_FAULTS, Raised, RuntimeFault};
pub use time::{Reference, TimeFault};
pub use twinrung_partner::Partner;
pub use twinrung_primary::Primary;

/// The controller with the two interpreters of this project.
pub type DualController = Controller<Primary, Partner>;
