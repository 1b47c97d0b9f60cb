//! The controller with channels whose behaviour a test chooses.

mod cells;
mod fake;
#[cfg(feature = "injection")]
mod halves;
mod load;
mod scan;
mod time;
