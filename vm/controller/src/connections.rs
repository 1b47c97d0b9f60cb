//! Which cells come from outside at the start of a scan, and which leave at its end.

use alloc::vec::Vec;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::image::{TagKind, TagRecord};
use twinrung_bytecode::index::TagIndex;
use twinrung_bytecode::layout;

/// The cells of one tag: a run in each space.
#[derive(Debug, Clone, PartialEq, Eq)]
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

impl CellRange {
    /// The cells of a tag; `None` when the tag has none (an alias) or is not in the image.
    pub fn of(image: &AdmittedImage, tag: TagIndex) -> Option<CellRange> {
        let record: &TagRecord = image.image().tags.get(tag.position())?;
        if matches!(record.kind, TagKind::Alias(_)) {
            return None;
        }
        let (bits, words) = layout::cells(image.layouts(), record.type_reference)?;
        let elements = layout::elements(record.dimensions)?;
        Some(CellRange {
            tag,
            bit_cell: record.bit_cell,
            bit_cells: bits.checked_mul(elements)?,
            word_cell: record.word_cell,
            word_cells: words.checked_mul(elements)?,
        })
    }

    pub(crate) fn bits(&self) -> core::ops::Range<usize> {
        let begin = self.bit_cell as usize;
        begin..begin.saturating_add(self.bit_cells as usize)
    }

    pub(crate) fn words(&self) -> core::ops::Range<usize> {
        let begin = self.word_cell as usize;
        begin..begin.saturating_add(self.word_cells as usize)
    }
}

/// What enters and leaves a scan.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Connections {
    /// Module inputs, consumed tags and mapped tags.
    pub frozen: Vec<CellRange>,
    /// Module outputs and produced tags.
    pub published: Vec<CellRange>,
}

impl Connections {
    /// Reads the connections of an image.
    pub fn of(image: &AdmittedImage) -> Connections {
        let mut connections = Connections::default();
        for (index, tag) in image.image().tags.iter().enumerate() {
            let list = match tag.kind {
                TagKind::ModuleInput | TagKind::Consumed => &mut connections.frozen,
                TagKind::ModuleOutput | TagKind::Produced => &mut connections.published,
                TagKind::Base | TagKind::Alias(_) => continue,
            };
            list.extend(CellRange::of(image, TagIndex(index as u32)));
        }
        for entry in &image.image().map {
            if !connections.frozen.iter().any(|range| range.tag == entry.safety) {
                connections.frozen.extend(CellRange::of(image, entry.safety));
            }
        }
        connections
    }
}
