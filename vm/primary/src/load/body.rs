//! Decodes the code of a routine, for a program once, for an Add-On Instruction once for each call with the arguments'
//! own cells.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use twinrung_bytecode::format;
use twinrung_bytecode::image::{ParameterRecord, TypeReference, Usage};
use twinrung_bytecode::limits;
use twinrung_catalog::{Element, Opcode};

use super::operand::{Binding, element_of};
use super::reader::Reader;
use super::{Loader, copy};
use crate::error::LoadError;
use crate::program::{AddOnCall, Argument, Code, Instruction, Jump, Label, Location, NONE, Operand, Range, SafetyCall};

/// What is known of a body while it is built.
struct Building {
    body: u32,
    rung: u32,
    element: u32,
    /// Labels by name in lower case.
    labels: BTreeMap<Vec<u8>, u32>,
    /// JMPs: the rung, and the name of the label.
    jumping: Vec<(u32, Vec<u8>)>,
    /// Position of the rung's first code.
    rung_code: u32,
}

impl Loader<'_> {
    pub(super) fn build_body(&mut self, body: u32, binding: &Binding) -> Result<(), LoadError> {
        const MALFORMED: LoadError = LoadError::Malformed("the code of a routine");
        let routine = self.program.bodies.get(body as usize).ok_or(MALFORMED)?.routine;
        let image = self.image;
        let record = image.routines.get(routine as usize).ok_or(MALFORMED)?;
        let mut reader = Reader::new(&record.code);
        let first = self.program.codes.len();
        let mut building =
            Building { body, rung: 0, element: 0, labels: BTreeMap::new(), jumping: Vec::new(), rung_code: 0 };
        let mut depth = 0usize;
        while !reader.is_empty() {
            let code = match reader.u8()? {
                format::RUNG => {
                    building.element = 0;
                    building.rung_code = self.program.codes.len() as u32;
                    Code::Rung
                }
                format::END_RUNG => {
                    building.rung = building.rung.saturating_add(1);
                    Code::EndRung
                }
                format::BRANCH => {
                    depth = depth.saturating_add(1);
                    Code::Branch
                }
                format::NEXT_LEG => Code::NextLeg,
                format::END_BRANCH => {
                    depth = depth.checked_sub(1).ok_or(MALFORMED)?;
                    Code::EndBranch
                }
                format::ADD_ON => self.add_on(&mut reader, &mut building, binding)?,
                number => {
                    let opcode = Opcode::from_number(number).ok_or(MALFORMED)?;
                    self.instruction(opcode, &mut reader, &mut building, binding)?
                }
            };
            if depth > limits::BRANCH_DEPTH {
                return Err(LoadError::TooLarge("the nesting of branches"));
            }
            self.program.codes.push(code);
            if matches!(code, Code::Instruction(_) | Code::AddOn(_)) {
                building.element = building.element.saturating_add(1);
                self.expanded = self.expanded.saturating_add(1);
            }
            if self.expanded > limits::EXPANDED_INSTRUCTIONS {
                return Err(LoadError::TooLarge("the bodies of Add-On Instructions"));
            }
        }
        let jumps = self.jumps(&building)?;
        if let Some(entry) = self.program.bodies.get_mut(body as usize) {
            entry.codes = Range::since(first, &self.program.codes);
            entry.jumps = jumps;
        }
        Ok(())
    }

    /// Finds the labels of a body's JMPs; gives the JMPs, if one of them jumps backward.
    fn jumps(&mut self, building: &Building) -> Result<Range, LoadError> {
        const MALFORMED: LoadError = LoadError::Malformed("the label of a JMP");
        let first = self.program.jumps.len().saturating_sub(building.jumping.len());
        let jumps = Range::since(first, &self.program.jumps);
        let mut any_backward = false;
        for (jump, (rung, name)) in self.program.jumps.iter_mut().skip(first).zip(&building.jumping) {
            jump.label = *building.labels.get(name).ok_or(MALFORMED)?;
            jump.backward = self.program.labels.get(jump.label as usize).ok_or(MALFORMED)?.rung <= *rung;
            any_backward |= jump.backward;
        }
        Ok(if any_backward { jumps } else { Range::default() })
    }

    fn operand_indices(reader: &mut Reader<'_>) -> Result<Vec<u32>, LoadError> {
        let count = usize::from(reader.u8()?);
        (0..count).map(|_| reader.u32()).collect()
    }

    fn instruction(
        &mut self,
        opcode: Opcode,
        reader: &mut Reader<'_>,
        building: &mut Building,
        binding: &Binding,
    ) -> Result<Code, LoadError> {
        let indices = Self::operand_indices(reader)?;
        let mut extra = NONE;
        let operands = match opcode {
            Opcode::Lbl => {
                let name = self.label(&indices)?;
                let label = self.program.labels.len() as u32;
                self.program.labels.push(Label { code: building.rung_code, rung: building.rung, step: 0 });
                building.labels.insert(name, label);
                Range::default()
            }
            Opcode::Jmp => {
                let name = self.label(&indices)?;
                extra = self.program.jumps.len() as u32;
                building.jumping.push((building.rung, name));
                self.program.jumps.push(Jump { label: NONE, backward: false });
                Range::default()
            }
            Opcode::Cpt => {
                let dest = self.first_operand(&indices, 0, binding)?;
                let expression = self.expression_operand(&indices, 1, binding, is_real(dest))?;
                self.push_operands(&[dest, expression])
            }
            Opcode::Cmp => {
                let expression = self.expression_operand(&indices, 0, binding, false)?;
                self.push_operands(&[expression])
            }
            Opcode::Fal | Opcode::Fsc => {
                let with_destination = opcode == Opcode::Fal;
                let last = if with_destination { 5 } else { 4 };
                let mut operands = Vec::with_capacity(6);
                for position in 0..last {
                    operands.push(self.first_operand(&indices, position, binding)?);
                }
                let real = with_destination && operands.last().is_some_and(|dest| is_real(*dest));
                operands.push(self.expression_operand(&indices, last, binding, real)?);
                self.push_operands(&operands)
            }
            Opcode::Size => {
                let dimension = match self.first_operand(&indices, 1, binding)? {
                    Operand::Integer(dimension) => usize::try_from(dimension).unwrap_or(usize::MAX),
                    _ => return Err(LoadError::Malformed("the dimension of a SIZE")),
                };
                let array = *indices.first().ok_or(LoadError::Malformed("the operands of a SIZE"))?;
                let size = Operand::Integer(self.dimension(array, dimension)?);
                let dest = self.first_operand(&indices, 2, binding)?;
                self.push_operands(&[size, dest])
            }
            _ => self.operands(&indices, binding)?,
        };
        match opcode {
            Opcode::Cop | Opcode::Fll => extra = self.copy_plan(operands)?,
            Opcode::Gsv | Opcode::Ssv => extra = self.system_plan(operands)?,
            _ if opcode.instruction().group.is_safety_library() => extra = self.safety_call(opcode, operands)?,
            _ => {}
        }
        let index = self.program.instructions.len() as u32;
        self.program.instructions.push(Instruction { opcode, operands, element: building.element, extra });
        if opcode == Opcode::Sbr
            && building.rung == 0
            && building.element == 0
            && let Some(body) = self.program.bodies.get_mut(building.body as usize)
        {
            body.parameters = index;
        }
        Ok(Code::Instruction(index))
    }

    fn label(&self, indices: &[u32]) -> Result<Vec<u8>, LoadError> {
        const MALFORMED: LoadError = LoadError::Malformed("the operand of a JMP or LBL");
        let mut reader = self.entry(*indices.first().ok_or(MALFORMED)?)?;
        if reader.u8()? != format::TEXT {
            return Err(MALFORMED);
        }
        let length = usize::from(reader.u16()?);
        Ok(reader.take(length)?.to_ascii_lowercase())
    }

    fn first_operand(&mut self, indices: &[u32], position: usize, binding: &Binding) -> Result<Operand, LoadError> {
        let index = *indices.get(position).ok_or(LoadError::Malformed("the number of operands"))?;
        let known = self.operand(index, binding)?;
        self.program.operands.get(known as usize).copied().ok_or(LoadError::Malformed("the index of an operand"))
    }

    fn expression_operand(
        &mut self,
        indices: &[u32],
        position: usize,
        binding: &Binding,
        real_destination: bool,
    ) -> Result<Operand, LoadError> {
        let index = *indices.get(position).ok_or(LoadError::Malformed("the number of operands"))?;
        self.expression(index, binding, real_destination)
    }

    fn push_operands(&mut self, operands: &[Operand]) -> Range {
        let first = self.program.operands.len();
        self.program.operands.extend_from_slice(operands);
        Range::since(first, &self.program.operands)
    }

    fn operands(&mut self, indices: &[u32], binding: &Binding) -> Result<Range, LoadError> {
        if let [only] = indices {
            return Ok(Range { first: self.operand(*only, binding)?, count: 1 });
        }
        let mut operands = Vec::with_capacity(indices.len());
        for position in 0..indices.len() {
            operands.push(self.first_operand(indices, position, binding)?);
        }
        Ok(self.push_operands(&operands))
    }

    /// The plan of a COP or FLL: operands source, destination, length.
    fn copy_plan(&mut self, operands: Range) -> Result<u32, LoadError> {
        let Operand::Integer(length) = self.program.operand(operands, 2) else {
            return Err(LoadError::Malformed("the length of a COP or FLL"));
        };
        let length = u32::try_from(length).map_err(|_| LoadError::Malformed("the length of a COP or FLL"))?;
        let source = self.side(self.program.operand(operands, 0))?;
        let destination = self.side(self.program.operand(operands, 1))?;
        self.push_plan(copy::plan(length, source, destination)?)
    }

    /// The plan of a GSV or SSV: its data, as many elements as hold the bytes of the attribute.
    fn system_plan(&mut self, operands: Range) -> Result<u32, LoadError> {
        const MALFORMED: LoadError = LoadError::Malformed("the operands of a GSV or SSV");
        let Operand::SystemValue(index) = self.program.operand(operands, 2) else { return Err(MALFORMED) };
        let bytes = self.program.system_values.get(usize::from(index)).ok_or(MALFORMED)?.bytes();
        let side = self.side(self.program.operand(operands, 3))?;
        let covered = bytes.checked_next_multiple_of(side.bytes).ok_or(MALFORMED)?;
        let length = covered.checked_div(side.bytes).ok_or(MALFORMED)?;
        self.push_plan(copy::plan(length, side, side)?)
    }

    fn safety_call(&mut self, opcode: Opcode, operands: Range) -> Result<u32, LoadError> {
        let Some(Location { bit, word, formula: NONE }) = self.program.operand(operands, 0).location() else {
            return Err(LoadError::Unsupported("a backing tag with a variable subscript"));
        };
        let fresh = self.safety_states.len() as u32;
        let state = *self.known_states.entry((bit, word)).or_insert(fresh);
        if state == fresh {
            self.safety_states.push(opcode);
        }
        let index = self.program.safety_calls.len() as u32;
        self.program.safety_calls.push(SafetyCall { opcode, state, bit, word });
        Ok(index)
    }

    fn add_on(
        &mut self,
        reader: &mut Reader<'_>,
        building: &mut Building,
        binding: &Binding,
    ) -> Result<Code, LoadError> {
        const MALFORMED: LoadError = LoadError::Malformed("the call of an Add-On Instruction");
        let indices = Self::operand_indices(reader)?;
        let (instance, arguments) = indices.split_first().ok_or(MALFORMED)?;
        let reference = self.reference(*instance, binding)?;
        let crate::program::Content::Structure(type_index) = reference.content else { return Err(MALFORMED) };
        if !reference.terms.is_empty() {
            return Err(LoadError::Unsupported("an instance with a variable subscript"));
        }
        let image = self.image;
        let add_on = image.add_ons.iter().find(|add_on| add_on.instance_type.0 == type_index).ok_or(MALFORMED)?;
        let base = (reference.bit, reference.word);
        let mut inner = Binding { instance: Some(base), in_outs: alloc::vec![None; add_on.parameters.len()] };
        let (mut inputs, mut outputs, mut varying) = (Vec::new(), Vec::new(), Vec::new());
        let mut remaining = arguments.iter();
        for (position, parameter) in add_on.parameters.iter().enumerate() {
            if !parameter.argument {
                continue;
            }
            let outside = *remaining.next().ok_or(MALFORMED)?;
            let outside = self.operand(outside, binding)?;
            let operand = self.program.operands.get(outside as usize).copied().ok_or(MALFORMED)?;
            match parameter.usage {
                Usage::InOut => {
                    let cells = match operand {
                        Operand::WordBit { .. } => None,
                        _ => operand.location().filter(|location| location.formula == NONE),
                    };
                    let cells = cells.ok_or(LoadError::Unsupported("an InOut argument with a variable subscript"))?;
                    if let Some(slot) = inner.in_outs.get_mut(position) {
                        *slot = Some((cells.bit, cells.word));
                    }
                }
                usage => {
                    let inside = self.parameter_cell(type_index, parameter, base)?;
                    let inside = self.push_operand(inside)?;
                    let side = if usage == Usage::Input { &mut inputs } else { &mut outputs };
                    side.push(Argument { outside, inside });
                    if !operand.is_fixed() {
                        varying.push(Argument { outside, inside });
                    }
                }
            }
        }
        if remaining.next().is_some() {
            return Err(MALFORMED);
        }
        let enable = |position: usize| -> Result<u32, LoadError> {
            let parameter = add_on.parameters.get(position).ok_or(MALFORMED)?;
            match self.parameter_cell(type_index, parameter, base)? {
                Operand::Bit(location) => Ok(location.bit),
                _ => Err(MALFORMED),
            }
        };
        let (enable_in, enable_out) = (enable(0)?, enable(1)?);
        let (inputs, outputs) = (self.push_arguments(&inputs), self.push_arguments(&outputs));
        let varying = self.push_arguments(&varying);
        let logic = self.new_body(add_on.logic.0, inner.clone(), false, true)?;
        let enable_in_false = match add_on.enable_in_false {
            Some(routine) => self.new_body(routine.0, inner.clone(), false, true)?,
            None => NONE,
        };
        let prescan = match add_on.prescan {
            Some(routine) => self.new_body(routine.0, inner, false, false)?,
            None => NONE,
        };
        let index = self.program.calls.len() as u32;
        self.program.calls.push(AddOnCall {
            element: building.element,
            enable_in,
            enable_out,
            inputs,
            outputs,
            varying,
            logic,
            prescan,
            enable_in_false,
        });
        Ok(Code::AddOn(index))
    }

    fn push_arguments(&mut self, arguments: &[Argument]) -> Range {
        let first = self.program.arguments.len();
        self.program.arguments.extend_from_slice(arguments);
        Range::since(first, &self.program.arguments)
    }

    /// The cell of a parameter in an instance.
    fn parameter_cell(
        &self,
        type_index: u16,
        parameter: &ParameterRecord,
        base: (u32, u32),
    ) -> Result<Operand, LoadError> {
        const MALFORMED: LoadError = LoadError::Malformed("a parameter of an Add-On Instruction");
        let member = usize::from(parameter.member.ok_or(MALFORMED)?);
        let layout = self.layouts.get(usize::from(type_index)).ok_or(MALFORMED)?;
        let place = layout.members.get(member).ok_or(MALFORMED)?;
        let location = Location {
            bit: place.bit_cell.saturating_add(base.0),
            word: place.word_cell.saturating_add(base.1),
            formula: NONE,
        };
        match parameter.type_reference {
            TypeReference::Element(Element::Bool) => Ok(Operand::Bit(location)),
            TypeReference::Element(element) => {
                let element = element_of(element as u8)?;
                Ok(Operand::Word { location, element, count: 1 })
            }
            TypeReference::Structure(_) => Err(MALFORMED),
        }
    }
}

fn is_real(operand: Operand) -> bool {
    matches!(operand, Operand::Word { element: Element::Real, .. })
}
