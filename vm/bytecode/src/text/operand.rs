//! Operands as canonical text.

use alloc::vec::Vec;
use core::fmt::Write;

use twinrung_catalog::OperandKind;
use twinrung_catalog::instructions::system::ATTRIBUTES;

use super::expression;
use super::number::{write_integer, write_real};
use crate::error::ImageError;
use crate::format::STATUS_KEYWORDS;
use crate::image::{Image, TypeReference};
use crate::index::OperandIndex;
use crate::limits;
use crate::operand::{OperandRecord, Reference, Root, Step, Subscript, whole_tag};

/// Why a text was not written to its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Stop {
    /// The records have no text.
    Image(ImageError),
    /// The writer refused.
    Writer,
}

impl From<ImageError> for Stop {
    fn from(error: ImageError) -> Stop {
        Stop::Image(error)
    }
}

impl From<core::fmt::Error> for Stop {
    fn from(_: core::fmt::Error) -> Stop {
        Stop::Writer
    }
}

/// A piece of an operand's text that is still to be written.
pub(super) enum Piece<'a> {
    Text(&'a str),
    Number(u32),
    /// An operand, and how many operands it stands in.
    Operand(OperandIndex, usize),
}

/// Writes operands; keeps its work list between them.
pub(super) struct OperandWriter<'a> {
    image: &'a Image,
    /// What is to be written, the next piece last.
    pending: Vec<Piece<'a>>,
    /// Pieces of one operand in the order of the text.
    pieces: Vec<Piece<'a>>,
}

impl<'a> OperandWriter<'a> {
    pub(super) fn new(image: &'a Image) -> OperandWriter<'a> {
        OperandWriter { image, pending: Vec::new(), pieces: Vec::new() }
    }

    /// Writes an operand where an instruction declares `kind`. The work is bounded by what is written. That the record of
    /// a whole tag is one to its end, who reads the table shows: here only its path is looked at.
    pub(super) fn write(
        &mut self,
        operand: OperandIndex,
        kind: Option<OperandKind>,
        out: &mut dyn Write,
    ) -> Result<(), Stop> {
        // Most operands are whole tags: their names are written without reading the record.
        let whole = self.image.operands.entry(operand).and_then(whole_tag);
        if let Some(tag) = whole.and_then(|tag| self.image.tags.get(tag.position())) {
            return Ok(out.write_str(&tag.name)?);
        }
        self.pending.clear();
        self.pending.push(Piece::Operand(operand, 0));
        while let Some(piece) = self.pending.pop() {
            match piece {
                Piece::Text(text) => out.write_str(text)?,
                Piece::Number(number) => write!(out, "{number}")?,
                Piece::Operand(operand, depth) => {
                    let kind = if depth == 0 { kind } else { None };
                    self.write_entry(operand, depth, kind, out)?;
                    self.pending.extend(self.pieces.drain(..).rev());
                }
            }
        }
        Ok(())
    }

    /// Writes what has a text by itself, and puts the pieces of the others into the list.
    fn write_entry(
        &mut self,
        operand: OperandIndex,
        depth: usize,
        kind: Option<OperandKind>,
        out: &mut dyn Write,
    ) -> Result<(), Stop> {
        let without_text = Stop::Image(ImageError::OperandWithoutText { operand });
        if depth > limits::SUBSCRIPT_DEPTH {
            return Err(ImageError::OperandDepth { operand }.into());
        }
        match decode(self.image, operand)? {
            OperandRecord::Integer { radix, value } => write_integer(out, radix, value)?,
            OperandRecord::Real(bits) if f32::from_bits(bits).is_finite() => write_real(out, bits)?,
            OperandRecord::Real(_) => return Err(without_text),
            OperandRecord::Choice(value) => match (kind, value) {
                (Some(OperandKind::Choice(list)), _) => out.write_str(list.word(value).ok_or(without_text)?)?,
                (Some(OperandKind::FileMode), 0) => out.write_str("ALL")?,
                (Some(OperandKind::FileMode), -1) => out.write_str("INC")?,
                (Some(OperandKind::FileMode), 1..) => write!(out, "{value}")?,
                (Some(OperandKind::ByteOrder), 0) => out.write_str("REVERSE")?,
                (Some(OperandKind::ByteOrder), 1) => out.write_str("WORD")?,
                (Some(OperandKind::ByteOrder), 2) => out.write_str("HIGH/LOW")?,
                _ => return Err(without_text),
            },
            OperandRecord::Unassigned => out.write_str("?")?,
            OperandRecord::Text(text) => out.write_str(&text)?,
            OperandRecord::Routine(routine) => {
                out.write_str(&self.image.routines.get(routine.position()).ok_or(without_text)?.name)?;
            }
            OperandRecord::Status(keyword) => {
                out.write_str(STATUS_KEYWORDS.get(usize::from(keyword)).ok_or(without_text)?)?;
            }
            OperandRecord::SystemValue(index) => {
                let value = self.image.system_values.get(index.position()).ok_or(without_text.clone())?;
                let attribute = ATTRIBUTES.iter().find(|known| known.number == value.attribute);
                out.write_str(attribute.ok_or(without_text)?.name)?;
            }
            OperandRecord::EventTask(index) => {
                out.write_str(self.image.event_tasks.get(index.position()).ok_or(without_text)?)?;
            }
            OperandRecord::Expression(operations) => {
                let is_negative = |pushed: OperandIndex| match decode(self.image, pushed) {
                    Ok(OperandRecord::Integer { radix: 10, value }) => value < 0,
                    Ok(OperandRecord::Real(bits)) => f32::from_bits(bits).is_sign_negative(),
                    _ => false,
                };
                let depth = depth.saturating_add(1);
                expression::pieces(operand, &operations, depth, &is_negative, &mut self.pieces)?;
            }
            OperandRecord::Reference(reference) => self.reference(operand, &reference, depth)?,
        }
        Ok(())
    }

    fn reference(&mut self, operand: OperandIndex, reference: &Reference, depth: usize) -> Result<(), ImageError> {
        let without_text = || ImageError::OperandWithoutText { operand };
        let image = self.image;
        let (name, mut type_reference) = match reference.root {
            Root::Tag(tag) => {
                let tag = image.tags.get(tag.position()).ok_or_else(without_text)?;
                (tag.name.as_str(), tag.type_reference)
            }
            Root::Member(add_on, member) => {
                let add_on = image.add_ons.get(add_on.position()).ok_or_else(without_text)?;
                let instance = image.types.get(add_on.instance_type.position()).ok_or_else(without_text)?;
                let member = instance.members.get(usize::from(member)).ok_or_else(without_text)?;
                (member.name.as_str(), member.type_reference)
            }
            Root::InOut(add_on, parameter) => {
                let add_on = image.add_ons.get(add_on.position()).ok_or_else(without_text)?;
                let parameter = add_on.parameters.get(usize::from(parameter)).ok_or_else(without_text)?;
                (parameter.name.as_str(), parameter.type_reference)
            }
        };
        self.pieces.push(Piece::Text(name));
        let depth = depth.saturating_add(1);
        for step in &reference.steps {
            match step {
                Step::Member(member) => {
                    let TypeReference::Structure(index) = type_reference else { return Err(without_text()) };
                    let structure = image.types.get(index.position()).ok_or_else(without_text)?;
                    let member = structure.members.get(usize::from(*member)).ok_or_else(without_text)?;
                    self.pieces.push(Piece::Text("."));
                    self.pieces.push(Piece::Text(&member.name));
                    type_reference = member.type_reference;
                }
                Step::Subscript(subscripts) => {
                    for (position, subscript) in subscripts.iter().enumerate() {
                        self.pieces.push(Piece::Text(if position == 0 { "[" } else { "," }));
                        self.pieces.push(match subscript {
                            Subscript::Constant(value) => Piece::Number(*value),
                            Subscript::Operand(inner) => Piece::Operand(*inner, depth),
                        });
                    }
                    self.pieces.push(Piece::Text("]"));
                }
                Step::Bit(bit) => {
                    self.pieces.push(Piece::Text("."));
                    self.pieces.push(Piece::Number(u32::from(*bit)));
                }
                Step::BitOperand(inner) => {
                    self.pieces.push(Piece::Text(".["));
                    self.pieces.push(Piece::Operand(*inner, depth));
                    self.pieces.push(Piece::Text("]"));
                }
            }
        }
        Ok(())
    }
}

/// The record of an entry.
pub(crate) fn decode(image: &Image, operand: OperandIndex) -> Result<OperandRecord, ImageError> {
    let bytes = image.operands.entry(operand).ok_or(ImageError::NoSuchOperand { operand })?;
    OperandRecord::decode(bytes).map_err(|why| ImageError::OperandEncoding { operand, why })
}
