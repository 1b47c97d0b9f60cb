//! Where data is: a root and a path, with every alias followed and every subscript evaluated.

use std::collections::HashMap;

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::{Element, PredefinedType};
use twinrung_compiler::operand::{Reference, Root, Step, Subscript};
use twinrung_compiler::project::{Project, TagId, TagKind};

use crate::evaluator::{Exit, Judge};
use crate::value::Value;

/// What a path begins at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Base {
    /// A tag of the project.
    Tag(TagId),
    /// The private instance of a library Add-On Instruction.
    Library(usize),
}

/// A place in memory.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct Target {
    pub base: Base,
    pub path: Vec<u32>,
    /// A bit of the integer there.
    pub bit: Option<u8>,
}

impl Target {
    /// A part of it.
    pub fn part(&self, step: u32) -> Target {
        let mut target = self.clone();
        target.path.push(step);
        target
    }

    /// The element so many places further in the same array (or the place itself for 0).
    pub fn following(&self, offset: u32) -> Target {
        let mut target = self.clone();
        if let Some(last) = target.path.last_mut() {
            *last += offset;
        }
        target
    }
}

/// The Add-On Instruction that is being executed.
#[derive(Debug, Clone)]
pub(crate) struct Instance {
    pub target: Target,
    pub in_out: HashMap<u16, Target>,
}

/// Whose routine is being executed.
#[derive(Clone)]
pub(crate) struct Frame<'p> {
    pub project: &'p Project,
    pub program: u16,
    pub routine: u32,
    pub rung: u32,
    pub element: u32,
    pub instance: Option<Instance>,
    /// Whether what it executes counts as executed and may touch the flags: false within the library.
    pub counts: bool,
    /// Whether MCR zones of the program apply.
    pub in_add_on: bool,
    /// Whether rungs are prescanned: false within the Prescan routine of an Add-On Instruction, which runs.
    pub prescanning: bool,
}

/// All data.
#[derive(Debug, Clone, Default)]
pub(crate) struct Memory {
    pub tags: HashMap<TagId, Value>,
    pub library: Vec<Value>,
    /// The hidden time stamp of each TIMER.
    pub last_time: HashMap<Target, i64>,
}

impl Memory {
    pub fn get(&self, target: &Target) -> &Value {
        let root = match target.base {
            Base::Tag(tag) => &self.tags[&tag],
            Base::Library(index) => &self.library[index],
        };
        root.at(&target.path)
    }

    pub fn get_mut(&mut self, target: &Target) -> &mut Value {
        let root = match target.base {
            Base::Tag(tag) => self.tags.get_mut(&tag).unwrap_or_else(|| panic!("no tag {tag:?}")),
            Base::Library(index) => &mut self.library[index],
        };
        root.at_mut(&target.path)
    }

    pub fn bit(&self, target: &Target) -> bool {
        match (self.get(target), target.bit) {
            (Value::Bit(value), None) => *value,
            (Value::Integer(_, value), Some(bit)) => (value >> bit) & 1 == 1,
            other => panic!("not a bit: {other:?}"),
        }
    }

    pub fn set_bit(&mut self, target: &Target, to: bool) {
        let bit = target.bit;
        match (self.get_mut(target), bit) {
            (Value::Bit(value), None) => *value = to,
            (Value::Integer(element, value), Some(bit)) => {
                let changed = if to { *value | (1_i32 << bit) } else { *value & !(1_i32 << bit) };
                *value = narrowed(*element, changed);
            }
            other => panic!("not a bit: {other:?}"),
        }
    }

    pub fn integer(&self, target: &Target) -> i32 {
        match self.get(target) {
            Value::Integer(_, value) => *value,
            Value::Real(bits) => *bits as i32,
            Value::Bit(value) => i32::from(*value),
            other => panic!("not a number: {other:?}"),
        }
    }

    pub fn set_integer(&mut self, target: &Target, to: i32) {
        match self.get_mut(target) {
            Value::Integer(element, value) => *value = narrowed(*element, to),
            Value::Real(bits) => *bits = to as u32,
            other => panic!("not a number: {other:?}"),
        }
    }
}

/// The low bits of a value, sign-extended.
pub(crate) fn narrowed(element: Element, value: i32) -> i32 {
    match element {
        Element::Sint => i32::from(value as i8),
        Element::Int => i32::from(value as i16),
        _ => value,
    }
}

/// The position of a member of a predefined structure.
pub(crate) fn member(structure: &PredefinedType, name: &str) -> u32 {
    structure.member(name).unwrap_or_else(|| panic!("{} has no {name}", structure.name)).0 as u32
}

impl Judge<'_> {
    /// Where a reference leads now. Subscripts out of range are fault 4/20.
    pub(crate) fn locate(&mut self, frame: &Frame<'_>, reference: &Reference) -> Result<Target, Exit> {
        let (mut target, mut type_reference, mut dimensions) = match reference.root {
            Root::Tag(id) => {
                let tag = frame.project.tag(id);
                match &tag.kind {
                    TagKind::Alias(Some(alias)) => {
                        let aliased = &alias.reference;
                        (self.locate(frame, aliased)?, aliased.type_reference, aliased.dimensions)
                    }
                    _ => (
                        Target { base: Base::Tag(id), path: Vec::new(), bit: None },
                        tag.type_reference.unwrap_or_else(|| panic!("{} has no type", tag.name)),
                        tag.dimensions,
                    ),
                }
            }
            Root::Member(add_on, index) => {
                let instance = frame.instance.as_ref().unwrap_or_else(|| panic!("outside an Add-On Instruction"));
                let definition = &frame.project.add_ons[usize::from(add_on.0)];
                let record = frame.project.types.record(definition.instance_type.unwrap_or_else(|| panic!("no type")));
                let declared = &record.members[usize::from(index)];
                (instance.target.part(u32::from(index)), declared.type_reference, declared.dimensions)
            }
            Root::InOut(add_on, index) => {
                let instance = frame.instance.as_ref().unwrap_or_else(|| panic!("outside an Add-On Instruction"));
                let parameter = &frame.project.add_ons[usize::from(add_on.0)].parameters[usize::from(index)];
                (
                    instance.in_out[&index].clone(),
                    parameter.type_reference.unwrap_or_else(|| panic!("no type")),
                    parameter.dimensions,
                )
            }
        };
        for step in &reference.steps {
            match step {
                Step::Member(index) => {
                    let TypeReference::Structure(structure) = type_reference else { panic!("no structure") };
                    let declared = &frame.project.types.record(structure).members[usize::from(*index)];
                    target = target.part(u32::from(*index));
                    type_reference = declared.type_reference;
                    dimensions = declared.dimensions;
                }
                Step::Subscript(subscripts) => {
                    let mut position: u32 = 0;
                    for (subscript, size) in subscripts.iter().zip(dimensions) {
                        let value = match subscript {
                            Subscript::Constant(value) => i64::from(*value),
                            Subscript::Expression(expression) => i64::from(self.subscript_value(frame, expression)?),
                        };
                        if value < 0 || value >= i64::from(size) {
                            return Err(Exit::Fault(20));
                        }
                        position = position * size + value as u32;
                    }
                    target = target.part(position);
                    dimensions = [0; 3];
                }
                Step::Bit(bit) => target.bit = Some(*bit),
                Step::BitExpression(expression) => {
                    let TypeReference::Element(element) = type_reference else { panic!("no integer") };
                    let value = self.subscript_value(frame, expression)?;
                    if value < 0 || value >= i32::from(element.bits()) {
                        return Err(Exit::Fault(20));
                    }
                    target.bit = Some(value as u8);
                }
            }
        }
        Ok(target)
    }
}

/// The dimensions of what a reference names.
pub(crate) fn dimensions_of(project: &Project, reference: &Reference) -> [u32; 3] {
    let (mut type_reference, mut dimensions) = match reference.root {
        Root::Tag(id) => match &project.tag(id).kind {
            TagKind::Alias(Some(alias)) => (Some(alias.reference.type_reference), alias.reference.dimensions),
            _ => (project.tag(id).type_reference, project.tag(id).dimensions),
        },
        Root::Member(add_on, index) => {
            let definition = &project.add_ons[usize::from(add_on.0)];
            let record = project.types.record(definition.instance_type.unwrap_or_else(|| panic!("no type")));
            let declared = &record.members[usize::from(index)];
            (Some(declared.type_reference), declared.dimensions)
        }
        Root::InOut(add_on, index) => {
            let parameter = &project.add_ons[usize::from(add_on.0)].parameters[usize::from(index)];
            (parameter.type_reference, parameter.dimensions)
        }
    };
    for step in &reference.steps {
        match (step, type_reference) {
            (Step::Member(index), Some(TypeReference::Structure(structure))) => {
                let declared = &project.types.record(structure).members[usize::from(*index)];
                (type_reference, dimensions) = (Some(declared.type_reference), declared.dimensions);
            }
            _ => dimensions = [0; 3],
        }
    }
    dimensions
}
