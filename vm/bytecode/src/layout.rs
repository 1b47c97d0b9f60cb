//! Which cells a type takes, and which bytes it has in the Logix memory layout (which COP makes visible).
//!
//! Cells: a BOOL takes one bit cell; a SINT, INT, DINT or REAL one word cell; a structure the cells of its members in
//! declared order; an array the cells of its elements, one after the other (row-major, last dimension fastest).
//!
//! Bytes (neutral-text-and-l5x.md D.4): members in declared order; consecutive BOOL members share a byte, eight to one;
//! SINT is aligned to 1, INT to 2, DINT, REAL, structures and BOOL arrays to 4; the size is rounded up to 4. Predefined
//! structures have the bytes that the catalog declares. The instance of an Add-On Instruction has no bytes here: COP
//! does not reach it (decided).

use alloc::vec::Vec;
use core::fmt;

use twinrung_catalog::{Element, PredefinedType};

use crate::image::{TypeKind, TypeRecord, TypeReference};
use crate::limits;

/// The layout of a structure.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct TypeLayout {
    /// Size in bytes; 0 where the structure has no byte layout.
    pub bytes: u32,
    /// Bit cells.
    pub bit_cells: u32,
    /// Word cells.
    pub word_cells: u32,
    /// One for each member.
    pub members: Vec<MemberLayout>,
    /// Depth of structures within it; 1 without any.
    pub depth: usize,
    /// Whether it, or a structure within it, backs a safety application instruction or an Add-On Instruction.
    pub holds_backing: bool,
    /// Whether a REAL lies anywhere within it.
    pub holds_real: bool,
}

/// Where a member lies in its structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct MemberLayout {
    /// First byte (for a BOOL: of its host).
    pub byte: u32,
    /// For a BOOL: the bit, counted from the host's first byte.
    pub bit: u8,
    /// First bit cell.
    pub bit_cell: u32,
    /// First word cell.
    pub word_cell: u32,
    /// Number of elements, 1 for a scalar.
    pub elements: u32,
}

/// One elementary field of a structure as COP sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Field {
    /// First byte.
    pub byte: u32,
    /// For a BOOL the bit from that byte on, else 0.
    pub bit: u8,
    /// Its type.
    pub element: Element,
    /// Its cell, in the bit space for a BOOL, else in the word space.
    pub cell: u32,
}

/// Why types have no layout.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayoutError {
    /// A member's type is not an earlier entry of the table.
    NotEarlier,
    /// A predefined type is not in the catalog, or its members are not the catalog's.
    NotInCatalog,
    /// Too many cells, bytes, elements or levels.
    TooLarge,
    /// A BOOL array whose length is not a multiple of 32.
    BoolArrayLength,
}

impl fmt::Display for LayoutError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            LayoutError::NotEarlier => "a member's type is not declared before it",
            LayoutError::NotInCatalog => "a predefined type is not as the catalog declares it",
            LayoutError::TooLarge => "a type has too many cells, bytes, elements or levels",
            LayoutError::BoolArrayLength => "the length of a BOOL array is not a multiple of 32",
        })
    }
}

impl core::error::Error for LayoutError {}

/// Bit and word cells of one element of a type.
pub fn cells(layouts: &[TypeLayout], type_reference: TypeReference) -> Option<(u32, u32)> {
    match type_reference {
        TypeReference::Element(Element::Bool) => Some((1, 0)),
        TypeReference::Element(_) => Some((0, 1)),
        TypeReference::Structure(index) => {
            layouts.get(index.position()).map(|layout| (layout.bit_cells, layout.word_cells))
        }
    }
}

/// Number of elements that dimensions declare, 1 for a scalar; `None` when it is beyond [`limits::ARRAY_ELEMENTS`] or a
/// dimension follows an unused one.
pub fn elements(dimensions: [u32; 3]) -> Option<u32> {
    let [first, second, third] = dimensions;
    let gap = (first == 0 && second != 0) || (second == 0 && third != 0);
    if gap {
        return None;
    }
    let count = first.max(1).checked_mul(second.max(1))?.checked_mul(third.max(1))?;
    (count <= limits::ARRAY_ELEMENTS).then_some(count)
}

/// The layouts of all types.
pub fn layouts(types: &[TypeRecord]) -> Result<Vec<TypeLayout>, LayoutError> {
    let mut done: Vec<TypeLayout> = Vec::with_capacity(types.len());
    for record in types {
        let layout = layout(record, &done)?;
        done.push(layout);
    }
    Ok(done)
}

/// The layout of one type whose members' types are laid out in `earlier`.
pub fn layout(record: &TypeRecord, earlier: &[TypeLayout]) -> Result<TypeLayout, LayoutError> {
    let predefined = match record.kind {
        TypeKind::Predefined => Some(PredefinedType::by_name(&record.name).ok_or(LayoutError::NotInCatalog)?),
        TypeKind::User | TypeKind::AddOn(_) => None,
    };
    if predefined.is_some_and(|known| known.members.len() != record.members.len()) {
        return Err(LayoutError::NotInCatalog);
    }
    let mut layout = TypeLayout {
        depth: 1,
        holds_backing: predefined.is_some_and(|known| known.backs_one_call)
            || matches!(record.kind, TypeKind::AddOn(_)),
        ..TypeLayout::default()
    };
    let mut packing = Packing::default();
    for (index, member) in record.members.iter().enumerate() {
        let count = elements(member.dimensions).ok_or(LayoutError::TooLarge)?;
        let (bits, words) = cells(earlier, member.type_reference).ok_or(LayoutError::NotEarlier)?;
        let array = member.dimensions != [0; 3];
        let (byte, bit) = match predefined {
            Some(known) => {
                let declared = known.members.get(index).ok_or(LayoutError::NotInCatalog)?;
                let same = declared.name == member.name
                    && member.type_reference == TypeReference::Element(declared.element)
                    && member.dimensions == [declared.length, 0, 0];
                if !same {
                    return Err(LayoutError::NotInCatalog);
                }
                (declared.byte, declared.bit)
            }
            None => packing.place(earlier, member.type_reference, count, array)?,
        };
        layout.members.push(MemberLayout {
            byte,
            bit,
            bit_cell: layout.bit_cells,
            word_cell: layout.word_cells,
            elements: count,
        });
        layout.bit_cells = add_cells(layout.bit_cells, bits, count, limits::BIT_CELLS)?;
        layout.word_cells = add_cells(layout.word_cells, words, count, limits::WORD_CELLS)?;
        match member.type_reference {
            TypeReference::Element(Element::Real) => layout.holds_real = true,
            TypeReference::Element(_) => {}
            TypeReference::Structure(inner) => {
                let inner = earlier.get(inner.position()).ok_or(LayoutError::NotEarlier)?;
                layout.depth = layout.depth.max(inner.depth.saturating_add(1));
                layout.holds_backing |= inner.holds_backing;
                layout.holds_real |= inner.holds_real;
            }
        }
    }
    if layout.depth > limits::TYPE_DEPTH {
        return Err(LayoutError::TooLarge);
    }
    layout.bytes = match (record.kind, predefined) {
        (TypeKind::AddOn(_), _) => 0,
        (_, Some(known)) => known.bytes,
        (_, None) => packing.finish()?,
    };
    Ok(layout)
}

fn add_cells(so_far: u32, each: u32, count: u32, limit: u32) -> Result<u32, LayoutError> {
    each.checked_mul(count)
        .and_then(|more| so_far.checked_add(more))
        .filter(|sum| *sum <= limit)
        .ok_or(LayoutError::TooLarge)
}

/// Places members of a user-defined type one after the other.
#[derive(Default)]
struct Packing {
    next_byte: u32,
    /// Host byte and next bit of the BOOLs that are being packed.
    host: Option<(u32, u8)>,
}

impl Packing {
    fn place(
        &mut self,
        earlier: &[TypeLayout],
        type_reference: TypeReference,
        count: u32,
        array: bool,
    ) -> Result<(u32, u8), LayoutError> {
        if type_reference == TypeReference::Element(Element::Bool) && !array {
            let (byte, bit) = match self.host {
                Some((byte, bit)) if bit < 8 => (byte, bit),
                _ => (self.take(1, 1)?, 0),
            };
            self.host = Some((byte, bit.saturating_add(1)));
            return Ok((byte, bit));
        }
        self.host = None;
        let (alignment, size) = match type_reference {
            TypeReference::Element(Element::Bool) => {
                if !count.is_multiple_of(32) {
                    return Err(LayoutError::BoolArrayLength);
                }
                (4, count / 8)
            }
            TypeReference::Element(element) => {
                (element.bytes(), element.bytes().checked_mul(count).ok_or(LayoutError::TooLarge)?)
            }
            TypeReference::Structure(index) => {
                let inner = earlier.get(index.position()).ok_or(LayoutError::NotEarlier)?;
                (4, inner.bytes.checked_mul(count).ok_or(LayoutError::TooLarge)?)
            }
        };
        Ok((self.take(alignment, size)?, 0))
    }

    fn take(&mut self, alignment: u32, size: u32) -> Result<u32, LayoutError> {
        let begin = self.next_byte.checked_next_multiple_of(alignment.max(1)).ok_or(LayoutError::TooLarge)?;
        self.next_byte = begin.checked_add(size).ok_or(LayoutError::TooLarge)?;
        Ok(begin)
    }

    fn finish(&self) -> Result<u32, LayoutError> {
        self.next_byte.checked_next_multiple_of(4).ok_or(LayoutError::TooLarge)
    }
}

/// The elementary fields of one element of a type, in declared order, with bytes and cells counted from its start.
/// Bounded by the number of its cells.
pub fn fields(types: &[TypeRecord], layouts: &[TypeLayout], type_reference: TypeReference) -> Vec<Field> {
    struct Pending {
        type_reference: TypeReference,
        elements: u32,
        array: bool,
        byte: u32,
        bit: u8,
        bit_cell: u32,
        word_cell: u32,
    }
    let mut out = Vec::new();
    let mut stack =
        alloc::vec![Pending { type_reference, elements: 1, array: false, byte: 0, bit: 0, bit_cell: 0, word_cell: 0 }];
    while let Some(item) = stack.pop() {
        for element_index in 0..item.elements {
            match item.type_reference {
                TypeReference::Element(Element::Bool) => {
                    let bit = if item.array { element_index } else { u32::from(item.bit) };
                    out.push(Field {
                        byte: item.byte.saturating_add(bit / 8),
                        bit: (bit % 8) as u8,
                        element: Element::Bool,
                        cell: item.bit_cell.saturating_add(element_index),
                    });
                }
                TypeReference::Element(element) => out.push(Field {
                    byte: item.byte.saturating_add(element.bytes().saturating_mul(element_index)),
                    bit: 0,
                    element,
                    cell: item.word_cell.saturating_add(element_index),
                }),
                TypeReference::Structure(index) => {
                    let (Some(record), Some(layout)) = (types.get(index.position()), layouts.get(index.position()))
                    else {
                        continue;
                    };
                    for (member, place) in record.members.iter().zip(&layout.members) {
                        stack.push(Pending {
                            type_reference: member.type_reference,
                            elements: place.elements,
                            array: member.dimensions != [0; 3],
                            byte: item
                                .byte
                                .saturating_add(layout.bytes.saturating_mul(element_index))
                                .saturating_add(place.byte),
                            bit: place.bit,
                            bit_cell: item
                                .bit_cell
                                .saturating_add(layout.bit_cells.saturating_mul(element_index))
                                .saturating_add(place.bit_cell),
                            word_cell: item
                                .word_cell
                                .saturating_add(layout.word_cells.saturating_mul(element_index))
                                .saturating_add(place.word_cell),
                        });
                    }
                }
            }
        }
    }
    out.sort_by_key(|field| (field.byte, field.bit, field.cell));
    out
}
