//! Random valid programs over the whole instruction set, and how their inputs move: all from one seed, or from the choices of
//! a [`Genome`].

mod data;
mod expression;
mod guards;
mod literals;
mod operands;
mod palette;
mod program;
mod random;
mod rungs;
pub mod safety;
mod stimulus;
mod text;
mod writer;

use twinrung_catalog::Element;

pub use program::{program, program_of};
pub use random::{Gene, Genome, Random};
use safety::Call;
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
    /// Some 10 rungs: what guided fuzzing runs hundreds of in a second.
    pub const TINY: Size = Size { rungs: 8, programs: 1, subroutines: 1, add_ons: 1 };
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

/// A call of a safety application instruction whose operands the stimulus moves together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Actor {
    /// The call.
    pub call: Call,
    /// The tags that are its operands; none where the stimulus leaves one alone.
    pub tags: Vec<Option<Driven>>,
}

/// A tag that is an operand of such a call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Driven {
    /// Its full name.
    pub name: String,
    /// Its type.
    pub element: Element,
}

/// A generated program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Generated {
    /// The project as `.rll`; each rung and each tag stands on a line of its own.
    pub text: String,
    /// The tags that a stimulus drives.
    pub inputs: Vec<Input>,
    /// Calls whose operands move as devices do.
    pub actors: Vec<Actor>,
}

/// A program and how its inputs move, of a genome, with the genome completed by the choices that it did not give.
pub fn of_genome(genome: &Genome, size: Size, scans: usize) -> (Generated, Stimulus, Genome) {
    let mut random = Random::given(genome.program.clone(), genome.seed);
    let generated = program_of(&mut random, size);
    let program = random.taken();
    let mut random = Random::given(genome.inputs.clone(), genome.seed ^ 0x0005_7112_A1D5);
    let stimulus = stimulus_of(&mut random, &generated, scans);
    (generated, stimulus, Genome { program, inputs: random.taken(), seed: genome.seed })
}
