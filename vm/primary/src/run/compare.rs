//! Comparisons in the order of the text. general-instructions.md A.4.

use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::{FaultCode, Run};
use crate::number::{Number, Relation, zero_filled};
use crate::program::{Instruction, Operand};

/// The relation of a comparison with two operands.
pub(crate) fn relation(opcode: Opcode) -> Option<Relation> {
    Some(match opcode {
        Opcode::Equ => Relation::Equal,
        Opcode::Neq => Relation::NotEqual,
        Opcode::Grt => Relation::Greater,
        Opcode::Geq => Relation::GreaterOrEqual,
        Opcode::Les => Relation::Less,
        Opcode::Leq => Relation::LessOrEqual,
        _ => return None,
    })
}

impl<O: Observer> Run<'_, O> {
    /// A comparison with a true rung.
    pub(super) fn compare(&mut self, instruction: Instruction) -> Result<bool, FaultCode> {
        let operands = instruction.operands;
        let first = self.program.operand(operands, 0);
        if instruction.opcode == Opcode::Cmp {
            let value = self.expression_value(first)?;
            return Ok(is_true(value));
        }
        let (second, third) = (self.program.operand(operands, 1), self.program.operand(operands, 2));
        if let Some(relation) = relation(instruction.opcode) {
            let (left, right) = (self.number(first)?, self.number(second)?);
            return Ok(relation.of(left, right));
        }
        if instruction.opcode == Opcode::Lim {
            let (low, test, high) = (self.number(first)?, self.number(second)?, self.number(third)?);
            return Ok(within(low, test, high));
        }
        let (source, source_type) = self.integer(first)?;
        let (mask, mask_type) = self.integer(second)?;
        let (compared, compared_type) = self.integer(third)?;
        let mask = zero_filled(mask, mask_type);
        let differing = zero_filled(source, source_type) ^ zero_filled(compared, compared_type);
        Ok(differing & mask == 0)
    }

    /// The value of CPT's, CMP's, FAL's or FSC's expression.
    pub(super) fn expression_value(&mut self, operand: Operand) -> Result<Number, FaultCode> {
        let Operand::Expression { formula, real, .. } = operand else { return self.number(operand) };
        let value = self.value(formula)?;
        Ok(if real { Number::Real(f32::from_bits(value as u32)) } else { Number::Integer(value) })
    }
}

/// A number as a truth value.
pub(crate) fn is_true(value: Number) -> bool {
    match value {
        Number::Integer(value) => value != 0,
        Number::Real(value) => value != 0.0,
    }
}

/// LIM: within the limits, or outside the gap when low is above high; never with a NaN.
pub(crate) fn within(low: Number, test: Number, high: Number) -> bool {
    let (from, to) = match (low, test, high) {
        (Number::Integer(low), Number::Integer(test), Number::Integer(high)) => {
            return if low <= high { low <= test && test <= high } else { test >= low || test <= high };
        }
        _ => (low.real(), high.real()),
    };
    let test = test.real();
    if from <= to {
        from <= test && test <= to
    } else if from > to {
        test >= from || test <= to
    } else {
        false
    }
}
