//! The version-14 set, `v14-and-metal-form.md` 2 and 3.

mod circuit;
pub(crate) mod din;
pub(crate) mod enpend;
pub(crate) mod estop;
pub(crate) mod fpms;
pub(crate) mod lc;
pub(crate) mod rin;
pub(crate) mod thrs;
