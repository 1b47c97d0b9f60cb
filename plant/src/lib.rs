//! What stands around a controller, simulated: POINT Guard I/O modules with their terminals, the wires at the terminals and
//! what can go wrong with them, and the safety connections that carry tags.
//!
//! It is for verifying a project against wiring faults before a machine exists: a stimulus acts on terminals, and the tags
//! follow. It may depend on the catalog and on nothing else, so that it knows neither logic nor a controller. It never decides
//! a safety output: it only shows what a module would make of one.
//!
//! Time is simulated. Modules look at their terminals once each millisecond; pulse tests are shorter than that and take
//! place within one such look. Packets of a connection are sent at multiples of its interval from power-up on, and arrive at
//! once: the model is as fast as a plant can be, and the longest times are what Appendix C of 1756-RM093 adds up (`reaction`).
//!
//! Where the manual (1734-UM013) is silent the model does what is harder on the project: a fault is found as late, and goes
//! away by itself as soon, as the text admits; only after an overcurrent of a sensor supply the longest time holds. Such choices
//! are marked decided.

#![forbid(unsafe_code)]

pub mod analog_input;
pub mod connection;
mod device;
pub mod digital_input;
pub mod digital_output;
mod error_latch;
mod followers;
pub mod member;
pub mod settings;
pub mod station;
pub mod stimulus;
pub mod wiring;

pub use connection::{Connection, Received, Sent, Times};
pub use device::Device;
pub use member::{Command, Reading};
pub use settings::{ModuleSettings, PointSettings};
pub use station::{Plant, Station};
pub use stimulus::{AuxiliaryContact, Fault, Refusal, SERIES_MAX, Series, Signal, Stimulus, Terminal};
