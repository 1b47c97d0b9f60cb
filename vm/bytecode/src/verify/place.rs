//! Where a path leads: the verifier's own walk, with which the access of every reference must agree.
//!
//! A place is a type, dimensions that are not subscripted yet, and the first cells, counted from a base. Each step
//! narrows it:
//!
//! - a member: the cells of the member are added; the count begins anew (elements of the member's array, else 1);
//! - subscripts, one for each dimension, first = leftmost, last = fastest: constants add their cells and are taken
//!   from the count; operands become terms in the order of the path;
//! - a bit of a SINT, INT or DINT ends the path; its count is 1.
//!
//! A tag that is an alias begins where its target's path ends, with the target's count.

use alloc::vec::Vec;

use twinrung_catalog::{Element, MemberRole};

use super::tables::Tables;
use crate::error::ImageError;
use crate::image::{TypeKind, TypeReference};
use crate::index::{OperandIndex, TagIndex, TypeIndex};
use crate::layout;
use crate::limits;
use crate::operand::{Access, AccessType, Base, BitNumber, Shape, Step, Subscript, Term};

/// Where a path leads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place {
    /// The type of one element; for a bit of a word the word's type.
    pub(super) type_reference: TypeReference,
    /// Dimensions of an array that is designated as a whole; zeros otherwise.
    pub(super) dimensions: [u32; 3],
    /// Dimensions of the array of which this is an element, or of the whole array; zeros where the path does not end at one.
    pub(super) array: [u32; 3],
    pub(super) base: Base,
    /// The tag behind all aliases, for an absolute base.
    pub(super) tag: Option<TagIndex>,
    pub(super) bit_cell: u32,
    pub(super) word_cell: u32,
    pub(super) count: u32,
    pub(super) bit: Option<BitNumber>,
    /// Cells from the first to the last that variable subscripts can reach, less those of the place itself.
    pub(super) bit_span: u32,
    pub(super) word_span: u32,
    /// Whether a variable subscript, or bit number, takes part.
    pub(super) variable: bool,
    /// Whether an alias on the way says that logic may not write it.
    pub(super) constant: bool,
    /// Whether the path goes into a structure that backs a safety application instruction.
    pub(super) within_backing: bool,
}

impl Place {
    /// A tag, member or parameter as a whole.
    pub(super) fn whole(
        type_reference: TypeReference,
        dimensions: [u32; 3],
        base: Base,
        tag: Option<TagIndex>,
        cells: (u32, u32),
    ) -> Option<Place> {
        Some(Place {
            type_reference,
            dimensions,
            array: dimensions,
            base,
            tag,
            bit_cell: cells.0,
            word_cell: cells.1,
            count: layout::elements(dimensions)?,
            bit: None,
            bit_span: 0,
            word_span: 0,
            variable: false,
            constant: false,
            within_backing: false,
        })
    }

    pub(super) fn is_whole_array(&self) -> bool {
        self.dimensions != [0; 3]
    }

    /// The structure, where this is one structure and no array.
    pub(super) fn structure(&self) -> Option<TypeIndex> {
        match self.type_reference {
            TypeReference::Structure(index) if !self.is_whole_array() => Some(index),
            _ => None,
        }
    }

    pub(super) fn shape(&self) -> Shape {
        match (self.bit, self.type_reference) {
            (Some(bit), _) => Shape::WordBit(bit),
            (None, TypeReference::Structure(_)) => Shape::Region,
            (None, TypeReference::Element(_)) if self.is_whole_array() => Shape::Region,
            (None, TypeReference::Element(Element::Bool)) => Shape::Bit,
            (None, TypeReference::Element(_)) => Shape::Word,
        }
    }

    /// The element of a word.
    pub(super) fn word(&self) -> Option<Element> {
        match (self.shape(), self.type_reference) {
            (Shape::Word, TypeReference::Element(element)) => Some(element),
            _ => None,
        }
    }

    /// Whether this is one BOOL: a cell or a bit of a word.
    pub(super) fn is_bit(&self) -> bool {
        matches!(self.shape(), Shape::Bit | Shape::WordBit(_))
    }

    pub(super) fn access(&self, terms: Vec<Term>) -> Access {
        Access {
            shape: self.shape(),
            access_type: match self.type_reference {
                TypeReference::Element(element) => AccessType::Element(element),
                TypeReference::Structure(index) => AccessType::Structure(index),
            },
            base: self.base,
            bit_cell: self.bit_cell,
            word_cell: self.word_cell,
            count: self.count,
            terms,
        }
    }
}

/// A walk along a path.
pub(super) struct Walk<'t, 'a> {
    pub(super) tables: &'t Tables<'a>,
    pub(super) operand: OperandIndex,
    pub(super) place: Place,
    pub(super) terms: Vec<Term>,
}

impl Walk<'_, '_> {
    /// Goes one step. `is_integer` says whether an operand can be a subscript, and refuses it otherwise.
    pub(super) fn step(
        &mut self,
        step: &Step,
        is_integer: &mut dyn FnMut(OperandIndex) -> Result<(), ImageError>,
    ) -> Result<(), ImageError> {
        if self.place.bit.is_some() {
            return Err(ImageError::PathBit { operand: self.operand });
        }
        match step {
            Step::Member(member) => self.member(*member),
            Step::Subscript(subscripts) => self.subscript(subscripts, is_integer),
            Step::Bit(bit) => {
                let length = self.bit_length()?;
                if *bit >= length {
                    return Err(ImageError::SubscriptRange { operand: self.operand });
                }
                self.end_at_bit(BitNumber::Constant { bit: *bit, length });
                Ok(())
            }
            Step::BitOperand(operand) => {
                let length = self.bit_length()?;
                is_integer(*operand)?;
                self.place.variable = true;
                self.end_at_bit(BitNumber::Operand { operand: *operand, length });
                Ok(())
            }
        }
    }

    fn bit_length(&self) -> Result<u8, ImageError> {
        match self.place.word() {
            Some(element @ (Element::Sint | Element::Int | Element::Dint)) => Ok(element.bits()),
            _ => Err(ImageError::PathBit { operand: self.operand }),
        }
    }

    fn end_at_bit(&mut self, bit: BitNumber) {
        self.place.bit = Some(bit);
        self.place.count = 1;
        self.place.array = [0; 3];
    }

    fn member(&mut self, member: u16) -> Result<(), ImageError> {
        let operand = self.operand;
        let wrong = ImageError::PathMember { operand };
        let index = self.place.structure().ok_or(wrong.clone())?;
        let record = self.tables.image.types.get(index.position()).ok_or(wrong.clone())?;
        let layout = self.tables.layout(index).ok_or(wrong.clone())?;
        let position = usize::from(member);
        let declared = record.members.get(position).ok_or(wrong.clone())?;
        let place = layout.members.get(position).ok_or(wrong.clone())?;
        match record.kind {
            TypeKind::Predefined => {
                let known = self.tables.predefined(index).ok_or(wrong.clone())?;
                let role = known.members.get(position).map(|known| known.role);
                if role == Some(MemberRole::Internal) {
                    return Err(ImageError::PathInternal { operand });
                }
                self.place.within_backing |= known.backs_one_call;
            }
            // What backs a call within an instance serves the instance's own logic, and nobody else's.
            TypeKind::AddOn(_) if self.tables.holds_backing(declared.type_reference) => {
                return Err(ImageError::PathPrivate { operand });
            }
            TypeKind::AddOn(_) | TypeKind::User => {}
        }
        self.place.bit_cell = self.place.bit_cell.checked_add(place.bit_cell).ok_or(wrong.clone())?;
        self.place.word_cell = self.place.word_cell.checked_add(place.word_cell).ok_or(wrong)?;
        self.place.type_reference = declared.type_reference;
        self.place.dimensions = declared.dimensions;
        self.place.array = declared.dimensions;
        self.place.count = place.elements;
        Ok(())
    }

    fn subscript(
        &mut self,
        subscripts: &[Subscript],
        is_integer: &mut dyn FnMut(OperandIndex) -> Result<(), ImageError>,
    ) -> Result<(), ImageError> {
        let operand = self.operand;
        let wrong = ImageError::PathSubscript { operand };
        let [first, second, third] = self.place.dimensions;
        let dimensions = self.place.dimensions.iter().filter(|dimension| **dimension != 0).count();
        if subscripts.len() != dimensions {
            return Err(wrong);
        }
        let (bits, words) = layout::cells(self.tables.layouts, self.place.type_reference).ok_or(wrong.clone())?;
        // Elements from one index to the next, leftmost dimension first.
        let strides = [second.max(1).saturating_mul(third.max(1)), third.max(1), 1];
        for ((subscript, length), stride) in subscripts.iter().zip([first, second, third]).zip(strides) {
            let bit_stride = bits.checked_mul(stride).ok_or(wrong.clone())?;
            let word_stride = words.checked_mul(stride).ok_or(wrong.clone())?;
            match subscript {
                Subscript::Constant(value) => {
                    if *value >= length {
                        return Err(ImageError::SubscriptRange { operand });
                    }
                    self.place.bit_cell = far(self.place.bit_cell, bit_stride, *value).ok_or(wrong.clone())?;
                    self.place.word_cell = far(self.place.word_cell, word_stride, *value).ok_or(wrong.clone())?;
                    self.place.count = self.place.count.saturating_sub(stride.saturating_mul(*value));
                }
                Subscript::Operand(index) => {
                    is_integer(*index)?;
                    if self.terms.len() >= limits::SUBSCRIPT_TERMS {
                        return Err(ImageError::PathLength { operand });
                    }
                    let last = length.saturating_sub(1);
                    self.place.bit_span = far(self.place.bit_span, bit_stride, last).ok_or(wrong.clone())?;
                    self.place.word_span = far(self.place.word_span, word_stride, last).ok_or(wrong.clone())?;
                    self.place.variable = true;
                    self.terms.push(Term { operand: *index, length, bit_stride, word_stride });
                }
            }
        }
        self.place.dimensions = [0; 3];
        Ok(())
    }
}

fn far(from: u32, stride: u32, steps: u32) -> Option<u32> {
    from.checked_add(stride.checked_mul(steps)?)
}
