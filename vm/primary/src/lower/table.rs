//! The tables that a scan runs through: records of equal shape, side by side.

use alloc::vec::Vec;

use crate::number::{Binary, Relation};
use crate::program::Range;

/// What the records of a run are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Gates,
    Compares(Relation),
    WordBits,
    OnDelays,
    OffDelays,
    Retentives,
    General,
    Moves,
    Arithmetic(Binary),
}

/// Number of kinds: seven, and each of six relations and eight operators by itself.
pub(crate) const KINDS: usize = 21;

impl Kind {
    /// Order in which ready work is taken: first what other work waits for.
    pub(crate) fn rank(self) -> usize {
        match self {
            Kind::Gates => 0,
            Kind::WordBits => 1,
            Kind::Compares(relation) => 2usize.saturating_add(relation as usize),
            Kind::OnDelays => 8,
            Kind::OffDelays => 9,
            Kind::Retentives => 10,
            Kind::General => 11,
            Kind::Moves => 12,
            Kind::Arithmetic(operator) => 13usize.saturating_add(operator as usize),
        }
    }
}

/// Records of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct WorkRun {
    pub(crate) kind: Kind,
    pub(crate) range: Range,
}

/// A gate: four cells, a truth table, and the cell that it writes. Evaluated without a choice.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Gate<T> {
    pub(crate) inputs: [T; 4],
    pub(crate) out: T,
    pub(crate) table: u16,
}

/// A timer: rung condition, PRE (ACC follows), EN (TT and DN follow).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TimerRecord {
    pub(crate) input: u32,
    pub(crate) word: u32,
    pub(crate) bit: u32,
}

/// A relation of two words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct CompareRecord {
    pub(crate) left: u32,
    pub(crate) right: u32,
    pub(crate) out: u32,
}

/// A bit of a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct WordBitRecord {
    pub(crate) word: u32,
    pub(crate) bit: u32,
    pub(crate) out: u32,
}

/// An operation on two words (a move has the same word twice), stored while the rung is true. `order`: its place among
/// the instructions of its block that affect the status, from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ArithmeticRecord {
    pub(crate) input: u32,
    pub(crate) left: u32,
    pub(crate) right: u32,
    pub(crate) destination: u32,
    pub(crate) order: u32,
}

/// Any other instruction that cannot fault. `order` is 0 where it does not affect the status.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct GeneralRecord {
    pub(crate) instruction: u32,
    pub(crate) input: u32,
    pub(crate) output: u32,
    pub(crate) order: u32,
}

/// All records, run by run.
#[derive(Debug, Clone, Default)]
pub(crate) struct Tables {
    pub(crate) runs: Vec<WorkRun>,
    /// Used while the bit bank has 65,536 cells.
    pub(crate) narrow: Vec<Gate<u16>>,
    /// Used beyond that.
    pub(crate) wide: Vec<Gate<u32>>,
    pub(crate) timers: Vec<TimerRecord>,
    pub(crate) compares: Vec<CompareRecord>,
    pub(crate) word_bits: Vec<WordBitRecord>,
    pub(crate) arithmetic: Vec<ArithmeticRecord>,
    pub(crate) general: Vec<GeneralRecord>,
}

impl Tables {
    /// Maps every bit cell of every record.
    pub(crate) fn map_bits(&mut self, map: impl Fn(u32) -> u32) {
        for gate in &mut self.wide {
            for input in &mut gate.inputs {
                *input = map(*input);
            }
            gate.out = map(gate.out);
        }
        for record in &mut self.timers {
            record.input = map(record.input);
        }
        for record in &mut self.compares {
            record.out = map(record.out);
        }
        for record in &mut self.word_bits {
            record.out = map(record.out);
        }
        for record in &mut self.arithmetic {
            record.input = map(record.input);
        }
        for record in &mut self.general {
            record.input = map(record.input);
            record.output = map(record.output);
        }
    }

    /// Halves the gates' records where every cell fits into 16 bits.
    pub(crate) fn narrow(&mut self) {
        self.narrow = self
            .wide
            .iter()
            .map(|gate| Gate { inputs: gate.inputs.map(|cell| cell as u16), out: gate.out as u16, table: gate.table })
            .collect();
        self.wide = Vec::new();
    }
}
