//! Numbers: conversion, storing, the operations. general-instructions.md 2.2 and A.9.

use twinrung_catalog::Element;
use twinrung_compiler::operand::Operand;
use twinrung_compiler::project::OperandUse;

use crate::evaluator::{Exit, Judge};
use crate::memory::{Frame, Target, narrowed};
use crate::value::Value;

/// The one form of NaN (REQ-EXEC-003).
const NAN: u32 = 0x7FC0_0000;

/// The bits of a REAL as instructions store them.
pub(crate) fn canonical(bits: u32) -> u32 {
    if f32::from_bits(bits).is_nan() { NAN } else { bits }
}

/// A number in a register.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Number {
    Integer(i32),
    Real(f32),
}

/// A result, and whether it says S:V.
pub(crate) type Computed = (Number, bool);

impl Number {
    pub fn to_real(self) -> f32 {
        match self {
            Number::Integer(value) => value as f32,
            Number::Real(value) => value,
        }
    }

    /// As DINT: rounded half to even, low 32 bits, and whether it did not fit.
    pub fn to_integer(self) -> (i32, bool) {
        match self {
            Number::Integer(value) => (value, false),
            Number::Real(value) => {
                let wide = f64::from(value);
                if !wide.is_finite() || wide.abs() >= 9_223_372_036_854_775_808.0 {
                    return (i32::MIN, true);
                }
                let rounded = wide.round_ties_even() as i64;
                (rounded as i32, i32::try_from(rounded).is_err())
            }
        }
    }
}

/// An arithmetic operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Operation {
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
}

/// Applies an operation in REAL or in DINT.
pub(crate) fn apply(operation: Operation, a: Number, b: Number, real: bool) -> Computed {
    if real {
        let (a, b) = (a.to_real(), b.to_real());
        let zero_division = b == 0.0 && matches!(operation, Operation::Divide | Operation::Modulo);
        let value = match operation {
            Operation::Add => a + b,
            Operation::Subtract => a - b,
            Operation::Multiply => a * b,
            // By the sign of A, whatever the sign of the zero (A.9).
            Operation::Divide if b == 0.0 => a / 0.0,
            Operation::Divide => a / b,
            Operation::Modulo if b == 0.0 => 0.0,
            Operation::Modulo => a % b,
        };
        let overflow = zero_division || (!value.is_finite() && a.is_finite() && b.is_finite());
        return (Number::Real(value), overflow);
    }
    let ((a, a_over), (b, b_over)) = (a.to_integer(), b.to_integer());
    let (wide_a, wide_b) = (i64::from(a), i64::from(b));
    let (wide, overflow) = match operation {
        Operation::Add => (wide_a + wide_b, false),
        Operation::Subtract => (wide_a - wide_b, false),
        Operation::Multiply => (wide_a * wide_b, false),
        Operation::Divide if b == 0 => (wide_a, true),
        Operation::Divide => (wide_a / wide_b, false),
        Operation::Modulo if b == 0 => (0, true),
        Operation::Modulo => (wide_a % wide_b, false),
    };
    let overflow = overflow || a_over || b_over || i32::try_from(wide).is_err();
    (Number::Integer(wide as i32), overflow)
}

/// Square root of the absolute value.
pub(crate) fn square_root(value: Number, real: bool) -> Number {
    if real {
        return Number::Real(value.to_real().abs().sqrt());
    }
    let wide = i64::from(value.to_integer().0).unsigned_abs();
    Number::Integer(wide.isqrt() as i32)
}

/// 0 - value.
pub(crate) fn negate(value: Number, real: bool) -> Computed {
    if real {
        return (Number::Real(-value.to_real()), false);
    }
    let value = value.to_integer().0;
    (Number::Integer(value.wrapping_neg()), value == i32::MIN)
}

/// The value without its sign.
pub(crate) fn absolute(value: Number, real: bool) -> Computed {
    if real {
        return (Number::Real(value.to_real().abs()), false);
    }
    let value = value.to_integer().0;
    (Number::Integer(value.wrapping_abs()), value == i32::MIN)
}

/// An integer as bitwise instructions see it: SINT and INT filled with zeros.
pub(crate) fn zero_filled(element: Element, value: i32) -> i32 {
    match element {
        Element::Sint => value & 0xFF,
        Element::Int => value & 0xFFFF,
        _ => value,
    }
}

impl Judge<'_> {
    pub(crate) fn element(&self, target: &Target) -> Element {
        match self.memory.get(target) {
            Value::Integer(element, _) => *element,
            Value::Real(_) => Element::Real,
            Value::Bit(_) => Element::Bool,
            other => panic!("not elementary: {other:?}"),
        }
    }

    pub(crate) fn number_at(&self, target: &Target) -> Number {
        match self.memory.get(target) {
            Value::Integer(_, value) => Number::Integer(*value),
            Value::Real(bits) => Number::Real(f32::from_bits(*bits)),
            other => panic!("not a number: {other:?}"),
        }
    }

    /// A numeric operand.
    pub(crate) fn number(&mut self, frame: &Frame<'_>, operand: OperandUse) -> Result<Number, Exit> {
        match frame.project.operand(operand.id) {
            Operand::Integer { value, .. } => Ok(Number::Integer(*value)),
            Operand::Real(bits) => Ok(Number::Real(f32::from_bits(*bits))),
            Operand::Reference(reference) => {
                let target = self.locate(frame, reference)?;
                Ok(self.number_at(&target))
            }
            other => panic!("not a number: {other:?}"),
        }
    }

    /// An integer operand as bitwise instructions see it.
    pub(crate) fn pattern(&mut self, frame: &Frame<'_>, operand: OperandUse) -> Result<i32, Exit> {
        match frame.project.operand(operand.id) {
            Operand::Integer { value, .. } => Ok(*value),
            Operand::Reference(reference) => {
                let target = self.locate(frame, reference)?;
                Ok(zero_filled(self.element(&target), self.memory.integer(&target)))
            }
            other => panic!("not an integer: {other:?}"),
        }
    }

    /// Whether an operand is REAL.
    pub(crate) fn is_real(&self, frame: &Frame<'_>, operand: OperandUse) -> bool {
        match frame.project.operand(operand.id) {
            Operand::Real(_) => true,
            Operand::Reference(reference) => reference.element() == Some(Element::Real),
            _ => false,
        }
    }

    /// Stores a number; whether it did not fit.
    pub(crate) fn store(&mut self, target: &Target, value: Number) -> bool {
        let element = self.element(target);
        if element == Element::Real {
            let real = value.to_real();
            *self.memory.get_mut(target) = Value::Real(canonical(real.to_bits()));
            return false;
        }
        let (integer, overflow) = value.to_integer();
        let low = narrowed(element, integer);
        self.memory.set_integer(target, low);
        overflow || low != integer
    }

    /// Stores a result and sets the flags from what was stored.
    pub(crate) fn store_with_flags(&mut self, frame: &Frame<'_>, target: &Target, result: Computed) {
        let overflow = self.store(target, result.0) | result.1;
        if overflow {
            self.overflow(frame);
        }
        if frame.counts {
            let (zero, negative) = match self.number_at(target) {
                Number::Integer(value) => (value == 0, value < 0),
                Number::Real(value) => (value == 0.0, value < 0.0),
            };
            self.flags.zero = zero;
            self.flags.negative = negative;
        }
    }
}
