//! COP, FLL, SIZE, SWPB. general-instructions.md A.5 and A.6.

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::{Element, PredefinedType};
use twinrung_compiler::operand::{Operand, Reference, Step};
use twinrung_compiler::project::{OperandUse, Types};

use crate::arithmetic::{Number, canonical};
use crate::evaluator::{Exit, Judge};
use crate::memory::{Frame, Target, narrowed};
use crate::value::Value;

/// Writes a value's bytes at an offset in the Logix layout, or takes them from there.
trait Bytes {
    fn bit(&mut self, byte: usize, bit: u8, value: &mut bool);
    fn integer(&mut self, byte: usize, length: usize, value: &mut i32);
}

struct Gather(Vec<u8>);
struct Scatter(Vec<u8>);

impl Bytes for Gather {
    fn bit(&mut self, byte: usize, bit: u8, value: &mut bool) {
        self.0[byte + usize::from(bit / 8)] |= u8::from(*value) << (bit % 8);
    }

    fn integer(&mut self, byte: usize, length: usize, value: &mut i32) {
        self.0[byte..byte + length].copy_from_slice(&value.to_le_bytes()[..length]);
    }
}

impl Bytes for Scatter {
    fn bit(&mut self, byte: usize, bit: u8, value: &mut bool) {
        *value = (self.0[byte + usize::from(bit / 8)] >> (bit % 8)) & 1 == 1;
    }

    fn integer(&mut self, byte: usize, length: usize, value: &mut i32) {
        let mut bytes = [0; 4];
        bytes[..length].copy_from_slice(&self.0[byte..byte + length]);
        *value = i32::from_le_bytes(bytes);
    }
}

/// Bytes of one element of a type, and its alignment.
fn size(types: &Types, type_reference: TypeReference) -> (usize, usize) {
    match type_reference {
        TypeReference::Element(element) => (element.bytes() as usize, element.bytes() as usize),
        TypeReference::Structure(index) => {
            let record = types.record(index);
            if let Some(known) = PredefinedType::by_name(&record.name) {
                return (known.bytes as usize, 4);
            }
            let end = places(types, type_reference).last().map_or(0, |place| place.end);
            (end.next_multiple_of(4), 4)
        }
    }
}

struct MemberPlace {
    byte: usize,
    bit: u8,
    end: usize,
}

/// Where each member of a structure lies: neutral-text-and-l5x.md D.4.
fn places(types: &Types, type_reference: TypeReference) -> Vec<MemberPlace> {
    let TypeReference::Structure(index) = type_reference else { return Vec::new() };
    let record = types.record(index);
    if let Some(known) = PredefinedType::by_name(&record.name) {
        return known
            .members
            .iter()
            .map(|member| MemberPlace { byte: member.byte as usize, bit: member.bit, end: known.bytes as usize })
            .collect();
    }
    let mut places: Vec<MemberPlace> = Vec::new();
    let (mut end, mut packed) = (0_usize, 8_u8);
    for member in &record.members {
        let array = member.dimensions != [0; 3];
        let count = member.dimensions.iter().map(|size| (*size).max(1) as usize).product::<usize>();
        let boolean = member.type_reference == TypeReference::Element(Element::Bool);
        if boolean && !array {
            if packed == 8 {
                (end, packed) = (end + 1, 0);
            }
            places.push(MemberPlace { byte: end - 1, bit: packed, end });
            packed += 1;
            continue;
        }
        packed = 8;
        let (bytes, alignment) = if boolean { (count / 8, 4) } else { size(types, member.type_reference) };
        let begin = end.next_multiple_of(alignment);
        end = begin + if boolean { bytes } else { bytes * count };
        places.push(MemberPlace { byte: begin, bit: 0, end });
    }
    places
}

fn walk(types: &Types, type_reference: TypeReference, value: &mut Value, byte: usize, bit: u8, bytes: &mut dyn Bytes) {
    match value {
        Value::Bit(value) => bytes.bit(byte, bit, value),
        Value::Integer(element, value) => {
            bytes.integer(byte, element.bytes() as usize, value);
            *value = narrowed(*element, *value);
        }
        Value::Real(value) => {
            let mut pattern = *value as i32;
            bytes.integer(byte, 4, &mut pattern);
            *value = pattern as u32;
        }
        Value::Array(parts) => {
            let boolean = type_reference == TypeReference::Element(Element::Bool);
            let step = if boolean { 0 } else { size(types, type_reference).0 };
            for (index, part) in parts.iter_mut().enumerate() {
                let (byte, bit) =
                    if boolean { (byte + index / 8, (index % 8) as u8) } else { (byte + step * index, 0) };
                walk(types, type_reference, part, byte, bit, bytes);
            }
        }
        Value::Structure(parts) => {
            let TypeReference::Structure(index) = type_reference else { panic!("no structure") };
            let members = &types.record(index).members;
            for ((part, place), member) in parts.iter_mut().zip(places(types, type_reference)).zip(members) {
                walk(types, member.type_reference, part, byte + place.byte, place.bit, bytes);
            }
        }
    }
}

impl Judge<'_> {
    /// The first element that an operand of COP, FLL or GSV means: the first of an array named as a whole.
    pub(crate) fn first_element(
        &mut self,
        frame: &Frame<'_>,
        operand: OperandUse,
    ) -> Result<(Target, Reference), Exit> {
        let Operand::Reference(reference) = frame.project.operand(operand.id) else { panic!("not a reference") };
        let target = self.locate(frame, reference)?;
        let target = if reference.dimensions == [0; 3] { target } else { target.part(0) };
        Ok((target, reference.clone()))
    }

    /// Checks that so many elements lie between a first one and the end of its array, as it is declared: an InOut parameter
    /// ends where its declaration ends, however long its argument is.
    pub(crate) fn within(
        &self,
        frame: &Frame<'_>,
        operand: OperandUse,
        target: &Target,
        count: u32,
    ) -> Result<(), Exit> {
        let Operand::Reference(reference) = frame.project.operand(operand.id) else { panic!("not a reference") };
        let is_element = matches!(reference.steps.last(), Some(Step::Subscript(_)));
        if reference.dimensions == [0; 3] && !is_element {
            return Ok(());
        }
        let sizes = self.declared_dimensions(frame, operand);
        let elements: u32 = sizes.into_iter().filter(|size| *size > 0).product();
        let first = target.path.last().copied().unwrap_or_default();
        if first + count > elements { Err(Exit::Fault(20)) } else { Ok(()) }
    }

    fn constant(&self, frame: &Frame<'_>, operand: OperandUse) -> u32 {
        match frame.project.operand(operand.id) {
            Operand::Integer { value, .. } => *value as u32,
            other => panic!("not a constant: {other:?}"),
        }
    }

    pub(crate) fn copy(&mut self, frame: &Frame<'_>, operands: &[OperandUse]) -> Result<(), Exit> {
        let (source, from) = self.first_element(frame, operands[0])?;
        let (destination, to) = self.first_element(frame, operands[1])?;
        let count = self.constant(frame, operands[2]);
        self.within(frame, operands[0], &source, count)?;
        self.within(frame, operands[1], &destination, count)?;
        let bytes = self.bytes_of(frame, &source, from.type_reference, count);
        self.scatter(frame, &destination, to.type_reference, count, bytes);
        Ok(())
    }

    /// The first element that an operand means, how many from there on hold so many bytes, and what they hold.
    pub(crate) fn bytes_from(
        &mut self,
        frame: &Frame<'_>,
        operand: OperandUse,
        bytes: usize,
    ) -> Result<(Target, u32, Vec<u8>), Exit> {
        let (first, reference) = self.first_element(frame, operand)?;
        let elements = bytes.div_ceil(size(&frame.project.types, reference.type_reference).0) as u32;
        self.within(frame, operand, &first, elements)?;
        let held = self.bytes_of(frame, &first, reference.type_reference, elements);
        Ok((first, elements, held))
    }

    /// Puts back what `bytes_from` gave, changed.
    pub(crate) fn put_bytes(
        &mut self,
        frame: &Frame<'_>,
        operand: OperandUse,
        first: &Target,
        elements: u32,
        bytes: Vec<u8>,
    ) {
        let Operand::Reference(reference) = frame.project.operand(operand.id) else { panic!("not a reference") };
        self.scatter(frame, first, reference.type_reference, elements, bytes);
    }

    fn bytes_of(&self, frame: &Frame<'_>, first: &Target, type_reference: TypeReference, count: u32) -> Vec<u8> {
        let types = &frame.project.types;
        let each = size(types, type_reference).0;
        let mut gather = Gather(vec![0; each * count as usize]);
        for index in 0..count {
            let mut value = self.memory.get(&first.following(index)).clone();
            walk(types, type_reference, &mut value, each * index as usize, 0, &mut gather);
        }
        gather.0
    }

    fn scatter(
        &mut self,
        frame: &Frame<'_>,
        first: &Target,
        type_reference: TypeReference,
        count: u32,
        bytes: Vec<u8>,
    ) {
        let types = &frame.project.types;
        let each = size(types, type_reference).0;
        let mut scatter = Scatter(bytes);
        for index in 0..count {
            let value = self.memory.get_mut(&first.following(index));
            walk(types, type_reference, value, each * index as usize, 0, &mut scatter);
        }
    }

    pub(crate) fn fill(&mut self, frame: &Frame<'_>, operands: &[OperandUse]) -> Result<(), Exit> {
        let value = self.number(frame, operands[0])?;
        let (destination, _) = self.first_element(frame, operands[1])?;
        let count = self.constant(frame, operands[2]);
        self.within(frame, operands[1], &destination, count)?;
        for index in 0..count {
            self.store_and_report(frame, &destination.following(index), value);
        }
        Ok(())
    }

    pub(crate) fn size(&mut self, frame: &Frame<'_>, operands: &[OperandUse]) -> Result<(), Exit> {
        let dimension = self.constant(frame, operands[1]) as usize;
        let sizes = self.declared_dimensions(frame, operands[0]);
        let target = self.target(frame, operands[2])?;
        self.store_and_report(frame, &target, Number::Integer(sizes[dimension] as i32));
        Ok(())
    }

    /// Stores a number; S:V alone says that it did not fit.
    pub(crate) fn store_and_report(&mut self, frame: &Frame<'_>, target: &Target, value: Number) {
        if self.store(target, value) {
            self.overflow(frame);
        }
    }

    /// The dimensions of the array that an operand names, as a whole or by one of its elements.
    fn declared_dimensions(&self, frame: &Frame<'_>, operand: OperandUse) -> [u32; 3] {
        let Operand::Reference(reference) = frame.project.operand(operand.id) else { panic!("not a reference") };
        if reference.dimensions != [0; 3] {
            return reference.dimensions;
        }
        let mut whole = reference.clone();
        whole.steps.pop();
        crate::memory::dimensions_of(frame.project, &whole)
    }

    pub(crate) fn swap_bytes(&mut self, frame: &Frame<'_>, operands: &[OperandUse]) -> Result<(), Exit> {
        let source = self.target(frame, operands[0])?;
        let Operand::Choice(order) = frame.project.operand(operands[1].id) else { panic!("no order") };
        let destination = self.target(frame, operands[2])?;
        let value = self.memory.integer(&source);
        let swapped = if self.element(&source) == Element::Int {
            i32::from((value as i16).swap_bytes())
        } else {
            let [a, b, c, d] = value.to_be_bytes();
            i32::from_be_bytes(match order {
                0 => [d, c, b, a],
                1 => [c, d, a, b],
                _ => [b, a, d, c],
            })
        };
        let real = self.element(&destination) == Element::Real;
        let stored = if real { canonical(swapped as u32) as i32 } else { swapped };
        self.memory.set_integer(&destination, stored);
        Ok(())
    }
}
