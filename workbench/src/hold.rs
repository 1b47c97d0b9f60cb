//! Values that stand against what comes in and what goes out: forces on I/O, produced and consumed safety tags, and the safe
//! state of a connection that is inhibited (1756-RM093 Force Data; Inhibit a Module).
//!
//! They act at the edge of the controller, where the stimulus does, so that the scan itself has no force in it: what comes
//! in is driven anew before each scan, what goes out is seen through them.

use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_controller::{Controller, Mode};

use crate::signal::{ReadSignal, Signal, Value, bit_of, number};

/// A cell, and what it is held at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Held {
    /// A BOOL.
    Bit(BitCell, bool),
    /// A number.
    Word(WordCell, i32),
    /// A bit (0 to 31) of an integer.
    WordBit(WordCell, u8, bool),
}

/// What is held, and on which side of the scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hold {
    /// Before the logic.
    Input(Held),
    /// Behind the logic.
    Output(Held),
}

/// Everything that is held; of two on one cell the later counts.
#[derive(Debug, Clone, Default)]
pub struct Holds {
    inputs: Vec<Held>,
    outputs: Vec<Held>,
}

const fn with_bit(word: i32, bit: u8, value: bool) -> i32 {
    let mask = 1_i32 << (bit & 31);
    if value { word | mask } else { word & !mask }
}

impl Holds {
    /// These.
    pub fn of(holds: &[Hold]) -> Holds {
        let mut all = Holds::default();
        holds.iter().for_each(|one| all.add(*one));
        all
    }

    /// One more.
    pub fn add(&mut self, one: Hold) {
        match one {
            Hold::Input(held) => self.inputs.push(held),
            Hold::Output(held) => self.outputs.push(held),
        }
    }

    /// Drives what comes in, over whatever else drives it.
    pub fn drive<A: Channel, B: Channel>(&self, controller: &mut Controller<A, B>) {
        for held in &self.inputs {
            match *held {
                Held::Bit(cell, value) => controller.drive_bit(cell, value),
                Held::Word(cell, value) => controller.drive_word(cell, value),
                Held::WordBit(cell, bit, value) => {
                    let word = controller.driven_word(cell).unwrap_or_default();
                    controller.drive_word(cell, with_bit(word, bit, value));
                }
            }
        }
    }

    /// A value as it is seen from outside. Where the logic does not execute outputs are off, held or not.
    pub fn read<A: Channel, B: Channel>(&self, signal: Signal, controller: &Controller<A, B>) -> Value {
        let is_off = controller.mode() == Mode::Program || controller.stopped().is_some();
        if self.outputs.is_empty() || is_off {
            return signal.read(controller);
        }
        let word = |cell: WordCell| {
            let published = controller.published_word(cell).unwrap_or_default();
            self.outputs.iter().fold(published, |word, held| match *held {
                Held::Word(other, value) if other == cell => value,
                Held::WordBit(other, bit, value) if other == cell => with_bit(word, bit, value),
                _ => word,
            })
        };
        match signal {
            Signal::PublishedBit(cell) => {
                let published = controller.published_bit(cell).unwrap_or_default();
                Value::Bool(self.outputs.iter().fold(published, |bit, held| match *held {
                    Held::Bit(other, value) if other == cell => value,
                    _ => bit,
                }))
            }
            Signal::PublishedWord(cell, element) => number(word(cell), element),
            Signal::PublishedWordBit(cell, bit) => bit_of(word(cell), bit),
            other => other.read(controller),
        }
    }
}
