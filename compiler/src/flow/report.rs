//! From the solution to findings: the path of unqualified data, rung by rung.

use twinrung_bytecode::image::TypeReference;
use twinrung_bytecode::layout::elements;
use twinrung_catalog::Element;
use twinrung_grammar::tree::Span;

use super::network::Network;
use super::places::{Key, Part, Slot};
use super::solve::{Solution, Step};
use crate::diagnostic::Finding;
use crate::names::Map;
use crate::project::{Project, TagClass};

/// Steps of a path that are shown; the first and the last ones.
const STEPS_SHOWN: usize = 12;

/// A path from a source to a place.
pub(super) struct Path {
    /// The cell where it begins.
    pub source: Slot,
    /// Reads and writes, from the source on.
    pub steps: Vec<(u32, u32)>,
}

/// Follows unqualified data back to where it comes from.
pub(super) fn path(network: &Network, solution: &Solution, place: Slot) -> Path {
    let mut slot = place;
    let mut steps = Vec::new();
    // Every step leads to what was unqualified before it, so this ends.
    while steps.len() <= network.writes.len() {
        match solution.step(slot) {
            Step::Source => break,
            Step::Link(from) => slot = from,
            Step::Rung { read, write } => match network.reads.get(read as usize) {
                Some(one) => {
                    steps.push((read, write));
                    slot = one.slot;
                }
                None => break,
            },
        }
    }
    steps.reverse();
    Path { source: slot, steps }
}

/// The read with which the path to a place begins; `known` keeps it for every place on the way.
pub(super) fn begin(
    network: &Network,
    solution: &Solution,
    place: Slot,
    known: &mut Map<Slot, Option<u32>>,
) -> Option<u32> {
    let mut way: Vec<(Slot, Option<u32>)> = Vec::new();
    let mut slot = place;
    let mut first = loop {
        if let Some(found) = known.get(&slot) {
            break *found;
        }
        let (from, read) = match solution.step(slot) {
            Step::Source => break None,
            Step::Link(from) => (from, None),
            Step::Rung { read, .. } => match network.reads.get(read as usize) {
                Some(one) => (one.slot, Some(read)),
                None => break None,
            },
        };
        way.push((slot, read));
        slot = from;
        if way.len() > network.places.keys.len() {
            break None;
        }
    };
    for (slot, read) in way.into_iter().rev() {
        first = first.or(read);
        known.insert(slot, first);
    }
    first
}

/// Whether a cell holds a number.
pub(super) fn is_number(key: Key) -> bool {
    matches!(key.part, Part::Word(_) | Part::Whole(_))
}

/// What a source is, in words.
pub(super) fn source_text(project: &Project, key: Key) -> String {
    let name = name_of(project, key);
    let line = key.tag.and_then(|tag| project.map.iter().find(|line| line.safety == tag));
    match line {
        Some(line) => format!("`{name}`, mapped from the standard tag `{}`,", line.standard),
        None => format!("`{name}`"),
    }
}

/// Labels for every step: where the data goes on.
pub(super) fn labelled(project: &Project, network: &Network, path: &Path, finding: Finding) -> Finding {
    let mut finding = finding;
    let count = path.steps.len();
    for (at, (_, write)) in path.steps.iter().enumerate() {
        if count > STEPS_SHOWN && at >= STEPS_SHOWN / 2 && at < count - STEPS_SHOWN / 2 {
            continue;
        }
        let Some(write) = network.writes.get(*write as usize) else { continue };
        let Some(unit) = network.units.get(write.unit as usize) else { continue };
        let place = format!("rung {} of {}", unit.rung, project.routine_name(unit.routine));
        finding = finding.label(write.span, format!("{}. {place}: it goes on from here", at + 1));
    }
    finding
}

/// Where the source is declared.
pub(super) fn declaration(project: &Project, key: Key) -> Option<(Span, String)> {
    let tag = key.tag?;
    if let Some(line) = project.map.iter().find(|line| line.safety == tag) {
        return Some((line.span, format!("mapped from the standard tag `{}`", line.standard)));
    }
    let declared = project.tag(tag);
    (declared.class == TagClass::Safety).then(|| (declared.span, "declared here".to_owned()))
}

/// The name of a cell.
pub(super) fn name_of(project: &Project, key: Key) -> String {
    let Some(tag) = key.tag else { return "the rung condition".to_owned() };
    let declared = project.tag(tag);
    let (cell, is_bit, bit) = match key.part {
        Part::On(cell) | Part::Off(cell) => (cell, true, None),
        Part::Word(cell) | Part::Whole(cell) => (cell, false, None),
        Part::BitOn(cell, bit) | Part::BitOff(cell, bit) => (cell, false, Some(bit)),
        Part::Joint(_) => return declared.image_name().to_owned(),
    };
    let mut name = declared.image_name().to_owned();
    if let Some(type_reference) = declared.type_reference {
        describe(project, type_reference, declared.dimensions, cell, is_bit, &mut name);
    }
    match bit {
        Some(bit) => format!("{name}.{bit}"),
        None => name,
    }
}

/// The rest of the path to a cell. Bounded by the depth of types.
fn describe(project: &Project, kind: TypeReference, dimensions: [u32; 3], cell: u32, is_bit: bool, name: &mut String) {
    let size = |kind| {
        let (bits, words) = project.types.cells(kind);
        if is_bit { bits } else { words }
    };
    let one = size(kind).max(1);
    if dimensions != [0; 3] {
        let at = cell / one;
        let [first, second, third] = dimensions.map(|size| size.max(1));
        let text = match dimensions {
            [_, 0, 0] => format!("[{at}]"),
            [_, _, 0] => format!("[{},{}]", at / second, at % second),
            _ => format!("[{},{},{}]", at / (second * third) % first, at / third % second, at % third),
        };
        name.push_str(&text);
    }
    let TypeReference::Structure(index) = kind else { return };
    let within = cell % one;
    let record = project.types.record(index);
    for (member, layout) in record.members.iter().zip(&project.types.layout(index).members) {
        let begin = if is_bit { layout.bit_cell } else { layout.word_cell };
        let count = size(member.type_reference) * elements(member.dimensions).unwrap_or(1);
        let holds = match member.type_reference {
            TypeReference::Element(Element::Bool) => is_bit,
            TypeReference::Element(_) => !is_bit,
            TypeReference::Structure(_) => true,
        };
        if holds && (begin..begin + count).contains(&within) {
            name.push('.');
            name.push_str(&member.name);
            describe(project, member.type_reference, member.dimensions, within - begin, is_bit, name);
            return;
        }
    }
}
