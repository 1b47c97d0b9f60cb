//! Data flow: which data is unqualified, or of SIL 2 only, and where it leads.
//!
//! The logic is made into one network of places ([`builder`]); the least fixed point over it says for each place which
//! kinds of paths lead to it ([`solve`]); where a path of unqualified data alone leads to a safety output, or to an
//! operand that takes safety data only, it is followed back and reported ([`report`]). `docs/data-flow.md` says exactly
//! what is proved and what is conservative.

mod builder;
mod calls;
mod instructions;
mod kinds;
mod network;
mod operands;
mod origin;
mod places;
mod report;
mod sequence;
mod solve;

use twinrung_catalog::modules::is_safety_output;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::names::{Map, Set};
use crate::project::{Project, TagClass, TagId, TagKind};
use crate::rules::{parameter_in_use, parameter_sequence, sil_2_data, unqualified_operand, unqualified_output};
use kinds::Kinds;
use network::Network;
use origin::Origins;
use places::{Part, Slot};
use report::Path;
use sequence::Sequences;
use solve::{Solution, solve};

/// What is mended in thought, so that the next path shows, so often. Each time all paths that are known by then are.
const ROUNDS: usize = 32;

/// Reports unqualified data that controls a safety output or stands in the place of safety data, and SIL 2 data that
/// controls a SIL 3 output.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let data = Origins::of_data(project);
    let integrity = sil_3_cells(project);
    if !data.has_unqualified() && integrity.is_empty() {
        return;
    }
    let network = builder::build(project);
    if data.has_unqualified() {
        let mended = of_data(project, &network, &data, findings);
        of_numbers(project, &network, mended, findings);
    }
    if !integrity.is_empty() {
        of_integrity(project, &network, &integrity, findings);
    }
}

/// What was reported counts as mended, and is returned.
fn of_data(project: &Project, network: &Network, origins: &Origins, findings: &mut Findings) -> Set<u32> {
    let source = |slot: Slot| origins.of(network.places.keys[slot as usize], &network.places.merged);
    let mut mended: Set<u32> = Set::default();
    let mut solution = solve(network, source, &mended);
    operands(project, network, &solution, &mut mended, findings);
    let outputs: Vec<Slot> =
        (0..network.places.keys.len() as u32).filter(|slot| is_output(project, network, *slot)).collect();
    let sequences = Sequences::of(project);
    for _ in 0..ROUNDS {
        if !mended.is_empty() {
            solution = solve(network, source, &mended);
        }
        let found = paths(network, &solution, &outputs);
        if found.is_empty() {
            break;
        }
        for (read, path, output, further) in found {
            mended.insert(read);
            let key = network.places.keys[path.source as usize];
            let from = report::source_text(project, key);
            let to = report::name_of(project, network.places.keys[output as usize]);
            let span = network.reads[read as usize].span;
            let finding = if report::is_number(key) {
                parameter_sequence::finding(&from, &to, further, sequences.missing(span), span)
            } else {
                unqualified_output::finding(&from, &to, further, span)
            };
            push(project, network, read, &path, finding, findings);
        }
    }
    mended
}

/// Mapped numbers that take part in switching an output at all: to this question nothing but the sequence for
/// parameters qualifies them.
fn of_numbers(project: &Project, network: &Network, mended: Set<u32>, findings: &mut Findings) {
    let mapped: Set<TagId> = project.map.iter().map(|line| line.safety).collect();
    let source = |slot: Slot| {
        let key = network.places.keys[slot as usize];
        let number = !matches!(key.part, Part::On(_) | Part::Off(_) | Part::Joint(_));
        let outside = key.tag.is_some_and(|tag| mapped.contains(&tag));
        match (outside && !matches!(key.part, Part::Joint(_)), number) {
            (true, true) => Some(Kinds::UNQUALIFIED),
            (true, false) => Some(Kinds::NEUTRAL),
            (false, _) => None,
        }
    };
    if !(0..network.places.keys.len() as u32).any(|slot| source(slot).is_some_and(Kinds::has_unqualified)) {
        return;
    }
    let outputs: Vec<Slot> =
        (0..network.places.keys.len() as u32).filter(|slot| is_output(project, network, *slot)).collect();
    let sequences = Sequences::of(project);
    let mut mended = mended;
    for _ in 0..ROUNDS {
        let found = paths(network, &solve(network, source, &mended), &outputs);
        if found.is_empty() {
            return;
        }
        for (read, path, output, further) in found {
            mended.insert(read);
            let read_span = network.reads[read as usize].span;
            let from = report::source_text(project, network.places.keys[path.source as usize]);
            let to = report::name_of(project, network.places.keys[output as usize]);
            let finding = parameter_in_use::finding(&from, &to, further, sequences.missing(read_span), read_span);
            push(project, network, read, &path, finding, findings);
        }
    }
}

/// Adds a finding about a read with its path.
fn push(project: &Project, network: &Network, read: u32, path: &Path, finding: Finding, findings: &mut Findings) {
    let mut finding = report::labelled(project, network, path, finding);
    if let Some((span, text)) = report::declaration(project, network.places.keys[path.source as usize]) {
        finding = finding.label(span, text);
    }
    finding.rung = report::rung_place(project, network, network.reads[read as usize].unit);
    findings.push(finding);
}

/// Operands of safety instructions that take no unqualified data. What is reported counts as mended.
fn operands(project: &Project, network: &Network, solution: &Solution, mended: &mut Set<u32>, findings: &mut Findings) {
    let mut reported: Set<Span> = Set::default();
    for (number, name) in &network.safety_only {
        let read = network.reads[*number as usize];
        let unit = &network.units[read.unit as usize];
        if !solution.kinds(read.slot).has_unqualified() || unit.incomplete {
            continue;
        }
        mended.insert(*number);
        if !reported.insert(read.span) {
            continue;
        }
        let path = report::path(network, solution, read.slot);
        let from = report::source_text(project, network.places.keys[path.source as usize]);
        let finding = unqualified_operand::finding(name, &from, read.span);
        push(project, network, *number, &path, finding, findings);
    }
    // Every read of the operand counts as mended, not only the one that was reported.
    let spans: Set<Span> = reported;
    for (at, read) in network.reads.iter().enumerate() {
        if spans.contains(&read.span) {
            mended.insert(at as u32);
        }
    }
}

/// For each read that brings unqualified data in: the path of the first output that it reaches, and how many more.
fn paths(network: &Network, solution: &Solution, outputs: &[Slot]) -> Vec<(u32, Path, Slot, usize)> {
    let mut found: Vec<(u32, Path, Slot, usize)> = Vec::new();
    let mut at: Map<u32, usize> = Map::default();
    for output in outputs {
        if !solution.kinds(*output).has_unqualified() {
            continue;
        }
        let path = report::path(network, solution, *output);
        let Some((read, _)) = path.steps.first().copied() else { continue };
        match at.get(&read) {
            Some(known) => found[*known].3 += 1,
            None => {
                at.insert(read, found.len());
                found.push((read, path, *output, 0));
            }
        }
    }
    found
}

/// Whether a place switches a safety output on, or is what another controller receives.
fn is_output(project: &Project, network: &Network, slot: Slot) -> bool {
    let key = network.places.keys[slot as usize];
    let Some(tag) = key.tag.map(|tag| project.tag(tag)) else { return false };
    if !matches!(key.part, Part::On(_) | Part::Word(_) | Part::BitOn(..)) || tag.class != TagClass::Safety {
        return false;
    }
    match tag.kind {
        TagKind::Produced => true,
        TagKind::ModuleOutput(module) => {
            let name = report::name_of(project, key);
            let member = name.split('.').find(|part| !part.contains(':')).unwrap_or_default();
            is_safety_output(&project.modules[module].catalog_number, member)
        }
        _ => false,
    }
}

/// Cells that are declared SIL 3 and that logic may write.
fn sil_3_cells(project: &Project) -> Vec<(TagId, Span, origin::Run)> {
    let mut list = Vec::new();
    for (at, tag) in project.tags.iter().enumerate() {
        let id = TagId(at as u32);
        if tag.sil == Some(3)
            && let Some(run) = origin::cells_of(project, id, tag)
            && !matches!(project.tag(run.0).kind, TagKind::ModuleInput(_) | TagKind::Consumed)
        {
            list.push((run.0, tag.span, run));
        }
        if let TagKind::ModuleOutput(module) = tag.kind {
            list.extend(sil_3_points(project, module, id));
        }
    }
    list
}

/// Output points that a module declares SIL 3.
fn sil_3_points(project: &Project, module: usize, id: TagId) -> Vec<(TagId, Span, origin::Run)> {
    let Some(twinrung_bytecode::image::TypeReference::Structure(index)) = project.tag(id).type_reference else {
        return Vec::new();
    };
    let members = project.types.record(index).members.iter().zip(&project.types.layout(index).members);
    let points = project.modules[module].points.iter().filter(|point| point.sil == Some(3));
    points
        .filter_map(|point| {
            let number = point.name.strip_prefix('O')?.parse::<u32>().ok()?;
            let wanted = format!("pt{number:02}data");
            let (_, layout) = members.clone().find(|(member, _)| member.name.eq_ignore_ascii_case(&wanted))?;
            Some((id, point.span, (id, layout.bit_cell..layout.bit_cell + 1, 0..0)))
        })
        .collect()
}

fn of_integrity(project: &Project, network: &Network, cells: &[(TagId, Span, origin::Run)], findings: &mut Findings) {
    let origins = Origins::of_integrity(project);
    let source = |slot: Slot| origins.of(network.places.keys[slot as usize], &network.places.merged);
    let mut outputs = Vec::new();
    let mut declared: Map<Slot, Span> = Map::default();
    for (slot, key) in network.places.keys.iter().enumerate() {
        let within = cells.iter().find(|(tag, _, (_, bits, words))| {
            key.tag == Some(*tag)
                && match key.part {
                    Part::On(cell) => bits.contains(&cell),
                    Part::Word(cell) | Part::BitOn(cell, _) => words.contains(&cell),
                    _ => false,
                }
        });
        if let Some((_, span, _)) = within {
            outputs.push(slot as u32);
            declared.insert(slot as u32, *span);
        }
    }
    let mut mended: Set<u32> = Set::default();
    for _ in 0..ROUNDS {
        let solution = solve(network, source, &mended);
        let found = paths(network, &solution, &outputs);
        if found.is_empty() {
            return;
        }
        for (read, path, output, further) in found {
            mended.insert(read);
            let from = report::name_of(project, network.places.keys[path.source as usize]);
            let to = report::name_of(project, network.places.keys[output as usize]);
            let mut finding = sil_2_data::finding(&from, &to, further, network.reads[read as usize].span);
            if let Some(span) = declared.get(&output) {
                finding = finding.label(*span, "SIL 3 is declared here");
            }
            push(project, network, read, &path, finding, findings);
        }
    }
}
