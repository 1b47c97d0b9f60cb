//! COP, FLL and SIZE, and the bytes of elements. general-instructions.md A.6; REQ-EXEC-006.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Element;

use super::Walker;
use super::bit::at;
use super::fault::{Fault, SUBSCRIPT};
use super::math::element_of;
use crate::ladder::{Argument, Location, Span};

/// A span with the place of its first element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    span: Span,
    bit: u32,
    word: u32,
    /// The type of the elements, where they are elementary.
    element: Element,
    /// Elements from the start to the end of the array.
    pub(super) count: u32,
}

impl Stretch {
    /// Bytes of an element.
    const fn bytes(&self) -> u32 {
        self.span.bytes
    }

    /// The word of an element of an elementary type.
    pub(super) fn element_place(&self, number: u32) -> Location {
        Location::Word(element_cells(self, number).1, self.element)
    }
}

impl<O: Observer> Walker<'_, O> {
    /// Finds where a span begins.
    pub(super) fn stretch(&mut self, argument: Argument) -> Result<Option<Stretch>, Fault> {
        let Argument::Span(index) = argument else { return Ok(None) };
        let Some(span) = self.ladder.spans.get(index as usize).copied() else { return Ok(None) };
        let found = self.find(span.start)?;
        let (bit, word) = match found.location {
            Location::Region { bit, word, .. } => (bit, word),
            Location::Word(word, _) => (0, word),
            Location::Bit(bit) => (bit, 0),
            Location::WordBit(..) => return Ok(None),
        };
        let skipped = if span.moves { found.skipped } else { 0 };
        let count = span.count.saturating_sub(skipped);
        // The place of an array is a region, which has no type: its elements' only field has it.
        let element = match self.ladder.fields.get(span.first_field as usize) {
            Some(field) if span.fields == 1 => field.element,
            _ => element_of(found.location),
        };
        Ok(Some(Stretch { span, bit, word, element, count }))
    }

    /// Whether so many bytes fit on their way.
    fn has_room(&self, bytes: u32) -> bool {
        bytes as usize <= self.state.bytes.len()
    }

    /// Collects the bytes of elements from their cells; bytes without a member are 0.
    fn gather(&mut self, stretch: &Stretch, elements: u32) {
        let ladder = self.ladder;
        let span = &stretch.span;
        let total = span.bytes.saturating_mul(elements) as usize;
        if let Some(bytes) = self.state.bytes.get_mut(..total) {
            bytes.fill(0);
        }
        let first = span.first_field as usize;
        let fields = ladder.fields.get(first..first.saturating_add(span.fields as usize)).unwrap_or(&[]);
        for number in 0..elements {
            let (bit, word) = element_cells(stretch, number);
            let base = number.saturating_mul(span.bytes);
            for field in fields {
                let position = base.saturating_add(field.byte) as usize;
                if field.element == Element::Bool {
                    let value = self.state.memory.bit(bit.wrapping_add(field.cell));
                    if let Some(byte) = self.state.bytes.get_mut(position) {
                        *byte |= u8::from(value).wrapping_shl(u32::from(field.bit));
                    }
                    continue;
                }
                let value = self.state.memory.word(word.wrapping_add(field.cell)).to_le_bytes();
                let length = field.element.bytes() as usize;
                let to = self.state.bytes.get_mut(position..position.saturating_add(length));
                if let (Some(to), Some(from)) = (to, value.get(..length)) {
                    to.copy_from_slice(from);
                }
            }
        }
    }

    /// Spreads bytes over the cells of elements; bytes without a member are dropped.
    fn scatter(&mut self, stretch: &Stretch, elements: u32) {
        let ladder = self.ladder;
        let span = &stretch.span;
        let first = span.first_field as usize;
        let fields = ladder.fields.get(first..first.saturating_add(span.fields as usize)).unwrap_or(&[]);
        for number in 0..elements {
            let (bit, word) = element_cells(stretch, number);
            let base = number.saturating_mul(span.bytes);
            for field in fields {
                let position = base.saturating_add(field.byte) as usize;
                let mut four = [0u8; 4];
                for (offset, byte) in four.iter_mut().enumerate() {
                    *byte = self.state.bytes.get(position.saturating_add(offset)).copied().unwrap_or(0);
                }
                let value = i32::from_le_bytes(four);
                let [low, ..] = four;
                match field.element {
                    Element::Bool => {
                        let value = low.wrapping_shr(u32::from(field.bit)) & 1 != 0;
                        self.write_bit_cell(bit.wrapping_add(field.cell), value);
                    }
                    element => {
                        let value = super::value::low_bits(value, element);
                        self.write_word_cell(word.wrapping_add(field.cell), value);
                    }
                }
            }
        }
    }

    pub(super) fn copies(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        let source = self.stretch(at(arguments, 0))?;
        let length = length(at(arguments, 2));
        if source.is_some_and(|source| length > source.count) {
            return Err(SUBSCRIPT);
        }
        let destination = self.stretch(at(arguments, 1))?;
        let (Some(source), Some(destination)) = (source, destination) else { return Ok(input) };
        if length > destination.count {
            return Err(SUBSCRIPT);
        }
        if self.has_room(destination.bytes().saturating_mul(length)) {
            self.gather(&source, length);
            self.scatter(&destination, length);
        }
        Ok(input)
    }

    pub(super) fn fills(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        let value = self.number(at(arguments, 0))?;
        let Some(destination) = self.stretch(at(arguments, 1))? else { return Ok(input) };
        let length = length(at(arguments, 2));
        if length > destination.count {
            return Err(SUBSCRIPT);
        }
        for number in 0..length {
            self.store_value(destination.element_place(number), value);
        }
        Ok(input)
    }

    pub(super) fn sizes(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if input {
            let elements = self.number(at(arguments, 0))?;
            let destination = self.locate(at(arguments, 1))?;
            self.store_value(destination, elements);
        }
        Ok(input)
    }
}

fn length(argument: Argument) -> u32 {
    match argument {
        Argument::Integer(length) => u32::try_from(length).unwrap_or(0),
        _ => 0,
    }
}

/// The first cells of an element.
fn element_cells(stretch: &Stretch, number: u32) -> (u32, u32) {
    let bit = stretch.bit.wrapping_add(number.wrapping_mul(stretch.span.bits));
    let word = stretch.word.wrapping_add(number.wrapping_mul(stretch.span.words));
    (bit, word)
}
