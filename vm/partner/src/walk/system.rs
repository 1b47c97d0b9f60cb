//! GSV, SSV and EVENT. general-instructions.md A.8, A.10; REQ-EXEC-019.

use twinrung_bytecode::observer::Observer;

use super::Walker;
use super::bit::at;
use super::copy::Stretch;
use super::fault::{Fault, SUBSCRIPT};
use super::math::element_of;
use super::value::low_bits;
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

    /// The destination or source of a system value: as many elements as the attribute has must lie there.
    fn system_data(&mut self, arguments: &[Argument]) -> Result<Option<(SystemValue, Stretch)>, Fault> {
        let data = self.stretch(at(arguments, 1))?;
        let (Some(value), Some(data)) = (self.system_value(at(arguments, 0)), data) else { return Ok(None) };
        if value.length > data.count { Err(SUBSCRIPT) } else { Ok(Some((value, data))) }
    }

    pub(super) fn gets_system_value(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        if let Some((value, data)) = self.system_data(arguments)? {
            for number in 0..value.length {
                let word = self.system_word(&value, number);
                let place = data.element_place(number);
                self.write_word(place, low_bits(word, element_of(place)));
            }
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

    pub(super) fn sets_system_value(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(input);
        }
        if let Some((value, data)) = self.system_data(arguments)? {
            let Some(program) = value.record_of else { return Ok(input) };
            let mut record = [0i32; RECORD_WORDS];
            for (number, word) in record.iter_mut().take(value.length as usize).enumerate() {
                *word = self.value_at(data.element_place(number as u32)).bits;
            }
            if let Some(own) = self.state.records.get_mut(program.position()) {
                *own = record;
            }
        }
        Ok(input)
    }
}
