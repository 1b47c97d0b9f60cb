//! Random valid programs over the base instruction set, and how their inputs move: all from one seed.

mod data;
mod expression;
mod literals;
mod operands;
mod program;
mod random;
mod rungs;
mod stimulus;
mod text;
mod writer;

use twinrung_catalog::Element;

pub use program::{program, program_of};
pub use random::Random;
pub use stimulus::{Step, Stimulus, any_value, stimulus, stimulus_of};

/// The position of the data type that has the 12 bytes of a TIMER.
pub(crate) const TWELVE: usize = 0;

/// How large a program is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    /// Rungs of each main routine.
    pub rungs: usize,
    /// Programs of the safety task, at most.
    pub programs: usize,
    /// Subroutines of each program, at most.
    pub subroutines: usize,
    /// Add-On Instructions, at most.
    pub add_ons: usize,
}

impl Size {
    /// Some 30 rungs: what a test runs many of.
    pub const SMALL: Size = Size { rungs: 16, programs: 2, subroutines: 2, add_ons: 2 };
    /// Some 150 rungs: what a long run uses.
    pub const LARGE: Size = Size { rungs: 80, programs: 2, subroutines: 3, add_ons: 3 };

    /// So many rungs in each main routine, at least one.
    pub fn of_rungs(rungs: usize) -> Size {
        Size { rungs: rungs.max(1), ..Size::LARGE }
    }
}

/// A tag that the stimulus drives.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Input {
    /// Its full name.
    pub name: String,
    /// Its type.
    pub element: Element,
    /// For a subscript: the values below this are in range.
    pub bound: Option<u32>,
}

/// A generated program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Generated {
    /// The project as `.rll`; each rung and each tag stands on a line of its own.
    pub text: String,
    /// The tags that a stimulus drives.
    pub inputs: Vec<Input>,
}
