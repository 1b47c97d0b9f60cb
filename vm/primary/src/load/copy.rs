//! What COP, FLL, GSV and SSV move: the cells and bytes of each side.

use twinrung_bytecode::image::TypeReference;
use twinrung_bytecode::index::TypeIndex;
use twinrung_bytecode::layout;
use twinrung_bytecode::limits;
use twinrung_catalog::Element;

use super::Loader;
use crate::error::LoadError;
use crate::program::{Content, CopyPlan, Operand, Range, Side};

/// A plan, within the bound on what one instruction moves.
pub(super) fn plan(length: u32, source: Side, destination: Side) -> Result<CopyPlan, LoadError> {
    let bytes = u64::from(length).saturating_mul(u64::from(destination.bytes.max(source.bytes)));
    if bytes > u64::from(limits::COPY_BYTES) {
        return Err(LoadError::TooLarge("the bytes that one instruction moves"));
    }
    Ok(CopyPlan { length, source, destination })
}

impl Loader<'_> {
    pub(super) fn push_plan(&mut self, plan: CopyPlan) -> Result<u32, LoadError> {
        let index = u32::try_from(self.program.copies.len()).map_err(|_| LoadError::TooLarge("the copies"))?;
        self.program.copies.push(plan);
        Ok(index)
    }

    /// One side of a copy. The source of FLL may be a literal, which has no cells.
    pub(super) fn side(&mut self, operand: Operand) -> Result<Side, LoadError> {
        let (content, count) = match operand {
            Operand::Word { element, count, .. } => (Content::Element(element), count),
            Operand::Region { content, count, .. } => (content, count),
            Operand::Integer(_) => (Content::Element(Element::Dint), 1),
            Operand::Real(_) => (Content::Element(Element::Real), 1),
            _ => return Err(LoadError::Malformed("an operand of a copy")),
        };
        let (bit_cells, word_cells) = self.cells_of(content)?;
        let bytes = match content {
            Content::Element(element) => element.bytes(),
            Content::Structure(index) => self.layouts.get(usize::from(index)).map_or(0, |layout| layout.bytes),
        };
        if bytes > limits::COPY_BYTES {
            return Err(LoadError::TooLarge("the bytes that one instruction moves"));
        }
        let fields = self.fields(content);
        Ok(Side { bytes, bit_cells, word_cells, fields, content, count })
    }

    fn fields(&mut self, content: Content) -> Range {
        if let Some(known) = self.known_fields.get(&content) {
            return *known;
        }
        let type_reference = match content {
            Content::Element(element) => TypeReference::Element(element),
            Content::Structure(index) => TypeReference::Structure(TypeIndex(index)),
        };
        let first = self.program.fields.len();
        self.program.fields.extend(layout::fields(&self.image.types, self.layouts, type_reference));
        let range = Range::since(first, &self.program.fields);
        self.known_fields.insert(content, range);
        range
    }
}
