//! From the name that an engineer writes to a signal of a running controller.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::image::{TagKind, TagRecord, TypeReference};
use twinrung_bytecode::index::{BitCell, ProgramIndex, TagIndex, WordCell};
use twinrung_bytecode::layout;
use twinrung_bytecode::operand::{AccessType, BitNumber, OperandRecord, Reference, Shape};
use twinrung_catalog::Element;

use crate::signal::{Signal, SignalError};

/// What a path has reached.
#[derive(Debug, Clone, Copy)]
struct Reached {
    type_reference: TypeReference,
    dimensions: [u32; 3],
    bit_cell: u32,
    word_cell: u32,
    bit: Option<u8>,
}

/// Looks a name up: operand text (`EStop.O1`, `Doors:I.Pt00Data`, `Program:Safety_Main.Step`, `Levels[3]`, `Word.5`),
/// `Published:` before such a text, `Controller:Mode` or `Controller:Fault`.
pub fn signal(image: &AdmittedImage, name: &str) -> Result<Signal, SignalError> {
    if name.eq_ignore_ascii_case("Controller:Mode") {
        return Ok(Signal::ControllerMode);
    }
    if name.eq_ignore_ascii_case("Controller:Fault") {
        return Ok(Signal::ControllerFault);
    }
    if let Some(rest) = strip_prefix(name, "Published:") {
        return tag_signal(image, name, rest).map(Signal::published);
    }
    tag_signal(image, name, name)
}

/// Looks up a name that a stimulus drives: a safety tag that no logic writes, or a standard tag that the map reads.
pub fn driven(image: &AdmittedImage, name: &str) -> Result<Signal, SignalError> {
    let records = image.image();
    if let Some(line) = records.map.iter().find(|line| line.standard.eq_ignore_ascii_case(name)) {
        let tag = records.tags.get(line.safety.position());
        let reached = tag.and_then(|tag| start(image, tag, 0));
        return reached.and_then(one_value).ok_or_else(|| SignalError::NotOneValue { name: name.to_owned() });
    }
    let signal = signal(image, name)?;
    let writes = image.program_writes();
    let frozen = |bit: Option<BitCell>, word: Option<WordCell>| {
        image.frozen().iter().any(|range| {
            bit.is_some_and(|cell| (range.bit_cell..range.bit_cell + range.bit_cells).contains(&cell.0))
                || word.is_some_and(|cell| (range.word_cell..range.word_cell + range.word_cells).contains(&cell.0))
        })
    };
    // Inputs are copied in anew at each scan, so logic that writes them (Appendix F) does not take them over.
    let written = match signal {
        Signal::Bit(cell) => writes.has_bit(cell) && !frozen(Some(cell), None),
        Signal::Word(cell, _) | Signal::WordBit(cell, _) => writes.has_word(cell) && !frozen(None, Some(cell)),
        _ => return Err(SignalError::NotDriven { name: name.to_owned() }),
    };
    if written { Err(SignalError::WrittenByLogic { name: name.to_owned() }) } else { Ok(signal) }
}

fn strip_prefix<'a>(name: &'a str, prefix: &str) -> Option<&'a str> {
    name.get(..prefix.len()).filter(|head| head.eq_ignore_ascii_case(prefix)).and_then(|_| name.get(prefix.len()..))
}

fn tag_signal(image: &AdmittedImage, whole: &str, text: &str) -> Result<Signal, SignalError> {
    let (program, text) = match strip_prefix(text, "Program:") {
        None => (None, text),
        Some(rest) => {
            let (program, rest) = rest.split_once('.').unwrap_or((rest, ""));
            let index = image.image().programs.iter().position(|record| record.name.eq_ignore_ascii_case(program));
            let index = index.ok_or_else(|| SignalError::NoSuchProgram { name: whole.to_owned() })?;
            (Some(ProgramIndex(index as u16)), rest)
        }
    };
    let end = text.find(['.', '[']).unwrap_or(text.len());
    let (name, mut rest) = text.split_at(end);
    let (index, tag) = find(image, program, name)
        .ok_or_else(|| SignalError::NoSuchTag { name: whole.to_owned(), close: closest(image, program, name) })?;
    let _ = index;
    let mut reached = start(image, tag, 0).ok_or_else(|| SignalError::NotOneValue { name: whole.to_owned() })?;
    while !rest.is_empty() {
        let (part, after) = next_part(rest);
        reached = step(image, reached, part)
            .ok_or_else(|| SignalError::NoSuchMember { name: whole.to_owned(), part: part.to_owned() })?;
        rest = after;
    }
    one_value(reached).ok_or_else(|| SignalError::NotOneValue { name: whole.to_owned() })
}

fn find<'a>(image: &'a AdmittedImage, program: Option<ProgramIndex>, name: &str) -> Option<(TagIndex, &'a TagRecord)> {
    let mut tags = image.image().tags.iter().enumerate();
    tags.find(|(_, tag)| tag.program == program && tag.name.eq_ignore_ascii_case(name))
        .map(|(index, tag)| (TagIndex(index as u32), tag))
}

/// The tag whose name differs least, when it differs little.
fn closest(image: &AdmittedImage, program: Option<ProgramIndex>, name: &str) -> Option<String> {
    let allowed = (name.chars().count() / 3).clamp(1, 3);
    image
        .image()
        .tags
        .iter()
        .filter(|tag| tag.program == program)
        .map(|tag| (distance(&tag.name.to_ascii_lowercase(), &name.to_ascii_lowercase()), &tag.name))
        .filter(|(distance, _)| *distance <= allowed)
        .min()
        .map(|(_, name)| name.clone())
}

/// Edit distance.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let above = row[j + 1];
            row[j + 1] = (diagonal + usize::from(x != *y)).min(above + 1).min(row[j] + 1);
            diagonal = above;
        }
    }
    row[b.len()]
}

/// `.Name`, `.5` or `[1,2]` at the front of a text, and what follows.
fn next_part(text: &str) -> (&str, &str) {
    let skip = text.chars().next().map_or(0, char::len_utf8);
    let end = if text.starts_with('[') {
        text.find(']').map_or(text.len(), |at| at + 1)
    } else {
        text[skip..].find(['.', '[']).map_or(text.len(), |at| at + skip)
    };
    text.split_at(end)
}

/// How many aliases may stand in a row; the verifier admits no circle.
const ALIAS_DEPTH: usize = 64;

fn start(image: &AdmittedImage, tag: &TagRecord, depth: usize) -> Option<Reached> {
    let TagKind::Alias(operand) = tag.kind else {
        return Some(Reached {
            type_reference: tag.type_reference,
            dimensions: tag.dimensions,
            bit_cell: tag.bit_cell,
            word_cell: tag.word_cell,
            bit: None,
        });
    };
    if depth > ALIAS_DEPTH {
        return None;
    }
    let OperandRecord::Reference(Reference { access, .. }) =
        OperandRecord::decode(image.image().operands.entry(operand)?).ok()?
    else {
        return None;
    };
    let bit = match access.shape {
        Shape::WordBit(BitNumber::Constant { bit, .. }) => Some(bit),
        Shape::WordBit(BitNumber::Operand { .. }) => return None,
        _ => None,
    };
    Some(Reached {
        type_reference: match access.access_type {
            AccessType::Element(element) => TypeReference::Element(element),
            AccessType::Structure(index) => TypeReference::Structure(index),
        },
        dimensions: tag.dimensions,
        bit_cell: access.bit_cell,
        word_cell: access.word_cell,
        bit,
    })
}

fn step(image: &AdmittedImage, from: Reached, part: &str) -> Option<Reached> {
    if let Some(list) = part.strip_prefix('[') {
        return subscript(image, from, list.strip_suffix(']')?);
    }
    let name = part.strip_prefix('.')?;
    if from.dimensions != [0; 3] || from.bit.is_some() {
        return None;
    }
    match from.type_reference {
        TypeReference::Element(element) => {
            let bit: u8 = name.parse().ok()?;
            (element != Element::Bool && element != Element::Real && bit < element.bits())
                .then_some(Reached { bit: Some(bit), ..from })
        }
        TypeReference::Structure(index) => {
            let record = image.image().types.get(index.position())?;
            let at = record.members.iter().position(|member| member.name.eq_ignore_ascii_case(name))?;
            let (member, place) = (record.members.get(at)?, image.layouts().get(index.position())?.members.get(at)?);
            Some(Reached {
                type_reference: member.type_reference,
                dimensions: member.dimensions,
                bit_cell: from.bit_cell + place.bit_cell,
                word_cell: from.word_cell + place.word_cell,
                bit: None,
            })
        }
    }
}

fn subscript(image: &AdmittedImage, from: Reached, list: &str) -> Option<Reached> {
    let used: Vec<u32> = from.dimensions.into_iter().filter(|size| *size != 0).collect();
    let given: Vec<u32> = list.split(',').map(|item| item.trim().parse().ok()).collect::<Option<_>>()?;
    if used.is_empty() || used.len() != given.len() {
        return None;
    }
    let mut element = 0_u32;
    for (size, index) in used.iter().zip(given) {
        element = element * size + Some(index).filter(|index| index < size)?;
    }
    let (bits, words) = layout::cells(image.layouts(), from.type_reference)?;
    Some(Reached {
        dimensions: [0; 3],
        bit_cell: from.bit_cell + bits * element,
        word_cell: from.word_cell + words * element,
        ..from
    })
}

fn one_value(reached: Reached) -> Option<Signal> {
    if reached.dimensions != [0; 3] {
        return None;
    }
    match (reached.type_reference, reached.bit) {
        (TypeReference::Element(_), Some(bit)) => Some(Signal::WordBit(WordCell(reached.word_cell), bit)),
        (TypeReference::Element(Element::Bool), None) => Some(Signal::Bit(BitCell(reached.bit_cell))),
        (TypeReference::Element(element), None) => Some(Signal::Word(WordCell(reached.word_cell), element)),
        (TypeReference::Structure(_), _) => None,
    }
}

/// Every single value of a tag with its full name, in the order of its declaration: what a list of signals begins with.
pub fn values_of(image: &AdmittedImage, tag: TagIndex) -> Vec<(String, Signal)> {
    let Some(record) = image.image().tags.get(tag.position()) else { return Vec::new() };
    let name = match record.program.and_then(|program| image.image().programs.get(program.position())) {
        Some(program) => format!("Program:{}.{}", program.name, record.name),
        None => record.name.clone(),
    };
    let mut found = Vec::new();
    let mut open: Vec<(String, Reached)> = start(image, record, 0).map(|reached| (name, reached)).into_iter().collect();
    while let Some((name, reached)) = open.pop() {
        if let Some(signal) = one_value(reached) {
            found.push((name, signal));
            continue;
        }
        let parts = parts_of(image, &name, reached);
        open.extend(parts.into_iter().rev());
    }
    found
}

fn parts_of(image: &AdmittedImage, name: &str, reached: Reached) -> Vec<(String, Reached)> {
    let names: Vec<String> = match (reached.dimensions, reached.type_reference) {
        ([0, 0, 0], TypeReference::Structure(index)) => image
            .image()
            .types
            .get(index.position())
            .map(|record| record.members.iter().map(|member| format!(".{}", member.name)).collect())
            .unwrap_or_default(),
        ([first, 0, 0], _) => (0..first).map(|i| format!("[{i}]")).collect(),
        ([first, second, 0], _) => (0..first).flat_map(|i| (0..second).map(move |j| format!("[{i},{j}]"))).collect(),
        ([first, second, third], _) => (0..first)
            .flat_map(|i| (0..second).flat_map(move |j| (0..third).map(move |k| format!("[{i},{j},{k}]"))))
            .collect(),
    };
    names
        .into_iter()
        .filter_map(|part| step(image, reached, &part).map(|inner| (format!("{name}{part}"), inner)))
        .collect()
}
