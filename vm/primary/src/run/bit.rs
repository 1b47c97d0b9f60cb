//! Contacts, coils and one-shots in the order of the text. general-instructions.md A.1.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::{FaultCode, Run};
use crate::program::Operand;

impl<O: Observer> Run<'_, O> {
    /// XIC and XIO. With a false rung they do not look at their bit.
    pub(super) fn contact(&mut self, opcode: Opcode, operand: Operand, input: bool) -> Result<bool, FaultCode> {
        if !input {
            return Ok(false);
        }
        let set = self.bit_operand(operand)?;
        Ok(set == (opcode == Opcode::Xic))
    }

    /// OTE, OTL and OTU.
    pub(super) fn coil(&mut self, opcode: Opcode, operand: Operand, input: bool) -> Result<(), FaultCode> {
        if opcode != Opcode::Ote && !input {
            return Ok(());
        }
        let slot = self.slot(operand)?;
        let value = match opcode {
            Opcode::Ote => input,
            Opcode::Otl => true,
            _ => false,
        };
        self.put_slot_bit(slot, value);
        Ok(())
    }

    /// ONS.
    pub(super) fn one_shot(&mut self, storage: Operand, input: bool) -> Result<bool, FaultCode> {
        let slot = self.slot(storage)?;
        let out = input && !self.bit_of(slot);
        self.put_slot_bit(slot, input);
        Ok(out)
    }

    /// OSR and OSF.
    pub(super) fn one_shot_output(
        &mut self,
        opcode: Opcode,
        storage: Operand,
        output: Operand,
        input: bool,
    ) -> Result<(), FaultCode> {
        let (storage, output) = (self.slot(storage)?, self.slot(output)?);
        let was = self.bit_of(storage);
        let pulse = if opcode == Opcode::Osr { input && !was } else { !input && was };
        self.put_slot_bit(storage, input);
        self.put_slot_bit(output, pulse);
        Ok(())
    }
}
