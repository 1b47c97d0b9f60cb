//! Random executions of one safety application instruction on the two halves of the library: operands that move as devices
//! do (and some that move as no device does), and every member of every backing tag compared in every scan.

mod halves;
mod project;
mod shrink;
mod walk;

pub use walk::{Walk, Walked};
