//! Timers, counters and RES. general-instructions.md A.2, A.3.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::Walker;
use super::bit::at;
use super::fault::{Fault, TIMER};
use super::value::narrow_to_dint;
use crate::ladder::{Argument, Location, StructureKind};
use crate::timer::{TimerState, off_delay, on_delay, retentive};

/// First cells of a structure operand: bit and word.
type Cells = (u32, u32);

// Members of TIMER, COUNTER and CONTROL, counted from the first cells.
const ACC: u32 = 1;
const EN: u32 = 0;
const TT: u32 = 1;
const TIMER_DN: u32 = 2;
const CU: u32 = 0;
const CD: u32 = 1;
const COUNTER_DN: u32 = 2;
const OV: u32 = 3;
const UN: u32 = 4;

impl<O: Observer> Walker<'_, O> {
    /// The first cells of a structure operand.
    pub(super) fn structure(&mut self, argument: Argument) -> Result<Cells, Fault> {
        Ok(match self.locate(argument)? {
            Location::Region { bit, word, .. } => (bit, word),
            _ => (u32::MAX, u32::MAX),
        })
    }

    pub(super) fn member_bit(&self, (bit, _): Cells, member: u32) -> bool {
        self.state.memory.bit(bit.wrapping_add(member))
    }

    pub(super) fn set_member_bit(&mut self, (bit, _): Cells, member: u32, value: bool) {
        self.write_bit_cell(bit.wrapping_add(member), value);
    }

    pub(super) fn member_word(&self, (_, word): Cells, member: u32) -> i32 {
        self.state.memory.word(word.wrapping_add(member))
    }

    pub(super) fn set_member_word(&mut self, (_, word): Cells, member: u32, value: i32) {
        self.write_word_cell(word.wrapping_add(member), value);
    }

    pub(super) fn timer(&mut self, opcode: Opcode, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        let cells = self.structure(at(arguments, 0))?;
        let before = TimerState {
            enabled: self.member_bit(cells, EN),
            timing: self.member_bit(cells, TT),
            done: self.member_bit(cells, TIMER_DN),
            preset: self.member_word(cells, 0),
            accumulated: self.member_word(cells, ACC),
            last_time: self.state.memory.stamp(cells.1),
        };
        let enabled = if opcode == Opcode::Tof { !input } else { input };
        if enabled && (before.preset < 0 || before.accumulated < 0) {
            return Err(TIMER);
        }
        let now_ms = self.inputs.now_ms;
        let after = match opcode {
            Opcode::Ton => on_delay(before, input, now_ms),
            Opcode::Tof => off_delay(before, input, now_ms),
            _ => retentive(before, input, now_ms),
        };
        self.set_member_bit(cells, EN, after.enabled);
        self.set_member_bit(cells, TT, after.timing);
        self.set_member_bit(cells, TIMER_DN, after.done);
        self.set_member_word(cells, ACC, after.accumulated);
        self.state.memory.set_stamp(cells.1, after.last_time);
        Ok(input)
    }

    pub(super) fn counter(&mut self, opcode: Opcode, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        let cells = self.structure(at(arguments, 0))?;
        let up = opcode == Opcode::Ctu;
        let (edge, own_wrap, other_wrap) = if up { (CU, OV, UN) } else { (CD, UN, OV) };
        let mut frozen = false;
        if input && !self.member_bit(cells, edge) {
            let accumulated = i64::from(self.member_word(cells, ACC));
            let (value, wrapped) = narrow_to_dint(accumulated.wrapping_add(if up { 1 } else { -1 }));
            self.set_member_word(cells, ACC, value);
            if wrapped {
                if self.member_bit(cells, other_wrap) {
                    self.set_member_bit(cells, OV, false);
                    self.set_member_bit(cells, UN, false);
                } else {
                    self.set_member_bit(cells, own_wrap, true);
                    frozen = true;
                }
            }
        }
        self.set_member_bit(cells, edge, input);
        if !frozen && !self.member_bit(cells, OV) && !self.member_bit(cells, UN) {
            let done = self.member_word(cells, ACC) >= self.member_word(cells, 0);
            self.set_member_bit(cells, COUNTER_DN, done);
        }
        Ok(input)
    }

    pub(super) fn resets(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        if let Location::Region { bit, word, kind } = self.locate(at(arguments, 0))? {
            // ACC and POS are the second word; of CONTROL's eight bits and the others' all are cleared.
            let bits = match kind {
                StructureKind::Timer => 3,
                StructureKind::Counter => 5,
                StructureKind::Control => 8,
                StructureKind::Other => return Ok(input),
            };
            self.set_member_word((bit, word), ACC, 0);
            for member in 0..bits {
                self.set_member_bit((bit, word), member, false);
            }
        }
        Ok(input)
    }

    /// The prescan action of timers and counters.
    pub(super) fn prescan_timer(&mut self, opcode: Opcode, argument: Argument) -> Result<(), Fault> {
        let cells = self.structure(argument)?;
        match opcode {
            Opcode::Ctu => self.set_member_bit(cells, CU, true),
            Opcode::Ctd => self.set_member_bit(cells, CD, true),
            _ => {
                for member in [EN, TT, TIMER_DN] {
                    self.set_member_bit(cells, member, false);
                }
                match opcode {
                    Opcode::Ton => self.set_member_word(cells, ACC, 0),
                    Opcode::Tof => {
                        let preset = self.member_word(cells, 0);
                        self.set_member_word(cells, ACC, preset);
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }
}
