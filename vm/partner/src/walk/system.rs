//! GSV, SSV and EVENT. general-instructions.md A.8, A.10.

use twinrung_bytecode::observer::Observer;

use super::Walker;
use super::bit::at;
use super::copy::Stretch;
use super::fault::Fault;
use crate::ladder::{Argument, SystemValue};
use crate::state::RECORD_WORDS;

impl<O: Observer> Walker<'_, O> {
    pub(super) fn triggers(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if let (true, Argument::EventTask(task)) = (input, at(arguments, 0)) {
            if let Some(count) = self.state.events.get_mut(usize::from(task)) {
                *count = count.saturating_add(1);
            }
        }
        Ok(input)
    }

    fn system_value(&self, argument: Argument) -> Option<SystemValue> {
        match argument {
            Argument::SystemValue(index) => self.ladder.system_values.get(usize::from(index)).copied(),
            _ => None,
        }
    }

    /// The elements that so many bytes reach into; `None` where the data is too small.
    fn covering(&self, data: &Stretch, bytes: u32) -> Option<u32> {
        let each = data.bytes();
        let elements = bytes.checked_add(each)?.checked_sub(1)?.checked_div(each)?;
        let room = self.has_room(elements.checked_mul(each)?);
        (elements <= data.count && room).then_some(elements)
    }

    pub(super) fn gets_system_value(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        let data = self.stretch(at(arguments, 1))?;
        let (Some(value), Some(data)) = (self.system_value(at(arguments, 0)), data) else { return Ok(input) };
        let each = value.element.bytes();
        let bytes = each.saturating_mul(value.length);
        let Some(elements) = self.covering(&data, bytes) else {
            // Minor fault 4/7: the destination is too small.
            self.state.log_minor_fault();
            return Ok(input);
        };
        self.gather(&data, elements);
        for number in 0..value.length {
            let word = self.system_word(&value, number).to_le_bytes();
            let position = number.saturating_mul(each) as usize;
            let to = self.state.bytes.get_mut(position..position.saturating_add(each as usize));
            if let (Some(to), Some(from)) = (to, word.get(..each as usize)) {
                to.copy_from_slice(from);
            }
        }
        self.scatter(&data, elements);
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

    pub(super) fn sets_system_value(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        let data = self.stretch(at(arguments, 1))?;
        let (Some(value), Some(data)) = (self.system_value(at(arguments, 0)), data) else { return Ok(input) };
        let bytes = value.element.bytes().saturating_mul(value.length);
        let (Some(program), Some(elements)) = (value.record_of, self.covering(&data, bytes)) else {
            // Minor fault 4/6: not enough data, or an attribute that nobody may write.
            self.state.log_minor_fault();
            return Ok(input);
        };
        self.gather(&data, elements);
        let mut record = [0i32; RECORD_WORDS];
        for (word, four) in record.iter_mut().zip(self.state.bytes.chunks_exact(4)) {
            if let Ok(four) = four.try_into() {
                *word = i32::from_le_bytes(four);
            }
        }
        if let Some(own) = self.state.records.get_mut(program.position()) {
            *own = record;
        }
        Ok(input)
    }
}
