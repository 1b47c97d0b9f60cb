//! Reading one form of a value into cells.

use twinrung_bytecode::image::{TypeKind, TypeReference};
use twinrung_bytecode::index::TypeIndex;
use twinrung_bytecode::layout::{elements, fields};
use twinrung_catalog::{Element, PredefinedType};
use twinrung_grammar::tree::{Number, Span, Text, Value};

use super::{At, Region, Trouble};
use crate::diagnostic::{DATA_DOES_NOT_FIT, Finding, reading_finding};
use crate::project::Types;
/// Reads values with these types.
pub(super) struct Reader<'t> {
    pub types: &'t Types,
}

impl Reader<'_> {
    pub fn value(
        &self,
        value: &Value,
        type_reference: TypeReference,
        dimensions: [u32; 3],
        at: At,
        region: &mut Region,
    ) -> Result<(), Trouble> {
        if dimensions != [0; 3] {
            return self.array(value, type_reference, dimensions, at, region);
        }
        match type_reference {
            TypeReference::Element(element) => {
                let number = number(value, element)?;
                store(region, element, at, number);
                Ok(())
            }
            TypeReference::Structure(index) => self.structure(value, index, at, region),
        }
    }

    fn array(
        &self,
        value: &Value,
        type_reference: TypeReference,
        dimensions: [u32; 3],
        at: At,
        region: &mut Region,
    ) -> Result<(), Trouble> {
        let (bits, words) = self.types.cells(type_reference);
        let count = elements(dimensions).unwrap_or(1);
        let place = |number: u32| At { bit: at.bit + number * bits, word: at.word + number * words };
        match value {
            Value::List { items, span } => {
                if items.len() != count as usize {
                    return Err(self.misfit(*span, &format!("{} values for {count} elements", items.len())));
                }
                for (number, item) in items.iter().enumerate() {
                    self.value(item, type_reference, [0; 3], place(number as u32), region)?;
                }
                Ok(())
            }
            Value::Array { elements: shown, span, .. } => {
                for (index, item) in shown {
                    let mut number = 0;
                    let sizes = dimensions.iter().take_while(|size| **size > 0);
                    let within = index.sizes().len() == sizes.clone().count()
                        && index.sizes().iter().zip(sizes.clone()).all(|(at, size)| at < size);
                    if !within {
                        return Err(self.misfit(item.span(), "an element outside the array"));
                    }
                    for (at, size) in index.sizes().iter().zip(sizes) {
                        number = number * size + at;
                    }
                    self.value(item, type_reference, [0; 3], place(number), region)?;
                }
                if shown.len() != count as usize {
                    return Err(self.misfit(*span, &format!("{} values for {count} elements", shown.len())));
                }
                Ok(())
            }
            Value::String(text) if type_reference == TypeReference::Element(Element::Sint) => {
                let bytes = characters(text)?;
                if bytes.len() > count as usize {
                    return Err(self.misfit(text.span, &format!("{} characters for {count}", bytes.len())));
                }
                for (number, byte) in bytes.into_iter().enumerate() {
                    store(region, Element::Sint, place(number as u32), i32::from(byte as i8));
                }
                Ok(())
            }
            other => Err(self.misfit(other.span(), "an array has a list of values")),
        }
    }

    fn structure(&self, value: &Value, index: TypeIndex, at: At, region: &mut Region) -> Result<(), Trouble> {
        let record = self.types.record(index);
        let layout = self.types.layout(index);
        let place = |position: usize| At {
            bit: at.bit + layout.members[position].bit_cell,
            word: at.word + layout.members[position].word_cell,
        };
        match value {
            Value::Structure { members, .. } => {
                for member in members {
                    let Some(position) = self.types.member(index, member.name.as_str()) else {
                        let message = format!("{} has no member `{}`", record.name, member.name);
                        return Err(self.misfit(member.name.span, &message));
                    };
                    let position = usize::from(position);
                    let declared = &record.members[position];
                    self.value(&member.value, declared.type_reference, declared.dimensions, place(position), region)?;
                }
                Ok(())
            }
            Value::String(text) => {
                let (Some(length), Some(data)) = (self.types.member(index, "LEN"), self.types.member(index, "DATA"))
                else {
                    return Err(self.misfit(text.span, &format!("{} is no string type", record.name)));
                };
                let bytes = characters(text)?;
                store(region, Element::Dint, place(usize::from(length)), bytes.len() as i32);
                let declared = &record.members[usize::from(data)];
                let at = place(usize::from(data));
                self.array(value, declared.type_reference, declared.dimensions, at, region)
            }
            Value::List { items, span } => match (record.kind, PredefinedType::by_name(&record.name)) {
                (TypeKind::Predefined, Some(known)) if known.name != "STRING" => {
                    self.words(items, *span, known, index, at, region)
                }
                (TypeKind::AddOn(_), _) if items.len() != record.members.len() => Err(Trouble::NotVisible(*span)),
                _ => self.members(items, *span, index, at, region),
            },
            Value::Number(text) => {
                let known = PredefinedType::by_name(&record.name).filter(|known| known.bytes == 4);
                match known {
                    Some(known) => self.words(std::slice::from_ref(value), text.span, known, index, at, region),
                    None => Err(self.misfit(text.span, &format!("one number for a {}", record.name))),
                }
            }
            other => Err(self.misfit(other.span(), &format!("this is no {}", record.name))),
        }
    }

    /// A predefined structure in form L5K: its words in the order of memory.
    fn words(
        &self,
        items: &[Value],
        span: Span,
        known: &PredefinedType,
        index: TypeIndex,
        at: At,
        region: &mut Region,
    ) -> Result<(), Trouble> {
        if items.len() != (known.bytes / 4) as usize {
            return Err(Trouble::NotVisible(span));
        }
        let words = items.iter().map(bits_of).collect::<Result<Vec<i32>, Trouble>>()?;
        for (member, place) in known.members.iter().zip(&self.types.layout(index).members) {
            let word = words.get((member.byte / 4) as usize).copied().unwrap_or(0);
            let value = match member.element {
                Element::Bool => (word >> (member.bit & 31)) & 1,
                _ => word,
            };
            store(region, member.element, At { bit: at.bit + place.bit_cell, word: at.word + place.word_cell }, value);
        }
        Ok(())
    }

    /// A structure in form L5K: members in order, consecutive BOOLs as the bytes that hold them. One value for each
    /// member is read too, where the count tells the two apart.
    fn members(
        &self,
        items: &[Value],
        span: Span,
        index: TypeIndex,
        at: At,
        region: &mut Region,
    ) -> Result<(), Trouble> {
        let record = self.types.record(index);
        let layout = self.types.layout(index);
        let is_bit = |position: usize| {
            let member = &record.members[position];
            member.type_reference == TypeReference::Element(Element::Bool) && member.dimensions == [0; 3]
        };
        let place = |position: usize| At {
            bit: at.bit + layout.members[position].bit_cell,
            word: at.word + layout.members[position].word_cell,
        };
        let count = record.members.len();
        let mut hosts = 0;
        let mut last_host = None;
        for position in 0..count {
            let host = is_bit(position).then(|| layout.members[position].byte);
            if host.is_none() || host != last_host {
                hosts += 1;
            }
            last_host = host;
        }
        let packed = items.len() == hosts;
        if !packed && items.len() != count {
            return Err(Trouble::NotVisible(span));
        }
        let mut items = items.iter();
        let mut current: Option<(u32, i32)> = None;
        for (position, member) in record.members.iter().enumerate() {
            if packed && is_bit(position) {
                let byte = layout.members[position].byte;
                let host = match current {
                    Some((known, value)) if known == byte => value,
                    _ => match items.next() {
                        Some(item) => bits_of(item)?,
                        None => return Err(Trouble::NotVisible(span)),
                    },
                };
                current = Some((byte, host));
                store(region, Element::Bool, place(position), (host >> layout.members[position].bit) & 1);
                continue;
            }
            current = None;
            let Some(item) = items.next() else { return Err(Trouble::NotVisible(span)) };
            self.value(item, member.type_reference, member.dimensions, place(position), region)?;
        }
        Ok(())
    }

    /// The memory image.
    pub fn raw(
        &self,
        value: &Value,
        type_reference: TypeReference,
        dimensions: [u32; 3],
        region: &mut Region,
    ) -> Result<(), Trouble> {
        let Value::Bytes { bytes, span } = value else {
            return Err(self.misfit(value.span(), "the memory image is a list of bytes"));
        };
        let (bits, words) = self.types.cells(type_reference);
        let count = elements(dimensions).unwrap_or(1);
        let word_at = |from: usize, size: u32, element: Element| -> Option<i32> {
            let mut raw = [0u8; 4];
            raw.get_mut(..size as usize)?.copy_from_slice(bytes.get(from..from + size as usize)?);
            let wide = i32::from_le_bytes(raw);
            Some(match element {
                Element::Sint => i32::from(wide as i8),
                Element::Int => i32::from(wide as i16),
                _ => wide,
            })
        };
        let size = match type_reference {
            TypeReference::Element(Element::Bool) => 1,
            TypeReference::Element(element) => element.bytes(),
            TypeReference::Structure(index) => self.types.layout(index).bytes,
        };
        if size == 0 {
            return Err(Trouble::NotVisible(*span));
        }
        let packed_bits = type_reference == TypeReference::Element(Element::Bool) && dimensions != [0; 3];
        let expected = if packed_bits { count.div_ceil(32) * 4 } else { size * count };
        if (bytes.len() as u32) < expected || bytes.len() as u32 > expected + 3 {
            return Err(Trouble::NotVisible(*span));
        }
        for number in 0..count {
            let at = At { bit: number * bits, word: number * words };
            match type_reference {
                TypeReference::Element(Element::Bool) => {
                    let bit = if packed_bits {
                        bytes.get((number / 8) as usize).map_or(0, |byte| byte >> (number % 8) & 1)
                    } else {
                        bytes.first().copied().unwrap_or(0) & 1
                    };
                    store(region, Element::Bool, at, i32::from(bit));
                }
                TypeReference::Element(element) => {
                    let value = word_at((number * size) as usize, size, element).ok_or(Trouble::NotVisible(*span))?;
                    store(region, element, at, value);
                }
                TypeReference::Structure(_) => {
                    let from = number * size;
                    for field in fields(self.types.records(), self.types.layouts(), type_reference) {
                        let byte = (from + field.byte + u32::from(field.bit) / 8) as usize;
                        if field.element == Element::Bool {
                            let value = bytes.get(byte).map_or(0, |byte| byte >> (field.bit % 8) & 1);
                            store(region, Element::Bool, At { bit: at.bit + field.cell, ..at }, i32::from(value));
                        } else {
                            let value = word_at((from + field.byte) as usize, field.element.bytes(), field.element)
                                .ok_or(Trouble::NotVisible(*span))?;
                            store(region, field.element, At { word: at.word + field.cell, ..at }, value);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn misfit(&self, span: Span, what: &str) -> Trouble {
        Finding::new(&DATA_DOES_NOT_FIT, span, format!("the data does not fit the type: {what}")).into()
    }
}

fn store(region: &mut Region, element: Element, at: At, value: i32) {
    if element == Element::Bool {
        if let Some(bit) = region.bits.get_mut(at.bit as usize) {
            *bit = u8::from(value & 1 != 0);
        }
    } else if let Some(word) = region.words.get_mut(at.word as usize) {
        *word = value;
    }
}

fn characters(text: &Text) -> Result<Vec<u8>, Trouble> {
    twinrung_grammar::unescape(text).map_err(|error| reading_finding(&error).into())
}

/// A number as the cell of an elementary type holds it.
fn number(value: &Value, element: Element) -> Result<i32, Trouble> {
    let integer = !matches!(element, Element::Bool | Element::Real);
    if let (Value::String(text), true) = (value, integer) {
        return of_characters(text, element);
    }
    let Value::Number(text) = value else {
        let message = format!("the data does not fit the type: expected a {}", element.name());
        return Err(Finding::new(&DATA_DOES_NOT_FIT, value.span(), message).into());
    };
    // The commonest values by far.
    match text.as_str() {
        "0" if element != Element::Real => return Ok(0),
        "1" if element != Element::Real => return Ok(1),
        _ => {}
    }
    let immediate = twinrung_grammar::read_number(text).map_err(|error| Trouble::from(reading_finding(&error)))?;
    let misfit = || {
        let message = format!("`{}` does not fit {}", text.as_str(), element.name());
        Trouble::from(Finding::new(&DATA_DOES_NOT_FIT, text.span, message))
    };
    match immediate.number {
        Number::Integer { negative, magnitude, radix } => {
            let decimal = radix == twinrung_grammar::tree::Radix::Decimal;
            let value = i128::from(magnitude) * if negative { -1 } else { 1 };
            if element == Element::Real {
                return Ok((value as f32).to_bits() as i32);
            }
            let bits = u32::from(element.bits());
            let (least, greatest) = match element {
                Element::Bool => (0, 1),
                _ => (-(1i128 << (bits - 1)), (1i128 << (bits - 1)) - 1),
            };
            let patterns = if decimal { greatest } else { (1i128 << bits) - 1 };
            if value < least || value > patterns {
                return Err(misfit());
            }
            Ok(match element {
                Element::Sint => i32::from(value as i8),
                Element::Int => i32::from(value as i16),
                _ => value as u32 as i32,
            })
        }
        Number::Real { bits } | Number::Special { bits } if element == Element::Real => {
            let value = f32::from_bits(bits);
            Ok(if value.is_nan() { 0x7FC0_0000 } else { bits as i32 })
        }
        _ => Err(misfit()),
    }
}

/// An integer whose radix is ASCII: the first character is the most significant byte.
fn of_characters(text: &Text, element: Element) -> Result<i32, Trouble> {
    let bytes = characters(text)?;
    if bytes.len() > element.bytes() as usize {
        let message = format!("{} characters do not fit {}", bytes.len(), element.name());
        return Err(Finding::new(&DATA_DOES_NOT_FIT, text.span, message).into());
    }
    let value = bytes.iter().fold(0u32, |value, byte| value << 8 | u32::from(*byte));
    Ok(match element {
        Element::Sint => i32::from(value as i8),
        Element::Int => i32::from(value as i16),
        _ => value as i32,
    })
}

/// The 32 bits of a number in a list of words.
fn bits_of(value: &Value) -> Result<i32, Trouble> {
    let Value::Number(text) = value else {
        return Err(Finding::new(&DATA_DOES_NOT_FIT, value.span(), "expected a number").into());
    };
    let immediate = twinrung_grammar::read_number(text).map_err(|error| Trouble::from(reading_finding(&error)))?;
    match immediate.number {
        Number::Integer { negative, magnitude, .. } if magnitude <= u64::from(u32::MAX) => {
            let bits = magnitude as u32;
            Ok(if negative { bits.wrapping_neg() as i32 } else { bits as i32 })
        }
        Number::Real { bits } | Number::Special { bits } => Ok(bits as i32),
        _ => {
            let message = format!("`{}` has more than 32 bits", text.as_str());
            Err(Finding::new(&DATA_DOES_NOT_FIT, text.span, message).into())
        }
    }
}
