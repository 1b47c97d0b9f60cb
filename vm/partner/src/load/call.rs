//! Calls of Add-On Instructions: arguments are bound, and the routines get bodies of their own.

use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::image::{ParameterRecord, TypeKind, TypeReference, Usage};
use twinrung_bytecode::index::RoutineIndex;
use twinrung_catalog::Element;

use super::code::Operands;
use super::context::{Base, Context, Instance};
use super::{LoadError, Loader};
use crate::ladder::{Argument, BodyIndex, Call, Input, Location, NONE, Output, PrivateCells};

/// The cell of an elementary member whose structure begins at these cells.
pub(crate) fn member_location(bit: u32, word: u32, element: Element) -> Location {
    if element == Element::Bool { Location::Bit(bit) } else { Location::Word(word, element) }
}

impl<'a> Loader<'a> {
    /// Binds a call of an Add-On Instruction; its entry of the calls.
    pub(crate) fn add_on_call(
        &mut self,
        context: &Rc<Context>,
        operands: Operands<'a>,
        routine: RoutineIndex,
    ) -> Result<u32, LoadError> {
        let broken = || LoadError::Routine(routine);
        let unit = self.unit(context.library).ok_or_else(broken)?;
        let operand = operands.get(0).ok_or_else(broken)?;
        let instance = self.structure(context, operand)?;
        let record = unit.image.types.get(instance.type_index.position()).ok_or_else(broken)?;
        let layout = unit.layouts.get(instance.type_index.position()).ok_or_else(broken)?;
        let TypeKind::AddOn(index) = record.kind else { return Err(LoadError::Operand(operand)) };
        let add_on = unit.image.add_ons.get(index.position()).ok_or_else(broken)?;
        let location = |parameter: &ParameterRecord| {
            let member = layout.members.get(usize::from(parameter.member?))?;
            let TypeReference::Element(element) = parameter.type_reference else { return None };
            let bit = instance.bit.checked_add(member.bit_cell)?;
            let word = instance.word.checked_add(member.word_cell)?;
            Some(member_location(bit, word, element))
        };
        let mut call = Call {
            arguments: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            enable_in: 0,
            enable_out: 0,
            logic: BodyIndex(0),
            prescan: None,
            enable_in_false: None,
            configuration: Vec::new(),
            private: PrivateCells::default(),
            prescanned: NONE,
        };
        let mut in_outs = vec![None; add_on.parameters.len()];
        let mut next = 1usize;
        for (index, parameter) in add_on.parameters.iter().enumerate() {
            match (index, location(parameter)) {
                (0, Some(Location::Bit(cell))) => call.enable_in = cell,
                (1, Some(Location::Bit(cell))) => call.enable_out = cell,
                _ => {}
            }
            if !parameter.argument {
                continue;
            }
            let operand = operands.get(next).ok_or_else(broken)?;
            next = next.wrapping_add(1);
            let argument = self.argument(context, operand)?;
            if parameter.usage == Usage::InOut {
                let base = base(argument).ok_or(LoadError::Operand(operand))?;
                if let Some(entry) = in_outs.get_mut(index) {
                    *entry = Some(base);
                }
                continue;
            }
            let parameter_cell = location(parameter).ok_or_else(broken)?;
            if parameter.usage == Usage::Input {
                call.inputs.push(Input { argument: call.arguments.len() as u32, parameter: parameter_cell });
                call.arguments.push(argument);
            } else {
                call.outputs.push(Output { argument, parameter: parameter_cell });
                call.arguments.extend(Some(argument).filter(|argument| matches!(argument, Argument::Dynamic(_))));
            }
        }
        let inner = Rc::new(Context {
            library: context.library,
            program: context.program,
            instance: Instance::At { bit: instance.bit, word: instance.word },
            in_outs,
        });
        call.logic = self.queue(add_on.logic, Rc::clone(&inner));
        call.prescan = add_on.prescan.map(|routine| self.queue(routine, Rc::clone(&inner)));
        call.enable_in_false = add_on.enable_in_false.map(|routine| self.queue(routine, inner));
        self.calls.push(call);
        Ok(self.calls.len().wrapping_sub(1) as u32)
    }
}

fn base(argument: Argument) -> Option<Base> {
    match argument {
        Argument::At(Location::Bit(bit)) => Some(Base::Cells { bit, word: 0 }),
        Argument::At(Location::Word(word, _)) => Some(Base::Cells { bit: 0, word }),
        Argument::At(Location::WordBit(word, bit, element)) => Some(Base::WordBit { word, bit, element }),
        Argument::At(Location::Region { bit, word, .. }) => Some(Base::Cells { bit, word }),
        _ => None,
    }
}
