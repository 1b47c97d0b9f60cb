//! Comparisons. general-instructions.md A.4.

use twinrung_bytecode::format;
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::Walker;
use super::arithmetic;
use super::bit::at;
use super::fault::Fault;
use crate::ladder::Argument;

impl<O: Observer> Walker<'_, O> {
    pub(super) fn relation(&mut self, opcode: Opcode, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(false);
        }
        let left = self.number(at(arguments, 0))?;
        let right = self.number(at(arguments, 1))?;
        let operator = match opcode {
            Opcode::Equ => format::OPERATION_EQUAL,
            Opcode::Neq => format::OPERATION_NOT_EQUAL,
            Opcode::Grt => format::OPERATION_GREATER,
            Opcode::Geq => format::OPERATION_GREATER_OR_EQUAL,
            Opcode::Les => format::OPERATION_LESS,
            _ => format::OPERATION_LESS_OR_EQUAL,
        };
        Ok(arithmetic::compare(operator, left, right, left.is_real() || right.is_real()))
    }

    pub(super) fn limit(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(false);
        }
        let low = self.number(at(arguments, 0))?;
        let test = self.number(at(arguments, 1))?;
        let high = self.number(at(arguments, 2))?;
        let real = low.is_real() || test.is_real() || high.is_real();
        let not_above = |left, right| arithmetic::compare(format::OPERATION_LESS_OR_EQUAL, left, right, real);
        if not_above(low, high) {
            return Ok(not_above(low, test) && not_above(test, high));
        }
        // Neither order holds where a limit is NaN.
        let gap = arithmetic::compare(format::OPERATION_GREATER, low, high, real);
        Ok(gap && (not_above(low, test) || not_above(test, high)))
    }

    pub(super) fn masked_equal(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(false);
        }
        let source = self.number(at(arguments, 0))?.zero_filled();
        let mask = self.number(at(arguments, 1))?.zero_filled();
        let compare = self.number(at(arguments, 2))?.zero_filled();
        Ok(source & mask == compare & mask)
    }

    pub(super) fn compare_expression(&mut self, arguments: &[Argument], input: bool) -> Result<bool, Fault> {
        if !input {
            return Ok(false);
        }
        self.truth(at(arguments, 0))
    }

    /// An expression as a truth value: whether it is not 0.
    pub(super) fn truth(&mut self, expression: Argument) -> Result<bool, Fault> {
        let value = self.evaluate(expression)?;
        Ok(if value.is_real() { value.to_real() != 0.0 } else { value.bits != 0 })
    }
}
