//! Both channels at the same time: the partner on a thread of its own.
//!
//! The controller knows nothing of threads. It says which scan it will ask for ([`Channel::begin`]), lets the primary
//! execute, and asks the partner ([`Channel::scan`]): a partner that is [`OnThread`] has executed meanwhile. Nothing is shared
//! while both execute: the partner itself, with its copy of the time and the system values, goes to its thread and comes back.

mod handover;
mod on_thread;

use std::fmt;
use std::str::FromStr;

#[cfg(doc)]
use twinrung_bytecode::channel::Channel;

pub use on_thread::{LoadError, OnThread};

/// On how many threads the channels execute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Threads {
    /// One after the other.
    #[default]
    One,
    /// At the same time.
    Two,
}

impl Threads {
    /// As a number.
    pub const fn count(self) -> u8 {
        match self {
            Threads::One => 1,
            Threads::Two => 2,
        }
    }
}

impl FromStr for Threads {
    type Err = String;

    fn from_str(text: &str) -> Result<Threads, String> {
        match text {
            "1" => Ok(Threads::One),
            "2" => Ok(Threads::Two),
            _ => Err("1 or 2 threads".to_owned()),
        }
    }
}

impl fmt::Display for Threads {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.count())
    }
}
