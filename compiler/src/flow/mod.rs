//! Data flow: which data is unqualified, or of SIL 2 only, and where it leads.
//!
//! The logic is made into one network of places ([`builder`]); the least fixed point over it says for each place which
//! kinds of paths lead to it ([`solve`]); where a path of unqualified data alone leads to a safety output, or to an
//! operand that takes safety data only, it is followed back and reported ([`report`]). `docs/data-flow.md` says exactly
//! what is proved and what is conservative.

mod add_ons;
mod builder;
mod initial;
mod instructions;
mod integrity;
mod jumps;
mod kinds;
mod network;
mod operands;
mod origin;
mod places;
mod report;
mod rung;
mod safety;
mod sequence;
mod solve;
mod subroutines;

use twinrung_catalog::modules::is_safety_output;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::names::{Map, Set};
use crate::project::{Project, TagClass, TagId, TagKind};
use crate::rules::{parameter_in_use, parameter_sequence, unqualified_operand, unqualified_output};
use kinds::Kinds;
use network::Network;
use origin::Origins;
use places::{Part, Slot};
use report::Path;
use sequence::Sequences;
use solve::{Solution, solve};

/// What is mended in thought, so that the next path shows, so often. Each time all paths that are known by then are; what
/// shows after that is said once, with a word that there may be more.
const ROUNDS: usize = 32;

/// Reports unqualified data that controls a safety output or stands in the place of safety data, and SIL 2 data that
/// controls a SIL 3 output.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let data = Origins::of_data(project);
    let sil_3 = integrity::sil_3_cells(project);
    if !data.has_unqualified() && sil_3.is_empty() {
        return;
    }
    let sequences = Sequences::of(project);
    let network = builder::build(project, &sequences);
    if data.has_unqualified() {
        let outputs = outputs(project, &network);
        let mended = of_data(project, &network, &data, &sequences, &outputs, findings);
        of_numbers(project, &network, mended, &sequences, &outputs, findings);
    }
    if !sil_3.is_empty() {
        integrity::check(project, &network, &sil_3, findings);
    }
}

/// What was reported counts as mended, and is returned.
fn of_data(
    project: &Project,
    network: &Network,
    origins: &Origins,
    sequences: &Sequences,
    outputs: &[Slot],
    findings: &mut Findings,
) -> Set<u32> {
    let source = |slot: Slot| origins.of(network.places.keys[slot as usize], &network.places.merged);
    let mut mended: Set<u32> = Set::default();
    let solution = solve(network, source, &mended);
    operands(project, network, &solution, &mut mended, findings);
    let again = !mended.is_empty();
    let first = (!again).then_some(solution);
    rounds(network, source, first, mended, outputs, &mut |read, path, output, further, last| {
        let key = network.places.keys[path.source as usize];
        let from = report::source_text(project, key);
        let to = report::name_of(project, network.places.keys[output as usize]);
        let span = network.reads[read as usize].span;
        let finding = if report::is_number(key) {
            parameter_sequence::finding(&from, &to, further, sequences.missing(span), span)
        } else {
            unqualified_output::finding(&from, &to, further, span)
        };
        push(project, network, path, finding, last, findings);
    })
}

/// Mapped numbers that take part in switching an output at all: to this question nothing but the sequence for
/// parameters qualifies them.
fn of_numbers(
    project: &Project,
    network: &Network,
    mended: Set<u32>,
    sequences: &Sequences,
    outputs: &[Slot],
    findings: &mut Findings,
) {
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
    rounds(network, source, None, mended, outputs, &mut |read, path, output, further, last| {
        let span = network.reads[read as usize].span;
        let from = report::source_text(project, network.places.keys[path.source as usize]);
        let to = report::name_of(project, network.places.keys[output as usize]);
        let finding = parameter_in_use::finding(&from, &to, further, sequences.missing(span), span);
        push(project, network, path, finding, last, findings);
    });
}

/// Reports the first path from each read that brings unqualified data in, takes those reads as mended, and looks again.
/// `report` is given the read, the path, the output, how many further ones there are, and whether this is
/// the first of the last round. Every round mends at least one read, so this ends; the number of rounds is limited for the time it takes.
/// Gives what was mended.
fn rounds(
    network: &Network,
    source: impl Fn(Slot) -> Option<Kinds>,
    first: Option<Solution>,
    mended: Set<u32>,
    outputs: &[Slot],
    report: &mut dyn FnMut(u32, &Path, Slot, usize, bool),
) -> Set<u32> {
    let (mut solution, mut mended) = (first, mended);
    let mut alike: Option<Alike> = None;
    for round in 1..=ROUNDS {
        let solved = solution.take().unwrap_or_else(|| solve(network, &source, &mended));
        let found = paths(network, &solved, outputs);
        if found.is_empty() {
            break;
        }
        for (at, (read, path, output, further)) in found.into_iter().enumerate() {
            if !mended.insert(read) {
                continue;
            }
            let alike = alike.get_or_insert_with(|| reads_alike(network));
            mended.extend(alike.get(&key(network, read)).into_iter().flatten());
            report(read, &path, output, further, round == ROUNDS && at == 0);
        }
    }
    mended
}

type Alike = Map<(Span, Option<TagId>), Vec<u32>>;

/// One operand is read in several ways, as what makes it 1 and as what makes it 0, and is reported once.
fn reads_alike(network: &Network) -> Alike {
    let mut alike = Alike::default();
    for read in 0..network.reads.len() as u32 {
        alike.entry(key(network, read)).or_default().push(read);
    }
    alike
}

fn key(network: &Network, read: u32) -> (Span, Option<TagId>) {
    let read = network.reads[read as usize];
    (read.span, network.places.keys[read.slot as usize].tag)
}

/// Adds a finding about a read with its path.
fn push(project: &Project, network: &Network, path: &Path, finding: Finding, last: bool, findings: &mut Findings) {
    let mut finding = report::labelled(project, network, path, finding);
    if let Some((span, text)) = report::declaration(project, network.places.keys[path.source as usize]) {
        finding = finding.label(span, text);
    }
    if last {
        finding.message.push_str("; there may be further paths, which are looked for when those reported are mended");
    }
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
        push(project, network, &path, finding, false, findings);
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
    let mut begins: Map<Slot, Option<u32>> = Map::default();
    for output in outputs {
        if !solution.kinds(*output).has_unqualified() {
            continue;
        }
        let Some(read) = report::begin(network, solution, *output, &mut begins) else { continue };
        match at.get(&read) {
            Some(known) => found[*known].3 += 1,
            None => {
                at.insert(read, found.len());
                found.push((read, report::path(network, solution, *output), *output, 0));
            }
        }
    }
    found
}

/// Places that switch a safety output on, or are what another controller receives.
fn outputs(project: &Project, network: &Network) -> Vec<Slot> {
    (0..network.places.keys.len() as u32).filter(|slot| is_output(project, network, *slot)).collect()
}

fn is_output(project: &Project, network: &Network, slot: Slot) -> bool {
    let key = network.places.keys[slot as usize];
    let Some((id, tag)) = key.tag.map(|tag| (tag, project.tag(tag))) else { return false };
    if !matches!(key.part, Part::On(_) | Part::Word(_) | Part::BitOn(..)) || tag.class != TagClass::Safety {
        return false;
    }
    match tag.kind {
        TagKind::Produced => true,
        // Of a tag that is judged as one cell some member is a safety output.
        TagKind::ModuleOutput(_) if network.places.merged.contains(&id) => true,
        TagKind::ModuleOutput(module) => {
            let name = report::name_of(project, key);
            let member = name.split('.').find(|part| !part.contains(':')).unwrap_or_default();
            is_safety_output(&project.modules[module].catalog_number, member)
        }
        _ => false,
    }
}
