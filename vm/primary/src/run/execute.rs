//! Executes one instruction, except those that change the flow.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::{FaultCode, Run, math};
use crate::program::Instruction;

impl<O: Observer> Run<'_, O> {
    /// Executes an instruction and gives the rung condition after it.
    pub(super) fn execute(&mut self, instruction: Instruction, input: bool) -> Result<bool, FaultCode> {
        let program = self.program;
        let first = program.operand(instruction.operands, 0);
        let second = || program.operand(instruction.operands, 1);
        match instruction.opcode {
            opcode @ (Opcode::Xic | Opcode::Xio) => return self.contact(opcode, first, input),
            Opcode::Ons => return self.one_shot(first, input),
            Opcode::Afi => return Ok(false),
            Opcode::Equ
            | Opcode::Neq
            | Opcode::Grt
            | Opcode::Geq
            | Opcode::Les
            | Opcode::Leq
            | Opcode::Lim
            | Opcode::Meq
            | Opcode::Cmp => return if input { self.compare(instruction) } else { Ok(false) },
            opcode @ (Opcode::Ote | Opcode::Otl | Opcode::Otu) => self.coil(opcode, first, input)?,
            opcode @ (Opcode::Osr | Opcode::Osf) => self.one_shot_output(opcode, first, second(), input)?,
            opcode @ (Opcode::Ton | Opcode::Tof | Opcode::Rto) => self.timer(opcode, first, input)?,
            opcode @ (Opcode::Ctu | Opcode::Ctd) => self.counter(opcode, first, input)?,
            Opcode::Fal | Opcode::Fsc => self.file(instruction, input)?,
            Opcode::Mcr if !input => {
                let rail = self.machine.bit(program.rail);
                self.machine.put_bit(program.rail, !rail);
            }
            opcode if opcode.instruction().group.is_safety_library() => self.safety(instruction, input, false)?,
            _ if input => self.act(instruction)?,
            _ => {}
        }
        Ok(input)
    }

    /// Instructions that do nothing with a false rung.
    fn act(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        let first = self.program.operand(instruction.operands, 0);
        match instruction.opcode {
            Opcode::Mov => self.move_number(instruction),
            Opcode::Mvm => self.masked_move(instruction),
            Opcode::Clr => self.clear(instruction),
            Opcode::Cop => self.copy(instruction),
            Opcode::Swpb => self.swap_bytes(instruction),
            Opcode::And | Opcode::Or | Opcode::Xor => self.logical(instruction),
            Opcode::Not => self.invert(instruction),
            Opcode::Cpt => self.compute(instruction),
            Opcode::Fll => self.fill(instruction),
            Opcode::Size => self.size(instruction),
            Opcode::Res => self.reset(first),
            Opcode::Gsv => self.get_system_value(instruction),
            Opcode::Ssv => self.set_system_value(instruction),
            Opcode::Event => {
                self.event(instruction);
                Ok(())
            }
            opcode => match (math::binary(opcode), math::unary(opcode)) {
                (Some(operator), _) => self.math_binary(operator, instruction),
                (None, Some(operator)) => self.math_unary(operator, instruction),
                (None, None) => Ok(()),
            },
        }
    }
}
