//! GSV, SSV and EVENT. general-instructions.md A.8, A.10; REQ-EXEC-019.

use twinrung_bytecode::limits;
use twinrung_bytecode::observer::Observer;

use super::Walker;
use super::bit::at;
use super::copy::Stretch;
use super::fault::{Fault, SUBSCRIPT};
use crate::ladder::{Argument, SystemValue};
use crate::state::RECORD_WORDS;

impl<O: Observer> Walker<'_, O> {
    pub(super) fn triggers(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if let (true, Argument::EventTask(task)) = (input, at(arguments, 0))
            && let Some(count) = self.state.events.get_mut(usize::from(task))
        {
            *count = count.saturating_add(1);
        }
        Ok(input)
    }

    fn system_value(&self, argument: Argument) -> Option<SystemValue> {
        match argument {
            Argument::SystemValue(index) => self.ladder.system_values.get(usize::from(index)).copied(),
            _ => None,
        }
    }

    /// The destination or source of a system value, and how many bytes the value has: they must lie there.
    fn system_data(&mut self, arguments: &[Argument]) -> Result<Option<(SystemValue, Stretch, u32)>, Fault> {
        let data = self.stretch(at(arguments, 1))?;
        let (Some(value), Some(data)) = (self.system_value(at(arguments, 0)), data) else { return Ok(None) };
        let bytes = value.width.saturating_mul(value.length);
        if data.holds(bytes) { Ok(Some((value, data, bytes))) } else { Err(SUBSCRIPT) }
    }

    pub(super) fn gets_system_value(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        if let Some((value, data, bytes)) = self.system_data(arguments)? {
            // What lies beyond the value in its last field stays as it is gathered.
            self.gather(&data, bytes);
            for number in 0..value.length.min(limits::COPY_BYTES) {
                let word = self.system_word(&value, number);
                self.hold_word(number.saturating_mul(value.width), value.width, word);
            }
            self.scatter(&data, bytes);
        }
        Ok(input)
    }

    fn system_word(&self, value: &SystemValue, number: u32) -> i32 {
        match value.record_of {
            Some(program) => {
                let record = self.state.records.get(program.position());
                record.and_then(|record| record.get(number as usize)).copied().unwrap_or(0)
            }
            None => {
                let position = value.first.saturating_add(number) as usize;
                self.inputs.system_values.get(position).copied().unwrap_or(0)
            }
        }
    }

    /// Only the MajorFaultRecord can be set.
    pub(super) fn sets_system_value(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        if let Some((value, data, bytes)) = self.system_data(arguments)? {
            let Some(program) = value.record_of else { return Ok(input) };
            self.gather(&data, bytes);
            let mut record = [0i32; RECORD_WORDS];
            for (word, position) in record.iter_mut().zip((0..bytes).step_by(4)) {
                *word = self.held_word(position);
            }
            if let Some(own) = self.state.records.get_mut(program.position()) {
                *own = record;
            }
        }
        Ok(input)
    }
}
