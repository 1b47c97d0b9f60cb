//! Evaluates formulas: subscripts and expressions.

use twinrung_bytecode::format;
use twinrung_bytecode::observer::Observer;

use super::{FaultCode, Run, SUBSCRIPT};
use crate::number::{
    Binary, Number, Outcome, Relation, Unary, integer_binary, integer_unary, real_binary, real_unary, rounded,
    zero_filled,
};
use crate::program::FormulaOperation;

/// What an operator of the image format computes.
enum Operator {
    Unary(Unary),
    Binary(Binary),
    Relation(Relation),
}

fn operator(number: u8) -> Operator {
    match number {
        format::OPERATION_NEGATE => Operator::Unary(Unary::Negate),
        format::OPERATION_NOT => Operator::Unary(Unary::Not),
        format::OPERATION_ABSOLUTE => Operator::Unary(Unary::Absolute),
        format::OPERATION_SQUARE_ROOT => Operator::Unary(Unary::SquareRoot),
        format::OPERATION_MULTIPLY => Operator::Binary(Binary::Multiply),
        format::OPERATION_DIVIDE => Operator::Binary(Binary::Divide),
        format::OPERATION_MODULO => Operator::Binary(Binary::Modulo),
        format::OPERATION_SUBTRACT => Operator::Binary(Binary::Subtract),
        format::OPERATION_AND => Operator::Binary(Binary::And),
        format::OPERATION_XOR => Operator::Binary(Binary::Xor),
        format::OPERATION_OR => Operator::Binary(Binary::Or),
        format::OPERATION_LESS => Operator::Relation(Relation::Less),
        format::OPERATION_LESS_OR_EQUAL => Operator::Relation(Relation::LessOrEqual),
        format::OPERATION_GREATER => Operator::Relation(Relation::Greater),
        format::OPERATION_GREATER_OR_EQUAL => Operator::Relation(Relation::GreaterOrEqual),
        format::OPERATION_EQUAL => Operator::Relation(Relation::Equal),
        format::OPERATION_NOT_EQUAL => Operator::Relation(Relation::NotEqual),
        _ => Operator::Binary(Binary::Add),
    }
}

impl<O: Observer> Run<'_, O> {
    /// Evaluates a formula; its result is the first value or the first address. The loader has checked that the
    /// stacks suffice.
    pub(super) fn evaluate(&mut self, formula: u32) -> Result<(), FaultCode> {
        let program = self.program;
        let range = program.formulas.get(formula as usize).copied().unwrap_or_default();
        let (mut values, mut addresses) = (0usize, 0usize);
        for operation in range.of(&program.formula_operations) {
            match *operation {
                FormulaOperation::Push(value) => values = self.push_value(values, value),
                FormulaOperation::Load { word } => {
                    let value = self.machine.word(word);
                    values = self.push_value(values, value);
                }
                FormulaOperation::LoadAddress => {
                    addresses = addresses.saturating_sub(1);
                    let (_, word, _) = self.machine.addresses.get(addresses).copied().unwrap_or((0, 0, 0));
                    let value = self.machine.word(word);
                    values = self.push_value(values, value);
                }
                FormulaOperation::Address { bit, word } => {
                    if let Some(slot) = self.machine.addresses.get_mut(addresses) {
                        *slot = (bit, word, 0);
                    }
                    addresses = addresses.saturating_add(1);
                }
                FormulaOperation::Index { length, bit_stride, word_stride, elements } => {
                    values = values.saturating_sub(1);
                    let value = self.machine.values.get(values).copied().unwrap_or(0);
                    // An overflow while computing a subscript is the subscript's fault too (REQ-EXEC-012).
                    let sound = !self.has_overflowed(values);
                    let index = u32::try_from(value).ok().filter(|index| sound && *index < length).ok_or(SUBSCRIPT)?;
                    if let Some((bit, word, skipped)) = self.machine.addresses.get_mut(addresses.saturating_sub(1)) {
                        *bit = bit.saturating_add(index.saturating_mul(bit_stride));
                        *word = word.saturating_add(index.saturating_mul(word_stride));
                        *skipped = skipped.saturating_add(index.saturating_mul(elements));
                    }
                }
                FormulaOperation::ZeroFill(element) => {
                    let value = self.top(values);
                    self.replace(values, zero_filled(value, element));
                }
                FormulaOperation::ToReal => {
                    let value = self.top(values);
                    self.replace(values, (value as f32).to_bits() as i32);
                }
                FormulaOperation::ToInteger => {
                    let (value, lost) = rounded(f32::from_bits(self.top(values) as u32));
                    if lost {
                        self.overflow();
                        self.mark_overflow(values.saturating_sub(1));
                    }
                    self.replace(values, value);
                }
                FormulaOperation::Apply { operator: number, real } => values = self.apply(number, real, values),
            }
        }
        Ok(())
    }

    fn push_value(&mut self, values: usize, value: i32) -> usize {
        if let Some(slot) = self.machine.values.get_mut(values) {
            *slot = value;
        }
        if let Some(slot) = self.machine.overflowed.get_mut(values) {
            *slot = false;
        }
        values.saturating_add(1)
    }

    /// Whether something overflowed while the value at a position was computed.
    pub(super) fn has_overflowed(&self, position: usize) -> bool {
        self.machine.overflowed.get(position).copied().unwrap_or(true)
    }

    fn mark_overflow(&mut self, position: usize) {
        if let Some(slot) = self.machine.overflowed.get_mut(position) {
            *slot = true;
        }
    }

    fn top(&self, values: usize) -> i32 {
        self.machine.values.get(values.saturating_sub(1)).copied().unwrap_or(0)
    }

    fn replace(&mut self, values: usize, value: i32) {
        if let Some(slot) = self.machine.values.get_mut(values.saturating_sub(1)) {
            *slot = value;
        }
    }

    fn apply(&mut self, number: u8, real: bool, values: usize) -> usize {
        let operator = operator(number);
        let right = self.top(values);
        if let Operator::Unary(unary) = operator {
            let outcome =
                if real { real_unary(unary, f32::from_bits(right as u32)) } else { integer_unary(unary, right) };
            self.settle(values, outcome);
            return values;
        }
        let values = values.saturating_sub(1);
        let left = self.top(values);
        if self.has_overflowed(values) {
            self.mark_overflow(values.saturating_sub(1));
        }
        let (left_real, right_real) = (f32::from_bits(left as u32), f32::from_bits(right as u32));
        match operator {
            Operator::Relation(relation) => {
                let holds = if real { relation.holds(left_real, right_real) } else { relation.holds(left, right) };
                self.replace(values, i32::from(holds));
            }
            Operator::Binary(binary) => {
                let outcome =
                    if real { real_binary(binary, left_real, right_real) } else { integer_binary(binary, left, right) };
                self.settle(values, outcome);
            }
            Operator::Unary(_) => {}
        }
        values
    }

    fn settle(&mut self, values: usize, outcome: Outcome) {
        if outcome.overflow {
            self.overflow();
            self.mark_overflow(values.saturating_sub(1));
        }
        self.replace(
            values,
            match outcome.value {
                Number::Integer(value) => value,
                Number::Real(value) => value.to_bits() as i32,
            },
        );
    }
}
