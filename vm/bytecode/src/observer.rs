//! The one seam through which coverage, cost per rung, injection and guided fuzzing see a channel at work.

use crate::channel::Place;
use crate::index::{BitCell, WordCell};

/// What a disturbed processor does instead of executing a rung.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RungUpset {
    /// Nothing: it executes the rung.
    None,
    /// It goes on with the next rung.
    Skip,
    /// It executes the rung, and then once more.
    Repeat,
    /// It goes on with another rung of the same routine, counted from 0; behind the last one the routine ends. The jump is not
    /// reported, counted or signed as a JMP: nobody meant it.
    Goto(u32),
}

/// What a disturbed processor does instead of executing an instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ElementUpset {
    /// Nothing: it executes the instruction.
    None,
    /// The instruction has no effect, and the rung condition behind it is the one before it.
    Skip,
    /// It executes the instruction twice with the same rung condition before it; the second result counts.
    Repeat,
    /// It executes the instruction and takes the opposite for the rung condition behind it: the wrong way at a branch.
    Invert,
}

/// Receives what a channel does. Every method is empty unless overridden; with [`Silent`] the calls cost nothing.
pub trait Observer {
    /// Whether the channel must report. With `false` it may skip all bookkeeping that only reporting needs.
    const ACTIVE: bool = true;

    /// A rung begins; `place.element` is 0.
    fn rung_entered(&mut self, place: Place) {
        let _ = place;
    }

    /// An instruction was evaluated, with the rung condition before and after it.
    fn element_result(&mut self, place: Place, condition_in: bool, condition_out: bool) {
        let _ = (place, condition_in, condition_out);
    }

    /// A bit cell of the image was written by logic.
    fn bit_written(&mut self, cell: BitCell, value: bool) {
        let _ = (cell, value);
    }

    /// A word cell of the image was written by logic.
    fn word_written(&mut self, cell: WordCell, value: i32) {
        let _ = (cell, value);
    }

    /// So many more instructions were executed.
    fn instructions_retired(&mut self, count: u64) {
        let _ = count;
    }

    /// Asked before each rung, after [`Observer::rung_entered`]: how it is disturbed. With [`RungUpset::Repeat`] and
    /// [`RungUpset::Goto`] the rung that is executed next is asked about again, so an observer counts.
    fn rung_upset(&mut self, place: Place) -> RungUpset {
        let _ = place;
        RungUpset::None
    }

    /// Asked before each instruction: how it is disturbed. A channel that evaluates several instructions in one step while
    /// nobody observes asks for each of them here. Where an upset means nothing for an instruction (the condition behind a
    /// coil), it is as if there were none.
    fn element_upset(&mut self, place: Place) -> ElementUpset {
        let _ = place;
        ElementUpset::None
    }

    /// What arrives in a bit cell when logic writes a value; asked wherever [`Observer::bit_written`] is told, before it.
    fn bit_arrives(&mut self, cell: BitCell, value: bool) -> bool {
        let _ = cell;
        value
    }

    /// What arrives in a word cell when logic writes a value; asked wherever [`Observer::word_written`] is told, before it.
    fn word_arrives(&mut self, cell: WordCell, value: i32) -> i32 {
        let _ = cell;
        value
    }
}

/// The observer that sees nothing.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Silent;

impl Observer for Silent {
    const ACTIVE: bool = false;
}
