//! Instructions that move more than one cell, and those that ask something of two operands together.

use twinrung_catalog::instructions::system::ATTRIBUTES;
use twinrung_catalog::{Element, Instruction, Opcode, Relation};

use super::instruction::Check;
use super::operands::Fact;
use super::place::Place;
use crate::code::Operands;
use crate::error::ImageError;
use crate::image::{Owner, TypeReference};
use crate::index::{ProgramIndex, RoutineIndex};
use crate::limits;
use crate::operand::OperandRecord;
use crate::text;

impl Check<'_, '_> {
    /// COP: elements of equal size on both sides, enough of them, not too many bytes (general-instructions.md A.6).
    pub(super) fn check_copy(&mut self, operands: Operands<'_>) -> Result<(), ImageError> {
        let at = self.at;
        let (Some(source), Some(destination), Some(length)) =
            (self.place(operands, 0), self.place(operands, 1), self.literal(operands, 2))
        else {
            return Err(ImageError::OperandCount { at });
        };
        let bytes = self.tables.bytes(source.type_reference);
        if bytes != self.tables.bytes(destination.type_reference) {
            return Err(ImageError::CopySize { at });
        }
        let length = self.check_length(0, &source, length)?;
        self.check_length(1, &destination, length.cast_signed())?;
        if bytes.unwrap_or(u32::MAX).saturating_mul(length) > limits::COPY_BYTES {
            return Err(ImageError::CopyLength { at, position: 2 });
        }
        self.write(&destination, length)
    }

    /// FLL: enough elements.
    pub(super) fn check_fill(&mut self, operands: Operands<'_>) -> Result<(), ImageError> {
        let at = self.at;
        let (Some(destination), Some(length)) = (self.place(operands, 1), self.literal(operands, 2)) else {
            return Err(ImageError::OperandCount { at });
        };
        let length = self.check_length(1, &destination, length)?;
        let bytes = self.tables.bytes(destination.type_reference);
        if bytes.unwrap_or(u32::MAX).saturating_mul(length) > limits::COPY_BYTES {
            return Err(ImageError::CopyLength { at, position: 2 });
        }
        self.write(&destination, length)
    }

    fn check_length(&self, position: usize, place: &Place, length: i32) -> Result<u32, ImageError> {
        u32::try_from(length)
            .ok()
            .filter(|length| (1..=place.count).contains(length))
            .ok_or(ImageError::CopyLength { at: self.at, position })
    }

    /// SWPB: INT, DINT or REAL tags of one type (general-instructions.md A.5).
    pub(super) fn check_swap(&self, operands: Operands<'_>) -> Result<(), ImageError> {
        let word = |position| self.place(operands, position).and_then(|place| place.word());
        let same = word(0).is_some_and(|source| source != Element::Sint) && word(0) == word(2);
        if same { Ok(()) } else { Err(ImageError::SwapTypes { at: self.at }) }
    }

    /// SIZE: the array has the dimension.
    pub(super) fn check_size(&self, operands: Operands<'_>) -> Result<(), ImageError> {
        let dimension = self.literal(operands, 1).and_then(|value| usize::try_from(value).ok());
        let length = self.place(operands, 0).zip(dimension).and_then(|(place, at)| place.array.get(at).copied());
        if length.is_some_and(|length| length > 0) { Ok(()) } else { Err(ImageError::SizeDimension { at: self.at }) }
    }

    /// GSV and SSV: class, instance and attribute belong together, and the tag has the attribute's bytes.
    pub(super) fn system_value(&mut self, opcode: Opcode, operands: Operands<'_>) -> Result<(), ImageError> {
        let at = self.at;
        let wrong = ImageError::SystemObject { at };
        let image = self.tables.image;
        let Some(Fact::SystemValue(index)) =
            operands.get(2).and_then(|operand| Some(self.entries.get(operand).ok()?.fact))
        else {
            return Err(wrong);
        };
        let value = image.system_values.get(index.position()).ok_or(wrong.clone())?;
        let attribute = ATTRIBUTES.iter().find(|known| known.number == value.attribute).ok_or(wrong.clone())?;
        let words = |position: usize| match operands.get(position).map(|operand| text::decode(image, operand)) {
            Some(Ok(OperandRecord::Text(text))) => Ok(text),
            _ => Err(wrong.clone()),
        };
        let (class, instance) = (words(0)?, words(1)?);
        if class != attribute.class || instance.is_empty() == attribute.has_instance {
            return Err(wrong);
        }
        if attribute.has_instance && !self.is_instance(attribute.class, &instance, value.instance) {
            return Err(wrong);
        }
        if opcode == Opcode::Ssv && !attribute.writable {
            return Err(ImageError::SystemReadOnly { at });
        }
        let too_small = ImageError::SystemData { at };
        let place = self.place(operands, 3).ok_or(too_small.clone())?;
        let is_integers = match place.type_reference {
            TypeReference::Element(element) => matches!(element, Element::Sint | Element::Int | Element::Dint),
            structure => !self.tables.holds_backing(structure),
        };
        let is_copied = |bytes: &u32| is_integers && (1..=limits::COPY_BYTES).contains(bytes);
        let each = self.tables.bytes(place.type_reference).filter(is_copied).ok_or(too_small.clone())?;
        let needed = attribute.element.bytes().saturating_mul(attribute.length);
        if each.saturating_mul(place.count) < needed {
            return Err(too_small);
        }
        if opcode == Opcode::Gsv { self.write(&place, needed.div_ceil(each.max(1))) } else { Ok(()) }
    }

    /// Whether an instance operand names the object with this number.
    fn is_instance(&self, class: &str, instance: &str, number: u32) -> bool {
        let image = self.tables.image;
        let this = instance == "THIS";
        match (class, self.owner) {
            ("TASK", _) => this || image.task.as_ref().is_some_and(|task| task.name == instance),
            ("PROGRAM", Owner::Program(program)) if this => number == u32::from(program.0),
            ("PROGRAM", _) => image
                .programs
                .get(ProgramIndex(number as u16).position())
                .is_some_and(|program| !this && program.name == instance),
            ("ROUTINE", Owner::Program(_)) if this => number == self.at.routine.0,
            // Routines of the same program, by name.
            ("ROUTINE", owner) => image
                .routines
                .get(RoutineIndex(number).position())
                .is_some_and(|routine| !this && routine.owner == owner && routine.name == instance),
            _ => false,
        }
    }

    /// A safety application instruction: its backing tag serves no other call, its operands do not contradict each
    /// other.
    pub(super) fn safety_application(
        &mut self,
        instruction: &'static Instruction,
        operands: Operands<'_>,
    ) -> Result<(), ImageError> {
        let Some(safety) = instruction.safety else { return Ok(()) };
        let backing = self.place(operands, 0).ok_or(ImageError::OperandCount { at: self.at })?;
        self.state.use_backing(self.at, &backing)?;
        if safety.relations.iter().all(|relation| self.holds(instruction, operands, relation)) {
            Ok(())
        } else {
            Err(ImageError::OperandRelation { at: self.at })
        }
    }

    fn holds(&self, instruction: &Instruction, operands: Operands<'_>, relation: &Relation) -> bool {
        let position = |name: &str| instruction.operands.iter().position(|operand| operand.name == name);
        let literal = |name: &str| position(name).and_then(|position| self.literal(operands, position));
        let place = |name: &str| position(name).and_then(|position| self.place(operands, position));
        let real = |name: &str| {
            let operand = position(name).and_then(|position| operands.get(position))?;
            match self.entries.get(operand).ok()?.fact {
                Fact::Real(value) => Some(value),
                _ => None,
            }
        };
        match *relation {
            Relation::DifferentTags(first, second) => {
                let (first, second) = (place(first), place(second));
                first.is_none() || first.is_some_and(|first| first.variable) || first != second
            }
            Relation::NotZeroWhen(time, choice, value) => literal(choice) != Some(value) || literal(time) != Some(0),
            Relation::BelowUnlessZero(first, second) => match (literal(first), literal(second)) {
                (Some(first), Some(second)) => second == 0 || first < second,
                _ => true,
            },
            Relation::NotAbove(first, second) => {
                let integers = literal(first).zip(literal(second)).is_none_or(|(first, second)| first <= second);
                let reals = real(first).zip(real(second)).is_none_or(|(first, second)| first <= second);
                integers && reals
            }
            Relation::PeriodAtMost(milliseconds) => {
                self.tables.image.task.as_ref().is_none_or(|task| task.period_us <= milliseconds.saturating_mul(1000))
            }
        }
    }
}
