//! Arithmetic. general-instructions.md A.9.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::{Element, Opcode};

use super::{FaultCode, Run};
use crate::machine::Slot;
use crate::number::{Binary, Number, Unary, integer_binary, integer_unary, real_binary, real_unary};
use crate::program::Instruction;

/// The operator of a math instruction with two sources.
pub(crate) fn binary(opcode: Opcode) -> Option<Binary> {
    Some(match opcode {
        Opcode::Add => Binary::Add,
        Opcode::Sub => Binary::Subtract,
        Opcode::Mul => Binary::Multiply,
        Opcode::Div => Binary::Divide,
        Opcode::Mod => Binary::Modulo,
        _ => return None,
    })
}

/// The operator of a math instruction with one source.
pub(crate) fn unary(opcode: Opcode) -> Option<Unary> {
    Some(match opcode {
        Opcode::Sqr => Unary::SquareRoot,
        Opcode::Neg => Unary::Negate,
        Opcode::Abs => Unary::Absolute,
        _ => return None,
    })
}

fn is_real(slot: Slot) -> bool {
    matches!(slot, Slot::Word { element: Element::Real, .. })
}

impl<O: Observer> Run<'_, O> {
    /// ADD SUB MUL DIV MOD with a true rung. REAL when a source or the destination is (2.2).
    pub(super) fn math_binary(&mut self, operator: Binary, instruction: Instruction) -> Result<(), FaultCode> {
        self.clear_status();
        let left = self.number(self.program.operand(instruction.operands, 0))?;
        let right = self.number(self.program.operand(instruction.operands, 1))?;
        let slot = self.slot(self.program.operand(instruction.operands, 2))?;
        let outcome = match (left, right) {
            (Number::Integer(left), Number::Integer(right)) if !is_real(slot) => integer_binary(operator, left, right),
            _ => real_binary(operator, left.real(), right.real()),
        };
        self.conclude(slot, outcome.value, outcome.overflow, outcome.carry);
        Ok(())
    }

    /// SQR NEG ABS with a true rung.
    pub(super) fn math_unary(&mut self, operator: Unary, instruction: Instruction) -> Result<(), FaultCode> {
        self.clear_status();
        let source = self.number(self.program.operand(instruction.operands, 0))?;
        let slot = self.slot(self.program.operand(instruction.operands, 1))?;
        let outcome = match source {
            Number::Integer(source) if !is_real(slot) => integer_unary(operator, source),
            _ => real_unary(operator, source.real()),
        };
        self.conclude(slot, outcome.value, outcome.overflow, false);
        Ok(())
    }

    /// CPT with a true rung.
    pub(super) fn compute(&mut self, instruction: Instruction) -> Result<(), FaultCode> {
        self.clear_status();
        let slot = self.slot(self.program.operand(instruction.operands, 0))?;
        let value = self.expression_value(self.program.operand(instruction.operands, 1))?;
        self.conclude(slot, value, false, false);
        Ok(())
    }
}
