//! Scenarios: how a project is tested, from the file that an engineer wrote to what was not met.
//!
//! [`plan()`] looks names, values and times up; [`play()`] runs one scenario on both channels and judges it after each scan;
//! [`report`] says what came of it, for a person, a browser or a program.

mod blocks;
mod judge;
mod plan;
mod play;
pub mod report;
mod suite;
mod value;
mod why;
mod words;

pub use plan::{Exclusion, Plan, plan};
pub use play::{Failure, Played, play};
pub use suite::Suite;
pub use why::{Decision, Picture, picture};

use std::sync::Arc;

use twinrung_grammar::tree::Span;
use twinrung_grammar::tree::scenario::Mode;

use crate::signal::Signal;
use crate::site::Site;
use twinrung_plant::Stimulus;
use value::Check;

/// A scenario with names and values looked up and times counted from power-up.
#[derive(Debug, Clone)]
pub struct Scenario {
    /// Its name.
    pub name: String,
    /// Where its name stands.
    pub span: Span,
    /// Where the mode switch stands at power-up.
    pub power_up: Mode,
    /// What is done, in order of time.
    pub actions: Vec<Action>,
    /// What is expected.
    pub expectations: Vec<Expectation>,
    /// The modules that are simulated, whose tags follow their terminals; none where the scenario is not played at terminals.
    pub sites: Arc<[Site]>,
    /// Time of the last scan in ms.
    pub end_ms: u64,
}

/// Something that is done.
#[derive(Debug, Clone, PartialEq)]
pub struct Action {
    /// When, in ms: the first scan that begins then or later sees it.
    pub at_ms: u64,
    /// What.
    pub change: Change,
}

/// What is done.
#[derive(Debug, Clone, PartialEq)]
pub enum Change {
    /// An input gets a value.
    Drive {
        /// Its name as written.
        name: String,
        /// Where it is.
        signal: Signal,
        /// The content of its cell; of a bit of an integer 0 or 1.
        content: i32,
    },
    /// The mode switch is turned.
    Mode(Mode),
    /// Something happens at a terminal or to a module, by its position among the simulated ones.
    Plant {
        /// Which module.
        module: usize,
        /// What.
        stimulus: Stimulus,
    },
}

/// Something that is expected.
#[derive(Debug, Clone)]
pub struct Expectation {
    /// As written, on one line.
    pub text: String,
    /// Where.
    pub span: Span,
    /// Scans that begin from this time on are looked at, in ms.
    pub from_ms: u64,
    /// Scans that begin up to and including this time are looked at, in ms.
    pub until_ms: u64,
    /// What.
    pub kind: Expected,
}

/// What is expected of the scans of a span of time.
#[derive(Debug, Clone)]
pub enum Expected {
    /// One of them shows it, and none that begins sooner than the time given in ms.
    Reached(Check, u64),
    /// Each of them shows it.
    Stays(Check),
    /// None of them shows all of these together.
    Never(Vec<Check>),
    /// The controller has stopped in one of them with this fault: type and code.
    Fault(u16, u16),
}

impl Expected {
    /// What is looked at.
    pub fn checks(&self) -> &[Check] {
        match self {
            Expected::Reached(check, _) | Expected::Stays(check) => std::slice::from_ref(check),
            Expected::Never(checks) => checks,
            Expected::Fault(..) => &[],
        }
    }
}
