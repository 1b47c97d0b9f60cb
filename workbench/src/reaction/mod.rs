//! The reaction time and the probability of failure of every chain from a safety input to a safety output. 1756-RM093
//! Appendix C, Figures 20 and 21, and Appendix E.

mod chain;
pub(crate) mod connection;
mod dependence;
mod failure;

pub use chain::{Chain, Component, ReactionError, Settings, chains};
pub use connection::Connection;
pub use failure::{Element, Loop};

/// µs as ms with three decimals: `40.064`.
pub fn milliseconds(us: u64) -> String {
    format!("{}.{:03}", us / 1000, us % 1000)
}
