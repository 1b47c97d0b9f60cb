//! Calls of Add-On Instructions.

use alloc::rc::Rc;
use alloc::vec::Vec;

use twinrung_catalog::Element;

use super::instruction::Check;
use super::operands::{Entry, Fact};
use super::place::Place;
use crate::code::Operands;
use crate::error::ImageError;
use crate::image::{AddOnRecord, Owner, ParameterRecord, TypeReference, Usage};
use crate::limits;

impl Check<'_, '_> {
    /// A call: operand 0 is the instance, then one operand for each parameter that has an argument.
    pub(super) fn add_on(&mut self, operands: Operands<'_>) -> Result<(), ImageError> {
        let at = self.at;
        let no_instance = ImageError::AddOnInstance { at };
        let first = operands.get(0).ok_or(no_instance.clone())?;
        let Fact::Reference(instance) = self.entry(0, first)?.fact else { return Err(no_instance) };
        if instance.is_whole_array() || instance.bit.is_some() {
            return Err(no_instance);
        }
        if instance.variable {
            return Err(ImageError::AddOnVariable { at, position: 0 });
        }
        let callee = self.tables.instance_of(instance.type_reference).ok_or(no_instance.clone())?;
        if let Owner::AddOn(caller) = self.owner
            && callee >= caller
        {
            return Err(ImageError::AddOnOrder { at });
        }
        let record: &AddOnRecord = self.tables.image.add_ons.get(callee.position()).ok_or(no_instance.clone())?;
        let summary = self.state.summaries.get(callee.position()).ok_or(ImageError::AddOnOrder { at })?;
        let summary = Rc::clone(summary);
        if operands.len() != summary.arguments.len().saturating_add(1) {
            return Err(ImageError::OperandCount { at });
        }
        self.write(&instance, 1)?;
        let mut in_out: Vec<(u16, Place)> = Vec::new();
        for (index, (position, operand)) in summary.arguments.iter().zip(operands.iter().enumerate().skip(1)) {
            let parameter = record.parameters.get(usize::from(*index)).ok_or(no_instance.clone())?;
            let entry = self.entry(position, operand)?;
            match (parameter.usage, entry.fact) {
                (Usage::InOut, Fact::Reference(place)) => {
                    self.in_out(position, parameter, &place)?;
                    if summary.writes.get(usize::from(*index)) == Some(&true) {
                        let elements = layout_elements(parameter);
                        self.write(&place, elements)?;
                    }
                    in_out.push((*index, place));
                }
                (Usage::InOut, _) => return Err(ImageError::AddOnArgument { at, position }),
                (Usage::Input | Usage::Output, _) => self.argument(position, parameter, &entry)?,
            }
        }
        self.state.use_callee(at, &summary, &instance, &in_out)?;
        self.length = self.length.saturating_add(summary.length).saturating_add(1);
        let depth = summary.depth.saturating_add(1);
        if depth > limits::ADD_ON_DEPTH {
            return Err(ImageError::AddOnDepth { at });
        }
        self.state.current.depth = self.state.current.depth.max(depth);
        Ok(())
    }

    /// An argument that is copied: BOOL to BOOL, number to number.
    fn argument(&mut self, position: usize, parameter: &ParameterRecord, entry: &Entry) -> Result<(), ImageError> {
        let at = self.at;
        let is_bool = parameter.type_reference == TypeReference::Element(Element::Bool);
        let output = parameter.usage == Usage::Output;
        match entry.fact {
            Fact::Reference(place) if (is_bool && place.is_bit()) || (!is_bool && place.word().is_some()) => {
                if output {
                    self.write(&place, 1)
                } else {
                    Ok(())
                }
            }
            Fact::Integer(value) if !output && (!is_bool || (0..=1).contains(&value)) => Ok(()),
            Fact::Real(_) if !output && !is_bool => Ok(()),
            _ => Err(ImageError::AddOnArgument { at, position }),
        }
    }

    /// An argument that is referred to: the same type; an array may be longer in its first dimension.
    fn in_out(&self, position: usize, parameter: &ParameterRecord, place: &Place) -> Result<(), ImageError> {
        let at = self.at;
        if place.variable {
            return Err(ImageError::AddOnVariable { at, position });
        }
        let [first, second, third] = parameter.dimensions;
        let [length, inner, innermost] = place.dimensions;
        let fits = place.bit.is_none()
            && place.type_reference == parameter.type_reference
            && (inner, innermost) == (second, third)
            && (length == first || (first > 0 && length > first));
        if fits { Ok(()) } else { Err(ImageError::AddOnArgument { at, position }) }
    }
}

/// Elements that an InOut parameter reaches.
fn layout_elements(parameter: &ParameterRecord) -> u32 {
    crate::layout::elements(parameter.dimensions).unwrap_or(u32::MAX)
}
