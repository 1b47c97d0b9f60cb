//! COP, FLL and SIZE, and the bytes of elements. general-instructions.md A.6; REQ-EXEC-006.

use twinrung_bytecode::limits;
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Element;

use super::Walker;
use super::bit::at;
use super::fault::{Fault, SUBSCRIPT};
use super::value::low_bits;
use crate::ladder::{Argument, Field, Ladder, Location, Span};

/// A span with the place of its first element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    span: Span,
    bit: u32,
    word: u32,
    /// Elements from the start to the end of the array.
    count: u32,
}

impl Stretch {
    /// Bytes of so many elements.
    const fn bytes(&self, elements: u32) -> u32 {
        self.span.bytes.saturating_mul(elements)
    }

    /// Whether so many bytes lie before the end of the array.
    pub(super) const fn holds(&self, bytes: u32) -> bool {
        bytes <= self.bytes(self.count)
    }

    /// The first cells of an element.
    const fn cells(&self, number: u32) -> (u32, u32) {
        let bit = self.bit.wrapping_add(number.wrapping_mul(self.span.bits));
        let word = self.word.wrapping_add(number.wrapping_mul(self.span.words));
        (bit, word)
    }

    /// The elements that the first bytes touch: where each begins, and the fields that begin within those bytes.
    fn touched<'l>(&self, ladder: &'l Ladder, bytes: u32) -> impl Iterator<Item = (u32, Cells, &'l [Field])> + use<'l> {
        let stretch = *self;
        let first = stretch.span.first_field as usize;
        let fields = ladder.fields.get(first..first.saturating_add(stretch.span.fields as usize)).unwrap_or(&[]);
        // No more are on their way, whatever a damaged operand says.
        let bytes = bytes.min(limits::COPY_BYTES);
        (0..bytes.div_ceil(stretch.span.bytes.max(1))).map(move |number| {
            let base = stretch.bytes(number);
            let begun = fields.partition_point(|field| base.saturating_add(field.byte) < bytes);
            (base, stretch.cells(number), fields.get(..begun).unwrap_or(&[]))
        })
    }
}

/// First bit cell and first word cell.
type Cells = (u32, u32);

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
        Ok(Some(Stretch { span, bit, word, count: span.count.saturating_sub(skipped) }))
    }

    /// Collects the first bytes of a stretch from its cells, and the rest of a field that begins in them; bytes without
    /// a member are 0.
    pub(super) fn gather(&mut self, stretch: &Stretch, bytes: u32) {
        let ladder = self.ladder;
        if let Some(bytes) = self.state.bytes.get_mut(..bytes as usize) {
            bytes.fill(0);
        }
        for (base, (bit, word), fields) in stretch.touched(ladder, bytes) {
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

    /// Spreads the first bytes of a stretch over its cells; bytes without a member are dropped.
    pub(super) fn scatter(&mut self, stretch: &Stretch, bytes: u32) {
        for (base, (bit, word), fields) in stretch.touched(self.ladder, bytes) {
            for field in fields {
                let value = self.held_word(base.saturating_add(field.byte));
                match field.element {
                    Element::Bool => {
                        let value = value.wrapping_shr(u32::from(field.bit)) & 1 != 0;
                        self.write_bit_cell(bit.wrapping_add(field.cell), value);
                    }
                    element => self.write_word_cell(word.wrapping_add(field.cell), low_bits(value, element)),
                }
            }
        }
    }

    /// Four of the bytes on their way, low byte first.
    pub(super) fn held_word(&self, position: u32) -> i32 {
        let held = self.state.bytes.get(position as usize..).unwrap_or(&[]);
        let mut four = [0u8; 4];
        for (byte, from) in four.iter_mut().zip(held) {
            *byte = *from;
        }
        i32::from_le_bytes(four)
    }

    /// Puts the low bytes of a word among those on their way.
    pub(super) fn hold_word(&mut self, position: u32, bytes: u32, word: i32) {
        let held = self.state.bytes.get_mut(position as usize..).unwrap_or_default();
        for (byte, from) in held.iter_mut().zip(word.to_le_bytes()).take(bytes as usize) {
            *byte = from;
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
        // Admission: both have elements of one size, and no more bytes than fit on their way.
        self.gather(&source, source.bytes(length));
        self.scatter(&destination, destination.bytes(length));
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
        let Some(element) = destination.span.element else { return Ok(input) };
        // Admission: no more elements than bytes of a COP.
        for number in 0..length.min(limits::COPY_BYTES) {
            let (_, word) = destination.cells(number);
            self.store_value(Location::Word(word, element), value);
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
