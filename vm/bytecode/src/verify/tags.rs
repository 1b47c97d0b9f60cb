//! Tags: scopes, types, cells, initial values, aliases.
//!
//! Cells are assigned to the tags that are no aliases in the order of the table, without gaps: each tag takes the bit
//! cells and the word cells that follow those of the tag before it, also where it takes none in one of the spaces. An
//! alias has no cells and says 0.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::cmp::Ordering;

use twinrung_catalog::Element;

use super::declarations::check_tag_attributes;
use super::place::{Place, Walk};
use super::tables::Tables;
use crate::error::ImageError;
use crate::image::*;
use crate::index::*;
use crate::layout;
use crate::limits;
use crate::names;
use crate::operand::{Base, OperandRecord, Reference, Root};
use crate::text;

/// Names and scopes; answers for each controller tag whether a program has a tag of its name.
pub(super) fn check_tag_names(image: &Image) -> Result<Vec<bool>, ImageError> {
    let mut before: Option<&TagRecord> = None;
    for (index, tag) in image.tags.iter().enumerate() {
        let what = "tag";
        let is_name = if tag.program.is_some() { names::is_component } else { names::is_module_name };
        if !is_name(&tag.name) {
            return Err(ImageError::Name { what, index });
        }
        if names::is_reserved(&tag.name) {
            return Err(ImageError::NameReserved { what, index });
        }
        if tag.program.is_some_and(|program| program.position() >= image.programs.len()) {
            return Err(ImageError::IndexRange { what, index });
        }
        if let Some(before) = before {
            match before.program.cmp(&tag.program) {
                Ordering::Greater => return Err(ImageError::TagScope { tag: TagIndex(index as u32) }),
                Ordering::Less => {}
                Ordering::Equal => match names::order(&before.name, &tag.name) {
                    Ordering::Less => {}
                    Ordering::Equal => return Err(ImageError::NameTwice { what, index }),
                    Ordering::Greater => return Err(ImageError::NameOrder { what, index }),
                },
            }
        }
        before = Some(tag);
        check_tag_attributes(index, tag)?;
    }
    let end = image.tags.partition_point(|tag| tag.program.is_none());
    let (controller, programs) = image.tags.split_at_checked(end).unwrap_or_default();
    let mut hidden = alloc::vec![false; controller.len()];
    for tag in programs {
        if let Ok(found) = controller.binary_search_by(|known| names::order(&known.name, &tag.name))
            && let Some(hidden) = hidden.get_mut(found)
        {
            *hidden = true;
        }
    }
    Ok(hidden)
}

/// Types, dimensions and cells.
pub(super) fn check_cells(tables: &Tables<'_>) -> Result<(), ImageError> {
    let image = tables.image;
    let (mut next_bit, mut next_word) = (0u32, 0u32);
    for (index, record) in image.tags.iter().enumerate() {
        let tag = TagIndex(index as u32);
        let elements = layout::elements(record.dimensions).ok_or(ImageError::TagDimensions { tag })?;
        let (bits, words) = layout::cells(tables.layouts, record.type_reference)
            .ok_or(ImageError::IndexRange { what: "tag", index })?;
        if !tables.has_real() && tables.holds_real(record.type_reference) {
            return Err(ImageError::TagReal { tag });
        }
        if record.program.is_some() && !matches!(record.kind, TagKind::Base | TagKind::Alias(_)) {
            return Err(ImageError::TagConnection { tag });
        }
        if matches!(record.kind, TagKind::Alias(_)) {
            if (record.bit_cell, record.word_cell) != (0, 0) {
                return Err(ImageError::TagCells { tag });
            }
            continue;
        }
        if (record.bit_cell, record.word_cell) != (next_bit, next_word) {
            return Err(ImageError::TagCells { tag });
        }
        let after = |next: u32, each: u32, limit: u32| {
            let sum = each.checked_mul(elements).and_then(|more| next.checked_add(more));
            sum.filter(|sum| *sum <= limit).ok_or(ImageError::TooManyCells { tag })
        };
        next_bit = after(next_bit, bits, limits::BIT_CELLS)?;
        next_word = after(next_word, words, limits::WORD_CELLS)?;
    }
    let counts = (image.initial_bits.len(), image.initial_words.len());
    if counts == (next_bit as usize, next_word as usize) { Ok(()) } else { Err(ImageError::CellCount) }
}

/// Initial values: bits are 0 or 1, words are within their types. The one NaN is 16#7FC0_0000 (REQ-EXEC-003).
pub(super) fn check_initial(tables: &Tables<'_>) -> Result<(), ImageError> {
    let image = tables.image;
    if let Some(cell) = image.initial_bits.iter().position(|bit| *bit > 1) {
        return Err(ImageError::InitialBit { cell: BitCell(cell as u32) });
    }
    let restricted = restricted_types(tables);
    for tag in image.tags.iter().filter(|tag| !matches!(tag.kind, TagKind::Alias(_))) {
        let elements = layout::elements(tag.dimensions).unwrap_or(0);
        let mut runs = alloc::vec![(tag.type_reference, elements, tag.word_cell)];
        while let Some((type_reference, elements, word_cell)) = runs.pop() {
            match type_reference {
                TypeReference::Element(element) => check_words(image, element, elements, word_cell)?,
                TypeReference::Structure(index) => {
                    let (Some(record), Some(layout)) =
                        (image.types.get(index.position()), tables.layouts.get(index.position()))
                    else {
                        continue;
                    };
                    if !restricted.get(index.position()).copied().unwrap_or(false) {
                        continue;
                    }
                    if let Some(others) = elements.checked_sub(1).filter(|others| *others > 0) {
                        runs.push((type_reference, others, word_cell.saturating_add(layout.word_cells)));
                    }
                    for (member, place) in record.members.iter().zip(&layout.members) {
                        let word_cell = word_cell.saturating_add(place.word_cell);
                        runs.push((member.type_reference, place.elements, word_cell));
                    }
                }
            }
        }
    }
    Ok(())
}

/// For each type whether it holds SINT, INT or REAL: the others take every word.
fn restricted_types(tables: &Tables<'_>) -> Vec<bool> {
    let mut restricted: Vec<bool> = Vec::with_capacity(tables.image.types.len());
    for record in &tables.image.types {
        let any = record.members.iter().any(|member| match member.type_reference {
            TypeReference::Element(element) => matches!(element, Element::Sint | Element::Int | Element::Real),
            TypeReference::Structure(index) => restricted.get(index.position()).copied().unwrap_or(false),
        });
        restricted.push(any);
    }
    restricted
}

fn check_words(image: &Image, element: Element, elements: u32, word_cell: u32) -> Result<(), ImageError> {
    let begin = word_cell as usize;
    let words = image.initial_words.get(begin..begin.saturating_add(elements as usize)).unwrap_or_default();
    let fits = |word: i32| match element {
        Element::Sint => i8::try_from(word).is_ok(),
        Element::Int => i16::try_from(word).is_ok(),
        Element::Real => !f32::from_bits(word.cast_unsigned()).is_nan() || word == 0x7FC0_0000,
        Element::Bool | Element::Dint => true,
    };
    if element == Element::Bool {
        return Ok(());
    }
    match words.iter().position(|word| !fits(*word)) {
        Some(position) => Err(ImageError::InitialWord { cell: WordCell(begin.saturating_add(position) as u32) }),
        None => Ok(()),
    }
}

/// Where every alias leads, chains followed to their end.
pub(super) fn check_aliases(tables: &Tables<'_>) -> Result<BTreeMap<TagIndex, Place>, ImageError> {
    let mut places = BTreeMap::new();
    let mut chain: Vec<(TagIndex, Reference)> = Vec::new();
    for index in 0..tables.image.tags.len() {
        let mut tag = TagIndex(index as u32);
        // Down the chain to a tag with cells, or to an alias that is known already.
        while let Some(reference) = alias_target(tables, tag)?.filter(|_| !places.contains_key(&tag)) {
            if chain.len() > tables.image.tags.len() {
                return Err(ImageError::AliasCircle { tag });
            }
            let Root::Tag(target) = reference.root else { return Err(ImageError::AliasTarget { tag }) };
            chain.push((tag, reference));
            tag = target;
        }
        // And back, each alias from the place of its target.
        while let Some((alias, reference)) = chain.pop() {
            let place = alias_place(tables, &places, alias, &reference)?;
            places.insert(alias, place);
        }
    }
    Ok(places)
}

fn alias_target(tables: &Tables<'_>, tag: TagIndex) -> Result<Option<Reference>, ImageError> {
    let record = tables.image.tags.get(tag.position()).ok_or(ImageError::AliasTarget { tag })?;
    let TagKind::Alias(operand) = record.kind else { return Ok(None) };
    match text::decode(tables.image, operand)? {
        OperandRecord::Reference(reference) => Ok(Some(reference)),
        _ => Err(ImageError::AliasTarget { tag }),
    }
}

fn alias_place(
    tables: &Tables<'_>,
    places: &BTreeMap<TagIndex, Place>,
    tag: TagIndex,
    reference: &Reference,
) -> Result<Place, ImageError> {
    let wrong = ImageError::AliasTarget { tag };
    let (Some(alias), Root::Tag(target)) = (tables.image.tags.get(tag.position()), reference.root) else {
        return Err(wrong);
    };
    let visible = tables
        .image
        .tags
        .get(target.position())
        .is_some_and(|target| target.program.is_none() || target.program == alias.program);
    if !visible || is_hidden(tables, target, alias.program) {
        return Err(wrong);
    }
    let TagKind::Alias(operand) = alias.kind else { return Err(wrong) };
    let place = tag_place(tables, places, target).ok_or(wrong.clone())?;
    let mut walk = Walk { tables, operand, place, terms: Vec::new() };
    for step in &reference.steps {
        walk.step(step, &mut |_| Err(wrong.clone()))?;
    }
    let place = Place { constant: walk.place.constant || alias.constant, ..walk.place };
    let type_reference = if place.bit.is_some() { TypeReference::Element(Element::Bool) } else { place.type_reference };
    if (alias.type_reference, alias.dimensions) == (type_reference, place.dimensions) {
        Ok(place)
    } else {
        Err(ImageError::AliasType { tag })
    }
}

/// Where a tag lies, aliases followed.
pub(super) fn tag_place(tables: &Tables<'_>, aliases: &BTreeMap<TagIndex, Place>, tag: TagIndex) -> Option<Place> {
    let record = tables.image.tags.get(tag.position())?;
    match record.kind {
        TagKind::Alias(_) => aliases.get(&tag).copied(),
        _ => Place::whole(
            record.type_reference,
            record.dimensions,
            Base::Absolute,
            Some(tag),
            (record.bit_cell, record.word_cell),
        ),
    }
}

/// Whether a program has a tag of its own with the name of this controller tag.
pub(super) fn is_hidden(tables: &Tables<'_>, tag: TagIndex, program: Option<ProgramIndex>) -> bool {
    let (Some(record), Some(program)) = (tables.image.tags.get(tag.position()), program) else { return false };
    if record.program.is_some() || !tables.hidden.get(tag.position()).copied().unwrap_or(false) {
        return false;
    }
    let known =
        |other: &TagRecord| other.program.cmp(&Some(program)).then_with(|| names::order(&other.name, &record.name));
    tables.image.tags.binary_search_by(known).is_ok()
}
