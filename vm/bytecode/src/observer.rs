//! The one seam through which coverage, cost per rung, injection and guided fuzzing see a channel at work.

use crate::channel::Place;
use crate::index::{BitCell, WordCell};

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
}

/// The observer that sees nothing.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Silent;

impl Observer for Silent {
    const ACTIVE: bool = false;
}
