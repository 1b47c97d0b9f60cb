//! Decodes entries of the operand table and binds them to absolute cells.

use alloc::vec::Vec;

use twinrung_bytecode::format;
use twinrung_bytecode::image::{TagKind, TypeReference};
use twinrung_bytecode::index::OperandIndex;
use twinrung_catalog::Element;

use super::Loader;
use super::reader::Reader;
use crate::error::LoadError;
use crate::program::{BitNumber, Content, Location, NONE, Operand};

/// What the references of a routine count from.
#[derive(Debug, Clone, Default)]
pub(crate) struct Binding {
    /// First cells of the instance of the Add-On Instruction.
    pub(crate) instance: Option<(u32, u32)>,
    /// First cells of the argument of each InOut parameter, by parameter.
    pub(crate) in_outs: Vec<Option<(u32, u32)>>,
}

impl Binding {
    /// Whether references mean the same everywhere.
    pub(crate) fn is_absolute(&self) -> bool {
        self.instance.is_none()
    }
}

/// A variable subscript.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Term {
    pub(crate) operand: u32,
    pub(crate) length: u32,
    pub(crate) bit_stride: u32,
    pub(crate) word_stride: u32,
    /// Elements of the innermost array that one step skips.
    pub(crate) elements: u32,
}

/// A reference, bound to cells.
#[derive(Debug, Clone)]
pub(crate) struct Reference {
    pub(crate) shape: u8,
    pub(crate) content: Content,
    pub(crate) bit: u32,
    pub(crate) word: u32,
    pub(crate) count: u32,
    /// Whether the last step of the path selects an element.
    pub(crate) is_element: bool,
    pub(crate) terms: Vec<Term>,
    pub(crate) bit_number: u8,
    pub(crate) bit_operand: u32,
    pub(crate) bit_length: u8,
}

/// The elementary type with this number in an image.
pub(crate) fn element_of(number: u8) -> Result<Element, LoadError> {
    Element::ALL
        .into_iter()
        .find(|element| *element as u8 == number)
        .ok_or(LoadError::Malformed("the elementary type of a reference"))
}

impl Loader<'_> {
    /// The bytes of an entry.
    pub(crate) fn entry(&self, index: u32) -> Result<Reader<'_>, LoadError> {
        let bytes = self.image.operands.entry(OperandIndex(index));
        bytes.map(Reader::new).ok_or(LoadError::Malformed("the index of an operand"))
    }

    /// The operand in the program's table, decoded and bound; absolute ones once.
    pub(crate) fn operand(&mut self, index: u32, binding: &Binding) -> Result<u32, LoadError> {
        let known = self.known_operands.get(index as usize).copied().unwrap_or(NONE);
        if binding.is_absolute() && known != NONE {
            return Ok(known);
        }
        let operand = self.bind(index, binding)?;
        let position = self.push_operand(operand)?;
        if binding.is_absolute()
            && let Some(slot) = self.known_operands.get_mut(index as usize)
        {
            *slot = position;
        }
        Ok(position)
    }

    /// Appends to the program's table.
    pub(crate) fn push_operand(&mut self, operand: Operand) -> Result<u32, LoadError> {
        let position =
            u32::try_from(self.program.operands.len()).map_err(|_| LoadError::TooLarge("the table of operands"))?;
        self.program.operands.push(operand);
        Ok(position)
    }

    fn bind(&mut self, index: u32, binding: &Binding) -> Result<Operand, LoadError> {
        let mut reader = self.entry(index)?;
        Ok(match reader.u8()? {
            format::INTEGER => {
                let _radix = reader.u8()?;
                Operand::Integer(reader.i32()?)
            }
            format::REAL => Operand::Real(f32::from_bits(reader.u32()?)),
            format::CHOICE => Operand::Integer(reader.i32()?),
            format::UNASSIGNED | format::TEXT => Operand::Nothing,
            format::ROUTINE => {
                let routine = reader.u32()?;
                Operand::Routine(self.routine_body(routine)?)
            }
            format::STATUS => Operand::Status(reader.u8()?),
            format::SYSTEM_VALUE => Operand::SystemValue(reader.u16()?),
            format::EVENT_TASK => Operand::EventTask(reader.u16()?),
            format::EXPRESSION => return Err(LoadError::Malformed("an expression where none may stand")),
            format::REFERENCE => {
                let reference = self.reference(index, binding)?;
                self.bind_reference(&reference, binding)?
            }
            _ => return Err(LoadError::Malformed("the kind of an operand")),
        })
    }

    /// Cells of one element of a content.
    pub(crate) fn cells_of(&self, content: Content) -> Result<(u32, u32), LoadError> {
        match content {
            Content::Element(Element::Bool) => Ok((1, 0)),
            Content::Element(_) => Ok((0, 1)),
            Content::Structure(index) => self
                .layouts
                .get(usize::from(index))
                .map(|layout| (layout.bit_cells, layout.word_cells))
                .ok_or(LoadError::Malformed("the type of a reference")),
        }
    }

    fn bind_reference(&mut self, reference: &Reference, binding: &Binding) -> Result<Operand, LoadError> {
        let formula = if reference.terms.is_empty() { NONE } else { self.address_formula(reference, binding)? };
        let location = Location { bit: reference.bit, word: reference.word, formula };
        Ok(match (reference.shape, reference.content) {
            (format::SHAPE_BIT, _) => Operand::Bit(location),
            (format::SHAPE_WORD, Content::Element(element)) => {
                Operand::Word { location, element, count: reference.count }
            }
            (format::SHAPE_WORD_BIT, Content::Element(element)) => {
                let number = if reference.bit_operand == format::NO_OPERAND {
                    BitNumber::Constant(reference.bit_number)
                } else {
                    let formula = self.value_formula(reference.bit_operand, binding)?;
                    BitNumber::Variable { formula, length: reference.bit_length }
                };
                Operand::WordBit { location, number, element }
            }
            (format::SHAPE_REGION, content) => {
                let (bit_cells, word_cells) = self.cells_of(content)?;
                let designated = if reference.is_element { 1 } else { reference.count };
                Operand::Region {
                    location,
                    content,
                    count: reference.count,
                    bit_cells: bit_cells.saturating_mul(designated),
                    word_cells: word_cells.saturating_mul(designated),
                }
            }
            _ => return Err(LoadError::Malformed("the shape of a reference")),
        })
    }

    /// Decodes a reference and adds what its cells count from.
    pub(crate) fn reference(&self, index: u32, binding: &Binding) -> Result<Reference, LoadError> {
        let mut reader = self.entry(index)?;
        if reader.u8()? != format::REFERENCE {
            return Err(LoadError::Malformed("an operand that should be a reference"));
        }
        let path_length = usize::from(reader.u16()?);
        reader.take(path_length)?;
        let (innermost, is_element) = innermost_variables(self.designating_path(index)?)?;
        let shape = reader.u8()?;
        let element = reader.u8()?;
        let structure = reader.u16()?;
        let content = if element == format::NO_ELEMENT {
            Content::Structure(structure)
        } else {
            Content::Element(element_of(element)?)
        };
        let base = reader.u8()?;
        let parameter = reader.u16()?;
        let (base_bit, base_word) = match base {
            format::BASE_ABSOLUTE => (0, 0),
            format::BASE_INSTANCE => {
                binding.instance.ok_or(LoadError::Malformed("a reference to an instance outside one"))?
            }
            format::BASE_IN_OUT => binding
                .in_outs
                .get(usize::from(parameter))
                .copied()
                .flatten()
                .ok_or(LoadError::Malformed("a reference to an InOut parameter without argument"))?,
            _ => return Err(LoadError::Malformed("the base of a reference")),
        };
        let bit = reader.u32()?.saturating_add(base_bit);
        let word = reader.u32()?.saturating_add(base_word);
        let count = reader.u32()?;
        let (bit_cells, word_cells) = self.cells_of(content)?;
        let term_count = usize::from(reader.u8()?);
        let mut terms = Vec::with_capacity(term_count);
        for position in 0..term_count {
            let (operand, length, bit_stride, word_stride) =
                (reader.u32()?, reader.u32()?, reader.u32()?, reader.u32()?);
            let is_innermost = position.saturating_add(innermost) >= term_count;
            let elements = match (is_innermost, word_stride.checked_div(word_cells), bit_stride.checked_div(bit_cells))
            {
                (true, Some(elements), _) | (true, None, Some(elements)) => elements,
                _ => 0,
            };
            terms.push(Term { operand, length, bit_stride, word_stride, elements });
        }
        let (bit_number, bit_operand, bit_length) = (reader.u8()?, reader.u32()?, reader.u8()?);
        if !reader.is_empty() {
            return Err(LoadError::Malformed("a reference with bytes after it"));
        }
        Ok(Reference { shape, content, bit, word, count, is_element, terms, bit_number, bit_operand, bit_length })
    }

    /// The path of a reference; where that is nothing but the name of an alias, the path of what the alias designates:
    /// an alias of an array's element has no subscript in its own path.
    fn designating_path(&self, reference: u32) -> Result<Reader<'_>, LoadError> {
        let mut index = reference;
        for _ in 0..=self.image.tags.len() {
            let mut reader = self.entry(index)?;
            if reader.u8()? != format::REFERENCE {
                return Err(LoadError::Malformed("an operand that should be a reference"));
            }
            let path_length = usize::from(reader.u16()?);
            let path = reader.take(path_length)?;
            let mut root = Reader::new(path);
            let (kind, tag) = (root.u8()?, root.u32()?);
            let named = self.image.tags.get(tag as usize).filter(|_| kind == format::ROOT_TAG && root.is_empty());
            match named.map(|tag| &tag.kind) {
                Some(TagKind::Alias(target)) => index = target.0,
                _ => return Ok(Reader::new(path)),
            }
        }
        Err(LoadError::Malformed("aliases that lead to each other"))
    }

    /// The number of elements in one dimension of the array that a reference designates or selects an element of
    /// (SIZE).
    pub(crate) fn dimension(&self, index: u32, dimension: usize) -> Result<i32, LoadError> {
        const MALFORMED: LoadError = LoadError::Malformed("the path of an array");
        let mut path = self.designating_path(index)?;
        let (mut type_reference, mut dimensions) = match path.u8()? {
            format::ROOT_TAG => {
                let tag = self.image.tags.get(path.u32()? as usize).ok_or(MALFORMED)?;
                (tag.type_reference, tag.dimensions)
            }
            root @ (format::ROOT_MEMBER | format::ROOT_IN_OUT) => {
                let add_on = self.image.add_ons.get(usize::from(path.u16()?)).ok_or(MALFORMED)?;
                let member = usize::from(path.u16()?);
                if root == format::ROOT_IN_OUT {
                    let parameter = add_on.parameters.get(member).ok_or(MALFORMED)?;
                    (parameter.type_reference, parameter.dimensions)
                } else {
                    self.member(TypeReference::Structure(add_on.instance_type), member)?
                }
            }
            _ => return Err(MALFORMED),
        };
        while !path.is_empty() {
            match path.u8()? {
                format::STEP_MEMBER => {
                    (type_reference, dimensions) = self.member(type_reference, usize::from(path.u16()?))?;
                }
                format::STEP_SUBSCRIPT => {
                    let count = usize::from(path.u8()?);
                    path.take(count.saturating_mul(5))?;
                }
                _ => return Err(MALFORMED),
            }
        }
        let elements = dimensions.get(dimension).copied().unwrap_or(0);
        Ok(elements as i32)
    }

    fn member(&self, of: TypeReference, member: usize) -> Result<(TypeReference, [u32; 3]), LoadError> {
        let TypeReference::Structure(index) = of else {
            return Err(LoadError::Malformed("a member of an elementary type"));
        };
        let record = self.image.types.get(index.position()).and_then(|record| record.members.get(member));
        let record = record.ok_or(LoadError::Malformed("the index of a member"))?;
        Ok((record.type_reference, record.dimensions))
    }
}

/// How many variable subscripts select the element of the innermost array: those of the last step, where it is a
/// subscript; and whether it is one.
fn innermost_variables(mut path: Reader<'_>) -> Result<(usize, bool), LoadError> {
    match path.u8()? {
        format::ROOT_TAG => path.take(4)?,
        format::ROOT_MEMBER | format::ROOT_IN_OUT => path.take(4)?,
        _ => return Err(LoadError::Malformed("the root of a path")),
    };
    let mut innermost = 0usize;
    let mut is_element = false;
    while !path.is_empty() {
        match path.u8()? {
            format::STEP_MEMBER => {
                path.take(2)?;
                innermost = 0;
                is_element = false;
            }
            format::STEP_SUBSCRIPT => {
                innermost = 0;
                is_element = true;
                for _ in 0..path.u8()? {
                    if path.u8()? == format::SUBSCRIPT_OPERAND {
                        innermost = innermost.saturating_add(1);
                    }
                    path.take(4)?;
                }
            }
            format::STEP_BIT => {
                path.take(1)?;
            }
            format::STEP_BIT_OPERAND => {
                path.take(4)?;
            }
            _ => return Err(LoadError::Malformed("a step of a path")),
        }
    }
    Ok((innermost, is_element))
}
