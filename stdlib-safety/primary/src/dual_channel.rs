//! The dual-channel input family, `dual-channel-inputs.md`.

pub(crate) mod dcs;
mod pair;
mod stop;
