//! The dual-channel input family, `dual-channel-inputs.md`.

pub(crate) mod dcm;
pub(crate) mod dcs;
pub(crate) mod dcsrt;
pub(crate) mod dcst;
pub(crate) mod dcstl;
pub(crate) mod dcstm;
mod monitor;
mod pair;
pub(crate) mod smat;
mod stop;
pub(crate) mod thrse;
