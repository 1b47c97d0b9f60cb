//! CTU, CTD, RES. general-instructions.md A.3.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::cells::Cells;
use super::{FaultCode, Run};
use crate::program::Operand;

/// Cells of a COUNTER after its first: words PRE, ACC; bits CU, CD, DN, OV, UN.
const ACC: u32 = 1;
const CD: u32 = 1;
const DN: u32 = 2;
const OV: u32 = 3;
const UN: u32 = 4;
/// Bits of the largest structure that RES takes: CONTROL.
const RESETTABLE: u32 = 8;

impl<O: Observer> Run<'_, O> {
    /// One execution of a counter.
    pub(super) fn counter(&mut self, opcode: Opcode, counter: Operand, input: bool) -> Result<(), FaultCode> {
        let Cells { bit, word, .. } = self.structure(counter)?;
        let up = opcode == Opcode::Ctu;
        let edge = if up { bit } else { bit.saturating_add(CD) };
        let (overflow, underflow) = (bit.saturating_add(OV), bit.saturating_add(UN));
        let acc_cell = word.saturating_add(ACC);
        let rises = input && !self.machine.bit(edge);
        self.write_bit(edge, input);
        if rises {
            let accumulated = self.machine.word(acc_cell);
            let next = if up { accumulated.checked_add(1) } else { accumulated.checked_sub(1) };
            let wrapped = if up { i32::MIN } else { i32::MAX };
            self.write_word(acc_cell, next.unwrap_or(wrapped) as u32);
            if next.is_none() {
                let (mark, other) = if up { (overflow, underflow) } else { (underflow, overflow) };
                if !self.machine.bit(other) {
                    self.write_bit(mark, true);
                    return Ok(());
                }
                self.write_bit(underflow, false);
                self.write_bit(overflow, false);
            }
        }
        if !self.machine.bit(overflow) && !self.machine.bit(underflow) {
            let done = self.machine.word(acc_cell) >= self.machine.word(word);
            self.write_bit(bit.saturating_add(DN), done);
        }
        Ok(())
    }

    /// RES, with a true rung: the second word (ACC or POS) and all bits of a TIMER, COUNTER or CONTROL.
    pub(super) fn reset(&mut self, structure: Operand) -> Result<(), FaultCode> {
        let Cells { bit, word, .. } = self.structure(structure)?;
        let bits = match structure {
            Operand::Region { bit_cells, .. } => bit_cells,
            _ => 0,
        };
        self.write_word(word.saturating_add(ACC), 0);
        for offset in 0..bits.min(RESETTABLE) {
            self.write_bit(bit.saturating_add(offset), false);
        }
        Ok(())
    }
}
