//! Contacts, coils, latches and one-shots. general-instructions.md A.1.

use twinrung_bytecode::format;
use twinrung_bytecode::observer::Observer;

use super::Walker;
use super::fault::Fault;
use crate::ladder::{Argument, Location};
use crate::state::{CARRY, NEGATIVE, OVERFLOW, ZERO};

/// The argument at a position; a gap in admission reads as nothing.
pub(super) fn at(arguments: &[Argument], index: usize) -> Argument {
    arguments.get(index).copied().unwrap_or(Argument::Nothing)
}

impl<O: Observer> Walker<'_, O> {
    /// The value of a bit operand that is only read.
    pub(super) fn condition(&mut self, argument: Argument) -> Result<bool, Fault> {
        Ok(match argument {
            Argument::Integer(value) => value != 0,
            Argument::Status(keyword) => self.status_bit(keyword),
            other => {
                let location = self.locate(other)?;
                self.bit_at(location)
            }
        })
    }

    pub(super) fn status_bit(&self, keyword: u8) -> bool {
        let status = &self.state.status;
        match keyword {
            format::STATUS_OVERFLOW => status.key & OVERFLOW != 0,
            format::STATUS_ZERO => status.key & ZERO != 0,
            format::STATUS_NEGATIVE => status.key & NEGATIVE != 0,
            format::STATUS_CARRY => status.key & CARRY != 0,
            format::STATUS_MINOR => status.minor_faults != 0,
            _ => self.state.memory.bit(self.ladder.own.first_scan_bit),
        }
    }

    pub(super) fn contact(&mut self, arguments: &[Argument], closed: bool, input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(false);
        }
        Ok(self.condition(at(arguments, 0))? == closed)
    }

    pub(super) fn coil(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        let location = self.locate(at(arguments, 0))?;
        self.write_bit(location, input);
        Ok(input)
    }

    pub(super) fn latch(&mut self, arguments: &[Argument], value: bool, input: bool) -> Result<bool, Fault> {
        if input {
            let location = self.locate(at(arguments, 0))?;
            self.write_bit(location, value);
        }
        Ok(input)
    }

    pub(super) fn one_shot(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        let storage = self.locate(at(arguments, 0))?;
        let stored = self.bit_at(storage);
        self.write_bit(storage, input);
        Ok(input && !stored)
    }

    fn storage_and_output(&mut self, arguments: &[Argument]) -> Result<(Location, Location), Fault> {
        let storage = self.locate(at(arguments, 0))?;
        let output = self.locate(at(arguments, 1))?;
        Ok((storage, output))
    }

    pub(super) fn one_shot_rising(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        let (storage, output) = self.storage_and_output(arguments)?;
        let stored = self.bit_at(storage);
        self.write_bit(storage, input);
        self.write_bit(output, input && !stored);
        Ok(input)
    }

    pub(super) fn one_shot_falling(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        let (storage, output) = self.storage_and_output(arguments)?;
        let stored = self.bit_at(storage);
        self.write_bit(storage, input);
        self.write_bit(output, !input && stored);
        Ok(input)
    }
}
