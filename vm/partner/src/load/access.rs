//! Reads the bytes of a reference: its access, and what the end of its path says.

use twinrung_bytecode::format;
use twinrung_bytecode::image::{TypeKind, TypeReference};
use twinrung_bytecode::index::{OperandIndex, TypeIndex};
use twinrung_catalog::Element;

use super::Unit;
use super::context::{Base, Context, Instance};
use super::cursor::Cursor;
use crate::ladder::{Location, StructureKind};

/// A reference's access as its bytes have it.
pub(super) struct Access<'a> {
    pub(super) path: &'a [u8],
    pub(super) shape: u8,
    pub(super) element: Option<Element>,
    pub(super) type_index: Option<TypeIndex>,
    pub(super) base: u8,
    pub(super) parameter: u16,
    pub(super) bit: u32,
    pub(super) word: u32,
    pub(super) count: u32,
    pub(super) terms: &'a [u8],
    pub(super) bit_number: u8,
    pub(super) bit_operand: u32,
    pub(super) bit_length: u8,
}

/// Bytes of one variable subscript.
pub(super) const TERM_BYTES: usize = 16;

/// A variable subscript.
pub(super) struct Term {
    pub(super) operand: OperandIndex,
    pub(super) length: u32,
    pub(super) bits: u32,
    pub(super) words: u32,
}

pub(super) fn term(bytes: &[u8]) -> Option<Term> {
    let mut cursor = Cursor::new(bytes);
    Some(Term {
        operand: OperandIndex(cursor.word()?),
        length: cursor.word()?,
        bits: cursor.word()?,
        words: cursor.word()?,
    })
}

pub(super) fn element(number: u8) -> Option<Element> {
    Element::ALL.into_iter().find(|element| *element as u8 == number)
}

pub(super) fn access<'a>(cursor: &mut Cursor<'a>) -> Option<Access<'a>> {
    let path_length = cursor.half()?;
    let path = cursor.take(usize::from(path_length))?;
    let shape = cursor.byte()?;
    let element = element(cursor.byte()?);
    let type_index = Some(cursor.half()?).filter(|index| *index != format::NO_INDEX).map(TypeIndex);
    let base = cursor.byte()?;
    let parameter = cursor.half()?;
    let (bit, word, count) = (cursor.word()?, cursor.word()?, cursor.word()?);
    let terms = usize::from(cursor.byte()?);
    let terms = cursor.take(terms.checked_mul(TERM_BYTES)?)?;
    let (bit_number, bit_operand, bit_length) = (cursor.byte()?, cursor.word()?, cursor.byte()?);
    Some(Access {
        path,
        shape,
        element,
        type_index,
        base,
        parameter,
        bit,
        word,
        count,
        terms,
        bit_number,
        bit_operand,
        bit_length,
    })
}

impl Access<'_> {
    /// Whether no subscript and no bit number depends on data.
    pub(super) fn is_static(&self) -> bool {
        self.terms.is_empty() && (self.shape != format::SHAPE_WORD_BIT || self.bit_number != format::NO_BIT)
    }
}

/// The end of a reference's path.
pub(super) struct PathEnd {
    /// The last step is a subscript: the reference designates an element.
    pub(super) is_element: bool,
    /// How many variable subscripts that last step has.
    pub(super) variable: usize,
    /// Dimensions of the tag, member or parameter that the path reached last.
    pub(super) dimensions: [u32; 3],
}

pub(super) fn path_end(unit: Unit<'_>, path: &[u8]) -> Option<PathEnd> {
    let mut cursor = Cursor::new(path);
    let image = unit.image;
    let (mut type_reference, dimensions) = match cursor.byte()? {
        format::ROOT_TAG => {
            let tag = image.tags.get(cursor.word()? as usize)?;
            (tag.type_reference, tag.dimensions)
        }
        format::ROOT_MEMBER => {
            let add_on = image.add_ons.get(usize::from(cursor.half()?))?;
            let record = image.types.get(add_on.instance_type.position())?;
            let member = record.members.get(usize::from(cursor.half()?))?;
            (member.type_reference, member.dimensions)
        }
        format::ROOT_IN_OUT => {
            let add_on = image.add_ons.get(usize::from(cursor.half()?))?;
            let parameter = add_on.parameters.get(usize::from(cursor.half()?))?;
            (parameter.type_reference, parameter.dimensions)
        }
        _ => return None,
    };
    let mut end = PathEnd { is_element: false, variable: 0, dimensions };
    while !cursor.is_empty() {
        match cursor.byte()? {
            format::STEP_MEMBER => {
                let TypeReference::Structure(index) = type_reference else { return None };
                let member = image.types.get(index.position())?.members.get(usize::from(cursor.half()?))?;
                type_reference = member.type_reference;
                end = PathEnd { is_element: false, variable: 0, dimensions: member.dimensions };
            }
            format::STEP_SUBSCRIPT => {
                let count = cursor.byte()?;
                end.is_element = true;
                end.variable = 0;
                for _ in 0..count {
                    let variable = cursor.byte()? == format::SUBSCRIPT_OPERAND;
                    end.variable = end.variable.saturating_add(usize::from(variable));
                    cursor.word()?;
                }
            }
            format::STEP_BIT => {
                cursor.byte()?;
            }
            format::STEP_BIT_OPERAND => {
                cursor.word()?;
            }
            _ => return None,
        }
    }
    Some(end)
}

/// The cells of an access, without its variable subscripts.
pub(super) fn place(unit: Unit<'_>, context: &Context, access: &Access<'_>) -> Option<Location> {
    let (bit, word) = match access.base {
        format::BASE_ABSOLUTE => (access.bit, access.word),
        format::BASE_INSTANCE => match &context.instance {
            Instance::None => return None,
            Instance::At { bit, word } => (bit.checked_add(access.bit)?, word.checked_add(access.word)?),
            Instance::Scattered { bits, words } => (
                bits.get(access.bit as usize).copied().unwrap_or(0),
                words.get(access.word as usize).copied().unwrap_or(0),
            ),
        },
        format::BASE_IN_OUT => match context.in_outs.get(usize::from(access.parameter)).copied().flatten()? {
            Base::Cells { bit, word } => (bit.checked_add(access.bit)?, word.checked_add(access.word)?),
            Base::WordBit { word, bit, element } => return Some(Location::WordBit(word, bit, element)),
        },
        _ => return None,
    };
    Some(match access.shape {
        format::SHAPE_BIT => Location::Bit(bit),
        format::SHAPE_WORD => Location::Word(word, access.element?),
        format::SHAPE_WORD_BIT => {
            let number = if access.bit_number == format::NO_BIT { 0 } else { access.bit_number };
            Location::WordBit(word, number, access.element?)
        }
        format::SHAPE_REGION => Location::Region { bit, word, kind: structure_kind(unit, access.type_index) },
        _ => return None,
    })
}

pub(super) fn structure_kind(unit: Unit<'_>, index: Option<TypeIndex>) -> StructureKind {
    let record = index.and_then(|index| unit.image.types.get(index.position()));
    match record.filter(|record| record.kind == TypeKind::Predefined).map(|record| record.name.as_str()) {
        Some("TIMER") => StructureKind::Timer,
        Some("COUNTER") => StructureKind::Counter,
        Some("CONTROL") => StructureKind::Control,
        _ => StructureKind::Other,
    }
}
