//! How execution moves: along codes or steps, through rungs, branches, jumps, and out of bodies.

use twinrung_bytecode::channel::ScanEnd;
use twinrung_bytecode::limits;
use twinrung_bytecode::observer::{ElementUpset, Observer};
use twinrung_catalog::Opcode;

use super::path::Event;
use super::{FaultCode, LOOPS, NO_LABEL, Run, upset};
use crate::machine::{BRANCHES, Frame, Role};
use crate::program::{Code, NONE, Single, Step};

/// What an element did to the flow.
pub(crate) enum Next {
    /// It gave this rung condition.
    Out(bool),
    /// The frames changed: the frame on top goes on.
    Switched,
    /// The scan has executed more than its budget.
    Exhausted,
    /// Its body ends; with the parameters of this RET, or without.
    Ends { with: Option<u32> },
}

impl<O: Observer> Run<'_, O> {
    /// Goes along steps until the frames change.
    pub(super) fn by_steps(&mut self, mut frame: Frame) -> Result<(), ScanEnd> {
        loop {
            match self.program.steps.get(frame.position as usize).copied() {
                Some(Step::Block { runs, instructions }) => {
                    self.machine.spent = self.machine.spent.saturating_add(u64::from(instructions));
                    self.block(runs);
                    frame.position = frame.position.saturating_add(1);
                }
                Some(Step::Single(single)) => {
                    frame.rung = single.rung;
                    self.save(frame);
                    let input = self.machine.bit(single.input);
                    match self.element(single.code, input, &frame) {
                        Ok(Next::Out(out)) => {
                            self.machine.put_bit(single.output, out);
                            frame.position = frame.position.saturating_add(1);
                        }
                        Ok(Next::Switched) => return Ok(()),
                        Ok(Next::Exhausted) => return Err(ScanEnd::BudgetExceeded),
                        Ok(Next::Ends { with }) => {
                            self.machine.went(Event::Leaves { rung: frame.rung });
                            return self.finish(with);
                        }
                        Err(code) => return self.fault_at(code, single.code),
                    }
                }
                Some(Step::End { rungs }) => {
                    self.save(frame);
                    self.machine.went(Event::RunsOut { rungs });
                    return self.finish(None);
                }
                None => return self.finish(None),
            }
        }
    }

    /// Goes along codes until the frames change.
    pub(super) fn by_codes(&mut self, mut frame: Frame) -> Result<(), ScanEnd> {
        let Some(body) = self.program.bodies.get(frame.body as usize).copied() else {
            return self.finish(None);
        };
        let end = body.codes.first.saturating_add(body.codes.count);
        loop {
            let position = frame.position;
            let code = if position < end { self.program.codes.get(position as usize).copied() } else { None };
            frame.position = position.saturating_add(1);
            match code {
                Some(Code::Rung) => {
                    frame.condition = !frame.prescan && (!body.of_program || self.machine.bit(self.program.rail));
                    if O::ACTIVE {
                        let place = self.place(&frame, 0);
                        self.observer.rung_entered(place);
                        self.upset_rung(&body, &mut frame);
                    }
                }
                Some(Code::EndRung) => {
                    self.machine.branches.truncate(frame.branches as usize);
                    frame.halted = false;
                    if O::ACTIVE && frame.resume != NONE {
                        // Once more (see `upset_rung`).
                        frame.position = frame.resume;
                        frame.resume = NONE;
                        continue;
                    }
                    frame.rung = frame.rung.saturating_add(1);
                    if frame.resume != NONE {
                        frame.position = frame.resume;
                        frame.resume = NONE;
                        frame.stepping = true;
                        self.save(frame);
                        return Ok(());
                    }
                }
                Some(Code::Branch) => self.open_branch(frame.condition),
                Some(Code::NextLeg) => {
                    if let Some((begin, passed)) = self.machine.branches.last_mut() {
                        *passed |= frame.condition;
                        frame.condition = *begin;
                    }
                }
                Some(Code::EndBranch) => {
                    if let Some((_, passed)) = self.machine.branches.pop() {
                        frame.condition |= passed;
                    }
                }
                Some(Code::Instruction(_) | Code::AddOn(_)) => {
                    self.save(frame);
                    let input = frame.condition;
                    let upset = self.element_upset(&frame, position);
                    if upset == ElementUpset::Skip {
                        continue;
                    }
                    let mut next = self.element(position, input, &frame);
                    if upset == ElementUpset::Repeat && matches!(next, Ok(Next::Out(_))) {
                        next = self.element(position, input, &frame);
                    }
                    match next.map(|next| upset::upset(next, upset)) {
                        Ok(Next::Out(out)) => {
                            self.report(&frame, position, input, out);
                            frame.condition = out;
                        }
                        Ok(Next::Switched) => return Ok(()),
                        Ok(Next::Exhausted) => return Err(ScanEnd::BudgetExceeded),
                        Ok(Next::Ends { with }) => {
                            self.report(&frame, position, input, input);
                            self.machine.went(Event::Leaves { rung: frame.rung });
                            return self.finish(with);
                        }
                        Err(code) => return self.fault_at(code, position),
                    }
                }
                None => {
                    self.save(frame);
                    self.machine.went(Event::RunsOut { rungs: frame.rung });
                    return self.finish(None);
                }
            }
        }
    }

    /// Writes the frame on top back.
    fn save(&mut self, frame: Frame) {
        if let Some(top) = self.machine.frames.last_mut() {
            *top = frame;
        }
    }

    fn open_branch(&mut self, condition: bool) {
        // As many as the deepest stack of bodies can have open.
        if self.machine.branches.len() < BRANCHES {
            self.machine.branches.push((condition, false));
        }
    }

    fn report(&mut self, frame: &Frame, code: u32, input: bool, out: bool) {
        if O::ACTIVE {
            let place = self.place(frame, self.element_of(code));
            self.observer.element_result(place, input, out);
        }
    }

    /// The place on the rung of an element.
    pub(super) fn element_of(&self, code: u32) -> u32 {
        match self.program.codes.get(code as usize) {
            Some(Code::Instruction(index)) => {
                self.program.instructions.get(*index as usize).map_or(0, |instruction| instruction.element)
            }
            Some(Code::AddOn(index)) => self.program.calls.get(*index as usize).map_or(0, |call| call.element),
            _ => 0,
        }
    }

    /// Executes one element.
    fn element(&mut self, code: u32, input: bool, frame: &Frame) -> Result<Next, FaultCode> {
        let index = match self.program.codes.get(code as usize) {
            Some(Code::Instruction(index)) => *index,
            Some(Code::AddOn(call)) => {
                self.retire(1);
                if self.runs_away() {
                    return Ok(Next::Exhausted);
                }
                return self.add_on(*call, input, frame.prescan);
            }
            _ => return Ok(Next::Out(input)),
        };
        self.retire(1);
        let Some(instruction) = self.program.instructions.get(index as usize).copied() else {
            return Ok(Next::Out(input));
        };
        match instruction.opcode {
            Opcode::Jmp if input => self.jump(instruction.extra, frame),
            Opcode::Jsr if self.runs_away() => Ok(Next::Exhausted),
            Opcode::Jsr if input || frame.prescan => self.subroutine(index, frame.prescan),
            Opcode::Ret if input => {
                self.gather_returns(instruction)?;
                Ok(Next::Ends { with: Some(index) })
            }
            Opcode::Tnd if input => Ok(Next::Ends { with: None }),
            _ if frame.prescan => self.prescan_instruction(instruction).map(|()| Next::Out(false)),
            _ => self.execute(instruction, input).map(Next::Out),
        }
    }

    /// JMP, taken.
    fn jump(&mut self, index: u32, frame: &Frame) -> Result<Next, FaultCode> {
        let jump = *self.program.jumps.get(index as usize).ok_or(NO_LABEL)?;
        let label = *self.program.labels.get(jump.label as usize).ok_or(NO_LABEL)?;
        if jump.backward {
            let count = self.machine.backward_jumps(index).ok_or(NO_LABEL)?;
            if *count >= limits::BACKWARD_JUMPS {
                return Err(LOOPS);
            }
            *count = count.saturating_add(1);
            if self.over_budget() {
                return Ok(Next::Exhausted);
            }
        } else if self.runs_away() {
            return Ok(Next::Exhausted);
        }
        if !frame.stepping {
            self.report(frame, frame.position.saturating_sub(1), true, true);
        }
        self.machine.went(Event::Jumps { rung: label.rung });
        if let Some(top) = self.machine.frames.last_mut() {
            top.position = if top.stepping { label.step } else { label.code };
            top.rung = label.rung;
            if O::ACTIVE {
                top.resume = NONE;
            }
            let branches = top.branches as usize;
            self.machine.branches.truncate(branches);
        }
        Ok(Next::Switched)
    }

    /// Ends the body on top, and what called it goes on.
    fn finish(&mut self, with: Option<u32>) -> Result<(), ScanEnd> {
        let Some(frame) = self.machine.frames.pop() else { return Ok(()) };
        self.machine.branches.truncate(frame.branches as usize);
        match frame.role {
            Role::Main => Ok(()),
            Role::FaultPrescan => Ok(()),
            Role::Subroutine { instruction } => match self.return_values(instruction, with, frame.prescan) {
                Ok(()) => self.deliver(!frame.prescan),
                Err(code) => self.fault_caller(code),
            },
            Role::Logic { call } if frame.prescan => self.after_prescanned_logic(call),
            Role::Logic { call } => self.after_add_on(call),
            Role::EnableInFalse { call } => self.after_add_on(call),
            Role::Prescan { call } => self.after_add_on_prescan(call),
            Role::FaultRoutine { rail } => self.after_fault_routine(rail),
        }
    }

    /// Gives the element that called the body its rung condition.
    pub(super) fn deliver(&mut self, out: bool) -> Result<(), ScanEnd> {
        let Some(frame) = self.machine.frames.last().copied() else { return Ok(()) };
        if frame.stepping {
            if let Some(single) = self.single(&frame) {
                self.machine.put_bit(single.output, out);
            }
            if let Some(top) = self.machine.frames.last_mut() {
                top.position = top.position.saturating_add(1);
            }
        } else {
            let out = out && !frame.halted;
            self.report(&frame, frame.position.saturating_sub(1), frame.condition, out);
            if let Some(top) = self.machine.frames.last_mut() {
                top.condition = out;
            }
        }
        Ok(())
    }

    /// The instruction at which a stepping frame stands.
    pub(super) fn single(&self, frame: &Frame) -> Option<Single> {
        match self.program.steps.get(frame.position as usize) {
            Some(Step::Single(single)) => Some(*single),
            _ => None,
        }
    }
}
