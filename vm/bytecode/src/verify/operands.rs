//! The operand table: each entry by itself, in one pass; what an entry uses stands before it.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use twinrung_catalog::Element;

use super::expression::{Expression, check_expression};
use super::place::{Place, Walk};
use super::tables::Tables;
use super::tags::tag_place;
use crate::error::ImageError;
use crate::image::{Owner, TypeReference, Usage};
use crate::index::*;
use crate::limits;
use crate::operand::{Base, OperandRecord, Reference, Root};
use crate::text;

/// Where an operand may be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scope {
    /// Anywhere.
    Any,
    /// In programs.
    Programs,
    /// In one program.
    Program(ProgramIndex),
    /// In the routines of one Add-On Instruction.
    AddOn(AddOnIndex),
}

impl Scope {
    fn and(self, other: Scope) -> Option<Scope> {
        match (self, other) {
            (Scope::Any, scope) | (scope, Scope::Any) => Some(scope),
            (Scope::Programs, scope @ (Scope::Programs | Scope::Program(_)))
            | (scope @ Scope::Program(_), Scope::Programs) => Some(scope),
            _ => (self == other).then_some(self),
        }
    }

    /// Whether a routine of this owner may use the operand.
    pub(super) fn admits(self, owner: Owner) -> bool {
        match (self, owner) {
            (Scope::Any, _) | (Scope::Programs, Owner::Program(_)) => true,
            (Scope::Program(program), Owner::Program(owner)) => program == owner,
            (Scope::AddOn(add_on), Owner::AddOn(owner)) => add_on == owner,
            _ => false,
        }
    }
}

/// What an operand is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Fact {
    Integer(i32),
    Real(f32),
    Choice(i32),
    Unassigned,
    Text,
    Routine(RoutineIndex),
    Status,
    SystemValue(SystemValueIndex),
    EventTask,
    Expression(Expression),
    Reference(Place),
}

/// A verified entry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Entry {
    pub(super) fact: Fact,
    pub(super) scope: Scope,
    /// Operands within operands below this one.
    height: usize,
    /// A tag of the controller within this operand that some program hides behind a tag of its own.
    pub(super) hidden: bool,
}

/// The verified entries of the operand table.
pub(super) struct Entries(Vec<Entry>);

impl Entries {
    pub(super) fn get(&self, operand: OperandIndex) -> Result<&Entry, ImageError> {
        self.0.get(operand.position()).ok_or(ImageError::NoSuchOperand { operand })
    }
}

/// Verifies every entry.
pub(super) fn check_operands(tables: &Tables<'_>, aliases: &BTreeMap<TagIndex, Place>) -> Result<Entries, ImageError> {
    let mut entries = Entries(Vec::with_capacity(tables.image.operands.len()));
    for index in 0..tables.image.operands.len() {
        let operand = OperandIndex(index as u32);
        let entry = Check { tables, aliases, entries: &entries, operand, scope: Scope::Any, height: 0, hidden: false }
            .check(text::decode(tables.image, operand)?)?;
        entries.0.push(entry);
    }
    Ok(entries)
}

struct Check<'t, 'a> {
    tables: &'t Tables<'a>,
    aliases: &'t BTreeMap<TagIndex, Place>,
    entries: &'t Entries,
    operand: OperandIndex,
    scope: Scope,
    height: usize,
    hidden: bool,
}

impl Check<'_, '_> {
    fn check(mut self, record: OperandRecord) -> Result<Entry, ImageError> {
        let operand = self.operand;
        let without_text = ImageError::OperandWithoutText { operand };
        let fact = match record {
            OperandRecord::Integer { value, .. } => Fact::Integer(value),
            OperandRecord::Real(bits) => {
                let value = f32::from_bits(bits);
                if !value.is_finite() {
                    return Err(ImageError::RealNotFinite { operand });
                }
                if !self.tables.has_real() {
                    return Err(ImageError::RealOperand { operand });
                }
                Fact::Real(value)
            }
            OperandRecord::Choice(value) => Fact::Choice(value),
            OperandRecord::Unassigned => Fact::Unassigned,
            OperandRecord::Text(text) => {
                // A label, a system class or an instance: a name, or nothing.
                if !text.is_empty() && !crate::names::is_component(&text) {
                    return Err(without_text);
                }
                Fact::Text
            }
            OperandRecord::Routine(routine) => {
                let record = self.tables.image.routines.get(routine.position()).ok_or(without_text.clone())?;
                let Owner::Program(program) = record.owner else { return Err(without_text) };
                self.join(Scope::Program(program))?;
                Fact::Routine(routine)
            }
            OperandRecord::Status(_) => Fact::Status,
            OperandRecord::SystemValue(index) => {
                self.tables.image.system_values.get(index.position()).ok_or(without_text)?;
                Fact::SystemValue(index)
            }
            OperandRecord::EventTask(index) => {
                self.tables.image.event_tasks.get(index.position()).ok_or(without_text)?;
                Fact::EventTask
            }
            OperandRecord::Expression(operations) => {
                Fact::Expression(check_expression(operand, &operations, &mut |pushed| {
                    let fact = self.inner(pushed)?;
                    Ok(fact)
                })?)
            }
            OperandRecord::Reference(reference) => Fact::Reference(self.reference(&reference)?),
        };
        Ok(Entry { fact, scope: self.scope, height: self.height, hidden: self.hidden })
    }

    fn join(&mut self, scope: Scope) -> Result<(), ImageError> {
        self.scope = self.scope.and(scope).ok_or(ImageError::OperandScope { operand: self.operand })?;
        Ok(())
    }

    /// An operand within this one.
    fn inner(&mut self, inner: OperandIndex) -> Result<Fact, ImageError> {
        if inner >= self.operand {
            return Err(ImageError::OperandOrder { operand: inner });
        }
        let entry = *self.entries.get(inner)?;
        self.join(entry.scope)?;
        self.hidden |= entry.hidden;
        self.height = self.height.max(entry.height.saturating_add(1));
        if self.height > limits::SUBSCRIPT_DEPTH {
            return Err(ImageError::OperandDepth { operand: self.operand });
        }
        Ok(entry.fact)
    }

    fn reference(&mut self, reference: &Reference) -> Result<Place, ImageError> {
        let (tables, operand) = (self.tables, self.operand);
        let place = self.root(reference.root)?;
        let mut walk = Walk { tables, operand, place, terms: Vec::new() };
        for step in &reference.steps {
            walk.step(step, &mut |inner| match self.inner(inner)? {
                Fact::Expression(expression) if expression.is_subscript => Ok(()),
                Fact::Reference(place)
                    if matches!(place.word(), Some(Element::Sint | Element::Int | Element::Dint)) =>
                {
                    Ok(())
                }
                _ => Err(ImageError::SubscriptType { operand }),
            })?;
        }
        let Walk { place, terms, .. } = walk;
        if place.access(terms) == reference.access { Ok(place) } else { Err(ImageError::AccessDiffers { operand }) }
    }

    fn root(&mut self, root: Root) -> Result<Place, ImageError> {
        let wrong = ImageError::PathRoot { operand: self.operand };
        let image = self.tables.image;
        match root {
            Root::Tag(tag) => {
                let record = image.tags.get(tag.position()).ok_or(wrong.clone())?;
                self.join(record.program.map_or(Scope::Programs, Scope::Program))?;
                self.hidden |= record.program.is_none() && self.tables.hidden.get(tag.position()) == Some(&true);
                tag_place(self.tables, self.aliases, tag).ok_or(wrong)
            }
            Root::Member(add_on, member) => {
                let record = image.add_ons.get(add_on.position()).ok_or(wrong.clone())?;
                self.join(Scope::AddOn(add_on))?;
                let whole =
                    Place::whole(TypeReference::Structure(record.instance_type), [0; 3], Base::Instance, None, (0, 0));
                let instance = image.types.get(record.instance_type.position());
                let layout = self.tables.layout(record.instance_type);
                let (Some(whole), Some(instance), Some(layout)) = (whole, instance, layout) else { return Err(wrong) };
                // The root of a path within the instruction's own routines: its own instances are in reach.
                let position = usize::from(member);
                let (Some(declared), Some(place)) = (instance.members.get(position), layout.members.get(position))
                else {
                    return Err(wrong);
                };
                Ok(Place {
                    type_reference: declared.type_reference,
                    dimensions: declared.dimensions,
                    array: declared.dimensions,
                    bit_cell: place.bit_cell,
                    word_cell: place.word_cell,
                    count: place.elements,
                    ..whole
                })
            }
            Root::InOut(add_on, parameter) => {
                let record = image.add_ons.get(add_on.position()).ok_or(wrong.clone())?;
                self.join(Scope::AddOn(add_on))?;
                let declared = record.parameters.get(usize::from(parameter)).ok_or(wrong.clone())?;
                if declared.usage != Usage::InOut {
                    return Err(wrong);
                }
                let base = Base::InOut(parameter);
                Place::whole(declared.type_reference, declared.dimensions, base, None, (0, 0)).ok_or(wrong)
            }
        }
    }
}
