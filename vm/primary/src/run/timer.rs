//! TON, TOF, RTO. general-instructions.md A.2.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::cells::Cells;
use super::{FaultCode, Run, TIMER_NEGATIVE};
use crate::program::Operand;

/// Cells of a TIMER after its first: words PRE, ACC; bits EN, TT, DN.
const ACC: u32 = 1;
const TT: u32 = 1;
const DN: u32 = 2;

impl<O: Observer> Run<'_, O> {
    /// The cells of a structure.
    pub(super) fn structure(&mut self, operand: Operand) -> Result<Cells, FaultCode> {
        match operand.location() {
            Some(location) => self.cells(location),
            None => Ok(Cells { bit: crate::program::NONE, word: crate::program::NONE, skipped: 0 }),
        }
    }

    /// One execution of a timer.
    pub(super) fn timer(&mut self, opcode: Opcode, timer: Operand, input: bool) -> Result<(), FaultCode> {
        let Cells { bit, word, .. } = self.structure(timer)?;
        let timing_when = opcode != Opcode::Tof;
        let (acc_cell, tt, dn) = (word.saturating_add(ACC), bit.saturating_add(TT), bit.saturating_add(DN));
        if input != timing_when {
            match opcode {
                Opcode::Ton => {
                    self.write_bit(tt, false);
                    self.write_bit(dn, false);
                    self.write_word(acc_cell, 0);
                }
                Opcode::Tof => {
                    self.write_bit(tt, false);
                    self.write_bit(dn, true);
                    self.write_word(acc_cell, 0);
                }
                _ => self.write_bit(tt, false),
            }
            self.write_bit(bit, input);
            return Ok(());
        }
        let (preset, accumulated) = (self.machine.word(word), self.machine.word(acc_cell));
        if preset < 0 || accumulated < 0 {
            return Err(TIMER_NEGATIVE);
        }
        let (enabled, done) = (self.machine.bit(bit), self.machine.bit(dn));
        // TON and RTO time while DN is clear, TOF while it is set; EN says whether this is the first such execution.
        let timing = done != timing_when;
        if timing {
            if enabled == timing_when {
                let now = self.step(word, accumulated);
                self.write_word(acc_cell, now as u32);
                if now >= preset {
                    self.write_bit(dn, timing_when);
                    self.write_bit(tt, false);
                } else {
                    self.write_bit(tt, true);
                }
            } else {
                self.write_bit(tt, true);
            }
            self.machine.put_hidden(word, self.inputs.now_ms);
        } else {
            self.write_bit(tt, false);
            if timing_when {
                // A pause by DN is not counted.
                self.machine.put_hidden(word, self.inputs.now_ms);
            }
        }
        self.write_bit(bit, input);
        Ok(())
    }

    /// The accumulated time with what has passed since the timer was last executed.
    fn step(&self, word: u32, accumulated: i32) -> i32 {
        let passed = self.inputs.now_ms.saturating_sub(self.machine.hidden(word));
        advanced(accumulated, passed)
    }
}

/// Accumulated time and what passed, at the end of the range at most.
pub(crate) fn advanced(accumulated: i32, passed: i64) -> i32 {
    i64::from(accumulated).saturating_add(passed).clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
}
