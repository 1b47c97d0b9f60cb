//! The values that logic sees while a rung is evaluated, and from them what a condition would do if power reached it.

use std::cmp::Ordering;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::operand::{Access, AccessType, Base, BitNumber, OperandRecord, Reference, Shape};
use twinrung_catalog::{Element, Opcode};
use twinrung_controller::Controller;

use super::shape::Condition;

/// Where the cells of an Add-On Instruction's instance begin; nothing in a program's own routines.
pub type Frame = Option<(u32, u32)>;

/// All cells of the image, followed write by write.
#[derive(Debug, Clone, Default)]
pub struct Cells {
    /// BOOLs.
    pub bits: Vec<bool>,
    /// Numbers.
    pub words: Vec<i32>,
}

impl Cells {
    /// The cells as they are after a download.
    pub fn initial(image: &AdmittedImage) -> Cells {
        let records = image.image();
        Cells { bits: records.initial_bits.iter().map(|bit| *bit == 1).collect(), words: records.initial_words.clone() }
    }

    /// Takes over what the controller holds after a scan; how many cells were not as they were followed.
    pub fn reconcile<A: Channel, B: Channel>(&mut self, controller: &Controller<A, B>) -> u64 {
        let mut missed = 0;
        for (cell, held) in self.bits.iter_mut().enumerate() {
            let now = controller.bit(BitCell(cell as u32)).unwrap_or(*held);
            missed += u64::from(now != *held);
            *held = now;
        }
        for (cell, held) in self.words.iter_mut().enumerate() {
            let now = controller.word(WordCell(cell as u32)).unwrap_or(*held);
            missed += u64::from(now != *held);
            *held = now;
        }
        missed
    }

    /// A bit that a reference names; nothing where a tag or an argument says which.
    pub fn bit(&self, reference: &Reference, frame: Frame) -> Option<bool> {
        let (bit_base, word_base) = base(&reference.access, frame)?;
        match reference.access.shape {
            Shape::Bit => self.bits.get((bit_base + reference.access.bit_cell) as usize).copied(),
            Shape::WordBit(BitNumber::Constant { bit, .. }) => {
                let word = *self.words.get((word_base + reference.access.word_cell) as usize)?;
                Some((word >> bit.min(31)) & 1 == 1)
            }
            _ => None,
        }
    }

    /// What a condition would do if power reached it; nothing where that cannot be told from the cells alone.
    pub fn passes(&self, condition: &Condition, frame: Frame) -> Option<bool> {
        match condition {
            Condition::Contact(reference, closed) => self.bit(reference, frame).map(|bit| bit == *closed),
            Condition::OneShot(storage) => self.bit(storage, frame).map(|stored| !stored),
            Condition::Comparison(opcode, operands) => self.compares(*opcode, operands, frame),
            Condition::Other => None,
        }
    }

    fn compares(&self, opcode: Opcode, operands: &[OperandRecord], frame: Frame) -> Option<bool> {
        let values: Vec<f64> = operands.iter().map(|operand| self.number(operand, frame)).collect::<Option<_>>()?;
        // Integers are exact in f64, and so are REALs; where both kinds meet the controller rounds first.
        let reals = operands.iter().filter(|operand| is_real(operand)).count();
        if reals != 0 && reals != operands.len() {
            return None;
        }
        match (opcode, values.as_slice()) {
            (Opcode::Lim, [low, test, high]) if low <= high => Some(low <= test && test <= high),
            (Opcode::Lim, [low, test, high]) => Some(test >= low || test <= high),
            (_, [a, b]) => {
                let order = a.partial_cmp(b);
                Some(match opcode {
                    Opcode::Equ => order == Some(Ordering::Equal),
                    Opcode::Neq => order != Some(Ordering::Equal),
                    Opcode::Grt => order == Some(Ordering::Greater),
                    Opcode::Geq => matches!(order, Some(Ordering::Greater | Ordering::Equal)),
                    Opcode::Les => order == Some(Ordering::Less),
                    Opcode::Leq => matches!(order, Some(Ordering::Less | Ordering::Equal)),
                    _ => return None,
                })
            }
            _ => None,
        }
    }

    fn number(&self, operand: &OperandRecord, frame: Frame) -> Option<f64> {
        match operand {
            OperandRecord::Integer { value, .. } => Some(f64::from(*value)),
            OperandRecord::Real(bits) => Some(f64::from(f32::from_bits(*bits))),
            OperandRecord::Reference(Reference { access, .. }) if access.shape == Shape::Word => {
                let (_, word_base) = base(access, frame)?;
                let word = *self.words.get((word_base + access.word_cell) as usize)?;
                Some(if access.access_type == AccessType::Element(Element::Real) {
                    f64::from(f32::from_bits(word as u32))
                } else {
                    f64::from(word)
                })
            }
            _ => None,
        }
    }
}

fn is_real(operand: &OperandRecord) -> bool {
    match operand {
        OperandRecord::Real(_) => true,
        OperandRecord::Reference(reference) => reference.access.access_type == AccessType::Element(Element::Real),
        _ => false,
    }
}

/// What the cells of an access count from; nothing where it depends on a tag or on an argument.
pub fn base(access: &Access, frame: Frame) -> Frame {
    if !access.terms.is_empty() {
        return None;
    }
    match access.base {
        Base::Absolute => Some((0, 0)),
        Base::Instance => frame,
        Base::InOut(_) => None,
    }
}
