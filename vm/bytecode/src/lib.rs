//! The image: what a compiled safety application is, as bytes and as records, and who may be trusted with it.
//!
//! - [`image`] holds the records of an image, [`mod@format`] its code and operand bytes, [`operand`] the typed operands;
//! - [`layout`] says which cells a type takes and which bytes it has in the Logix memory layout;
//! - [`limits`] holds every bound, with its reason;
//! - [`container`] is the file, [`signature`] what is signed and how, [`text`] the canonical text of every record;
//! - [`verify`] trusts nobody: it alone makes an [`AdmittedImage`], and [`error`] has one variant for each of its rules;
//! - [`mod@bound`] says how much one scan can execute at most, from the code alone;
//! - [`channel`] and [`observer`] are what the two interpreters have in common: an interface, and nothing that computes;
//! - [`injection`] is what fault injection asks of them, behind a feature of theirs.
//!
//! This crate reads the catalog and nothing else of this project. It executes nothing.

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

pub mod admitted;
pub mod bound;
pub mod channel;
pub mod code;
pub mod container;
pub mod error;
pub mod format;
pub mod image;
pub mod index;
pub mod injection;
pub mod layout;
pub mod limits;
pub mod names;
pub mod observer;
pub mod operand;
pub mod signature;
pub mod text;
pub mod verify;

pub use admitted::{AdmittedImage, CellRange, CellSet};
pub use container::{ReadImage, encode, read};
pub use error::ImageError;
pub use signature::seal;
pub use verify::{admit, admit_library, admit_read};
