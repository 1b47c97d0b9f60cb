//! GSV, SSV and EVENT. general-instructions.md A.8 and A.10.

use twinrung_bytecode::channel::FaultRecord;
use twinrung_bytecode::limits;
use twinrung_bytecode::observer::Observer;

use super::cells::Cells;
use super::{FaultCode, Run};
use crate::program::{CopyPlan, Instruction, Operand, SystemValue};

impl<O: Observer> Run<'_, O> {
    fn system_value(&self, instruction: Instruction) -> Option<SystemValue> {
        let Operand::SystemValue(index) = self.program.operand(instruction.operands, 2) else { return None };
        self.program.system_values.get(usize::from(index)).copied()
    }

    /// Where the data begins, with the bytes of its elements collected; a variable subscript may leave too few.
    fn data(&mut self, instruction: Instruction) -> Result<Option<(Cells, CopyPlan)>, FaultCode> {
        let Some(plan) = self.plan(instruction) else { return Ok(None) };
        let operand = self.program.operand(instruction.operands, 3);
        let cells = self.side_cells(operand, plan.destination, plan.length)?;
        self.gather(cells, plan.destination, plan.length, plan.bytes());
        Ok(Some((cells, plan)))
    }

    /// GSV with a true rung: the bytes of the attribute over those that lie there. REQ-EXEC-019.
    pub(super) fn get_system_value(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let Some(value) = self.system_value(instruction) else { return Ok(()) };
        let Some((cells, plan)) = self.data(instruction)? else { return Ok(()) };
        let record = value.record_of.and_then(|program| self.machine.records.get(usize::from(program)).copied());
        let width = value.element_bytes as usize;
        for index in 0..value.length.min(limits::COPY_BYTES) {
            let number = match &record {
                Some(record) => record.get(index as usize).copied(),
                None => self.inputs.system_values.get(value.first.saturating_add(index) as usize).copied(),
            };
            let bytes = number.unwrap_or(0).to_le_bytes();
            let first = (index as usize).saturating_mul(width);
            for (place, byte) in self.machine.copied.iter_mut().skip(first).zip(bytes).take(width) {
                *place = byte;
            }
        }
        self.scatter(cells, plan.destination, plan.length, value.bytes());
        Ok(())
    }

    /// SSV with a true rung: a program's MajorFaultRecord, all of whose elements are DINTs.
    pub(super) fn set_system_value(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let Some(program) = self.system_value(instruction).and_then(|value| value.record_of) else { return Ok(()) };
        if self.data(instruction)?.is_none() {
            return Ok(());
        }
        let mut record = FaultRecord::default();
        for (number, bytes) in record.iter_mut().zip(self.machine.copied.chunks_exact(size_of::<i32>())) {
            *number = i32::from_le_bytes(bytes.try_into().unwrap_or_default());
        }
        if let Some(slot) = self.machine.records.get_mut(usize::from(program)) {
            *slot = record;
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
