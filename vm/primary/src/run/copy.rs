//! COP, FLL and SIZE. general-instructions.md A.6, REQ-EXEC-006.

use twinrung_bytecode::limits;
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Element;

use super::cells::Cells;
use super::{FaultCode, Run, SUBSCRIPT};
use crate::machine::Slot;
use crate::number::Number;
use crate::program::{CopyPlan, Instruction, Location, Operand, Side};

impl<O: Observer> Run<'_, O> {
    /// What a COP, FLL, GSV or SSV moves.
    pub(super) fn plan(&self, instruction: Instruction) -> Option<CopyPlan> {
        self.program.copies.get(instruction.extra as usize).copied()
    }

    /// The first cells of one side, of which `length` elements must lie in its array.
    pub(super) fn side_cells(&mut self, operand: Operand, side: Side, length: u32) -> Result<Cells, FaultCode> {
        let location = operand.location().unwrap_or(Location { bit: 0, word: 0, formula: crate::program::NONE });
        let cells = self.cells(location)?;
        if side.holds(cells.skipped, length) { Ok(cells) } else { Err(SUBSCRIPT) }
    }

    /// COP with a true rung.
    pub(super) fn copy(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let Some(plan) = self.plan(instruction) else { return Ok(()) };
        let (bytes, source_length) = (plan.bytes(), plan.source_length());
        let source = self.side_cells(self.program.operand(instruction.operands, 0), plan.source, source_length)?;
        let destination =
            self.side_cells(self.program.operand(instruction.operands, 1), plan.destination, plan.length)?;
        if !O::ACTIVE && plan.source.content == plan.destination.content {
            self.copy_cells(source, destination, plan);
        } else {
            self.gather(source, plan.source, source_length, bytes);
            self.scatter(destination, plan.destination, plan.length, bytes);
        }
        Ok(())
    }

    /// Between equal types a copy of bytes is a copy of cells.
    fn copy_cells(&mut self, source: Cells, destination: Cells, plan: CopyPlan) {
        let bits = plan.length.saturating_mul(plan.source.bit_cells) as usize;
        let words = plan.length.saturating_mul(plan.source.word_cells) as usize;
        move_within(&mut self.machine.bits, source.bit as usize, destination.bit as usize, bits);
        move_within(&mut self.machine.words, source.word as usize, destination.word as usize, words);
    }

    /// Collects the bytes of elements in the Logix memory layout; up to `bytes`, those that no member covers are 0.
    pub(super) fn gather(&mut self, from: Cells, side: Side, length: u32, bytes: u32) {
        for byte in self.machine.copied.iter_mut().take(bytes as usize) {
            *byte = 0;
        }
        let program = self.program;
        for index in 0..length.min(limits::COPY_BYTES) {
            let (bit, word, byte) = element_base(from, side, index);
            for field in side.fields.of(&program.fields) {
                let at = byte.saturating_add(field.byte) as usize;
                if field.element == Element::Bool {
                    let set = self.machine.bit(bit.saturating_add(field.cell));
                    if let Some(host) = self.machine.copied.get_mut(at) {
                        *host |= u8::from(set).wrapping_shl(u32::from(field.bit));
                    }
                    continue;
                }
                let value = self.machine.word(word.saturating_add(field.cell)).to_le_bytes();
                let count = field.element.bytes() as usize;
                for (target, value) in self.machine.copied.iter_mut().skip(at).zip(value).take(count) {
                    *target = value;
                }
            }
        }
    }

    /// Spreads what was collected over the fields that begin in the first `bytes` of elements; later ones stay.
    pub(super) fn scatter(&mut self, to: Cells, side: Side, length: u32, bytes: u32) {
        let program = self.program;
        for index in 0..length.min(limits::COPY_BYTES) {
            let (bit, word, byte) = element_base(to, side, index);
            for field in side.fields.of(&program.fields) {
                let at = byte.saturating_add(field.byte);
                if at >= bytes {
                    continue;
                }
                let at = at as usize;
                if field.element == Element::Bool {
                    let host = self.machine.copied.get(at).copied().unwrap_or(0);
                    let set = host.wrapping_shr(u32::from(field.bit)) & 1 != 0;
                    self.write_bit(bit.saturating_add(field.cell), set);
                    continue;
                }
                let mut value = [0u8; 4];
                for (value, source) in value.iter_mut().zip(self.machine.copied.iter().skip(at)) {
                    *value = *source;
                }
                let value = i32::from_le_bytes(value);
                let value = match field.element {
                    Element::Sint => i32::from(value as i8),
                    Element::Int => i32::from(value as i16),
                    _ => value,
                };
                self.write_word(word.saturating_add(field.cell), value as u32);
            }
        }
    }

    /// FLL with a true rung.
    pub(super) fn fill(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let Some(plan) = self.plan(instruction) else { return Ok(()) };
        let value = self.number(self.program.operand(instruction.operands, 0))?;
        let operand = self.program.operand(instruction.operands, 1);
        let cells = self.side_cells(operand, plan.destination, plan.length)?;
        let crate::program::Content::Element(element) = plan.destination.content else { return Ok(()) };
        for index in 0..plan.length.min(limits::COPY_BYTES) {
            let (_, lost) = self.store(Slot::Word { word: cells.word.saturating_add(index), element }, value);
            if lost {
                self.overflow();
            }
        }
        Ok(())
    }

    /// SIZE with a true rung; the loader has counted.
    pub(super) fn size(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let size = match self.program.operand(instruction.operands, 0) {
            Operand::Integer(size) => size,
            _ => 0,
        };
        let slot = self.slot(self.program.operand(instruction.operands, 1))?;
        if self.store(slot, Number::Integer(size)).1 {
            self.overflow();
        }
        Ok(())
    }
}

/// First bit cell, word cell and byte of an element.
fn element_base(first: Cells, side: Side, index: u32) -> (u32, u32, u32) {
    (
        first.bit.saturating_add(index.saturating_mul(side.bit_cells)),
        first.word.saturating_add(index.saturating_mul(side.word_cells)),
        index.saturating_mul(side.bytes),
    )
}

/// Copies within a bank as if the source were read before anything is written.
fn move_within<T: Copy>(bank: &mut [T], from: usize, to: usize, count: usize) {
    let inside = |first: usize| first.checked_add(count).is_some_and(|end| end <= bank.len());
    if inside(from) && inside(to) {
        bank.copy_within(from..from.saturating_add(count), to);
    }
}
