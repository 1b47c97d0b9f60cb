//! The base instructions, one after the other as the reference has them.

use twinrung_catalog::{Instruction as Declaration, Opcode};
use twinrung_compiler::operand::{BinaryOperator, Operand};
use twinrung_compiler::project::OperandUse;

use crate::arithmetic::{Computed, Number, Operation, absolute, apply, negate, square_root};
use crate::evaluator::{Exit, Judge};
use crate::expressions::{holds_real, related};
use crate::memory::Frame;

impl<'p> Judge<'p> {
    /// Executes one instruction; the rung condition after it.
    pub(crate) fn instruction(
        &mut self,
        frame: &Frame<'p>,
        declaration: &Declaration,
        operands: &[OperandUse],
        condition: bool,
    ) -> Result<bool, Exit> {
        use Opcode::*;
        if declaration.safety.is_some() {
            return self.safety_application(frame, declaration, operands, condition);
        }
        match declaration.opcode {
            Xic => Ok(condition && self.bit(frame, operands[0])?),
            Xio => Ok(condition && !self.bit(frame, operands[0])?),
            Afi => Ok(false),
            Nop | Lbl | Sbr => Ok(condition),
            Ote => {
                let target = self.target(frame, operands[0])?;
                self.memory.set_bit(&target, condition);
                Ok(condition)
            }
            Otl | Otu => {
                if condition {
                    let target = self.target(frame, operands[0])?;
                    self.memory.set_bit(&target, declaration.opcode == Otl);
                }
                Ok(condition)
            }
            Ons | Osr | Osf => self.one_shot(frame, declaration.opcode, operands, condition),
            Ton | Tof | Rto => {
                let target = self.target(frame, operands[0])?;
                self.timer(frame, declaration.opcode, target, condition)?;
                Ok(condition)
            }
            Ctu | Ctd => {
                let target = self.target(frame, operands[0])?;
                self.counter(frame, declaration.opcode, &target, condition);
                Ok(condition)
            }
            Res => {
                if condition {
                    let target = self.target(frame, operands[0])?;
                    let structure = self.resettable(&target);
                    self.reset(&target, structure);
                }
                Ok(condition)
            }
            Equ | Neq | Grt | Geq | Les | Leq | Lim | Meq | Cmp => {
                Ok(condition && self.comparison(frame, declaration.opcode, operands)?)
            }
            Fal | Fsc => {
                self.file(frame, declaration.opcode, operands, condition)?;
                Ok(condition)
            }
            Jmp | Jsr | Ret | Tnd | Mcr | Event | Gsv | Ssv => {
                self.program_control(frame, declaration.opcode, operands, condition)?;
                Ok(condition)
            }
            _ => {
                if condition {
                    self.when_true(frame, declaration.opcode, operands)?;
                }
                Ok(condition)
            }
        }
    }

    /// A BOOL operand.
    pub(crate) fn bit(&mut self, frame: &Frame<'_>, operand: OperandUse) -> Result<bool, Exit> {
        match frame.project.operand(operand.id) {
            Operand::Integer { value, .. } => Ok(*value != 0),
            Operand::Status(keyword) => Ok(match keyword {
                0 => self.flags.first_scan,
                1 => self.flags.overflow,
                2 => self.flags.zero,
                3 => self.flags.negative,
                4 => self.flags.carry,
                _ => self.flags.minor_fault,
            }),
            _ => {
                let target = self.target(frame, operand)?;
                Ok(self.memory.bit(&target))
            }
        }
    }

    fn one_shot(
        &mut self,
        frame: &Frame<'_>,
        opcode: Opcode,
        operands: &[OperandUse],
        condition: bool,
    ) -> Result<bool, Exit> {
        let storage = self.target(frame, operands[0])?;
        let output = match operands.get(1) {
            Some(operand) => Some(self.target(frame, *operand)?),
            None => None,
        };
        let stored = self.memory.bit(&storage);
        // Prescan arms ONS and OSR, so that an input that is true from the start gives no pulse, and disarms OSF.
        if frame.prescanning {
            self.memory.set_bit(&storage, opcode != Opcode::Osf);
            if let Some(output) = output {
                self.memory.set_bit(&output, false);
            }
            return Ok(false);
        }
        self.memory.set_bit(&storage, condition);
        let pulse = if opcode == Opcode::Osf { !condition && stored } else { condition && !stored };
        match output {
            Some(output) => {
                self.memory.set_bit(&output, pulse);
                Ok(condition)
            }
            None => Ok(pulse),
        }
    }

    fn comparison(&mut self, frame: &Frame<'_>, opcode: Opcode, operands: &[OperandUse]) -> Result<bool, Exit> {
        use BinaryOperator::{Equal, Greater, GreaterOrEqual, Less, LessOrEqual, NotEqual};
        match opcode {
            Opcode::Cmp => {
                let Operand::Expression(expression) = self.operand(frame, operands[0]) else { panic!("no expression") };
                let value = self.expression(frame, expression, holds_real(expression))?;
                Ok(match value {
                    Number::Integer(value) => value != 0,
                    Number::Real(value) => value != 0.0,
                })
            }
            Opcode::Meq => {
                let source = self.pattern(frame, operands[0])?;
                let mask = self.pattern(frame, operands[1])?;
                let compare = self.pattern(frame, operands[2])?;
                Ok(source & mask == compare & mask)
            }
            Opcode::Lim => {
                let real = operands.iter().any(|operand| self.is_real(frame, *operand));
                let low = self.number(frame, operands[0])?;
                let test = self.number(frame, operands[1])?;
                let high = self.number(frame, operands[2])?;
                let above = related(GreaterOrEqual, test, low, real);
                let below = related(LessOrEqual, test, high, real);
                if related(LessOrEqual, low, high, real) {
                    Ok(above && below)
                } else {
                    Ok(related(Greater, low, high, real) && (above || below))
                }
            }
            _ => {
                let real = operands.iter().any(|operand| self.is_real(frame, *operand));
                let a = self.number(frame, operands[0])?;
                let b = self.number(frame, operands[1])?;
                let relation = match opcode {
                    Opcode::Equ => Equal,
                    Opcode::Neq => NotEqual,
                    Opcode::Grt => Greater,
                    Opcode::Geq => GreaterOrEqual,
                    Opcode::Les => Less,
                    _ => LessOrEqual,
                };
                Ok(related(relation, a, b, real))
            }
        }
    }

    /// Instructions that do nothing on a false rung.
    fn when_true(&mut self, frame: &Frame<'_>, opcode: Opcode, operands: &[OperandUse]) -> Result<(), Exit> {
        use Opcode::*;
        match opcode {
            Cop => return self.copy(frame, operands),
            Fll => return self.fill(frame, operands),
            Size => return self.size(frame, operands),
            Swpb => return self.swap_bytes(frame, operands),
            _ => {}
        }
        self.clear_flags(frame);
        let last = operands[operands.len() - 1];
        match opcode {
            And | Or | Xor | Not | Mvm => {
                let a = self.pattern(frame, operands[0])?;
                let b = if opcode == Not { 0 } else { self.pattern(frame, operands[1])? };
                let target = self.target(frame, last)?;
                let result = match opcode {
                    And => a & b,
                    Or => a | b,
                    Xor => a ^ b,
                    Not => !a,
                    _ => (self.memory.integer(&target) & !b) | (a & b),
                };
                // The upper bits are dropped without S:V: REQ-EXEC-013.
                self.memory.set_integer(&target, result);
                let stored = self.memory.integer(&target);
                if frame.counts {
                    self.flags.zero = stored == 0;
                    self.flags.negative = stored < 0;
                }
            }
            Clr => {
                let target = self.target(frame, last)?;
                self.store_with_flags(frame, &target, (Number::Integer(0), false));
            }
            Cpt => {
                let target = self.target(frame, operands[0])?;
                let Operand::Expression(expression) = self.operand(frame, operands[1]) else { panic!("no expression") };
                let real = holds_real(expression) || self.is_real(frame, operands[0]);
                let value = self.expression(frame, expression, real)?;
                self.store_with_flags(frame, &target, (value, false));
            }
            _ => {
                let real = operands.iter().any(|operand| self.is_real(frame, *operand));
                let a = self.number(frame, operands[0])?;
                let b = if operands.len() == 3 { Some(self.number(frame, operands[1])?) } else { None };
                let target = self.target(frame, last)?;
                let result = self.computed(frame, opcode, a, b, real);
                self.store_with_flags(frame, &target, result);
            }
        }
        Ok(())
    }

    fn computed(&mut self, frame: &Frame<'_>, opcode: Opcode, a: Number, b: Option<Number>, real: bool) -> Computed {
        let other = b.unwrap_or(Number::Integer(0));
        if let (false, Opcode::Add | Opcode::Sub) = (real, opcode) {
            let (a, b) = (a.to_integer().0 as u32, other.to_integer().0 as u32);
            if frame.counts {
                self.flags.carry = if opcode == Opcode::Add { a.checked_add(b).is_none() } else { a < b };
            }
        }
        match opcode {
            Opcode::Add => apply(Operation::Add, a, other, real),
            Opcode::Sub => apply(Operation::Subtract, a, other, real),
            Opcode::Mul => apply(Operation::Multiply, a, other, real),
            Opcode::Div => apply(Operation::Divide, a, other, real),
            Opcode::Mod => apply(Operation::Modulo, a, other, real),
            Opcode::Sqr => (square_root(a, real), false),
            Opcode::Neg => negate(a, real),
            Opcode::Abs => absolute(a, real),
            Opcode::Mov => (a, false),
            other => panic!("{other:?} computes nothing"),
        }
    }
}
