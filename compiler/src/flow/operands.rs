//! From operands to places.

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::Element;
use twinrung_grammar::tree::Span;

use super::builder::{Base, Builder};
use super::network::{Join, Op};
use super::places::{Range, Slot};
use crate::operand::{BitPlace, Expression, Operand, Reference, Shape, Step, Subscript, Term};
use crate::project::OperandUse;

/// The reads of a BOOL: what makes it 1, what makes it 0, and what selects it.
pub(super) struct BitRead {
    pub on: u32,
    pub off: u32,
    pub selectors: Vec<u32>,
}

impl BitRead {
    /// What makes it 1 and what makes it 0, each with what selects it.
    pub fn with_selectors(&self) -> (Vec<u32>, Vec<u32>) {
        let with = |first: u32| std::iter::once(first).chain(self.selectors.iter().copied()).collect();
        (with(self.on), with(self.off))
    }
}

/// Where an operand is written.
pub(super) struct Target {
    /// What makes it 1, what makes it 0; of a region those of all its BOOLs.
    pub bit: Option<(Slot, Slot)>,
    /// The number; of a region all its numbers.
    pub word: Option<Slot>,
    /// Reads of what selects it.
    pub selectors: Vec<u32>,
}

impl<'a> Builder<'a> {
    pub fn reference(&self, one: &OperandUse) -> Option<&'a Reference> {
        self.project.operand(one.id).reference()
    }

    /// The two places of a BOOL cell.
    pub fn bit_slots(&mut self, base: Base, terms: &[Term], writes: bool) -> (Slot, Slot) {
        if terms.is_empty() {
            return self.network.places.bit(base.tag, base.bit);
        }
        let range = Range { tag: base.tag, bit: base.bit, word: base.word, bits: 1, words: 0, terms: terms.to_vec() };
        let [on, off, _] = self.network.places.range(range, writes);
        (on, off)
    }

    /// The place of a number, to read or to write.
    pub fn word_slot(&mut self, base: Base, terms: &[Term], writes: bool) -> Slot {
        if terms.is_empty() {
            let (written, read) = self.network.places.word(base.tag, base.word);
            return if writes { written } else { read };
        }
        let range = Range { tag: base.tag, bit: base.bit, word: base.word, bits: 0, words: 1, terms: terms.to_vec() };
        self.network.places.range(range, writes)[2]
    }

    /// The places of `count` elements of a type.
    pub fn region_slots(
        &mut self,
        base: Base,
        kind: TypeReference,
        count: u32,
        terms: &[Term],
        writes: bool,
    ) -> [Slot; 3] {
        let (bits, words) = self.project.types.cells(kind);
        let range = Range {
            tag: base.tag,
            bit: base.bit,
            word: base.word,
            bits: bits.saturating_mul(count),
            words: words.saturating_mul(count),
            terms: terms.to_vec(),
        };
        self.network.places.range(range, writes)
    }

    /// Reads of everything that variable subscripts and bit numbers depend on.
    pub fn selectors(&mut self, reference: &'a Reference, span: Span) -> Vec<u32> {
        let mut list = Vec::new();
        for step in &reference.steps {
            match step {
                Step::Subscript(subscripts) => {
                    for subscript in subscripts {
                        if let Subscript::Expression(expression) = subscript {
                            self.expression(expression, span, &mut list);
                        }
                    }
                }
                Step::BitExpression(expression) => self.expression(expression, span, &mut list),
                Step::Member(_) | Step::Bit(_) => {}
            }
        }
        list
    }

    fn expression(&mut self, expression: &'a Expression, span: Span, list: &mut Vec<u32>) {
        match expression {
            Expression::Integer { .. } | Expression::Real(_) => {}
            Expression::Reference(reference) => self.values(reference, span, list),
            Expression::Unary(_, operand) => self.expression(operand, span, list),
            Expression::Binary(_, left, right) => {
                self.expression(left, span, list);
                self.expression(right, span, list);
            }
        }
    }

    /// Reads of everything that the value of a reference depends on.
    pub fn values(&mut self, reference: &'a Reference, span: Span, list: &mut Vec<u32>) {
        let selectors = self.selectors(reference, span);
        list.extend(selectors);
        let Some(base) = self.base(&reference.location) else { return };
        let terms = &reference.location.terms;
        match (reference.shape(), reference.location.bit) {
            (Shape::Bit, _) => {
                let (on, off) = self.bit_slots(base, terms, false);
                list.push(self.read_any(base, &[on, off], span));
            }
            (Shape::WordBit, Some(BitPlace::Constant(bit))) if terms.is_empty() => {
                let (on, off) = self.network.places.word_bit(base.tag, base.word, bit);
                list.push(self.read_any(base, &[on, off], span));
            }
            (Shape::Word | Shape::WordBit, _) => {
                let slot = self.word_slot(base, terms, false);
                list.push(self.read(slot, span));
            }
            (Shape::Region, _) => {
                let count = region_count(reference);
                let joints = self.region_slots(base, reference.type_reference, count, terms, false);
                list.push(self.read_any(base, &joints, span));
            }
        }
    }

    /// One read of what may be any of these: of the two values of a BOOL one may never come about.
    fn read_any(&mut self, base: Base, of: &[Slot], span: Span) -> u32 {
        let slot = self.network.places.any_of(Some(base.tag), of);
        self.read(slot, span)
    }

    /// Reads of everything that the value of an operand depends on.
    pub fn operand_values(&mut self, one: &OperandUse) -> Vec<u32> {
        let mut list = Vec::new();
        match self.project.operand(one.id) {
            Operand::Reference(reference) => self.values(reference, one.span, &mut list),
            Operand::Expression(expression) => self.expression(expression, one.span, &mut list),
            _ => {}
        }
        list
    }

    /// The reads of a BOOL; nothing for a literal or a status keyword.
    pub fn bit_read(&mut self, one: &OperandUse) -> Option<BitRead> {
        let reference = self.reference(one)?;
        let selectors = self.selectors(reference, one.span);
        let base = self.base(&reference.location)?;
        let terms = &reference.location.terms;
        let (on, off) = match (reference.shape(), reference.location.bit) {
            (Shape::Bit, _) => self.bit_slots(base, terms, false),
            (Shape::WordBit, Some(BitPlace::Constant(bit))) if terms.is_empty() => {
                self.network.places.word_bit(base.tag, base.word, bit)
            }
            _ => {
                let slot = self.word_slot(base, terms, false);
                (slot, slot)
            }
        };
        Some(BitRead { on: self.read(on, one.span), off: self.read(off, one.span), selectors })
    }

    /// Where an operand is written.
    pub fn target(&mut self, reference: &'a Reference, span: Span) -> Option<Target> {
        let selectors = self.selectors(reference, span);
        let base = self.base(&reference.location)?;
        let terms = &reference.location.terms;
        let (bit, word) = match (reference.shape(), reference.location.bit) {
            (Shape::Bit, _) => (Some(self.bit_slots(base, terms, true)), None),
            (Shape::WordBit, Some(BitPlace::Constant(bit))) if terms.is_empty() => {
                (Some(self.network.places.word_bit(base.tag, base.word, bit)), None)
            }
            // Which bit is not known: the number as a whole.
            (Shape::Word | Shape::WordBit, _) => (None, Some(self.word_slot(base, terms, true))),
            (Shape::Region, _) => {
                let count = region_count(reference);
                let [on, off, word] = self.region_slots(base, reference.type_reference, count, terms, true);
                (Some((on, off)), Some(word))
            }
        };
        Some(Target { bit, word, selectors })
    }

    /// The two places of a BOOL member of a structure, or the place of a number of it to write.
    pub fn member(&mut self, reference: &'a Reference, name: &str) -> Option<(Base, bool)> {
        let TypeReference::Structure(index) = reference.type_reference else { return None };
        let base = self.base(&reference.location)?;
        let at = self.project.types.member(index, name)?;
        let layout = self.project.types.layout(index).members.get(usize::from(at))?;
        let kind = self.project.types.record(index).members.get(usize::from(at))?.type_reference;
        let place = Base { tag: base.tag, bit: base.bit + layout.bit_cell, word: base.word + layout.word_cell };
        Some((place, kind == TypeReference::Element(Element::Bool)))
    }

    pub fn join_all(&mut self, reads: &[u32], how: Join) {
        for read in reads {
            self.op(Op::Join { read: *read, how });
        }
    }
}

/// Elements that a region reference reaches: all of a whole array, else one.
fn region_count(reference: &Reference) -> u32 {
    twinrung_bytecode::layout::elements(reference.dimensions).unwrap_or(1)
}
