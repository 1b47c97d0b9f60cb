//! GSV, SSV and EVENT. general-instructions.md A.8 and A.10.

use twinrung_bytecode::observer::Observer;

use twinrung_catalog::Element;

use super::{FaultCode, Run, SUBSCRIPT};
use crate::number::narrowed;
use crate::program::{Content, CopyPlan, Instruction, Operand, Side, SystemValue};

impl<O: Observer> Run<'_, O> {
    fn system(&self, instruction: Instruction) -> Option<(SystemValue, CopyPlan)> {
        let Operand::SystemValue(index) = self.program.operand(instruction.operands, 2) else { return None };
        let value = self.program.system_values.get(usize::from(index))?;
        let plan = self.program.copies.get(instruction.extra as usize)?;
        Some((*value, *plan))
    }

    /// The first cell of the data, its type, and how many elements of an attribute fit.
    fn data(&mut self, instruction: Instruction, side: Side) -> Result<Option<(u32, Element, u32)>, FaultCode> {
        let operand = self.program.operand(instruction.operands, 3);
        let Some(location) = operand.location() else { return Ok(None) };
        let cells = self.cells(location)?;
        Ok(match side.content {
            Content::Element(element) => Some((cells.word, element, side.count.saturating_sub(cells.skipped))),
            Content::Structure(_) => None,
        })
    }

    /// GSV with a true rung. REQ-EXEC-019.
    pub(super) fn get_system_value(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let Some((value, plan)) = self.system(instruction) else { return Ok(()) };
        let data = self.data(instruction, plan.destination)?;
        let Some((word, element, room)) = data else { return Ok(()) };
        // The loader admits only data with room enough; a variable subscript may take it away.
        if room < value.length {
            return Err(SUBSCRIPT);
        }
        let record = value.record_of.and_then(|program| self.machine.records.get(usize::from(program)).copied());
        for index in 0..value.length {
            let number = match &record {
                Some(record) => record.get(index as usize).copied(),
                None => self.inputs.system_values.get(value.first.saturating_add(index) as usize).copied(),
            };
            let (kept, _) = narrowed(number.unwrap_or(0), element);
            self.write_word(word.saturating_add(index), kept as u32);
        }
        Ok(())
    }

    /// SSV with a true rung: a program's MajorFaultRecord.
    pub(super) fn set_system_value(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let Some((value, plan)) = self.system(instruction) else { return Ok(()) };
        let data = self.data(instruction, plan.source)?;
        let (Some((word, _, room)), Some(program)) = (data, value.record_of) else { return Ok(()) };
        if room < value.length {
            return Err(SUBSCRIPT);
        }
        let mut record = [0i32; 11];
        for (index, number) in (0u32..).zip(&mut record) {
            *number = self.machine.word(word.saturating_add(index));
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
