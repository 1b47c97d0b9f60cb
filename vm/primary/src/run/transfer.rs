//! Values on their way into and out of routines: JSR, SBR, RET, and the arguments of Add-On Instructions. Every source is
//! read before anything is written, but for the outputs of Add-On Instructions.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::{FaultCode, PARAMETERS, Run};
use crate::machine::{Slot, TRANSFERS};
use crate::number::Number;
use crate::program::{Instruction, Operand, Program, Range};

/// The inputs of a JSR, or its returns.
pub(crate) fn jsr_operands(program: &Program, instruction: Instruction, returns: bool) -> Range {
    let Range { first, count } = instruction.operands;
    let inputs = match program.operand(instruction.operands, 1) {
        Operand::Integer(inputs) => u32::try_from(inputs).unwrap_or(0),
        _ => 0,
    };
    let inputs = inputs.min(count.saturating_sub(2));
    let skipped = if returns { inputs.saturating_add(2) } else { 2 };
    let count = if returns { count.saturating_sub(skipped) } else { inputs };
    Range { first: first.saturating_add(skipped), count }
}

impl<O: Observer> Run<'_, O> {
    /// Evaluates operands and keeps their values.
    fn collect(&mut self, operands: Range) -> Result<(), FaultCode> {
        let program = self.program;
        let (mut bits, mut words) = (0usize, 0usize);
        for (index, operand) in operands.of(&program.operands).iter().enumerate() {
            let slot = self.slot(*operand)?;
            let number = self.number_of(slot);
            let machine = &mut *self.machine;
            if let Some(kept) = machine.slots.get_mut(index) {
                *kept = slot;
            }
            if let Some(kept) = machine.numbers.get_mut(index) {
                *kept = number;
            }
            if let Slot::Region { bit, bit_cells, word, word_cells } = slot {
                let source = machine.bits.iter().skip(bit as usize).take(bit_cells as usize);
                for (kept, source) in machine.passing_bits.iter_mut().skip(bits).zip(source) {
                    *kept = *source;
                }
                let source = machine.words.iter().skip(word as usize).take(word_cells as usize);
                for (kept, source) in machine.passing_words.iter_mut().skip(words).zip(source) {
                    *kept = *source;
                }
                bits = bits.saturating_add(bit_cells as usize);
                words = words.saturating_add(word_cells as usize);
            }
        }
        Ok(())
    }

    /// Evaluates the operands that receive.
    fn receive(&mut self, operands: Range) -> Result<(), FaultCode> {
        let program = self.program;
        for (index, operand) in operands.of(&program.operands).iter().enumerate() {
            let slot = self.slot(*operand)?;
            if let Some(kept) = self.machine.slots.get_mut(index) {
                *kept = slot;
            }
        }
        Ok(())
    }

    /// Writes the kept values to the receiving slots.
    fn hand_over(&mut self, count: u32) {
        let (mut bits, mut words) = (0usize, 0usize);
        for index in 0..(count as usize).min(TRANSFERS) {
            let slot = self.machine.slots.get(index).copied().unwrap_or(Slot::Constant(Number::Integer(0)));
            if let Slot::Region { bit, bit_cells, word, word_cells } = slot {
                for offset in 0..bit_cells.min(self.machine.passing_bits.len() as u32) {
                    let value = self.machine.passing_bits.get(bits).is_some_and(|bit| *bit != 0);
                    self.write_bit(bit.saturating_add(offset), value);
                    bits = bits.saturating_add(1);
                }
                for offset in 0..word_cells.min(self.machine.passing_words.len() as u32) {
                    let value = self.machine.passing_words.get(words).copied().unwrap_or(0);
                    self.write_word(word.saturating_add(offset), value);
                    words = words.saturating_add(1);
                }
                continue;
            }
            let number = self.machine.numbers.get(index).copied().unwrap_or(Number::Integer(0));
            if self.store(slot, number).1 {
                self.overflow();
            }
        }
    }

    /// Evaluates a JSR's inputs.
    pub(super) fn collect_inputs(&mut self, jsr: Instruction) -> Result<(), FaultCode> {
        self.collect(jsr_operands(self.program, jsr, false))
    }

    /// Evaluates the subscripts of a JSR's return operands and keeps what they select until its routine has ended
    /// (REQ-EXEC-023). The routine is not begun yet: its frame will be the next.
    pub(super) fn select_returns(&mut self, jsr: Instruction) -> Result<(), FaultCode> {
        let program = self.program;
        let first = self.first_return();
        for (index, operand) in jsr_operands(program, jsr, true).of(&program.operands).iter().enumerate() {
            let slot = self.slot(*operand)?;
            if let Some(kept) = self.machine.returns.get_mut(first.saturating_add(index)) {
                *kept = slot;
            }
        }
        Ok(())
    }

    /// Where the returns are kept of a routine whose frame has not begun or has just ended.
    fn first_return(&self) -> usize {
        self.machine.frames.len().saturating_mul(self.machine.most_returns)
    }

    /// Copies the inputs that were collected of a JSR to the SBR operands of the routine.
    pub(super) fn pass_inputs(&mut self, jsr: Instruction, body: u32) -> Result<(), FaultCode> {
        let inputs = jsr_operands(self.program, jsr, false);
        let parameters = self.program.bodies.get(body as usize).and_then(|body| {
            self.program.instructions.get(body.parameters as usize).map(|instruction| instruction.operands)
        });
        let parameters = parameters.unwrap_or_default();
        if parameters.count > inputs.count {
            return Err(PARAMETERS);
        }
        self.receive(parameters)?;
        self.hand_over(parameters.count);
        Ok(())
    }

    /// The fault of the user's own that the single input of a JSR to the fault routine names (A.8), once collected.
    pub(super) fn user_fault(&self, jsr: Instruction) -> Option<FaultCode> {
        if jsr_operands(self.program, jsr, false).count != 1 {
            return None;
        }
        match self.machine.numbers.first() {
            Some(Number::Integer(code @ 990..=999)) => u16::try_from(*code).ok().map(FaultCode),
            _ => None,
        }
    }

    /// Reads the operands of a RET.
    pub(super) fn gather_returns(&mut self, ret: Instruction) -> Result<(), FaultCode> {
        self.collect(ret.operands)
    }

    /// Copies what a RET gathered to what the return operands of its JSR selected before the routine began.
    pub(super) fn return_values(&mut self, jsr: u32, ret: Option<u32>, prescan: bool) -> Result<(), FaultCode> {
        let instruction = |index: u32| self.program.instructions.get(index as usize).copied();
        let (Some(jsr), Some(ret), false) = (instruction(jsr), ret.and_then(instruction), prescan) else {
            return Ok(());
        };
        let returns = jsr_operands(self.program, jsr, true);
        if ret.opcode != Opcode::Ret || returns.count > ret.operands.count {
            return Err(PARAMETERS);
        }
        let first = self.first_return();
        let machine = &mut *self.machine;
        for (slot, kept) in
            machine.slots.iter_mut().zip(machine.returns.iter().skip(first)).take(returns.count as usize)
        {
            *slot = *kept;
        }
        self.hand_over(returns.count);
        Ok(())
    }

    /// Copies the arguments of Input parameters of an Add-On call in: reads all, then writes.
    pub(super) fn copy_in(&mut self, arguments: Range) -> Result<(), FaultCode> {
        let program = self.program;
        let arguments = arguments.of(&program.arguments);
        for (index, argument) in arguments.iter().enumerate() {
            let value = self.number(program.operand_at(argument.outside))?;
            let slot = self.slot(program.operand_at(argument.inside))?;
            if let (Some(number), Some(kept)) = (self.machine.numbers.get_mut(index), self.machine.slots.get_mut(index))
            {
                *number = value;
                *kept = slot;
            }
        }
        self.hand_over(arguments.len() as u32);
        Ok(())
    }

    /// Copies the arguments of Output parameters of an Add-On call out, one after the other: what one writes may select
    /// the element of the next (REQ-EXEC-030).
    pub(super) fn copy_out(&mut self, arguments: Range) -> Result<(), FaultCode> {
        let program = self.program;
        for argument in arguments.of(&program.arguments) {
            let value = self.number(program.operand_at(argument.inside))?;
            let slot = self.slot(program.operand_at(argument.outside))?;
            if self.store(slot, value).1 {
                self.overflow();
            }
        }
        Ok(())
    }
}
