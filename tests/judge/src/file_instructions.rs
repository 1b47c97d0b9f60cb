//! FAL and FSC. general-instructions.md A.6.

use twinrung_bytecode::limits;
use twinrung_catalog::Opcode;
use twinrung_catalog::types::base::CONTROL;
use twinrung_compiler::operand::{Expression, Operand};
use twinrung_compiler::project::OperandUse;

use crate::arithmetic::Number;
use crate::evaluator::{Exit, Judge};
use crate::expressions::holds_real;
use crate::memory::{Frame, Target, member};

struct Control {
    length: Target,
    position: Target,
    enabled: Target,
    done: Target,
    error: Target,
    inhibit: Target,
    found: Target,
}

impl Control {
    fn of(target: &Target) -> Control {
        let part = |name| target.part(member(&CONTROL, name));
        Control {
            length: part("LEN"),
            position: part("POS"),
            enabled: part("EN"),
            done: part("DN"),
            error: part("ER"),
            inhibit: part("IN"),
            found: part("FD"),
        }
    }
}

impl Judge<'_> {
    pub(crate) fn file(
        &mut self,
        frame: &Frame<'_>,
        opcode: Opcode,
        operands: &[OperandUse],
        condition: bool,
    ) -> Result<(), Exit> {
        let target = self.target(frame, operands[0])?;
        let control = Control::of(&target);
        if frame.prescanning {
            for flag in [&control.enabled, &control.done, &control.error] {
                self.memory.set_bit(flag, false);
            }
            return Ok(());
        }
        let Operand::Choice(mode) = *self.operand(frame, operands[3]) else { panic!("no mode") };
        let search = opcode == Opcode::Fsc;
        if self.memory.bit(if search { &control.inhibit } else { &control.error }) {
            return Ok(());
        }
        let count = match mode {
            0 => self.edge(&control, condition, true, search),
            -1 => self.edge(&control, condition, false, search),
            elements => self.by_execution(&target, &control, condition, elements as u32, search),
        };
        if count == 0 {
            return Ok(());
        }
        self.run(frame, operands, &control, count, search)?;
        // The execution that completed the run last is the one that counts (REQ-EXEC-071).
        if self.memory.bit(&control.done) {
            if condition {
                self.completed_on_false.remove(&target);
            } else {
                self.completed_on_false.insert(target);
            }
        }
        Ok(())
    }

    /// ALL and INC: how many elements to process now.
    fn edge(&mut self, control: &Control, condition: bool, all: bool, search: bool) -> u32 {
        let count = if all { u32::MAX } else { 1 };
        let hit = search && self.memory.bit(&control.found);
        if !condition {
            self.memory.set_bit(&control.enabled, false);
            if self.memory.bit(&control.done) {
                self.memory.set_bit(&control.done, false);
                self.memory.set_integer(&control.position, 0);
            }
            return 0;
        }
        if !self.memory.bit(&control.enabled) {
            self.memory.set_bit(&control.enabled, true);
            if all {
                self.memory.set_integer(&control.position, 0);
            } else if hit {
                self.pass_hit(control);
            }
            self.memory.set_bit(&control.done, false);
            if search {
                self.memory.set_bit(&control.found, false);
            }
            return count;
        }
        if all && hit && !self.memory.bit(&control.done) {
            self.pass_hit(control);
            return count;
        }
        0
    }

    /// Mode n: how many elements to process now.
    fn by_execution(
        &mut self,
        target: &Target,
        control: &Control,
        condition: bool,
        elements: u32,
        search: bool,
    ) -> u32 {
        if !self.memory.bit(&control.enabled) {
            if !condition {
                return 0;
            }
            self.memory.set_bit(&control.enabled, true);
            self.memory.set_bit(&control.done, false);
            if search {
                self.memory.set_bit(&control.found, false);
            }
            self.memory.set_integer(&control.position, 0);
            self.completed_on_false.remove(target);
            return elements;
        }
        if !self.memory.bit(&control.done) {
            if search && self.memory.bit(&control.found) {
                self.pass_hit(control);
            }
            return elements;
        }
        if self.completed_on_false.remove(target) || !condition {
            self.memory.set_bit(&control.enabled, false);
            self.memory.set_bit(&control.done, false);
            self.memory.set_integer(&control.position, 0);
        }
        0
    }

    fn pass_hit(&mut self, control: &Control) {
        self.memory.set_bit(&control.found, false);
        let position = self.memory.integer(&control.position);
        self.memory.set_integer(&control.position, position.wrapping_add(1));
    }

    fn run(
        &mut self,
        frame: &Frame<'_>,
        operands: &[OperandUse],
        control: &Control,
        count: u32,
        search: bool,
    ) -> Result<(), Exit> {
        if self.memory.integer(&control.length) < 0 || self.memory.integer(&control.position) < 0 {
            return Err(Exit::Fault(21));
        }
        if self.memory.integer(&control.length) > limits::ARRAY_ELEMENTS as i32 {
            return Err(Exit::Fault(20));
        }
        if !search {
            self.clear_flags(frame);
        }
        for processed in 0..count {
            let position = self.memory.integer(&control.position);
            if position >= self.memory.integer(&control.length) {
                break;
            }
            // A run whose own POS or LEN is its destination would never end (REQ-EXEC-072).
            if processed == limits::ARRAY_ELEMENTS {
                return Err(Exit::Fault(20));
            }
            if frame.counts {
                self.flags.executed += 1;
            }
            let stops = if search {
                self.search_one(frame, operands, control)?
            } else {
                self.compute_one(frame, operands, control)?
            };
            if stops {
                return Ok(());
            }
            // The expression may have changed POS itself through the destination.
            let position = self.memory.integer(&control.position);
            self.memory.set_integer(&control.position, position.wrapping_add(1));
        }
        if self.memory.integer(&control.position) >= self.memory.integer(&control.length) {
            self.memory.set_bit(&control.done, true);
        }
        Ok(())
    }

    fn compute_one(&mut self, frame: &Frame<'_>, operands: &[OperandUse], control: &Control) -> Result<bool, Exit> {
        let expression = self.file_expression(frame, operands[5]);
        let real = holds_real(expression) || self.is_real(frame, operands[4]);
        let value = self.expression(frame, expression, real)?;
        let target = self.target(frame, operands[4])?;
        self.store_with_flags(frame, &target, (value, false));
        if self.flags.overflow {
            self.memory.set_bit(&control.error, true);
        }
        Ok(self.flags.overflow)
    }

    fn search_one(&mut self, frame: &Frame<'_>, operands: &[OperandUse], control: &Control) -> Result<bool, Exit> {
        let expression = self.file_expression(frame, operands[4]);
        let hit = match self.expression(frame, expression, holds_real(expression))? {
            Number::Integer(value) => value != 0,
            Number::Real(value) => value != 0.0,
        };
        if hit {
            self.memory.set_bit(&control.found, true);
            self.memory.set_bit(&control.inhibit, true);
        }
        Ok(hit)
    }

    fn file_expression<'a>(&self, frame: &Frame<'a>, operand: OperandUse) -> &'a Expression {
        match frame.project.operand(operand.id) {
            Operand::Expression(expression) => expression,
            other => panic!("no expression: {other:?}"),
        }
    }
}
