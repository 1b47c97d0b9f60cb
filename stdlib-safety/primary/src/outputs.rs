//! Redundant outputs with feedback, `muting-and-outputs.md` 6 and 7.

pub(crate) mod crout;
pub(crate) mod feedback;
pub(crate) mod rout;
