//! Code as neutral text, in the blanks of the exporter (neutral-text-and-l5x.md C.1): elements of a rung without
//! blanks, elements of a leg with one blank between them, a blank before `,` and `]` unless the leg is empty.

use alloc::vec::Vec;
use core::fmt::Write;

use super::operand::{OperandWriter, Stop, decode};
use crate::code::{CodeError, Mark, Marks, Operands};
use crate::error::ImageError;
use crate::image::{Image, RoutineRecord, TypeKind};
use crate::index::{OperandIndex, RoutineIndex};
use crate::limits;
use crate::operand::{AccessType, OperandRecord};

/// Writes the rungs of a routine, one per line.
pub fn write_routine(image: &Image, routine: RoutineIndex, out: &mut dyn Write) -> Result<(), Stop> {
    let Some(record) = image.routines.get(routine.position()) else { return Ok(()) };
    let mut writer = RungWriter::new(image, routine);
    for mark in Marks::new(&record.code) {
        writer.mark(mark.map_err(|error| code_error(routine, error))?, out)?;
    }
    Ok(())
}

pub(crate) fn code_error(routine: RoutineIndex, error: CodeError) -> ImageError {
    match error {
        CodeError::UnknownOpcode { offset, opcode } => ImageError::UnknownOpcode { routine, offset, opcode },
        CodeError::Truncated { offset } => ImageError::CodeTruncated { routine, offset },
    }
}

/// Writes a routine mark by mark.
pub(super) struct RungWriter<'a> {
    image: &'a Image,
    routine: RoutineIndex,
    rung: u32,
    operands: OperandWriter<'a>,
    /// For each open branch whether the leg has an element yet.
    legs: Vec<bool>,
}

impl<'a> RungWriter<'a> {
    pub(super) fn new(image: &'a Image, routine: RoutineIndex) -> RungWriter<'a> {
        RungWriter { image, routine, rung: 0, operands: OperandWriter::new(image), legs: Vec::new() }
    }

    pub(super) fn mark(&mut self, mark: Mark<'_>, out: &mut dyn Write) -> Result<(), Stop> {
        let wrong = ImageError::MarkOrder { routine: self.routine, rung: self.rung };
        match mark {
            Mark::Rung => {}
            Mark::EndRung if self.legs.is_empty() => {
                out.write_str(";\n")?;
                self.rung = self.rung.saturating_add(1);
            }
            Mark::Branch if self.legs.len() < limits::BRANCH_DEPTH => {
                self.separate(out)?;
                out.write_str("[")?;
                self.legs.push(false);
            }
            Mark::NextLeg => {
                let leg = self.legs.last_mut().ok_or(wrong)?;
                out.write_str(if *leg { " ," } else { "," })?;
                *leg = false;
            }
            Mark::EndBranch => {
                let leg = self.legs.pop().ok_or(wrong)?;
                out.write_str(if leg { " ]" } else { "]" })?;
            }
            Mark::EndRung | Mark::Branch => return Err(wrong.into()),
            Mark::Instruction(instruction, operands) => {
                self.separate(out)?;
                out.write_str(instruction.mnemonic)?;
                out.write_str("(")?;
                for (position, operand) in operands.iter().enumerate() {
                    let kind = instruction.operand(position).map(|declared| declared.kind);
                    if position > 0 {
                        out.write_str(",")?;
                    }
                    self.operands.write(operand, kind, out)?;
                }
                out.write_str(")")?;
            }
            Mark::AddOn(operands) => {
                self.separate(out)?;
                self.call(operands, out)?;
            }
        }
        Ok(())
    }

    /// The blank between the elements of a leg.
    fn separate(&mut self, out: &mut dyn Write) -> Result<(), Stop> {
        if let Some(leg) = self.legs.last_mut() {
            if *leg {
                out.write_str(" ")?;
            }
            *leg = true;
        }
        Ok(())
    }

    fn call(&mut self, operands: Operands<'_>, out: &mut dyn Write) -> Result<(), Stop> {
        let instance = operands.get(0).ok_or(ImageError::MarkOrder { routine: self.routine, rung: self.rung })?;
        out.write_str(called(self.image, instance)?)?;
        for (position, operand) in operands.iter().enumerate() {
            out.write_str(if position == 0 { "(" } else { "," })?;
            self.operands.write(operand, None, out)?;
        }
        out.write_str(")")?;
        Ok(())
    }
}

/// The name of the Add-On Instruction whose instance an operand is.
fn called(image: &Image, instance: OperandIndex) -> Result<&str, ImageError> {
    let wrong = ImageError::CallWithoutInstance { operand: instance };
    let OperandRecord::Reference(reference) = decode(image, instance)? else { return Err(wrong) };
    let AccessType::Structure(index) = reference.access.access_type else { return Err(wrong) };
    let add_on = match image.types.get(index.position()).map(|record| record.kind) {
        Some(TypeKind::AddOn(add_on)) => image.add_ons.get(add_on.position()),
        _ => None,
    };
    add_on.map(|add_on| add_on.name.as_str()).ok_or(wrong)
}

/// The records of a routine's owner, for its full name.
pub(super) fn owner_name<'a>(image: &'a Image, routine: &RoutineRecord) -> &'a str {
    match routine.owner {
        crate::image::Owner::Program(program) => {
            image.programs.get(program.position()).map_or("", |program| program.name.as_str())
        }
        crate::image::Owner::AddOn(add_on) => {
            image.add_ons.get(add_on.position()).map_or("", |add_on| add_on.name.as_str())
        }
    }
}
