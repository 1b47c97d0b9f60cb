//! Arithmetic, bitwise logic and moves, with their flags. general-instructions.md 2.3, A.5, A.7, A.9.

use twinrung_bytecode::format;
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::{Element, Opcode};

use super::Walker;
use super::arithmetic::{self, Outcome};
use super::bit::at;
use super::fault::Fault;
use super::value::{Value, low_bits};
use crate::ladder::{Argument, Location};
use crate::state::{ALL_FLAGS, CARRY, NEGATIVE, ZERO};

/// The type of a word's place.
pub(super) fn element_of(location: Location) -> Element {
    match location {
        Location::Word(_, element) => element,
        _ => Element::Dint,
    }
}

impl<O: Observer> Walker<'_, O> {
    /// Clears the flags, as an instruction that affects them begins with.
    pub(super) fn clear_flags(&mut self) {
        self.state.status.key &= !ALL_FLAGS;
    }

    /// Writes a word's cell.
    pub(super) fn write_word(&mut self, location: Location, bits: i32) {
        if let Location::Word(cell, _) = location {
            self.write_word_cell(cell, bits);
        }
    }

    /// Stores a converted value; an overflow sets S:V and nothing else.
    pub(super) fn store_value(&mut self, location: Location, value: Value) {
        let (bits, overflow) = value.converted(element_of(location));
        if overflow {
            self.state.set_overflow();
        }
        self.write_word(location, bits);
    }

    /// Stores a converted value and sets S:V, S:Z and S:N from it.
    pub(super) fn store_result(&mut self, location: Location, outcome: Outcome) {
        let (bits, unfit) = outcome.value.converted(element_of(location));
        if outcome.overflow || unfit {
            self.state.set_overflow();
        }
        self.stored_flags(location, bits);
        self.write_word(location, bits);
    }

    fn stored_flags(&mut self, location: Location, bits: i32) {
        let (zero, negative) = match element_of(location) {
            Element::Real => {
                let value = f32::from_bits(bits as u32);
                (value == 0.0, value < 0.0)
            }
            _ => (bits == 0, bits < 0),
        };
        let key = &mut self.state.status.key;
        *key &= !(ZERO | NEGATIVE);
        *key |= if zero { ZERO } else { 0 };
        *key |= if negative { NEGATIVE } else { 0 };
    }

    /// Stores the low bits of a bitwise result: no overflow.
    fn store_bits(&mut self, location: Location, bits: u32) {
        let kept = low_bits(bits as i32, element_of(location));
        self.stored_flags(location, kept);
        self.write_word(location, kept);
    }

    pub(super) fn moves(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if input {
            self.clear_flags();
            let value = self.number(at(arguments, 0))?;
            let destination = self.locate(at(arguments, 1))?;
            self.store_result(destination, Outcome { value, overflow: false });
        }
        Ok(input)
    }

    pub(super) fn clear(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if input {
            self.clear_flags();
            let destination = self.locate(at(arguments, 0))?;
            self.store_result(destination, Outcome { value: Value::dint(0), overflow: false });
        }
        Ok(input)
    }

    pub(super) fn masked_move(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if input {
            self.clear_flags();
            let source = self.number(at(arguments, 0))?.zero_filled();
            let mask = self.number(at(arguments, 1))?.zero_filled();
            let destination = self.locate(at(arguments, 2))?;
            let old = self.value_at(destination).zero_filled();
            self.store_bits(destination, (old & !mask) | (source & mask));
        }
        Ok(input)
    }

    pub(super) fn bitwise(&mut self, opcode: Opcode, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if input {
            self.clear_flags();
            let left = self.number(at(arguments, 0))?.zero_filled();
            let right = self.number(at(arguments, 1))?.zero_filled();
            let destination = self.locate(at(arguments, 2))?;
            let bits = match opcode {
                Opcode::And => left & right,
                Opcode::Or => left | right,
                _ => left ^ right,
            };
            self.store_bits(destination, bits);
        }
        Ok(input)
    }

    pub(super) fn bitwise_not(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if input {
            self.clear_flags();
            let source = self.number(at(arguments, 0))?.zero_filled();
            let destination = self.locate(at(arguments, 1))?;
            self.store_bits(destination, !source);
        }
        Ok(input)
    }

    pub(super) fn binary_math(&mut self, opcode: Opcode, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        self.clear_flags();
        let left = self.number(at(arguments, 0))?;
        let right = self.number(at(arguments, 1))?;
        let destination = self.locate(at(arguments, 2))?;
        let real = left.is_real() || right.is_real() || element_of(destination) == Element::Real;
        let operator = match opcode {
            Opcode::Add => format::OPERATION_ADD,
            Opcode::Sub => format::OPERATION_SUBTRACT,
            Opcode::Mul => format::OPERATION_MULTIPLY,
            Opcode::Div => format::OPERATION_DIVIDE,
            _ => format::OPERATION_MODULO,
        };
        if !real && carries(opcode, left.bits, right.bits) {
            self.state.status.key |= CARRY;
        }
        let outcome = arithmetic::binary(operator, left, right, real);
        self.store_result(destination, outcome);
        Ok(input)
    }

    pub(super) fn unary_math(&mut self, opcode: Opcode, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        self.clear_flags();
        let operand = self.number(at(arguments, 0))?;
        let destination = self.locate(at(arguments, 1))?;
        let real = operand.is_real() || element_of(destination) == Element::Real;
        let operator = match opcode {
            Opcode::Neg => format::OPERATION_NEGATE,
            Opcode::Abs => format::OPERATION_ABSOLUTE,
            _ => format::OPERATION_SQUARE_ROOT,
        };
        let outcome = arithmetic::unary(operator, operand, real);
        self.store_result(destination, outcome);
        Ok(input)
    }

    pub(super) fn computes(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if input {
            self.clear_flags();
            let destination = self.locate(at(arguments, 0))?;
            let value = self.evaluate(at(arguments, 1))?;
            self.store_result(destination, Outcome { value, overflow: false });
        }
        Ok(input)
    }

    pub(super) fn swaps_bytes(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        let value = self.number(at(arguments, 0))?;
        let destination = self.locate(at(arguments, 2))?;
        let order = match at(arguments, 1) {
            Argument::Integer(order) => order,
            _ => 0,
        };
        let element = element_of(destination);
        let bits = value.bits as u32;
        let swapped = match (element, order) {
            (Element::Int, _) => u32::from((bits as u16).swap_bytes()),
            (_, 0) => bits.swap_bytes(),
            (_, 1) => bits.rotate_left(16),
            _ => bits.swap_bytes().rotate_left(16),
        };
        let kept = low_bits(swapped as i32, element);
        let kept = if element == Element::Real { crate::real::canonical(kept as u32) as i32 } else { kept };
        self.write_word(destination, kept);
        Ok(input)
    }
}

/// The carry of an integer ADD, the borrow of an integer SUB, out of bit 31.
fn carries(opcode: Opcode, left: i32, right: i32) -> bool {
    let (left, right) = (u64::from(left as u32), u64::from(right as u32));
    match opcode {
        Opcode::Add => left.wrapping_add(right) >> 32 != 0,
        Opcode::Sub => left < right,
        _ => false,
    }
}
