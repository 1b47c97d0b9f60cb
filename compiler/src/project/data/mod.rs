//! Initial data: the forms in which a file writes it, as cells. neutral-text-and-l5x.md D.5.

mod forms;

use twinrung_bytecode::image::{TypeKind, TypeReference};
use twinrung_bytecode::index::TypeIndex;
use twinrung_bytecode::layout::{elements, fields};
use twinrung_catalog::Element;
use twinrung_grammar::tree::{Data, DataForm, Span};

use super::Types;
use crate::diagnostic::{DATA_DISAGREES, DATA_DOES_NOT_FIT, Finding, Findings};
use forms::Reader;

/// Values of the cells of a tag, member or type.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Region {
    /// One byte for each bit cell, 0 or 1.
    pub bits: Vec<u8>,
    /// Word cells.
    pub words: Vec<i32>,
}

impl Region {
    fn zeros(bits: u32, words: u32) -> Region {
        Region { bits: vec![0; bits as usize], words: vec![0; words as usize] }
    }

    /// Whether every cell is 0.
    pub fn is_zero(&self) -> bool {
        self.bits.iter().all(|bit| *bit == 0) && self.words.iter().all(|word| *word == 0)
    }

    /// Writes another region's cells into this one, from a bit cell and a word cell on.
    pub fn put(&mut self, from: &Region, bit: u32, word: u32) {
        for (slot, value) in self.bits.iter_mut().skip(bit as usize).zip(&from.bits) {
            *slot = *value;
        }
        for (slot, value) in self.words.iter_mut().skip(word as usize).zip(&from.words) {
            *slot = *value;
        }
    }
}

/// What the instances of Add-On Instructions hold before anything runs: by type, where that is not zero.
#[derive(Debug, Default)]
pub struct Defaults {
    by_type: Vec<Option<Region>>,
}

/// Where in a region a value goes.
#[derive(Clone, Copy)]
struct At {
    bit: u32,
    word: u32,
}

/// A form that cannot be read as this type.
enum Trouble {
    /// Report it.
    Finding(Box<Finding>),
    /// The form does not say enough about this type; another form may.
    NotVisible(Span),
}

impl From<Finding> for Trouble {
    fn from(finding: Finding) -> Trouble {
        Trouble::Finding(Box::new(finding))
    }
}

impl Defaults {
    /// Defaults of one element of a type.
    pub fn of(&self, index: TypeIndex) -> Option<&Region> {
        self.by_type.get(index.position()).and_then(Option::as_ref)
    }

    /// Sets the defaults of an Add-On Instruction's instances.
    pub fn set(&mut self, index: TypeIndex, region: Region) {
        if self.by_type.len() <= index.position() {
            self.by_type.resize(index.position() + 1, None);
        }
        self.by_type[index.position()] = (!region.is_zero()).then_some(region);
    }

    /// What data of this type holds when nothing else is said.
    pub fn blank(&mut self, types: &Types, type_reference: TypeReference, dimensions: [u32; 3]) -> Region {
        let (bits, words) = types.cells(type_reference);
        let count = elements(dimensions).unwrap_or(1);
        let mut region = Region::zeros(bits * count, words * count);
        if let TypeReference::Structure(index) = type_reference
            && let Some(default) = self.structure(types, index).cloned()
        {
            for number in 0..count {
                region.put(&default, number * bits, number * words);
            }
        }
        region
    }

    /// What data of this type holds when nothing else is said, once all Add-On Instructions are known.
    pub fn cells(&self, types: &Types, type_reference: TypeReference, dimensions: [u32; 3]) -> Region {
        let (bits, words) = types.cells(type_reference);
        let count = elements(dimensions).unwrap_or(1);
        let mut region = Region::zeros(bits * count, words * count);
        let TypeReference::Structure(index) = type_reference else { return region };
        if !types.layout(index).holds_backing {
            return region;
        }
        for number in 0..count {
            match self.of(index) {
                Some(known) => region.put(known, number * bits, number * words),
                None => {
                    for (member, place) in types.record(index).members.iter().zip(&types.layout(index).members) {
                        let inner = self.cells(types, member.type_reference, member.dimensions);
                        region.put(&inner, number * bits + place.bit_cell, number * words + place.word_cell);
                    }
                }
            }
        }
        region
    }

    /// Defaults of a user-defined type come from the Add-On Instructions within it.
    fn structure(&mut self, types: &Types, index: TypeIndex) -> Option<&Region> {
        let record = types.record(index);
        if record.kind == TypeKind::User && self.of(index).is_none() && types.layout(index).holds_backing {
            let (bits, words) = types.cells(TypeReference::Structure(index));
            let mut region = Region::zeros(bits, words);
            for (member, place) in record.members.iter().zip(&types.layout(index).members) {
                let inner = self.blank(types, member.type_reference, member.dimensions);
                region.put(&inner, place.bit_cell, place.word_cell);
            }
            self.set(index, region);
        }
        self.of(index)
    }
}

/// Reads the data of a tag, parameter or local tag; `None` when every cell is as [`Defaults::blank`] has it.
pub fn read(
    types: &Types,
    defaults: &mut Defaults,
    data: &[Data],
    type_reference: TypeReference,
    dimensions: [u32; 3],
    findings: &mut Findings,
) -> Option<Region> {
    let mut taken: Option<(Region, Span)> = None;
    let mut hidden = None;
    for form in [DataForm::Decorated, DataForm::String, DataForm::L5k, DataForm::Raw] {
        for one in data.iter().filter(|one| one.form == form) {
            let mut region = defaults.blank(types, type_reference, dimensions);
            let reader = Reader { types };
            let outcome = if form == DataForm::Raw {
                reader.raw(&one.value, type_reference, dimensions, &mut region)
            } else {
                reader.value(&one.value, type_reference, dimensions, At { bit: 0, word: 0 }, &mut region)
            };
            match (outcome, &taken) {
                (Ok(()), None) => taken = Some((region, one.value.span())),
                (Ok(()), Some((first, place))) => {
                    if !agrees(types, type_reference, first, &region) {
                        let message = "this form of the data says something else than the other form";
                        let finding = Finding::new(&DATA_DISAGREES, one.value.span(), message)
                            .label(*place, "the other form")
                            .help("export the project again");
                        findings.push(finding);
                        return None;
                    }
                }
                (Err(Trouble::Finding(finding)), _) => {
                    findings.push(*finding);
                    return None;
                }
                (Err(Trouble::NotVisible(span)), _) => hidden = Some(span),
            }
        }
    }
    match (taken, hidden) {
        (Some((region, _)), _) => (region != defaults.blank(types, type_reference, dimensions)).then_some(region),
        (None, Some(span)) => {
            let message = "the initial value cannot be read: this form does not show the members of the type";
            let help = "export with decorated data, or write one value for each member";
            findings.push(Finding::new(&DATA_DOES_NOT_FIT, span, message).help(help));
            None
        }
        (None, None) => None,
    }
}

/// REAL values of two forms may differ in the digits that each form writes; nothing else may.
fn agrees(types: &Types, type_reference: TypeReference, first: &Region, second: &Region) -> bool {
    if first == second {
        return true;
    }
    let close = |a: i32, b: i32| {
        let (a, b) = (f32::from_bits(a as u32), f32::from_bits(b as u32));
        a.is_finite() && b.is_finite() && (a - b).abs() <= a.abs().max(b.abs()) * 1e-5
    };
    let is_real: Vec<bool> = match type_reference {
        TypeReference::Element(element) => vec![element == Element::Real],
        TypeReference::Structure(_) => {
            let list = fields(types.records(), types.layouts(), type_reference);
            let words = list.iter().filter(|field| field.element != Element::Bool);
            let mut by_cell: Vec<(u32, bool)> =
                words.map(|field| (field.cell, field.element == Element::Real)).collect();
            by_cell.sort_unstable();
            by_cell.into_iter().map(|(_, is_real)| is_real).collect()
        }
    };
    let pairs = first.words.iter().zip(&second.words).zip(is_real.iter().cycle());
    first.bits == second.bits && pairs.into_iter().all(|((a, b), is_real)| a == b || (*is_real && close(*a, *b)))
}
