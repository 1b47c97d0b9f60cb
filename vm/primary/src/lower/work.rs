//! The pieces of work that a block consists of before it is scheduled, and which cells each reads and writes.

use alloc::vec::Vec;

use twinrung_catalog::Opcode;

use super::cone::Cone;
use super::table::Kind;
use crate::number::{Binary, Relation};

/// Signals from here on are scratch: each is written once, and gets a cell when its block is scheduled.
pub(crate) const VIRTUAL: u32 = 1 << 31;

/// A cell as the scheduler sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Resource {
    /// A bit cell or a virtual signal.
    Bit(u32),
    Word(u32),
}

/// A piece of work.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Work {
    Gate { cone: Cone, out: u32 },
    Timer { opcode: Opcode, input: u32, word: u32, bit: u32 },
    Compare { relation: Relation, left: u32, right: u32, out: u32 },
    WordBit { word: u32, bit: u8, out: u32 },
    Arithmetic { operator: Binary, input: u32, left: u32, right: u32, destination: u32, order: u32 },
    Move { input: u32, source: u32, destination: u32, order: u32 },
    General { instruction: u32, input: u32, output: u32, order: u32, reads: Vec<Resource>, writes: Vec<Resource> },
}

impl Work {
    /// What it is scheduled with.
    pub(crate) fn kind(&self) -> Kind {
        match self {
            Work::Gate { .. } => Kind::Gates,
            Work::Timer { opcode, .. } => match opcode {
                Opcode::Ton => Kind::OnDelays,
                Opcode::Tof => Kind::OffDelays,
                _ => Kind::Retentives,
            },
            Work::Compare { relation, .. } => Kind::Compares(*relation),
            Work::WordBit { .. } => Kind::WordBits,
            Work::Arithmetic { operator, .. } => Kind::Arithmetic(*operator),
            Work::Move { .. } => Kind::Moves,
            Work::General { .. } => Kind::General,
        }
    }

    /// The cells that it reads, those that it leaves unchanged at times included.
    pub(crate) fn reads(&self, mut each: impl FnMut(Resource)) {
        match self {
            Work::Gate { cone, .. } => cone.used().for_each(|signal| each(Resource::Bit(signal))),
            Work::Timer { input, word, bit, .. } => {
                each(Resource::Bit(*input));
                each(Resource::Word(*word));
                each(Resource::Word(word.saturating_add(1)));
                for offset in 0..3 {
                    each(Resource::Bit(bit.saturating_add(offset)));
                }
            }
            Work::Compare { left, right, .. } => {
                each(Resource::Word(*left));
                each(Resource::Word(*right));
            }
            Work::WordBit { word, .. } => each(Resource::Word(*word)),
            Work::Arithmetic { input, left, right, destination, .. } => {
                each(Resource::Bit(*input));
                for word in [left, right, destination] {
                    each(Resource::Word(*word));
                }
            }
            Work::Move { input, source, destination, .. } => {
                each(Resource::Bit(*input));
                each(Resource::Word(*source));
                each(Resource::Word(*destination));
            }
            Work::General { input, reads, .. } => {
                each(Resource::Bit(*input));
                reads.iter().for_each(|resource| each(*resource));
            }
        }
    }

    /// The cells that it writes.
    pub(crate) fn writes(&self, mut each: impl FnMut(Resource)) {
        match self {
            Work::Gate { out, .. } | Work::Compare { out, .. } | Work::WordBit { out, .. } => {
                each(Resource::Bit(*out));
            }
            Work::Timer { word, bit, .. } => {
                each(Resource::Word(word.saturating_add(1)));
                for offset in 0..3 {
                    each(Resource::Bit(bit.saturating_add(offset)));
                }
            }
            Work::Arithmetic { destination, .. } | Work::Move { destination, .. } => {
                each(Resource::Word(*destination));
            }
            Work::General { output, writes, .. } => {
                if *output != crate::program::NONE {
                    each(Resource::Bit(*output));
                }
                writes.iter().for_each(|resource| each(*resource));
            }
        }
    }

    /// Whether nothing but this virtual signal comes of it.
    pub(crate) fn only_result(&self) -> Option<u32> {
        match self {
            Work::Gate { out, .. } | Work::Compare { out, .. } | Work::WordBit { out, .. } if *out >= VIRTUAL => {
                Some(*out)
            }
            _ => None,
        }
    }
}
