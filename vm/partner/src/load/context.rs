//! What the relative cells of an Add-On Instruction's routines count from, for one call.

use alloc::vec::Vec;

use twinrung_bytecode::index::ProgramIndex;
use twinrung_catalog::Element;

/// Where an InOut parameter's argument lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Base {
    /// Its first cells.
    Cells {
        /// Bit cell.
        bit: u32,
        /// Word cell.
        word: u32,
    },
    /// It is a bit of a word.
    WordBit {
        /// Word cell.
        word: u32,
        /// Bit number.
        bit: u8,
        /// The word's type.
        element: Element,
    },
}

/// Where the instance of a call lies.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Instance {
    /// There is none: the routine belongs to a program.
    None,
    /// In one piece.
    At {
        /// First bit cell.
        bit: u32,
        /// First word cell.
        word: u32,
    },
    /// Cell by cell: parameters of a safety application instruction are members of its backing tag.
    Scattered {
        /// For each bit cell of the instance type its cell.
        bits: Vec<u32>,
        /// For each word cell of the instance type its cell.
        words: Vec<u32>,
    },
}

/// One call, or one program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Context {
    /// Whether the code is the library's.
    pub(crate) library: bool,
    /// The program whose scan runs it.
    pub(crate) program: ProgramIndex,
    /// Its instance.
    pub(crate) instance: Instance,
    /// Its InOut arguments, by parameter.
    pub(crate) in_outs: Vec<Option<Base>>,
}
