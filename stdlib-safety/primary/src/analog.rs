//! Dual channel analog inputs, `muting-and-outputs.md` 8.

pub(crate) mod dca;
pub(crate) mod dcaf;
mod pair;
