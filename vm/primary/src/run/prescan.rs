//! What prescan does to each instruction. general-instructions.md 2.7.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::{FaultCode, Run};
use crate::program::Instruction;

impl<O: Observer> Run<'_, O> {
    /// Prescans an instruction that is neither a call nor a jump.
    pub(super) fn prescan_instruction(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let first = self.program.operand(instruction.operands, 0);
        match instruction.opcode {
            Opcode::Ote => {
                let slot = self.slot(first)?;
                self.put_slot_bit(slot, false);
            }
            Opcode::Ons => {
                let slot = self.slot(first)?;
                self.put_slot_bit(slot, true);
            }
            Opcode::Osr | Opcode::Osf => {
                let storage = self.slot(first)?;
                let output = self.slot(self.program.operand(instruction.operands, 1))?;
                self.put_slot_bit(storage, instruction.opcode == Opcode::Osr);
                self.put_slot_bit(output, false);
            }
            Opcode::Ton | Opcode::Tof | Opcode::Rto => {
                let cells = self.structure(first)?;
                for bit in 0..3 {
                    self.write_bit(cells.bit.saturating_add(bit), false);
                }
                let accumulated = cells.word.saturating_add(1);
                match instruction.opcode {
                    Opcode::Ton => self.write_word(accumulated, 0),
                    Opcode::Tof => {
                        let preset = self.machine.word(cells.word);
                        self.write_word(accumulated, preset as u32);
                    }
                    _ => {}
                }
            }
            Opcode::Ctu | Opcode::Ctd => {
                let cells = self.structure(first)?;
                let edge = u32::from(instruction.opcode == Opcode::Ctd);
                self.write_bit(cells.bit.saturating_add(edge), true);
            }
            Opcode::Fal | Opcode::Fsc => {
                let cells = self.structure(first)?;
                // EN, DN, ER.
                for bit in [0, 2, 4] {
                    self.write_bit(cells.bit.saturating_add(bit), false);
                }
                self.machine.put_hidden(cells.word, 0);
            }
            opcode if opcode.instruction().group.is_safety_library() => self.safety(instruction, false, true)?,
            _ => {}
        }
        Ok(())
    }
}
