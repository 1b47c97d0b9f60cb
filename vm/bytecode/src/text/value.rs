//! Initial values as nested lists: members in declared order, elements one after the other.

use alloc::vec::Vec;
use core::fmt::{self, Write};

use twinrung_catalog::Element;

use super::number::write_real_data;
use crate::image::{Image, TagRecord, TypeReference};
use crate::layout::{self, TypeLayout};

/// A run of values that is still to be written.
enum Pending {
    Close,
    Run { type_reference: TypeReference, elements: u32, list: bool, first: bool, bit: u32, word: u32 },
}

/// Whether every cell of a tag begins as 0; `None` where the tag's cells are not in the image.
fn cells<'a>(image: &'a Image, layouts: &[TypeLayout], tag: &TagRecord) -> Option<(&'a [u8], &'a [i32])> {
    let (bits, words) = layout::cells(layouts, tag.type_reference)?;
    let elements = layout::elements(tag.dimensions)?;
    let range = |begin: u32, each: u32| -> Option<core::ops::Range<usize>> {
        let end = begin.checked_add(each.checked_mul(elements)?)?;
        Some(begin as usize..end as usize)
    };
    let bits = image.initial_bits.get(range(tag.bit_cell, bits)?)?;
    let words = image.initial_words.get(range(tag.word_cell, words)?)?;
    Some((bits, words))
}

/// Writes ` := value`, or nothing where every cell begins as 0.
pub(super) fn write_initial(
    image: &Image,
    layouts: &[TypeLayout],
    tag: &TagRecord,
    out: &mut dyn Write,
) -> fmt::Result {
    let Some((bits, words)) = cells(image, layouts, tag) else { return out.write_str(" := ?") };
    if bits.iter().all(|bit| *bit == 0) && words.iter().all(|word| *word == 0) {
        return Ok(());
    }
    out.write_str(" := ")?;
    let elements = layout::elements(tag.dimensions).unwrap_or(0);
    let list = tag.dimensions != [0; 3];
    let type_reference = tag.type_reference;
    let mut stack = alloc::vec![Pending::Run { type_reference, elements, list, first: true, bit: 0, word: 0 }];
    while let Some(pending) = stack.pop() {
        match pending {
            Pending::Close => out.write_str("]")?,
            Pending::Run { type_reference, elements, list, first, bit, word } => {
                if !first {
                    out.write_str(",")?;
                }
                if list {
                    out.write_str("[")?;
                    stack.push(Pending::Close);
                }
                match type_reference {
                    TypeReference::Element(element) => {
                        for index in 0..elements {
                            if index > 0 {
                                out.write_str(",")?;
                            }
                            write_element(
                                element,
                                bits,
                                words,
                                bit.saturating_add(index),
                                word.saturating_add(index),
                                out,
                            )?;
                        }
                    }
                    TypeReference::Structure(index) => {
                        let position = index.position();
                        let (Some(record), Some(layout)) = (image.types.get(position), layouts.get(position)) else {
                            continue;
                        };
                        // One element now, the others as a run of their own behind it.
                        if let Some(others) = elements.checked_sub(1).filter(|others| *others > 0) {
                            stack.push(Pending::Run {
                                type_reference,
                                elements: others,
                                list: false,
                                first: false,
                                bit: bit.saturating_add(layout.bit_cells),
                                word: word.saturating_add(layout.word_cells),
                            });
                        }
                        out.write_str("[")?;
                        stack.push(Pending::Close);
                        let members: Vec<_> = record.members.iter().zip(&layout.members).enumerate().collect();
                        for (position, (member, place)) in members.into_iter().rev() {
                            stack.push(Pending::Run {
                                type_reference: member.type_reference,
                                elements: place.elements,
                                list: member.dimensions != [0; 3],
                                first: position == 0,
                                bit: bit.saturating_add(place.bit_cell),
                                word: word.saturating_add(place.word_cell),
                            });
                        }
                    }
                }
            }
        }
    }
    Ok(())
}

fn write_element(
    element: Element,
    bits: &[u8],
    words: &[i32],
    bit: u32,
    word: u32,
    out: &mut dyn Write,
) -> fmt::Result {
    let bit = bits.get(bit as usize).copied().unwrap_or(0);
    let word = words.get(word as usize).copied().unwrap_or(0);
    match element {
        Element::Bool => write!(out, "{bit}"),
        Element::Real => write_real_data(out, word.cast_unsigned()),
        Element::Sint | Element::Int | Element::Dint => write!(out, "{word}"),
    }
}
