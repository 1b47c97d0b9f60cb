//! FAL and FSC. general-instructions.md A.6, REQ-EXEC-070 to 072.

use twinrung_bytecode::limits;
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::cells::Cells;
use super::compare::is_true;
use super::{CONTROL_NEGATIVE, FaultCode, Run, SUBSCRIPT};
use crate::machine::ENDED_WHILE_FALSE;
use crate::program::{Instruction, Operand};

/// Cells of a CONTROL, counted from its first: words LEN, POS; bits EN, EU, DN, EM, ER, UL, IN, FD.
const POS: u32 = 1;
const EN: u32 = 0;
const DN: u32 = 2;
const ER: u32 = 4;
const IN: u32 = 6;
const FD: u32 = 7;

/// Modes in an image; a positive number is elements per execution.
const ALL: i32 = 0;
const INC: i32 = -1;

/// One FAL or FSC with its CONTROL.
#[derive(Clone, Copy)]
struct File {
    control: Cells,
    is_search: bool,
    destination: Operand,
    expression: Operand,
}

impl<O: Observer> Run<'_, O> {
    /// One execution of FAL or FSC.
    pub(super) fn file(&mut self, instruction: Instruction, input: bool) -> Result<(), FaultCode> {
        let control = self.structure(self.program.operand(instruction.operands, 0))?;
        let mode = match self.program.operand(instruction.operands, 3) {
            Operand::Integer(mode) => mode,
            _ => ALL,
        };
        let is_search = instruction.opcode == Opcode::Fsc;
        let (destination, expression) = if is_search {
            (Operand::Nothing, self.program.operand(instruction.operands, 4))
        } else {
            (self.program.operand(instruction.operands, 4), self.program.operand(instruction.operands, 5))
        };
        let file = File { control, is_search, destination, expression };
        if self.flag(file, if is_search { IN } else { ER }) {
            return Ok(());
        }
        match mode {
            ALL => self.file_all(file, input),
            INC => self.file_incremental(file, input),
            count => self.file_numeric(file, input, count),
        }
    }

    fn flag(&self, file: File, bit: u32) -> bool {
        self.machine.bit(file.control.bit.saturating_add(bit))
    }

    fn put_flag(&mut self, file: File, bit: u32, value: bool) {
        self.write_bit(file.control.bit.saturating_add(bit), value);
    }

    fn position(&self, file: File) -> i32 {
        self.machine.word(file.control.word.saturating_add(POS))
    }

    fn put_position(&mut self, file: File, position: i32) {
        self.write_word(file.control.word.saturating_add(POS), position as u32);
    }

    fn file_all(&mut self, file: File, input: bool) -> Result<(), FaultCode> {
        if !input {
            self.rest(file);
            Ok(())
        } else if !self.flag(file, EN) {
            self.put_flag(file, EN, true);
            self.put_position(file, 0);
            self.begin_file(file);
            self.run_of_elements(file, input, i32::MAX)
        } else if file.is_search && self.flag(file, FD) && !self.flag(file, DN) {
            self.pass_hit(file);
            self.run_of_elements(file, input, i32::MAX)
        } else {
            Ok(())
        }
    }

    fn file_incremental(&mut self, file: File, input: bool) -> Result<(), FaultCode> {
        if !input {
            self.rest(file);
            return Ok(());
        }
        if self.flag(file, EN) {
            return Ok(());
        }
        self.put_flag(file, EN, true);
        if file.is_search && self.flag(file, FD) {
            self.pass_hit(file);
        }
        self.begin_file(file);
        self.run_of_elements(file, input, 1)
    }

    fn file_numeric(&mut self, file: File, input: bool, count: i32) -> Result<(), FaultCode> {
        let word = file.control.word;
        if !self.flag(file, EN) {
            if !input {
                return Ok(());
            }
            self.put_flag(file, EN, true);
            self.begin_file(file);
            self.put_position(file, 0);
            self.machine.put_hidden(word, 0);
        } else if self.flag(file, DN) {
            let ended_while_false = self.machine.hidden(word) == ENDED_WHILE_FALSE;
            if !input || ended_while_false {
                self.machine.put_hidden(word, 0);
                self.put_flag(file, EN, false);
                self.put_flag(file, DN, false);
                self.put_position(file, 0);
            }
            return Ok(());
        } else if file.is_search && self.flag(file, FD) {
            self.pass_hit(file);
        }
        self.run_of_elements(file, input, count)
    }

    /// A run; the execution that completes it leaves its mark for mode n (REQ-EXEC-071).
    fn run_of_elements(&mut self, file: File, input: bool, count: i32) -> Result<(), FaultCode> {
        self.elements(file, count)?;
        if self.flag(file, DN) {
            self.machine.put_hidden(file.control.word, if input { 0 } else { ENDED_WHILE_FALSE });
        }
        Ok(())
    }

    /// A false rung in ALL and INC mode.
    fn rest(&mut self, file: File) {
        self.put_flag(file, EN, false);
        if self.flag(file, DN) {
            self.put_flag(file, DN, false);
            self.put_position(file, 0);
        }
    }

    /// What a start changes beside EN and POS. FD belongs to FSC alone.
    fn begin_file(&mut self, file: File) {
        self.put_flag(file, DN, false);
        if file.is_search {
            self.put_flag(file, FD, false);
        }
    }

    /// Goes on behind the element that was found.
    fn pass_hit(&mut self, file: File) {
        self.put_flag(file, FD, false);
        let next = self.position(file).wrapping_add(1);
        self.put_position(file, next);
    }

    /// Processes up to `count` elements from POS on.
    fn elements(&mut self, file: File, count: i32) -> Result<(), FaultCode> {
        if self.machine.word(file.control.word) < 0 || self.position(file) < 0 {
            return Err(CONTROL_NEGATIVE);
        }
        // Nothing can have more elements, so a longer run is bounded here (REQ-EXEC-072).
        if self.machine.word(file.control.word) > limits::ARRAY_ELEMENTS as i32 {
            return Err(SUBSCRIPT);
        }
        if !file.is_search {
            self.clear_status();
        }
        let (mut remaining, mut processed) = (count, 0u32);
        while remaining > 0 && self.position(file) < self.machine.word(file.control.word) {
            // A destination may be POS or LEN itself, and then the run might never end.
            if processed >= limits::ARRAY_ELEMENTS {
                return Err(SUBSCRIPT);
            }
            remaining = remaining.saturating_sub(1);
            processed = processed.saturating_add(1);
            self.retire(1);
            let stop = if file.is_search { self.search_element(file)? } else { self.store_element(file)? };
            if stop {
                return Ok(());
            }
            // It goes on from what is there now.
            let next = self.position(file).wrapping_add(1);
            self.put_position(file, next);
        }
        if self.position(file) >= self.machine.word(file.control.word) {
            self.put_flag(file, DN, true);
        }
        Ok(())
    }

    /// FAL: whether an overflow stops it.
    fn store_element(&mut self, file: File) -> Result<bool, FaultCode> {
        let value = self.expression_value(file.expression)?;
        let slot = self.slot(file.destination)?;
        self.conclude(slot, value, false, false);
        let overflow = self.machine.status.overflow;
        if overflow {
            self.put_flag(file, ER, true);
        }
        Ok(overflow)
    }

    /// FSC: whether the element is a hit.
    fn search_element(&mut self, file: File) -> Result<bool, FaultCode> {
        let value = self.expression_value(file.expression)?;
        let hit = is_true(value);
        if hit {
            self.put_flag(file, FD, true);
            self.put_flag(file, IN, true);
        }
        Ok(hit)
    }
}
