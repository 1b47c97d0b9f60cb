//! Calls of safety application instructions: the library's ladder, its parameters bound to the backing tag's members.

use alloc::format;
use alloc::rc::Rc;
use alloc::string::String;
use alloc::vec::Vec;

use twinrung_bytecode::image::{AddOnRecord, ParameterRecord, TagRecord, TypeReference, Usage};
use twinrung_bytecode::index::{RoutineIndex, TypeIndex};
use twinrung_catalog::{Element, MemberRole, Opcode, PredefinedType};

use super::call::member_location;
use super::code::Operands;
use super::context::{Context, Instance};
use super::{LoadError, Loader, Unit};
use crate::ladder::{Call, Input, Location, PrivateCells};

/// The cells of an instance type's elementary member.
fn cell(unit: Unit<'_>, type_index: TypeIndex, member: usize) -> Option<(u32, u32)> {
    let layout = unit.layouts.get(type_index.position())?.members.get(member)?;
    Some((layout.bit_cell, layout.word_cell))
}

/// Whether an operand's name, written as an identifier, is this parameter's name.
fn same_identifier(operand: &str, parameter: &str) -> bool {
    let letters = |text: &str| -> String {
        text.chars().filter(char::is_ascii_alphanumeric).map(|letter| letter.to_ascii_lowercase()).collect()
    };
    letters(operand) == letters(parameter)
}

fn elementary(parameter: &ParameterRecord) -> Option<Element> {
    match parameter.type_reference {
        TypeReference::Element(element) => Some(element),
        TypeReference::Structure(_) => None,
    }
}

/// A backing tag.
struct Backing {
    known: &'static PredefinedType,
    bit: u32,
    word: u32,
    type_index: TypeIndex,
}

impl<'a> Loader<'a> {
    /// Binds a call; its entry of the calls.
    pub(crate) fn safety_call(
        &mut self,
        context: &Rc<Context>,
        opcode: Opcode,
        operands: Operands<'a>,
        routine: RoutineIndex,
    ) -> Result<u32, LoadError> {
        let broken = || LoadError::Routine(routine);
        let declaration = opcode.instruction();
        let mnemonic = declaration.mnemonic;
        let safety = declaration.safety.ok_or(LoadError::Library(mnemonic))?;
        let library = self.library.ok_or(LoadError::Library(mnemonic))?;
        let name = format!("Safety_{mnemonic}");
        let add_on = library
            .image
            .add_ons
            .iter()
            .find(|add_on| add_on.name.eq_ignore_ascii_case(&name))
            .ok_or(LoadError::Library(mnemonic))?;
        let unit = self.unit(context.library).ok_or_else(broken)?;
        let reference = self.structure(context, operands.get(0).ok_or_else(broken)?)?;
        let backing = Backing {
            known: safety.backing,
            bit: reference.bit,
            word: reference.word,
            type_index: reference.type_index,
        };
        let member = |name: &str| {
            let (index, member) = backing.known.member(name)?;
            let (bit, word) = cell(unit, backing.type_index, index)?;
            let location =
                member_location(backing.bit.checked_add(bit)?, backing.word.checked_add(word)?, member.element);
            Some((location, member))
        };
        let enable = |name: &str| match member(name) {
            Some((Location::Bit(cell), _)) => Ok(cell),
            _ => Err(LoadError::LibraryParameter { mnemonic, parameter: name.into() }),
        };
        let (enable_in, enable_out) = (enable("EnableIn")?, enable("EnableOut")?);

        let (mut bits, mut words, private) = self.private_instance(library, add_on).ok_or_else(broken)?;
        let mut unbound: Vec<(&str, Location)> = Vec::new();
        for parameter in &add_on.parameters {
            let fault = || LoadError::LibraryParameter { mnemonic, parameter: parameter.name.clone() };
            let element = elementary(parameter).ok_or_else(fault)?;
            let number = usize::from(parameter.member.ok_or_else(fault)?);
            let (bit, word) = cell(library, add_on.instance_type, number).ok_or_else(fault)?;
            match member(&parameter.name) {
                Some((location, known)) if known.element == element => match location {
                    Location::Bit(target) => set(&mut bits, bit, target),
                    Location::Word(target, _) => set(&mut words, word, target),
                    Location::WordBit(..) | Location::Region { .. } => return Err(fault()),
                },
                Some(_) => return Err(fault()),
                None => {
                    let bit = bits.get(bit as usize).copied().unwrap_or(0);
                    let word = words.get(word as usize).copied().unwrap_or(0);
                    if parameter.usage == Usage::Input {
                        unbound.push((&parameter.name, member_location(bit, word, element)));
                    }
                }
            }
        }

        let (mut arguments, mut inputs, mut configuration) = (Vec::new(), Vec::new(), Vec::new());
        for (index, operand) in declaration.operands.iter().skip(1).enumerate() {
            let mirrored = safety.mirrored.get(index).copied().unwrap_or("");
            let target = if mirrored.is_empty() {
                let found = unbound.iter().position(|(name, _)| same_identifier(operand.name, name));
                found.map(|position| (unbound.swap_remove(position).1, true))
            } else {
                unbound.retain(|(name, _)| !name.eq_ignore_ascii_case(mirrored));
                member(mirrored).map(|(location, known)| (location, known.role == MemberRole::Configuration))
            };
            let Some((parameter, is_configuration)) = target else { continue };
            let argument = self.argument(context, operands.get(index.wrapping_add(1)).ok_or_else(broken)?)?;
            inputs.push(Input { argument: arguments.len() as u32, parameter });
            arguments.push(argument);
            configuration.push(is_configuration);
        }
        if let Some((name, _)) = unbound.first() {
            return Err(LoadError::LibraryParameter { mnemonic, parameter: (*name).into() });
        }

        let inner = Rc::new(Context {
            library: true,
            program: context.program,
            instance: Instance::Scattered { bits, words },
            in_outs: Vec::new(),
        });
        let call = Call {
            arguments,
            inputs,
            outputs: Vec::new(),
            enable_in,
            enable_out,
            logic: self.queue(add_on.logic, Rc::clone(&inner)),
            prescan: add_on.prescan.map(|routine| self.queue(routine, Rc::clone(&inner))),
            enable_in_false: add_on.enable_in_false.map(|routine| self.queue(routine, inner)),
            configuration,
            private,
            prescanned: self.private_bit(false),
        };
        self.calls.push(call);
        Ok(self.calls.len().wrapping_sub(1) as u32)
    }
}

fn set(cells: &mut [u32], index: u32, target: u32) {
    if let Some(cell) = cells.get_mut(index as usize) {
        *cell = target;
    }
}

impl Loader<'_> {
    /// Cells of the channel's own for an instance: for each bit and word of its type the cell.
    fn private_instance(
        &mut self,
        library: Unit<'_>,
        add_on: &AddOnRecord,
    ) -> Option<(Vec<u32>, Vec<u32>, PrivateCells)> {
        let layout = library.layouts.get(add_on.instance_type.position())?;
        let of_type = |tag: &&TagRecord| tag.type_reference == TypeReference::Structure(add_on.instance_type);
        // A tag of the library holds the initial values of an instance; without one they are 0.
        let model = library.image.tags.iter().find(of_type);
        let private = PrivateCells {
            bit: self.initial_bits.len() as u32,
            bits: layout.bit_cells,
            word: self.initial_words.len() as u32,
            words: layout.word_cells,
        };
        for index in 0..layout.bit_cells {
            let value = model
                .and_then(|tag| library.image.initial_bits.get(tag.bit_cell.checked_add(index)? as usize).copied());
            self.initial_bits.push(value.unwrap_or(0) != 0);
        }
        for index in 0..layout.word_cells {
            let value = model
                .and_then(|tag| library.image.initial_words.get(tag.word_cell.checked_add(index)? as usize).copied());
            self.initial_words.push(value.unwrap_or(0));
        }
        let bits = (0..layout.bit_cells).map(|index| private.bit.wrapping_add(index)).collect();
        let words = (0..layout.word_cells).map(|index| private.word.wrapping_add(index)).collect();
        Some((bits, words, private))
    }
}
