//! Calls of safety application instructions, and inputs that move as devices do: channels that follow each other, resets as
//! pulses, feedbacks, muting sequences, the steps of the vectors with their times shifted. Some move as no device does.

mod call;
mod driver;
mod episode;
mod knowledge;
mod times;

pub use call::{Call, Given, element, value_text};
pub use driver::{Driver, Inputs};
pub use knowledge::{Knowledge, knowledge};
