//! Where data comes from: the kinds of path that begin at each cell.

use twinrung_bytecode::image::TypeReference;
use twinrung_bytecode::layout::elements;
use twinrung_catalog::Element;
use twinrung_catalog::modules::{MemberClass, class_of_input, is_status};

use super::kinds::Kinds;
use super::places::{Key, Part};
use crate::names::{Map, Set};
use crate::project::{Project, Tag, TagClass, TagId, TagKind, Types};
use crate::rules::usage;

/// The kinds that begin at the cells of one tag.
#[derive(Debug, Clone, Default)]
struct Cells {
    bits: Vec<Kinds>,
    words: Vec<Kinds>,
}

impl Cells {
    fn whole(&self) -> Kinds {
        self.bits.iter().chain(&self.words).fold(Kinds::NONE, |all, one| all.or(*one))
    }
}

/// Where data comes from.
#[derive(Debug, Default)]
pub(crate) struct Origins {
    whole: Map<TagId, Kinds>,
    cells: Map<TagId, Cells>,
}

impl Origins {
    /// The kinds that begin at a place; nothing where data does not come from outside.
    pub fn of(&self, key: Key, merged: &Set<TagId>) -> Option<Kinds> {
        let tag = key.tag?;
        if let Some(kinds) = self.whole.get(&tag) {
            return (!matches!(key.part, Part::Joint(_))).then_some(*kinds);
        }
        let cells = self.cells.get(&tag)?;
        let kinds = match key.part {
            Part::Joint(_) => return None,
            _ if merged.contains(&tag) => cells.whole(),
            Part::On(cell) | Part::Off(cell) => cells.bits.get(cell as usize).copied()?,
            Part::Word(cell) | Part::Whole(cell) | Part::BitOn(cell, _) | Part::BitOff(cell, _) => {
                cells.words.get(cell as usize).copied()?
            }
        };
        (!kinds.is_none()).then_some(kinds)
    }

    /// Whether unqualified data comes from anywhere.
    pub fn has_unqualified(&self) -> bool {
        self.whole.values().any(|kinds| kinds.has_unqualified())
            || self.cells.values().any(|cells| cells.whole().has_unqualified())
    }

    /// Standard data in safety tags: what the tag map brings, and members that the module manual marks STANDARD.
    pub fn of_data(project: &Project) -> Origins {
        let mut origins = Origins::default();
        for line in &project.map {
            origins.whole.insert(line.safety, Kinds::UNQUALIFIED);
        }
        for (at, tag) in project.tags.iter().enumerate() {
            let module = match tag.kind {
                TagKind::ModuleInput(module) => Some(&project.modules[module]),
                TagKind::Consumed => None,
                _ => continue,
            };
            origins.add(project, TagId(at as u32), tag, |member| match module {
                Some(module) => match class_of_input(&module.catalog_number, member) {
                    // A status says that data is valid: it is watched, and qualifies nothing.
                    MemberClass::Safety if is_status(member) => Kinds::NEUTRAL,
                    // A standard device is connected to the point.
                    MemberClass::Safety if module.is_standard(member) => Kinds::UNQUALIFIED,
                    MemberClass::Safety => Kinds::SAFETY,
                    MemberClass::Standard => Kinds::UNQUALIFIED,
                    MemberClass::ConnectionStatus => Kinds::NEUTRAL,
                },
                None => consumed(member),
            });
        }
        origins
    }

    /// SIL 2 data (in the place of what is unqualified) and SIL 3 data (in the place of what is of safety origin).
    pub fn of_integrity(project: &Project) -> Origins {
        let mut origins = Origins::default();
        let paired = paired_points(project);
        for line in &project.map {
            // Standard data is the other question's affair.
            origins.whole.insert(line.safety, Kinds::NEUTRAL);
        }
        for (at, tag) in project.tags.iter().enumerate() {
            let id = TagId(at as u32);
            match tag.kind {
                TagKind::ModuleInput(module) => {
                    let module = &project.modules[module];
                    origins.add(project, id, tag, |member| {
                        let lower = member.to_ascii_lowercase();
                        if !lower.ends_with("data")
                            || class_of_input(&module.catalog_number, member) != MemberClass::Safety
                        {
                            return Kinds::NEUTRAL;
                        }
                        match module.point_of(member).and_then(|point| point.sil) {
                            Some(3) => Kinds::SAFETY,
                            Some(_) => Kinds::UNQUALIFIED,
                            None if module.is_dual(member) => Kinds::SAFETY,
                            None => Kinds::UNQUALIFIED,
                        }
                    });
                }
                TagKind::Consumed => origins.add(project, id, tag, consumed),
                _ => {}
            }
        }
        for (tag, bit, word) in paired {
            origins.set(tag, bit, word, Kinds::SAFETY, |known| known == Kinds::UNQUALIFIED);
        }
        origins.declared(project);
        origins
    }

    /// What tags and aliases declare with `SIL`. Another name does not make SIL 3 of what the tag map brings.
    fn declared(&mut self, project: &Project) {
        let mapped: Set<TagId> = project.map.iter().map(|line| line.safety).collect();
        for (at, tag) in project.tags.iter().enumerate() {
            let Some(sil) = tag.sil else { continue };
            if let Some((tag, bits, words)) = cells_of(project, TagId(at as u32), tag) {
                let kinds = if sil == 3 && !mapped.contains(&tag) { Kinds::SAFETY } else { Kinds::UNQUALIFIED };
                bits.for_each(|bit| self.set(tag, Some(bit), None, kinds, |_| true));
                words.for_each(|word| self.set(tag, None, Some(word), kinds, |_| true));
            }
        }
    }

    fn set(&mut self, tag: TagId, bit: Option<u32>, word: Option<u32>, kinds: Kinds, when: impl Fn(Kinds) -> bool) {
        self.whole.remove(&tag);
        let cells = self.cells.entry(tag).or_default();
        for (list, cell) in [(&mut cells.bits, bit), (&mut cells.words, word)] {
            let Some(cell) = cell.map(|cell| cell as usize) else { continue };
            if list.len() <= cell {
                list.resize(cell + 1, Kinds::NONE);
            }
            if when(list[cell]) {
                list[cell] = kinds;
            }
        }
    }

    fn add(&mut self, project: &Project, id: TagId, tag: &Tag, kinds: impl Fn(&str) -> Kinds) {
        let Some(type_reference) = tag.type_reference.filter(|_| tag.class == TagClass::Safety) else { return };
        let mut cells = Cells::default();
        let count = elements(tag.dimensions).unwrap_or(1);
        for _ in 0..count {
            walk(&project.types, type_reference, "", &kinds, &mut cells);
        }
        self.cells.insert(id, cells);
    }
}

/// Members of a consumed tag: all but the state of its connection are safety data.
fn consumed(member: &str) -> Kinds {
    if ["RunMode", "ConnectionFaulted"].iter().any(|name| member.eq_ignore_ascii_case(name)) {
        Kinds::NEUTRAL
    } else {
        Kinds::SAFETY
    }
}

/// Cells in the order of the layout, each with what its member is.
fn walk(types: &Types, reference: TypeReference, member: &str, kinds: &impl Fn(&str) -> Kinds, out: &mut Cells) {
    match reference {
        TypeReference::Element(Element::Bool) => out.bits.push(kinds(member)),
        TypeReference::Element(_) => out.words.push(kinds(member)),
        TypeReference::Structure(index) => {
            for one in &types.record(index).members {
                for _ in 0..elements(one.dimensions).unwrap_or(1) {
                    walk(types, one.type_reference, &one.name, kinds, out);
                }
            }
        }
    }
}

/// Points of which a safety instruction evaluates a pair.
fn paired_points(project: &Project) -> Vec<(TagId, Option<u32>, Option<u32>)> {
    let mut found = Vec::new();
    usage::channels(project, &mut |_, reference| {
        if let Some(tag) = reference.base_tag() {
            let is_bit = reference.element() == Some(Element::Bool);
            let location = &reference.location;
            found.push((tag, is_bit.then_some(location.bit_cell), (!is_bit).then_some(location.word_cell)));
        }
    });
    found
}

/// A tag and runs of its bit and word cells.
pub(super) type Run = (TagId, std::ops::Range<u32>, std::ops::Range<u32>);

/// The cells that a tag stands for; those of its target for an alias.
pub(super) fn cells_of(project: &Project, id: TagId, tag: &Tag) -> Option<Run> {
    let (base, bit, word, type_reference, dimensions) = match &tag.kind {
        TagKind::Alias(Some(target)) => {
            let reference = &target.reference;
            let base = reference.base_tag()?;
            (
                base,
                reference.location.bit_cell,
                reference.location.word_cell,
                reference.type_reference,
                reference.dimensions,
            )
        }
        TagKind::Alias(None) => return None,
        _ => (id, 0, 0, tag.type_reference?, tag.dimensions),
    };
    let count = elements(dimensions).unwrap_or(1);
    let (bits, words) = project.types.cells(type_reference);
    Some((base, bit..bit + bits * count, word..word + words * count))
}
