//! FAL and FSC. general-instructions.md A.6.

use twinrung_bytecode::limits;
use twinrung_bytecode::observer::Observer;

use super::Walker;
use super::arithmetic::Outcome;
use super::bit::at;
use super::fault::{CONTROL, Fault, SUBSCRIPT};
use crate::ladder::Argument;
use crate::memory::FINISHED_FALSE;
use crate::state::OVERFLOW;

// Members of CONTROL, counted from the first cells.
const LEN: u32 = 0;
const POS: u32 = 1;
const EN: u32 = 0;
const DN: u32 = 2;
const ER: u32 = 4;
const IN: u32 = 6;
const FD: u32 = 7;

/// The greatest LEN that a run accepts, and the most elements that it processes: no array has more (REQ-EXEC-072).
const MOST_ELEMENTS: u32 = limits::ARRAY_ELEMENTS;

/// First cells of the CONTROL.
type Cells = (u32, u32);

/// What is done for each element.
#[derive(Debug, Clone, Copy)]
enum Work {
    /// FAL: destination and expression.
    Store(Argument, Argument),
    /// FSC: the condition.
    Search(Argument),
}

impl Work {
    const fn searches(self) -> bool {
        matches!(self, Work::Search(_))
    }
}

/// How many elements an execution processes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum FileMode {
    All,
    Incremental,
    Numeric(u32),
}

fn file_mode(argument: Argument) -> FileMode {
    match argument {
        Argument::Integer(number) if number > 0 => FileMode::Numeric(number.unsigned_abs()),
        Argument::Integer(number) if number < 0 => FileMode::Incremental,
        _ => FileMode::All,
    }
}

impl<O: Observer> Walker<'_, O> {
    pub(super) fn file_arithmetic(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        let work = Work::Store(at(arguments, 2), at(arguments, 3));
        self.file(at(arguments, 0), file_mode(at(arguments, 1)), work, input)
    }

    pub(super) fn file_search(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        let work = Work::Search(at(arguments, 2));
        self.file(at(arguments, 0), file_mode(at(arguments, 1)), work, input)
    }

    fn file(&mut self, control: Argument, mode: FileMode, work: Work, input: bool) -> Result<bool, Fault> {
        let cells = self.structure(control)?;
        let blocked = self.member_bit(cells, if work.searches() { IN } else { ER });
        match mode {
            _ if blocked => {}
            FileMode::Numeric(count) => self.numeric(cells, work, count, input)?,
            FileMode::All | FileMode::Incremental if !input => self.ends(cells),
            FileMode::All => self.edge(cells, work, u32::MAX)?,
            FileMode::Incremental => self.edge(cells, work, 1)?,
        }
        Ok(input)
    }

    /// A false rung in ALL and INC mode.
    fn ends(&mut self, cells: Cells) {
        self.set_member_bit(cells, EN, false);
        if self.member_bit(cells, DN) {
            self.set_member_bit(cells, DN, false);
            self.set_member_word(cells, POS, 0);
        }
    }

    /// A true rung in ALL mode, or in INC mode where `count` is 1 (REQ-EXEC-070).
    fn edge(&mut self, cells: Cells, work: Work, count: u32) -> Result<(), Fault> {
        let all = count > 1;
        let hit = work.searches() && self.member_bit(cells, FD);
        if self.member_bit(cells, EN) {
            if all && hit && !self.member_bit(cells, DN) {
                self.leave_hit(cells);
                return self.run(cells, work, count, true);
            }
            return Ok(());
        }
        if all {
            self.set_member_word(cells, POS, 0);
        } else if hit {
            self.leave_hit(cells);
        }
        self.starts(cells, work);
        self.run(cells, work, count, true)
    }

    fn starts(&mut self, cells: Cells, work: Work) {
        self.set_member_bit(cells, EN, true);
        self.set_member_bit(cells, DN, false);
        if work.searches() {
            self.set_member_bit(cells, FD, false);
        }
    }

    /// Numeric mode: at every execution until done, whatever the rung is (REQ-EXEC-071).
    fn numeric(&mut self, cells: Cells, work: Work, count: u32, input: bool) -> Result<(), Fault> {
        let finished_false = self.state.memory.stamp(cells.1) == FINISHED_FALSE;
        if !self.member_bit(cells, EN) {
            if !input {
                return Ok(());
            }
            self.state.memory.set_stamp(cells.1, 0);
            self.set_member_word(cells, POS, 0);
            self.starts(cells, work);
        } else if self.member_bit(cells, DN) {
            if !input || finished_false {
                self.state.memory.set_stamp(cells.1, 0);
                self.set_member_bit(cells, EN, false);
                self.set_member_bit(cells, DN, false);
                self.set_member_word(cells, POS, 0);
            }
            return Ok(());
        } else if work.searches() && self.member_bit(cells, FD) {
            self.leave_hit(cells);
        }
        self.run(cells, work, count, input)
    }

    fn leave_hit(&mut self, cells: Cells) {
        let position = self.member_word(cells, POS);
        self.set_member_word(cells, POS, position.wrapping_add(1));
        self.set_member_bit(cells, FD, false);
    }

    /// Processes up to `count` elements (REQ-EXEC-072); who completes the run notes how the rung was.
    fn run(&mut self, cells: Cells, work: Work, count: u32, input: bool) -> Result<(), Fault> {
        if self.member_word(cells, LEN) < 0 || self.member_word(cells, POS) < 0 {
            return Err(CONTROL);
        }
        if self.member_word(cells, LEN) > MOST_ELEMENTS as i32 {
            return Err(SUBSCRIPT);
        }
        if !work.searches() {
            self.clear_flags();
        }
        let mut processed = 0u32;
        while processed < count && self.member_word(cells, POS) < self.member_word(cells, LEN) {
            // A run whose destination is its own POS or LEN would never end.
            if processed >= MOST_ELEMENTS {
                return Err(SUBSCRIPT);
            }
            self.count(1);
            let stops = match work {
                Work::Store(destination, expression) => self.store_element(destination, expression)?,
                Work::Search(condition) => self.truth(condition)?,
            };
            processed = processed.saturating_add(1);
            if stops {
                let mark = if work.searches() { [FD, IN].as_slice() } else { [ER].as_slice() };
                for member in mark {
                    self.set_member_bit(cells, *member, true);
                }
                return Ok(());
            }
            let position = self.member_word(cells, POS);
            self.set_member_word(cells, POS, position.wrapping_add(1));
        }
        if self.member_word(cells, POS) >= self.member_word(cells, LEN) {
            self.set_member_bit(cells, DN, true);
            self.state.memory.set_stamp(cells.1, if input { 0 } else { FINISHED_FALSE });
        }
        Ok(())
    }

    /// One element of FAL; whether it overflowed.
    fn store_element(&mut self, destination: Argument, expression: Argument) -> Result<bool, Fault> {
        let value = self.evaluate(expression)?;
        let destination = self.locate(destination)?;
        self.store_result(destination, Outcome { value, overflow: false });
        Ok(self.state.status.key & OVERFLOW != 0)
    }

    /// The prescan action.
    pub(super) fn prescan_file(&mut self, control: Argument) -> Result<(), Fault> {
        let cells = self.structure(control)?;
        for member in [EN, DN, ER] {
            self.set_member_bit(cells, member, false);
        }
        Ok(())
    }
}
