//! Muting of light curtains, `muting-and-outputs.md` 2 to 5.

mod common;
pub(crate) mod fsbm;
mod instruction;
mod sequence;
pub(crate) mod tsam;
pub(crate) mod tssm;
