//! Moves and bitwise logic. general-instructions.md A.5 and A.7.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::{Element, Opcode};

use super::{FaultCode, Run};
use crate::machine::Slot;
use crate::number::{Number, narrowed, zero_filled};
use crate::program::{Instruction, Operand};

/// SWPB's word orders; REVERSE is 0.
const WORD: i32 = 1;
const HIGH_LOW: i32 = 2;

impl<O: Observer> Run<'_, O> {
    /// MOV with a true rung.
    pub(super) fn move_number(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        self.clear_status();
        let value = self.number(self.program.operand(instruction.operands, 0))?;
        let slot = self.slot(self.program.operand(instruction.operands, 1))?;
        self.conclude(slot, value, false, false);
        Ok(())
    }

    /// CLR with a true rung.
    pub(super) fn clear(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        self.clear_status();
        let slot = self.slot(self.program.operand(instruction.operands, 0))?;
        self.conclude(slot, Number::Integer(0), false, false);
        Ok(())
    }

    /// MVM with a true rung.
    pub(super) fn masked_move(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        self.clear_status();
        let source = self.filled(self.program.operand(instruction.operands, 0))?;
        let mask = self.filled(self.program.operand(instruction.operands, 1))?;
        let slot = self.slot(self.program.operand(instruction.operands, 2))?;
        let old = match self.number_of(slot) {
            Number::Integer(value) => value,
            Number::Real(_) => 0,
        };
        self.conclude_bits(slot, (old & !mask) | (source & mask));
        Ok(())
    }

    /// AND OR XOR with a true rung.
    pub(super) fn logical(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        self.clear_status();
        let left = self.filled(self.program.operand(instruction.operands, 0))?;
        let right = self.filled(self.program.operand(instruction.operands, 1))?;
        let slot = self.slot(self.program.operand(instruction.operands, 2))?;
        let value = match instruction.opcode {
            Opcode::And => left & right,
            Opcode::Or => left | right,
            _ => left ^ right,
        };
        self.conclude_bits(slot, value);
        Ok(())
    }

    /// NOT with a true rung.
    pub(super) fn invert(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        self.clear_status();
        let source = self.filled(self.program.operand(instruction.operands, 0))?;
        let slot = self.slot(self.program.operand(instruction.operands, 1))?;
        self.conclude_bits(slot, !source);
        Ok(())
    }

    fn filled(&mut self, operand: Operand) -> Result<i32, FaultCode> {
        let (value, element) = self.integer(operand)?;
        Ok(zero_filled(value, element))
    }

    /// Stores the low bits; dropped bits are no overflow.
    fn conclude_bits(&mut self, slot: Slot, value: i32) {
        let element = match slot {
            Slot::Word { element, .. } => element,
            _ => Element::Dint,
        };
        self.conclude(slot, Number::Integer(narrowed(value, element).0), false, false);
    }

    /// SWPB with a true rung.
    pub(super) fn swap_bytes(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let source = self.slot(self.program.operand(instruction.operands, 0))?;
        let order = match self.program.operand(instruction.operands, 1) {
            Operand::Integer(order) => order,
            _ => 0,
        };
        let slot = self.slot(self.program.operand(instruction.operands, 2))?;
        let Slot::Word { word: destination, element } = slot else { return Ok(()) };
        let bits = match source {
            Slot::Word { word, .. } => self.machine.word(word) as u32,
            Slot::Constant(Number::Integer(value)) => value as u32,
            Slot::Constant(Number::Real(value)) => value.to_bits(),
            _ => 0,
        };
        let swapped = match element {
            Element::Int => i32::from((bits as u16).swap_bytes() as i16) as u32,
            _ => match order {
                WORD => bits.rotate_left(16),
                HIGH_LOW => bits.swap_bytes().rotate_left(16),
                _ => bits.swap_bytes(),
            },
        };
        let stored = if element == Element::Real { Self::canonical(swapped) } else { swapped };
        self.write_word(destination, stored);
        Ok(())
    }
}
