//! What every cell holds before anything runs: the data of the declarations, then the literals of pseudo-operands.

use twinrung_bytecode::image::{Image, TypeKind, TypeReference};
use twinrung_bytecode::layout::elements;

use super::order::Order;
use crate::project::{AddOnId, Project};
use crate::rules::preset::{self, Preset, PresetBase};

/// Fills the initial values of an image whose tags have their cells.
pub(super) fn values(project: &Project, order: &Order, image: &mut Image) {
    let presets = preset::all(project);
    let mut of_add_on: Vec<Vec<&Preset>> = vec![Vec::new(); project.add_ons.len()];
    for preset in &presets {
        if let PresetBase::AddOn(add_on) = preset.base {
            of_add_on[add_on.position()].push(preset);
        }
    }
    let mut first = vec![(0u32, 0u32); project.tags.len()];
    for (id, record) in order.tags.iter().zip(&image.tags) {
        let tag = project.tag(*id);
        let (bit, word) = (record.bit_cell, record.word_cell);
        first[id.position()] = (bit, word);
        let Some(type_reference) = tag.type_reference.filter(|_| !tag.is_alias()) else { continue };
        let count = elements(tag.dimensions).unwrap_or(1);
        match &tag.initial {
            Some(region) => {
                put(&mut image.initial_bits, &region.bits, bit);
                put(&mut image.initial_words, &region.words, word);
            }
            None => {
                let mut blanks = Blanks { project, bits: &mut image.initial_bits, words: &mut image.initial_words };
                blanks.put(type_reference, count, bit, word);
            }
        }
        within(project, type_reference, count, word, &of_add_on, &mut image.initial_words);
    }
    for preset in &presets {
        if let PresetBase::Tag(tag) = preset.base {
            let cell = first[tag.position()].1 + preset.word_cell;
            if let Some(word) = image.initial_words.get_mut(cell as usize) {
                *word = preset.value;
            }
        }
    }
}

fn put<T: Copy>(into: &mut [T], from: &[T], at: u32) {
    for (slot, value) in into.iter_mut().skip(at as usize).zip(from) {
        *slot = *value;
    }
}

/// Writes the defaults of Add-On Instructions within data that nothing else is said of.
struct Blanks<'a> {
    project: &'a Project,
    bits: &'a mut [u8],
    words: &'a mut [i32],
}

impl Blanks<'_> {
    /// The depth of types is limited.
    fn put(&mut self, type_reference: TypeReference, count: u32, bit: u32, word: u32) {
        let TypeReference::Structure(index) = type_reference else { return };
        let types = &self.project.types;
        let layout = types.layout(index);
        if !layout.holds_backing {
            return;
        }
        for number in 0..count {
            let (bit, word) = (bit + number * layout.bit_cells, word + number * layout.word_cells);
            if let Some(region) = self.project.defaults.of(index) {
                put(self.bits, &region.bits, bit);
                put(self.words, &region.words, word);
                continue;
            }
            for (member, place) in types.record(index).members.iter().zip(&layout.members) {
                self.put(member.type_reference, place.elements, bit + place.bit_cell, word + place.word_cell);
            }
        }
    }
}

/// Applies the literals of Add-On Instructions' routines to every instance within data. The depth of types is limited.
fn within(
    project: &Project,
    type_reference: TypeReference,
    count: u32,
    word: u32,
    of_add_on: &[Vec<&Preset>],
    words: &mut [i32],
) {
    let TypeReference::Structure(index) = type_reference else { return };
    let layout = project.types.layout(index);
    if !layout.holds_backing {
        return;
    }
    let record = project.types.record(index);
    for number in 0..count {
        let word = word + number * layout.word_cells;
        for (member, place) in record.members.iter().zip(&layout.members) {
            within(project, member.type_reference, place.elements, word + place.word_cell, of_add_on, words);
        }
        if let TypeKind::AddOn(add_on) = record.kind {
            for preset in of_add_on.get(AddOnId(add_on.0).position()).into_iter().flatten() {
                if let Some(slot) = words.get_mut((word + preset.word_cell) as usize) {
                    *slot = preset.value;
                }
            }
        }
    }
}
