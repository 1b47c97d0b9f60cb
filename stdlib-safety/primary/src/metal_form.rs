//! The metal-form set, `v14-and-metal-form.md` 5 to 11.

pub(crate) mod avc;
pub(crate) mod cbcm;
pub(crate) mod cbim;
pub(crate) mod cbssm;
mod clutch_brake;
pub(crate) mod cpm;
pub(crate) mod csm;
pub(crate) mod epms;
mod latch;
pub(crate) mod mmvc;
pub(crate) mod mvc;
mod valve;
mod zone;
