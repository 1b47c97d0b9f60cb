//! The controller with channels whose behaviour a test chooses.

mod fake;
#[cfg(feature = "injection")]
mod halves;
mod scan;
mod time;
