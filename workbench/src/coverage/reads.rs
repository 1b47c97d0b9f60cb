//! The cells that logic looks at: what of the inputs can matter.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::code::{Mark, Marks};
use twinrung_bytecode::image::TypeReference;
use twinrung_bytecode::index::OperandIndex;
use twinrung_bytecode::layout;
use twinrung_bytecode::operand::{
    Access, AccessType, Base, BitNumber, OperandRecord, Operation, Reference, Root, Shape, Step, Subscript,
};

/// Which cells occur in the operands of the code, those that are written among them.
pub struct Reads {
    bits: Vec<bool>,
    words: Vec<bool>,
}

impl Reads {
    /// Goes over all operands that the code names, and over those that they name.
    pub fn new(image: &AdmittedImage) -> Reads {
        let records = image.image();
        let mut reads =
            Reads { bits: vec![false; records.initial_bits.len()], words: vec![false; records.initial_words.len()] };
        let mut visited = vec![false; records.operands.len()];
        let mut open: Vec<OperandIndex> = Vec::new();
        for routine in &records.routines {
            for mark in Marks::new(&routine.code).map_while(Result::ok) {
                if let Mark::Instruction(_, operands) | Mark::AddOn(operands) = mark {
                    open.extend(operands.iter());
                }
            }
        }
        while let Some(index) = open.pop() {
            let new = visited.get_mut(index.position()).is_some_and(|visited| !std::mem::replace(visited, true));
            let decoded =
                records.operands.entry(index).filter(|_| new).and_then(|bytes| OperandRecord::decode(bytes).ok());
            match decoded {
                Some(OperandRecord::Expression(operations)) => {
                    open.extend(operations.iter().filter_map(|operation| match operation {
                        Operation::Push(operand) => Some(*operand),
                        Operation::Apply(_) => None,
                    }));
                }
                Some(OperandRecord::Reference(reference)) => {
                    named_by(&reference, &mut open);
                    reads.reference(image, &reference);
                }
                _ => {}
            }
        }
        reads
    }

    /// Whether a bit cell occurs.
    pub fn has_bit(&self, cell: u32) -> bool {
        self.bits.get(cell as usize).copied().unwrap_or(false)
    }

    /// Whether a word cell occurs.
    pub fn has_word(&self, cell: u32) -> bool {
        self.words.get(cell as usize).copied().unwrap_or(false)
    }

    fn reference(&mut self, image: &AdmittedImage, reference: &Reference) {
        let access = &reference.access;
        if access.base != Base::Absolute {
            return;
        }
        let whole = !access.terms.is_empty() || (access.count > 1 && access.shape != Shape::Bit);
        if let (true, Root::Tag(tag)) = (whole, reference.root) {
            // Which element it is a tag decides, or a run of them is meant: all of them can matter.
            if let Some(record) = image.image().tags.get(tag.position())
                && let Some((bits, words)) = layout::cells(image.layouts(), record.type_reference)
            {
                let count = layout::elements(record.dimensions).unwrap_or(1);
                self.run(record.bit_cell, bits * count, record.word_cell, words * count);
            }
        }
        match (access.shape, cells_of(image, access)) {
            (Shape::Bit, _) => self.run(access.bit_cell, 1, 0, 0),
            (Shape::Word | Shape::WordBit(_), _) => self.run(0, 0, access.word_cell, 1),
            (Shape::Region, Some((bits, words))) => self.run(access.bit_cell, bits, access.word_cell, words),
            (Shape::Region, None) => {}
        }
    }

    fn run(&mut self, bit: u32, bits: u32, word: u32, words: u32) {
        let mark = |cells: &mut Vec<bool>, begin: u32, count: u32| {
            let range = begin as usize..(begin as usize).saturating_add(count as usize);
            cells.get_mut(range).unwrap_or_default().fill(true);
        };
        mark(&mut self.bits, bit, bits);
        mark(&mut self.words, word, words);
    }
}

fn cells_of(image: &AdmittedImage, access: &Access) -> Option<(u32, u32)> {
    let type_reference = match access.access_type {
        AccessType::Element(element) => TypeReference::Element(element),
        AccessType::Structure(index) => TypeReference::Structure(index),
    };
    let (bits, words) = layout::cells(image.layouts(), type_reference)?;
    let count = access.count.max(1);
    Some((bits.saturating_mul(count), words.saturating_mul(count)))
}

/// The operands that choose an element or a bit.
fn named_by(reference: &Reference, open: &mut Vec<OperandIndex>) {
    for step in &reference.steps {
        match step {
            Step::Subscript(subscripts) => open.extend(subscripts.iter().filter_map(|subscript| match subscript {
                Subscript::Operand(operand) => Some(*operand),
                Subscript::Constant(_) => None,
            })),
            Step::BitOperand(operand) => open.push(*operand),
            Step::Member(_) | Step::Bit(_) => {}
        }
    }
    open.extend(reference.access.terms.iter().map(|term| term.operand));
    if let Shape::WordBit(BitNumber::Operand { operand, .. }) = reference.access.shape {
        open.push(operand);
    }
}
