//! GSV, SSV and EVENT. general-instructions.md A.8 and A.10.

use twinrung_bytecode::observer::Observer;

use super::cells::Cells;
use super::{FaultCode, Run};
use crate::program::{CopyPlan, Instruction, Operand, SystemValue};

impl<O: Observer> Run<'_, O> {
    fn system(&self, instruction: Instruction) -> Option<(SystemValue, CopyPlan)> {
        let Operand::SystemValue(index) = self.program.operand(instruction.operands, 2) else { return None };
        let value = self.program.system_values.get(usize::from(index))?;
        let plan = self.program.copies.get(instruction.extra as usize)?;
        Some((*value, *plan))
    }

    fn data(&mut self, instruction: Instruction) -> Result<(Cells, u32), FaultCode> {
        let operand = self.program.operand(instruction.operands, 3);
        let cells = match operand.location() {
            Some(location) => self.cells(location)?,
            None => Cells { bit: 0, word: 0, skipped: 0 },
        };
        Ok((cells, cells.skipped))
    }

    /// GSV with a true rung. A destination that is too small is a minor fault 4/7 and stays as it is.
    pub(super) fn get_system_value(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let Some((value, plan)) = self.system(instruction) else { return Ok(()) };
        let (cells, skipped) = self.data(instruction)?;
        let side = plan.destination;
        let room = side.count.saturating_sub(skipped).min(plan.length);
        let bytes = value.element.bytes().saturating_mul(value.length);
        if room.saturating_mul(side.bytes) < bytes {
            self.minor_fault();
            return Ok(());
        }
        self.gather(cells, side, room);
        let record = value.record_of.and_then(|program| self.machine.records.get(usize::from(program)).copied());
        let width = value.element.bytes() as usize;
        for index in 0..value.length as usize {
            let number = match &record {
                Some(record) => record.get(index).copied(),
                None => self.inputs.system_values.get((value.first as usize).saturating_add(index)).copied(),
            };
            let number = number.unwrap_or(0).to_le_bytes();
            let at = index.saturating_mul(width);
            for (target, byte) in self.machine.copied.iter_mut().skip(at).zip(number).take(width) {
                *target = byte;
            }
        }
        self.scatter(cells, side, room, bytes);
        Ok(())
    }

    /// SSV with a true rung: a program's MajorFaultRecord. Too little data is a minor fault 4/6.
    pub(super) fn set_system_value(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let Some((value, plan)) = self.system(instruction) else { return Ok(()) };
        let (cells, skipped) = self.data(instruction)?;
        let side = plan.source;
        let room = side.count.saturating_sub(skipped).min(plan.length);
        let bytes = value.element.bytes().saturating_mul(value.length);
        let (true, Some(program)) = (room.saturating_mul(side.bytes) >= bytes, value.record_of) else {
            self.minor_fault();
            return Ok(());
        };
        self.gather(cells, side, room);
        let (numbers, _) = self.machine.copied.as_chunks::<4>();
        if let Some(record) = self.machine.records.get_mut(usize::from(program)) {
            for (word, bytes) in record.iter_mut().zip(numbers) {
                *word = i32::from_le_bytes(*bytes);
            }
        }
        Ok(())
    }

    /// EVENT with a true rung.
    pub(super) fn event(&mut self, instruction: Instruction) {
        if let Operand::EventTask(task) = self.program.operand(instruction.operands, 0)
            && let Some(count) = self.machine.events.get_mut(usize::from(task))
        {
            *count = count.saturating_add(1);
        }
    }
}
