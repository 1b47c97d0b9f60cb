//! One instruction: whether the controller admits it, and whether its operands are what the catalog declares.

use alloc::vec::Vec;

use twinrung_catalog::types::base::{CONTROL, COUNTER, TIMER};
use twinrung_catalog::{Element, Instruction, Opcode, OperandKind, Position, PredefinedType, Requires};

use super::calls::{Call, Signature};
use super::operands::{Entries, Entry, Fact};
use super::place::Place;
use super::state::State;
use super::tables::Tables;
use super::tags::is_hidden;
use crate::code::Operands;
use crate::error::{ImageError, Site};
use crate::image::{Owner, TypeReference};
use crate::index::OperandIndex;
use crate::operand::{Base, OperandRecord, Operation, Root, Step, Subscript};
use crate::text;

/// The check of one routine, at one instruction.
pub(super) struct Check<'t, 'a> {
    pub(super) tables: &'t Tables<'a>,
    pub(super) entries: &'t Entries,
    pub(super) state: &'t mut State,
    pub(super) owner: Owner,
    pub(super) at: Site,
    /// Whether nothing stands before the instruction on its rung.
    pub(super) first: bool,
    pub(super) signature: Signature,
    pub(super) calls: Vec<Call>,
    /// Instructions so far, Add-On calls replaced by what they run.
    pub(super) length: u64,
}

impl Check<'_, '_> {
    /// On to the next element.
    pub(super) fn next(&mut self) {
        self.at.element = self.at.element.saturating_add(1);
        self.first = false;
    }

    pub(super) fn instruction(
        &mut self,
        instruction: &'static Instruction,
        operands: Operands<'_>,
    ) -> Result<(), ImageError> {
        let at = self.at;
        self.length = self.length.saturating_add(1);
        self.check_admission(instruction)?;
        if instruction.position == Position::First {
            let first_rung = instruction.opcode != Opcode::Sbr || at.rung == 0;
            if !self.first || !first_rung {
                return Err(ImageError::NotFirst { at });
            }
        }
        let (least, most) = instruction.operand_count();
        if operands.len() < least || most.is_some_and(|most| operands.len() > most) {
            return Err(ImageError::OperandCount { at });
        }
        if operands.len() > crate::limits::OPERANDS_PER_INSTRUCTION {
            return Err(ImageError::OperandCount { at });
        }
        for (position, operand) in operands.iter().enumerate() {
            let entry = self.entry(position, operand)?;
            let kind = instruction.operand(position).map(|declared| declared.kind);
            let kind = kind.ok_or(ImageError::OperandCount { at })?;
            self.check_operand(position, kind, &entry)?;
        }
        match instruction.opcode {
            Opcode::Cop => self.check_copy(operands),
            Opcode::Fll => self.check_fill(operands),
            Opcode::Swpb => self.check_swap(operands),
            Opcode::Size => self.check_size(operands),
            Opcode::Ton | Opcode::Tof | Opcode::Rto | Opcode::Ctu | Opcode::Ctd | Opcode::Fal | Opcode::Fsc => {
                self.check_presets(instruction, operands)
            }
            Opcode::Jmp | Opcode::Lbl => self.label(instruction.opcode, operands),
            Opcode::Jsr => self.call(operands),
            Opcode::Mcr if matches!(self.owner, Owner::AddOn(_)) => Err(ImageError::MasterControlInAddOn { at }),
            Opcode::Sbr | Opcode::Ret => self.parameters(instruction.opcode, operands),
            Opcode::Gsv | Opcode::Ssv => self.system_value(instruction.opcode, operands),
            _ => self.safety_application(instruction, operands),
        }
    }

    /// 1756-RM093 Tables 10 to 12. A library that leaves the controller open is admitted by its users.
    fn check_admission(&self, instruction: &Instruction) -> Result<(), ImageError> {
        let at = self.at;
        let Some(controller) = self.tables.controller else { return Ok(()) };
        let admitted = match instruction.requires {
            Requires::Any => true,
            Requires::L7x | Requires::Real => controller.has_real(),
        };
        if !admitted {
            return Err(ImageError::InstructionRequires { at });
        }
        if self.tables.image.controller.revision < u16::from(instruction.first_version) {
            return Err(ImageError::InstructionVersion { at });
        }
        Ok(())
    }

    /// An operand of the instruction: it exists, and may be used in this routine.
    pub(super) fn entry(&self, position: usize, operand: OperandIndex) -> Result<Entry, ImageError> {
        let entry = *self.entries.get(operand)?;
        if !entry.scope.admits(self.owner) {
            return Err(ImageError::ForeignOperand { at: self.at, position });
        }
        if entry.hidden {
            self.check_hidden(operand)?;
        }
        Ok(entry)
    }

    /// Names in the text mean the program's tags first: an operand may not mean the controller's of the same name.
    /// The work is bounded by the operand's text, which has been compared.
    fn check_hidden(&self, operand: OperandIndex) -> Result<(), ImageError> {
        let Owner::Program(program) = self.owner else { return Ok(()) };
        let mut pending = alloc::vec![operand];
        while let Some(operand) = pending.pop() {
            match text::decode(self.tables.image, operand)? {
                OperandRecord::Reference(reference) => {
                    if let Root::Tag(tag) = reference.root
                        && is_hidden(self.tables, tag, Some(program))
                    {
                        return Err(ImageError::HiddenTag { at: self.at, tag });
                    }
                    for step in &reference.steps {
                        match step {
                            Step::BitOperand(inner) => pending.push(*inner),
                            Step::Subscript(subscripts) => {
                                pending.extend(subscripts.iter().filter_map(|subscript| match subscript {
                                    Subscript::Operand(inner) => Some(*inner),
                                    Subscript::Constant(_) => None,
                                }));
                            }
                            Step::Member(_) | Step::Bit(_) => {}
                        }
                    }
                }
                OperandRecord::Expression(operations) => {
                    pending.extend(operations.iter().filter_map(|operation| match operation {
                        Operation::Push(inner) => Some(*inner),
                        Operation::Apply(_) => None,
                    }));
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The place of an operand that is a reference; the check of its kind has shown that it is.
    pub(super) fn place(&self, operands: Operands<'_>, position: usize) -> Option<Place> {
        match self.entries.get(operands.get(position)?).ok()?.fact {
            Fact::Reference(place) => Some(place),
            _ => None,
        }
    }

    /// The value of an operand that is an integer literal or a choice.
    pub(super) fn literal(&self, operands: Operands<'_>, position: usize) -> Option<i32> {
        match self.entries.get(operands.get(position)?).ok()?.fact {
            Fact::Integer(value) | Fact::Choice(value) => Some(value),
            _ => None,
        }
    }

    pub(super) fn write(&mut self, place: &Place, elements: u32) -> Result<(), ImageError> {
        self.state.write(self.tables, self.at, place, elements)
    }

    /// One operand against its declaration.
    fn check_operand(&mut self, position: usize, kind: OperandKind, entry: &Entry) -> Result<(), ImageError> {
        let at = self.at;
        let wrong = Err(ImageError::OperandKind { at, position });
        let out_of_range = Err(ImageError::OperandRange { at, position });
        let integer = |place: &Place| matches!(place.word(), Some(Element::Sint | Element::Int | Element::Dint));
        match (kind, entry.fact) {
            (OperandKind::Bit(access), Fact::Reference(place)) if place.is_bit() => {
                if access.writes() {
                    self.write(&place, 1)
                } else {
                    Ok(())
                }
            }
            (OperandKind::Bit(access), Fact::Status) if !access.writes() => Ok(()),
            (OperandKind::Number(access), Fact::Reference(place)) if place.word().is_some() => {
                if access.writes() {
                    self.write(&place, 1)
                } else {
                    Ok(())
                }
            }
            (OperandKind::Number(access), Fact::Integer(_) | Fact::Real(_)) if !access.writes() => Ok(()),
            (OperandKind::Integer(access), Fact::Reference(place)) if integer(&place) => {
                if access.writes() {
                    self.write(&place, 1)
                } else {
                    Ok(())
                }
            }
            (OperandKind::Integer(access), Fact::Integer(_)) if !access.writes() => Ok(()),
            (OperandKind::Structure(predefined, access), Fact::Reference(place))
                if self.is_structure(&place, predefined) =>
            {
                match (access.writes(), predefined == &CONTROL) {
                    (true, true) => self.state.write_control(self.tables, at, &place),
                    (true, false) => self.write(&place, 1),
                    (false, _) => Ok(()),
                }
            }
            (OperandKind::Resettable, Fact::Reference(place))
                if [&TIMER, &COUNTER, &CONTROL].iter().any(|known| self.is_structure(&place, known)) =>
            {
                if self.is_structure(&place, &CONTROL) {
                    self.state.write_control(self.tables, at, &place)
                } else {
                    self.write(&place, 1)
                }
            }
            (OperandKind::Pseudo(_), Fact::Unassigned | Fact::Integer(_)) => Ok(()),
            // Copies write as many elements as their length says: with their own checks.
            (OperandKind::CopySource | OperandKind::CopyDestination, Fact::Reference(place)) if place.bit.is_none() => {
                let copied = self.tables.bytes(place.type_reference).is_some()
                    && !self.tables.holds_backing(place.type_reference);
                if copied { Ok(()) } else { Err(ImageError::CopyType { at, position }) }
            }
            (OperandKind::FillDestination, Fact::Reference(place)) if place.bit.is_none() => {
                match place.type_reference {
                    TypeReference::Element(element) if element != Element::Bool => Ok(()),
                    _ => wrong,
                }
            }
            (OperandKind::ConstantLength, Fact::Integer(value)) => {
                if value >= 1 {
                    Ok(())
                } else {
                    out_of_range
                }
            }
            (OperandKind::Expression, Fact::Expression(expression)) if !expression.has_relation => Ok(()),
            (OperandKind::Condition, Fact::Expression(_)) => Ok(()),
            (OperandKind::FileMode, Fact::Choice(value)) => {
                if value >= -1 {
                    Ok(())
                } else {
                    out_of_range
                }
            }
            (OperandKind::ByteOrder, Fact::Choice(value)) => {
                if (0..=2).contains(&value) {
                    Ok(())
                } else {
                    out_of_range
                }
            }
            (OperandKind::Array, Fact::Reference(place)) if place.array != [0; 3] => {
                if place.type_reference == TypeReference::Element(Element::Bool) { wrong } else { Ok(()) }
            }
            (OperandKind::Dimension, Fact::Integer(value)) => {
                if (0..=2).contains(&value) {
                    Ok(())
                } else {
                    out_of_range
                }
            }
            (OperandKind::Label | OperandKind::LabelDefinition, Fact::Text) => Ok(()),
            (OperandKind::Routine, Fact::Routine(_)) => Ok(()),
            (OperandKind::InputCount, Fact::Integer(value)) => {
                if value >= 0 {
                    Ok(())
                } else {
                    out_of_range
                }
            }
            // Which of a JSR's parameters are written its own check knows.
            (OperandKind::Parameter(_), Fact::Reference(place)) => {
                if self.tables.holds_backing(place.type_reference) {
                    wrong
                } else {
                    Ok(())
                }
            }
            (OperandKind::Parameter(access), Fact::Integer(_) | Fact::Real(_))
                if access != twinrung_catalog::Access::Write =>
            {
                Ok(())
            }
            (OperandKind::EventTask, Fact::EventTask) => Ok(()),
            (OperandKind::SystemClass | OperandKind::SystemInstance, Fact::Text) => Ok(()),
            (OperandKind::SystemAttribute, Fact::SystemValue(_)) => Ok(()),
            (OperandKind::SystemData(_), Fact::Reference(place)) if place.bit.is_none() => Ok(()),
            (OperandKind::Choice(list), Fact::Choice(value)) => {
                if list.word(value).is_some() {
                    Ok(())
                } else {
                    out_of_range
                }
            }
            (OperandKind::Literal { or_zero, least, greatest, step, .. }, Fact::Integer(value)) => {
                let inside = (least..=greatest).contains(&value) && value.checked_rem(step) == Some(0);
                if inside || (or_zero && value == 0) { Ok(()) } else { out_of_range }
            }
            (OperandKind::SafetyBit { .. }, Fact::Reference(place)) if place.is_bit() => Ok(()),
            (OperandKind::SafetyBit { immediate: true }, Fact::Integer(value)) => {
                if (0..=1).contains(&value) {
                    Ok(())
                } else {
                    out_of_range
                }
            }
            (OperandKind::SafetyInteger { .. }, Fact::Reference(place)) if integer(&place) => Ok(()),
            (OperandKind::SafetyInteger { immediate: Some((least, greatest)), .. }, Fact::Integer(value)) => {
                if (least..=greatest).contains(&value) { Ok(()) } else { out_of_range }
            }
            (OperandKind::SafetyReal { .. }, Fact::Reference(place)) if place.word() == Some(Element::Real) => Ok(()),
            (OperandKind::SafetyReal { immediate: true, not_negative }, Fact::Real(value)) => {
                if not_negative && value < 0.0 { out_of_range } else { Ok(()) }
            }
            _ => wrong,
        }
    }

    fn is_structure(&self, place: &Place, predefined: &'static PredefinedType) -> bool {
        !place.is_whole_array() && place.bit.is_none() && self.tables.is_predefined(place.type_reference, predefined)
    }

    /// A value in the place of Preset, Accum, Length or Position is the tag's initial value
    /// (neutral-text-and-l5x.md C.2). Within an Add-On Instruction every instance has its own.
    fn check_presets(&self, instruction: &Instruction, operands: Operands<'_>) -> Result<(), ImageError> {
        let Some(place) = self.place(operands, 0).filter(|place| place.base == Base::Absolute && !place.variable)
        else {
            return Ok(());
        };
        let Some(layout) = place.structure().and_then(|index| self.tables.layout(index)) else { return Ok(()) };
        for (position, declared) in instruction.operands.iter().enumerate() {
            let (OperandKind::Pseudo(name), Some(value)) = (declared.kind, self.literal(operands, position)) else {
                continue;
            };
            let OperandKind::Structure(predefined, _) = instruction.operands.first().map_or(declared.kind, |o| o.kind)
            else {
                continue;
            };
            let member = predefined.member(name).and_then(|(member, _)| layout.members.get(member));
            let cell = member.map(|member| place.word_cell.saturating_add(member.word_cell) as usize);
            let initial = cell.and_then(|cell| self.tables.image.initial_words.get(cell));
            if initial != Some(&value) {
                return Err(ImageError::PresetDiffers { at: self.at, position });
            }
        }
        Ok(())
    }
}
