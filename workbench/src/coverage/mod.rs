//! What scenarios have shown of a program: inputs and outputs toggled, rungs true and false, contacts that decided, fault codes
//! reached; and what is missing, with the way to it. `docs/scenarios.md` defines each.
//!
//! It sees a channel at work through the observer alone. It never executes logic: where it asks what another position of a
//! contact would have changed it follows the wires of that one rung, with everything else as it was.

mod codes;
mod decide;
mod item;
mod reads;
mod shape;
mod state;
mod tally;
mod watch;
mod way;

pub use item::{Item, Kind};
pub use tally::{Coverage, Share, Summary};
pub use watch::{Fact, Watch};

pub(crate) use watch::Begins;

#[cfg(test)]
pub(crate) use shape::Program;
pub(crate) use shape::{RungId, collect, parsed};
