//! Calls of Add-On Instructions and of safety application instructions. REQ-EXEC-030 to 034, 060 to 062.

use twinrung_bytecode::observer::Observer;

use super::fault::Fault;
use super::frame::{Link, Mode};
use super::math::element_of;
use super::{Flow, Walker};
use crate::ladder::{Argument, BodyIndex, Call, Input, Location, Step};
use crate::state::{Bound, Flags};

impl<O: Observer> Walker<'_, O> {
    /// A call of an Add-On Instruction.
    pub(super) fn add_on(&mut self, step: Step) -> Result<(), Fault> {
        let ladder = self.ladder;
        let Some(call) = ladder.calls.get(step.first as usize) else { return Ok(()) };
        let prescan = self.frame.mode == Mode::Prescan;
        let input = self.frame.rail && !prescan;
        let body = if input || prescan { Some(call.logic) } else { call.enable_in_false };
        let Some(body) = body else {
            self.write_bit_cell(call.enable_in, false);
            self.write_bit_cell(call.enable_out, false);
            self.finish_call(false);
            return Ok(());
        };
        let first = self.bind_all(call.arguments.iter().copied())?;
        self.write_bit_cell(call.enable_in, input);
        if !input {
            self.write_bit_cell(call.enable_out, false);
        }
        for input in &call.inputs {
            let from = self.bound_input(first, *input);
            self.pass(from, Bound { argument: Argument::Nothing, location: input.parameter });
        }
        if input {
            self.write_bit_cell(call.enable_out, true);
        }
        if prescan {
            self.begin(body, Mode::Prescan, Link::AddOnPrescan(step.first), first)
        } else {
            self.begin(body, Mode::Normal, Link::AddOn(step.first), first)
        }
    }

    /// Copies the Output parameters to where the subscripts of their arguments now lead.
    fn copy_out(&mut self, call: &Call) -> Result<(), Fault> {
        for output in &call.outputs {
            let to = self.bind(output.argument)?;
            self.pass(Bound { argument: Argument::Nothing, location: output.parameter }, to);
        }
        Ok(())
    }

    /// Where an argument of the call whose arguments are kept from `first` on was found.
    fn bound_input(&self, first: usize, input: Input) -> Bound {
        self.bound(first.saturating_add(input.argument as usize))
    }

    pub(super) fn leave_add_on(&mut self, number: u32) -> Flow {
        let ladder = self.ladder;
        self.pop_frame();
        let Some(call) = ladder.calls.get(number as usize) else { return Flow::On };
        let result = self.copy_out(call);
        if result.is_ok() {
            let output = self.state.memory.bit(call.enable_out);
            // Behind a cleared fault the rest of the rung is false, whatever EnableOut says.
            let lives = self.frame.mode == Mode::Normal && self.frame.dead == 0;
            self.finish_call(output && lives);
        }
        self.after(result)
    }

    /// After the prescan of Logic the Prescan routine runs, with true rungs.
    pub(super) fn leave_prescanned_logic(&mut self, number: u32) -> Flow {
        let ladder = self.ladder;
        let prescan = ladder.calls.get(number as usize).and_then(|call| call.prescan);
        let Some(body) = prescan else { return self.leave_add_on(number) };
        self.enter(body, Mode::Normal, Link::AddOn(number), self.frame.bound);
        Flow::On
    }

    /// A safety application instruction: operands are mirrored, then the library's ladder runs.
    pub(super) fn safety(&mut self, step: Step) -> Result<(), Fault> {
        let ladder = self.ladder;
        let Some(call) = ladder.calls.get(step.first as usize) else { return Ok(()) };
        if self.frame.mode == Mode::Prescan {
            return self.prescan_safety(step, call);
        }
        let first = self.bind_all(call.arguments.iter().copied())?;
        let begins = !self.state.memory.bit(call.prescanned);
        if begins {
            self.forget_private(call);
        }
        for operand in &call.inputs {
            let from = self.bound_input(first, *operand);
            self.mirror(from, operand.parameter);
        }
        match begins {
            // No prescan has reached it: it begins as if one just had. REQ-EXEC-061.
            true => self.begin_prescan(step.first, call, first),
            false => self.execute_safety(step.first, call, first),
        }
    }

    /// Runs the library's ladder on operands that have been mirrored; bound arguments from `first` on are done with.
    fn execute_safety(&mut self, number: u32, call: &Call, first: usize) -> Result<(), Fault> {
        let input = self.frame.rail;
        self.write_bit_cell(call.enable_in, input);
        let flags = self.state.status;
        let body = if input { Some(call.logic) } else { call.enable_in_false };
        let Some(body) = body else {
            self.state.bound.truncate(first);
            self.write_bit_cell(call.enable_out, input);
            self.finish_call(input);
            return Ok(());
        };
        self.begin_library(body, Mode::Normal, Link::Safety(number, flags), first)
    }

    /// Mirrors an operand; the declared types fit, so that no flag is concerned.
    fn mirror(&mut self, from: Bound, to: Location) {
        match to {
            Location::Bit(cell) => {
                let value = self.bound_bit(from);
                self.write_bit_cell(cell, value);
            }
            Location::Word(cell, _) => {
                let (bits, _) = self.bound_value(from).converted(element_of(to));
                self.write_word_cell(cell, bits);
            }
            Location::WordBit(..) | Location::Region { .. } => {}
        }
    }

    pub(super) fn leave_safety(&mut self, number: u32, flags: Flags) {
        self.pop_frame();
        self.state.in_library = false;
        self.state.status = flags;
        let ladder = self.ladder;
        let output = self.frame.rail;
        if let Some(call) = ladder.calls.get(number as usize) {
            self.write_bit_cell(call.enable_out, output);
        }
        self.finish_call(output);
    }

    fn prescan_safety(&mut self, step: Step, call: &Call) -> Result<(), Fault> {
        // The subscripts of all operands first, as in a scan; then the configuration alone is mirrored. REQ-EXEC-004, 061.
        let first = self.bind_all(call.arguments.iter().copied())?;
        for (operand, is_configuration) in call.inputs.iter().zip(&call.configuration) {
            if *is_configuration {
                let from = self.bound_input(first, *operand);
                self.mirror(from, operand.parameter);
            }
        }
        self.write_bit_cell(call.enable_in, false);
        self.write_bit_cell(call.enable_out, false);
        self.forget_private(call);
        self.begin_prescan(step.first, call, first)
    }

    fn begin_prescan(&mut self, number: u32, call: &Call, first: usize) -> Result<(), Fault> {
        self.state.memory.set_bit(call.prescanned, true);
        let flags = self.state.status;
        self.begin_library(call.logic, Mode::Prescan, Link::SafetyPrescan(number, flags), first)
    }

    /// Begins a body of the library, which is at work from here on.
    fn begin_library(&mut self, body: BodyIndex, mode: Mode, link: Link, bound: usize) -> Result<(), Fault> {
        let within = core::mem::replace(&mut self.state.in_library, true);
        if !within {
            self.begun_in_library = 0;
        }
        self.begin(body, mode, link, bound).inspect_err(|_| self.state.in_library = within)
    }

    /// Private state gets its initial values, and no time has passed for its timers.
    fn forget_private(&mut self, call: &Call) {
        let ladder = self.ladder;
        let private = call.private;
        let bits = private.bit as usize..private.bit.saturating_add(private.bits) as usize;
        for (cell, value) in bits.clone().zip(ladder.initial_bits.get(bits).unwrap_or(&[])) {
            self.state.memory.set_bit(cell as u32, *value);
        }
        let words = private.word as usize..private.word.saturating_add(private.words) as usize;
        for (cell, value) in words.clone().zip(ladder.initial_words.get(words.clone()).unwrap_or(&[])) {
            self.state.memory.set_word(cell as u32, *value);
        }
        self.state.memory.set_stamps(words, self.inputs.now_ms);
    }

    pub(super) fn leave_safety_prescan(&mut self, number: u32, flags: Flags) -> Flow {
        let ladder = self.ladder;
        match ladder.calls.get(number as usize).and_then(|call| call.prescan) {
            Some(body) => {
                self.enter(body, Mode::Normal, Link::SafetyPrescanned(number, flags), self.frame.bound);
                Flow::On
            }
            None => self.leave_safety_prescanned(number, flags),
        }
    }

    /// The prescan of the library's ladder has ended: that of the instruction too, or its first execution follows.
    pub(super) fn leave_safety_prescanned(&mut self, number: u32, flags: Flags) -> Flow {
        self.pop_frame();
        self.state.in_library = false;
        self.state.status = flags;
        let ladder = self.ladder;
        let Some(call) = ladder.calls.get(number as usize) else { return Flow::On };
        if self.frame.mode == Mode::Normal {
            let result = self.execute_safety(number, call, self.state.bound.len());
            return self.after(result);
        }
        self.write_bit_cell(call.enable_in, false);
        self.write_bit_cell(call.enable_out, false);
        self.finish_call(false);
        Flow::On
    }
}
