//! SIL 2 data and what is declared SIL 3.

use twinrung_bytecode::image::TypeReference;
use twinrung_grammar::tree::Span;

use super::network::Network;
use super::origin::{Origins, Run, cells_of};
use super::places::{Part, Slot};
use super::{push, report, rounds};
use crate::diagnostic::Findings;
use crate::names::{Map, Set};
use crate::project::{Project, TagId, TagKind};
use crate::rules::sil_2_data;

/// Cells that are declared SIL 3 and that logic may write, each with where that is said.
pub(super) fn sil_3_cells(project: &Project) -> Vec<(Span, Run)> {
    let mut list = Vec::new();
    for (at, tag) in project.tags.iter().enumerate() {
        let id = TagId(at as u32);
        if tag.sil == Some(3)
            && let Some(run) = cells_of(project, id, tag)
            && !matches!(project.tag(run.0).kind, TagKind::ModuleInput(_) | TagKind::Consumed)
        {
            list.push((tag.span, run));
        }
        if let TagKind::ModuleOutput(module) = tag.kind {
            list.extend(sil_3_points(project, module, id));
        }
    }
    list
}

/// Output points that a module declares SIL 3.
fn sil_3_points(project: &Project, module: usize, id: TagId) -> Vec<(Span, Run)> {
    let Some(TypeReference::Structure(index)) = project.tag(id).type_reference else {
        return Vec::new();
    };
    let members = project.types.record(index).members.iter().zip(&project.types.layout(index).members);
    let points = project.modules[module].points.iter().filter(|point| point.sil == Some(3));
    points
        .filter_map(|point| {
            let number = point.name.strip_prefix('O')?.parse::<u32>().ok()?;
            let wanted = format!("pt{number:02}data");
            let (_, layout) = members.clone().find(|(member, _)| member.name.eq_ignore_ascii_case(&wanted))?;
            Some((point.span, (id, layout.bit_cell..layout.bit_cell + 1, 0..0)))
        })
        .collect()
}

/// The places of these cells, each with where SIL 3 is declared. Of a tag that is judged as one cell any of them counts.
fn declared(network: &Network, cells: &[(Span, Run)]) -> Map<Slot, Span> {
    let mut of_tag: Map<TagId, Vec<&(Span, Run)>> = Map::default();
    for one in cells {
        of_tag.entry(one.1.0).or_default().push(one);
    }
    let mut found = Map::default();
    for (slot, key) in network.places.keys.iter().enumerate() {
        let Some((tag, runs)) = key.tag.and_then(|tag| Some((tag, of_tag.get(&tag)?))) else { continue };
        let merged = network.places.merged.contains(&tag);
        let within = runs.iter().find(|(_, (_, bits, words))| match key.part {
            Part::On(_) | Part::Word(_) | Part::BitOn(..) if merged => true,
            Part::On(cell) => bits.contains(&cell),
            Part::Word(cell) | Part::BitOn(cell, _) => words.contains(&cell),
            _ => false,
        });
        if let Some((span, _)) = within {
            found.insert(slot as Slot, *span);
        }
    }
    found
}

/// Reports SIL 2 data that alone controls one of these cells.
pub(super) fn check(project: &Project, network: &Network, cells: &[(Span, Run)], findings: &mut Findings) {
    let origins = Origins::of_integrity(project);
    let source = |slot: Slot| origins.of(network.places.keys[slot as usize], &network.places.merged);
    let declared = declared(network, cells);
    let mut outputs: Vec<Slot> = declared.keys().copied().collect();
    outputs.sort_unstable();
    rounds(network, source, None, Set::default(), &outputs, &mut |read, path, output, further, last| {
        let from = report::name_of(project, network.places.keys[path.source as usize]);
        let to = report::name_of(project, network.places.keys[output as usize]);
        let mut finding = sil_2_data::finding(&from, &to, further, network.reads[read as usize].span);
        if let Some(span) = declared.get(&output) {
            finding = finding.label(*span, "SIL 3 is declared here");
        }
        push(project, network, path, finding, last, findings);
    });
}
