//! A controller that is kept from one command to the next, so that a project can be commissioned as Chapter 6 of the safety
//! reference manual asks: what it is, what was downloaded, mode and keyswitch, lock and passwords, signature, forces,
//! inhibited modules, faults.
//!
//! [`ControllerState`] asks [`twinrung_controller::protection`] before each change; nothing here decides what is
//! permitted. [`store::Store`] writes a state whole or not at all, and survives power loss at any moment.
//!
//! It may use the image format and the controller. It never executes logic, never reads a project's text, never reads a
//! clock (the date and time of a signature is an argument), and never writes but through a [`store::Storage`].

#![forbid(unsafe_code)]

pub mod card;
pub mod edit;
mod editing;
pub mod fault;
pub mod identity;
pub mod instruction;
pub mod lifecycle;
pub mod password;
pub mod permission;
pub mod record;
pub mod replacement;
pub mod signature;
pub mod state;
pub mod store;
mod words;

pub use card::{Card, LoadMode};
pub use edit::{OnlineEdit, Stage};
pub use fault::{Fault, FaultKind, LOG_ENTRIES_MAX, LogEntry};
pub use identity::Identity;
pub use instruction::SealedInstruction;
pub use lifecycle::{Downloaded, Refused};
pub use password::{PasswordError, Passwords};
pub use permission::{Permission, permissions};
pub use signature::SafetyTaskSignature;
pub use state::{Application, ControllerState, Force};
