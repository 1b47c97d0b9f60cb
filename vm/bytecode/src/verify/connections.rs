//! What enters a scan and what leaves it.

use alloc::vec::Vec;

use crate::admitted::CellRange;
use crate::image::{Image, TagKind, TagRecord};
use crate::index::TagIndex;
use crate::layout::{self, TypeLayout};

/// Published and frozen cells, in table order.
pub(super) fn connections(image: &Image, layouts: &[TypeLayout]) -> (Vec<CellRange>, Vec<CellRange>) {
    let mut mapped = alloc::vec![false; image.tags.len()];
    for line in &image.map {
        if let Some(mapped) = mapped.get_mut(line.safety.position()) {
            *mapped = true;
        }
    }
    let (mut published, mut frozen) = (Vec::new(), Vec::new());
    for ((index, tag), mapped) in image.tags.iter().enumerate().zip(mapped) {
        let list = match tag.kind {
            TagKind::ModuleOutput | TagKind::Produced => &mut published,
            TagKind::ModuleInput | TagKind::Consumed => &mut frozen,
            TagKind::Base if mapped => &mut frozen,
            TagKind::Base | TagKind::Alias(_) => continue,
        };
        list.extend(range(layouts, TagIndex(index as u32), tag));
    }
    (published, frozen)
}

fn range(layouts: &[TypeLayout], index: TagIndex, tag: &TagRecord) -> Option<CellRange> {
    let (bits, words) = layout::cells(layouts, tag.type_reference)?;
    let elements = layout::elements(tag.dimensions)?;
    Some(CellRange {
        tag: index,
        bit_cell: tag.bit_cell,
        bit_cells: bits.checked_mul(elements)?,
        word_cell: tag.word_cell,
        word_cells: words.checked_mul(elements)?,
    })
}
