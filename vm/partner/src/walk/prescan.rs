//! What instructions do at prescan. general-instructions.md 2.7; REQ-EXEC-024.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::Walker;
use super::bit::at;
use super::fault::Fault;
use super::frame::{Link, Mode};
use crate::ladder::Step;

impl<O: Observer> Walker<'_, O> {
    /// Visits an instruction with a false rung.
    pub(super) fn prescan_instruction(&mut self, step: Step, opcode: Opcode) -> Result<(), Fault> {
        let ladder = self.ladder;
        if opcode == Opcode::Jsr {
            return self.prescan_subroutine(step);
        }
        let arguments = ladder.arguments(step);
        match opcode {
            Opcode::Ote => {
                let location = self.locate(at(arguments, 0))?;
                self.write_bit(location, false);
            }
            Opcode::Ons => {
                let storage = self.locate(at(arguments, 0))?;
                self.write_bit(storage, true);
            }
            Opcode::Osr | Opcode::Osf => {
                let storage = self.locate(at(arguments, 0))?;
                let output = self.locate(at(arguments, 1))?;
                self.write_bit(storage, opcode == Opcode::Osr);
                self.write_bit(output, false);
            }
            Opcode::Ton | Opcode::Tof | Opcode::Rto | Opcode::Ctu | Opcode::Ctd => {
                self.prescan_timer(opcode, at(arguments, 0))?;
            }
            Opcode::Fal | Opcode::Fsc => self.prescan_file(at(arguments, 0))?,
            _ => {}
        }
        self.report(step, false, false);
        Ok(())
    }

    /// The first JSR of the program that reaches a routine prescans it; nothing is passed.
    fn prescan_subroutine(&mut self, step: Step) -> Result<(), Fault> {
        let body = self.ladder.subroutines.get(step.first as usize).map(|call| call.body);
        if let Some(body) = body
            && self.visit(body)
        {
            let bound = self.state.bound.len();
            return self.begin(body, Mode::Prescan, Link::Subroutine(step.first), bound);
        }
        self.report(step, false, false);
        Ok(())
    }
}
