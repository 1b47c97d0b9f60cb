//! The safety application instructions: one file each, the shared words in `choices`, the shared codes in `codes`.
//!
//! Operand 0 is the backing tag. Everything after it is named as the member that mirrors it.

pub mod choices;
pub mod codes;
pub mod crout;
pub mod dcs;
