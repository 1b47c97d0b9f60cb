//! An image that the verifier has admitted.

use alloc::vec::Vec;

use crate::image::Image;
use crate::index::{RoutineIndex, TagIndex, WordCell};
use crate::layout::TypeLayout;
use crate::signature::Signatures;

/// The cells of one tag: a run in each space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CellRange {
    /// The tag.
    pub tag: TagIndex,
    /// First bit cell.
    pub bit_cell: u32,
    /// Number of bit cells.
    pub bit_cells: u32,
    /// First word cell.
    pub word_cell: u32,
    /// Number of word cells.
    pub word_cells: u32,
}

/// An image whose every byte has been verified: its records agree with each other, every cell, operand, jump and call
/// is in bounds, and its code decompiles to the text it carries. Only the verifier makes one.
#[derive(Debug, Clone)]
pub struct AdmittedImage {
    pub(crate) image: Image,
    pub(crate) layouts: Vec<TypeLayout>,
    pub(crate) signatures: Signatures,
    pub(crate) rungs: Vec<u32>,
    pub(crate) published: Vec<CellRange>,
    pub(crate) frozen: Vec<CellRange>,
    pub(crate) writes: CellSet,
    pub(crate) written_by_others: Vec<bool>,
}

impl AdmittedImage {
    /// The records.
    pub fn image(&self) -> &Image {
        &self.image
    }

    /// The layouts of the types, in their order.
    pub fn layouts(&self) -> &[TypeLayout] {
        &self.layouts
    }

    /// Both signatures.
    pub fn signatures(&self) -> &Signatures {
        &self.signatures
    }

    /// The application signature: over texts and declarations, the same for every release of the compiler.
    pub fn application_signature(&self) -> &[u8; 32] {
        &self.signatures.application
    }

    /// The image signature: over the application signature and all bytes of the image.
    pub fn image_signature(&self) -> &[u8; 32] {
        &self.signatures.image
    }

    /// Rungs of each routine, in the order of the routines.
    pub fn rung_counts(&self) -> &[u32] {
        &self.rungs
    }

    /// Rungs of a routine; 0 where there is no such routine.
    pub fn rungs(&self, routine: RoutineIndex) -> u32 {
        self.rungs.get(routine.position()).copied().unwrap_or(0)
    }

    /// Module outputs and produced tags, in table order: what leaves a scan.
    pub fn published(&self) -> &[CellRange] {
        &self.published
    }

    /// Module inputs, consumed tags and mapped tags, in table order: what enters a scan.
    pub fn frozen(&self) -> &[CellRange] {
        &self.frozen
    }

    /// The cells that logic can write.
    pub fn program_writes(&self) -> &CellSet {
        &self.writes
    }

    /// Whether a word keeps its initial value: no input is copied to it, and logic does not write it. FAL, FSC and RES of a
    /// CONTROL are not counted as writing its LEN, which they leave as it is (general-instructions.md A.6).
    pub fn is_constant_word(&self, cell: WordCell) -> bool {
        let copied =
            |range: &CellRange| cell.0.checked_sub(range.word_cell).is_some_and(|offset| offset < range.word_cells);
        self.written_by_others.get(cell.position()) == Some(&false) && !self.frozen.iter().any(copied)
    }
}

/// A set of cells.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CellSet {
    pub(crate) bits: Vec<bool>,
    pub(crate) words: Vec<bool>,
}

impl CellSet {
    /// Whether a bit cell is in the set.
    pub fn has_bit(&self, cell: crate::index::BitCell) -> bool {
        self.bits.get(cell.position()).copied().unwrap_or(false)
    }

    /// Whether a word cell is in the set.
    pub fn has_word(&self, cell: WordCell) -> bool {
        self.words.get(cell.position()).copied().unwrap_or(false)
    }
}
