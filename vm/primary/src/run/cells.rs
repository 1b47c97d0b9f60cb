//! Reads and writes data through operands.

use twinrung_bytecode::format;
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Element;

use super::{FaultCode, Run, SUBSCRIPT};
use crate::machine::Slot;
use crate::number::{Number, converted, stored_real};
use crate::program::{BitNumber, Location, NONE, Operand};

/// Cells of a location, every subscript evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Cells {
    pub(crate) bit: u32,
    pub(crate) word: u32,
    /// Elements of the innermost array that variable subscripts skipped.
    pub(crate) skipped: u32,
}

impl<O: Observer> Run<'_, O> {
    /// Writes a bit cell of the image.
    pub(super) fn write_bit(&mut self, cell: u32, value: bool) {
        if O::ACTIVE && cell < self.program.bit_cells {
            let arrived = self.observer.bit_arrives(BitCell(cell), value);
            self.machine.put_bit(cell, arrived);
            self.observer.bit_written(BitCell(cell), arrived);
        } else {
            self.machine.put_bit(cell, value);
        }
    }

    /// Writes a word cell of the image.
    pub(super) fn write_word(&mut self, cell: u32, value: u32) {
        if O::ACTIVE && cell < self.program.word_cells {
            let arrived = self.observer.word_arrives(WordCell(cell), value as i32);
            self.machine.put_word(cell, arrived as u32);
            self.observer.word_written(WordCell(cell), arrived);
        } else {
            self.machine.put_word(cell, value);
        }
    }

    /// The cells of a location.
    pub(super) fn cells(&mut self, location: Location) -> Result<Cells, FaultCode> {
        if location.formula == NONE {
            return Ok(Cells { bit: location.bit, word: location.word, skipped: 0 });
        }
        self.evaluate(location.formula)?;
        let (bit, word, skipped) = self.machine.addresses.first().copied().unwrap_or((0, 0, 0));
        Ok(Cells { bit, word, skipped })
    }

    /// Evaluates the subscripts and the bit number of an operand.
    pub(super) fn slot(&mut self, operand: Operand) -> Result<Slot, FaultCode> {
        Ok(match operand {
            Operand::Integer(value) => Slot::Constant(Number::Integer(value)),
            Operand::Real(value) => Slot::Constant(Number::Real(value)),
            Operand::Status(keyword) => Slot::Constant(Number::Integer(i32::from(self.keyword(keyword)))),
            Operand::Bit(location) => Slot::Bit(self.cells(location)?.bit),
            Operand::Word { location, element, .. } => Slot::Word { word: self.cells(location)?.word, element },
            Operand::WordBit { location, number, element } => {
                let word = self.cells(location)?.word;
                let bit = match number {
                    BitNumber::Constant(bit) => bit,
                    BitNumber::Variable { formula, length } => {
                        let value = self.value(formula)?;
                        if self.has_overflowed(0) {
                            return Err(SUBSCRIPT);
                        }
                        u8::try_from(value).ok().filter(|bit| *bit < length).ok_or(SUBSCRIPT)?
                    }
                };
                Slot::WordBit { word, bit, element }
            }
            Operand::Region { location, bit_cells, word_cells, .. } => {
                let cells = self.cells(location)?;
                Slot::Region { bit: cells.bit, bit_cells, word: cells.word, word_cells }
            }
            _ => Slot::Constant(Number::Integer(0)),
        })
    }

    /// The value of an integer formula.
    pub(super) fn value(&mut self, formula: u32) -> Result<i32, FaultCode> {
        self.evaluate(formula)?;
        Ok(self.machine.values.first().copied().unwrap_or(0))
    }

    fn keyword(&self, keyword: u8) -> bool {
        let status = &self.machine.status;
        match keyword {
            format::STATUS_FIRST_SCAN => status.first_scan,
            format::STATUS_OVERFLOW => status.overflow,
            format::STATUS_ZERO => status.zero,
            format::STATUS_NEGATIVE => status.negative,
            format::STATUS_CARRY => status.carry,
            format::STATUS_MINOR => status.minor_fault,
            _ => false,
        }
    }

    /// The bit of a slot.
    pub(super) fn bit_of(&self, slot: Slot) -> bool {
        match slot {
            Slot::Bit(cell) => self.machine.bit(cell),
            Slot::WordBit { word, bit, .. } => self.machine.word(word).wrapping_shr(u32::from(bit)) & 1 != 0,
            Slot::Constant(Number::Integer(value)) => value != 0,
            _ => false,
        }
    }

    /// Writes the bit of a slot. The sign bit of a SINT or INT is extended, as cells hold them.
    pub(super) fn put_slot_bit(&mut self, slot: Slot, value: bool) {
        match slot {
            Slot::Bit(cell) => self.write_bit(cell, value),
            Slot::WordBit { word, bit, element } => {
                let mask = 1i32.wrapping_shl(u32::from(bit));
                let old = self.machine.word(word);
                let new = if value { old | mask } else { old & !mask };
                let kept = match element {
                    Element::Sint => i32::from(new as i8),
                    Element::Int => i32::from(new as i16),
                    Element::Bool | Element::Dint | Element::Real => new,
                };
                self.write_word(word, kept as u32);
            }
            _ => {}
        }
    }

    /// The number in a slot.
    pub(super) fn number_of(&self, slot: Slot) -> Number {
        match slot {
            Slot::Constant(number) => number,
            Slot::Word { word, element: Element::Real } => Number::Real(f32::from_bits(self.machine.word(word) as u32)),
            Slot::Word { word, .. } => Number::Integer(self.machine.word(word)),
            Slot::Bit(_) | Slot::WordBit { .. } => Number::Integer(i32::from(self.bit_of(slot))),
            Slot::Region { .. } => Number::Integer(0),
        }
    }

    /// Evaluates and reads a number.
    pub(super) fn number(&mut self, operand: Operand) -> Result<Number, FaultCode> {
        let slot = self.slot(operand)?;
        Ok(self.number_of(slot))
    }

    /// Evaluates and reads an integer with its type, for zero-filling.
    pub(super) fn integer(&mut self, operand: Operand) -> Result<(i32, Element), FaultCode> {
        let slot = self.slot(operand)?;
        let element = match slot {
            Slot::Word { element, .. } => element,
            _ => Element::Dint,
        };
        Ok(match self.number_of(slot) {
            Number::Integer(value) => (value, element),
            Number::Real(value) => (crate::number::rounded(value).0, Element::Dint),
        })
    }

    /// Evaluates and reads a bit.
    pub(super) fn bit_operand(&mut self, operand: Operand) -> Result<bool, FaultCode> {
        let slot = self.slot(operand)?;
        Ok(self.bit_of(slot))
    }

    /// Stores a converted number; whether it did not fit, and the stored bits.
    pub(super) fn store(&mut self, slot: Slot, value: Number) -> (u32, bool) {
        match slot {
            Slot::Word { word, element } => {
                let (bits, lost) = converted(value, element);
                self.write_word(word, bits);
                (bits, lost)
            }
            Slot::Bit(_) | Slot::WordBit { .. } => {
                let set = match value {
                    Number::Integer(value) => value != 0,
                    Number::Real(value) => value != 0.0,
                };
                self.put_slot_bit(slot, set);
                (u32::from(set), false)
            }
            Slot::Constant(_) | Slot::Region { .. } => (0, false),
        }
    }

    /// An overflow: S:V is set, and a minor fault 4/4 logged when it was clear.
    pub(super) fn overflow(&mut self) {
        if !self.machine.status.overflow {
            self.machine.status.overflow = true;
            self.minor_fault();
        }
    }

    /// Logs a minor fault.
    pub(super) fn minor_fault(&mut self) {
        let status = &mut self.machine.status;
        status.minor_fault = true;
        status.minor_faults = status.minor_faults.saturating_add(1);
    }

    /// Clears the arithmetic status: the begin of an instruction that affects it.
    pub(super) fn clear_status(&mut self) {
        let status = &mut self.machine.status;
        status.overflow = false;
        status.zero = false;
        status.negative = false;
        status.carry = false;
    }

    /// Stores a result and sets the arithmetic status from it.
    pub(super) fn conclude(&mut self, slot: Slot, value: Number, overflow: bool, carry: bool) {
        let (bits, lost) = self.store(slot, value);
        if overflow || lost {
            self.overflow();
        }
        let (zero, negative) = match slot {
            Slot::Word { element: Element::Real, .. } => {
                let stored = f32::from_bits(bits);
                (stored == 0.0, stored < 0.0)
            }
            _ => (bits == 0, (bits as i32) < 0),
        };
        let status = &mut self.machine.status;
        status.zero = zero;
        status.negative = negative;
        status.carry = carry;
    }

    /// A REAL cell's bits in the form that is stored.
    pub(super) fn canonical(bits: u32) -> u32 {
        stored_real(f32::from_bits(bits))
    }
}
