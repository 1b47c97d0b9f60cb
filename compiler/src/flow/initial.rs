//! What places hold before anything runs, and who can see it.
//!
//! A BOOL that a coil writes in every scan shows its initial value only to what stands before the coil in the first
//! scan; one that is latched shows it for as long as the latch is not set. So an initial value is a path of neither
//! origin, in series with the reasons for which each of the first writers leaves it as it is; and a read that comes
//! before one of them in the scan sees it as it is.

use twinrung_bytecode::image::TypeReference;

use super::network::{Follow, Network, Op};
use super::places::{Key, Part, Slot};
use crate::names::{Map, Set};
use crate::project::data::Region;
use crate::project::{Project, TagId};

/// So many writers of one place are looked at; further ones may leave the value as it is.
const WRITERS: usize = 8;

/// What places hold before anything runs.
#[derive(Debug, Default)]
pub(crate) struct Initial {
    /// Places that an initial value may reach.
    pub holds: Vec<bool>,
    /// Places whose initial value somebody sees before any writer.
    pub seen: Vec<bool>,
    /// The first operations that replace what each place holds.
    pub writers: Map<Slot, Vec<u32>>,
}

/// What a network holds before anything runs. Marks the reads that may see it.
pub(super) fn of(project: &Project, network: &mut Network, order: &[u32]) -> Initial {
    let slots = network.places.keys.len();
    let mut initial = Initial { holds: vec![false; slots], seen: vec![false; slots], writers: Map::default() };
    let mut last = vec![0u32; slots];
    let mut coil = vec![false; slots];
    let unwritten = |slot: Slot| matches!(network.places.keys[slot as usize].part, Part::Joint(_) | Part::Whole(_));
    for (at, op) in network.ops.iter().enumerate() {
        for (slot, follows) in replaced(op).into_iter().flatten() {
            if unwritten(slot) {
                continue;
            }
            coil[slot as usize] |= follows;
            if order[at] == u32::MAX {
                continue;
            }
            let writers = initial.writers.entry(slot).or_default();
            if writers.len() < WRITERS {
                writers.push(at as u32);
                last[slot as usize] = last[slot as usize].max(order[at]);
            }
        }
    }
    let mut declared: Map<TagId, Region> = Map::default();
    for (slot, key) in network.places.keys.iter().enumerate() {
        // A prescan clears what a coil writes.
        initial.holds[slot] = match value(project, key, &network.places.merged, &mut declared) {
            Some((true, begins)) => begins != Begins::Clear,
            Some((false, begins)) => begins != Begins::Set || coil[slot],
            None => false,
        };
    }
    for slot in &network.set_by_prescan {
        initial.holds[*slot as usize] = true;
    }
    let mut more = true;
    while more {
        more = false;
        for (from, to) in &network.copied_by_prescan {
            if initial.holds[*from as usize] && !initial.holds[*to as usize] {
                initial.holds[*to as usize] = true;
                more = true;
            }
        }
    }
    see(network, &mut initial, last, order);
    initial
}

/// With which value a bit may begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Begins {
    Clear,
    Set,
    Either,
}

/// Whether a place is what makes a bit 1, and with which value the bit begins.
fn value(
    project: &Project,
    key: &Key,
    merged: &Set<TagId>,
    declared: &mut Map<TagId, Region>,
) -> Option<(bool, Begins)> {
    let tag = key.tag?;
    let (is_on, cell, bit) = match key.part {
        Part::On(cell) => (true, cell, None),
        Part::Off(cell) => (false, cell, None),
        Part::BitOn(cell, bit) => (true, cell, Some(bit)),
        Part::BitOff(cell, bit) => (false, cell, Some(bit)),
        Part::Word(_) | Part::Whole(_) | Part::Joint(_) => return None,
    };
    let region = declared.entry(tag).or_insert_with(|| region(project, tag));
    if merged.contains(&tag) {
        return Some((is_on, Begins::Either));
    }
    let set = match bit {
        None => region.bits.get(cell as usize).is_some_and(|bit| *bit != 0),
        Some(bit) => region.words.get(cell as usize).is_some_and(|word| word >> bit & 1 != 0),
    };
    Some((is_on, if set { Begins::Set } else { Begins::Clear }))
}

/// The initial cells of a tag; fewer than it has where the rest are 0.
fn region(project: &Project, tag: TagId) -> Region {
    let tag = project.tag(tag);
    match (&tag.initial, tag.type_reference) {
        (Some(region), _) => Region::clone(region),
        (None, Some(kind @ TypeReference::Structure(index))) if project.types.layout(index).holds_backing => {
            project.defaults.cells(&project.types, kind, tag.dimensions)
        }
        _ => Region::default(),
    }
}

/// Marks reads that come before a writer, and places that are seen through others.
fn see(network: &mut Network, initial: &mut Initial, last: Vec<u32>, order: &[u32]) {
    let (mut holds, mut last) = (initial.holds.clone(), last);
    for (from, to) in &network.places.links {
        if matches!(network.places.keys[*to as usize].part, Part::Joint(_)) && holds[*from as usize] {
            holds[*to as usize] = true;
            last[*to as usize] = last[*to as usize].max(last[*from as usize]);
        }
    }
    let mut at = vec![u32::MAX; network.reads.len()];
    for (number, op) in network.ops.iter().enumerate() {
        let reads = match op {
            Op::Contact { on, off, .. } | Op::Resume { on, off } => [Some(*on), Some(*off)],
            Op::Join { read, .. } => [Some(*read), None],
            Op::Edge { on, off } => [Some(*on), Some(*off)],
            _ => [None, None],
        };
        // A one-shot looks at its storage bit before the coil of it, the operation before.
        let early = if matches!(op, Op::Edge { .. }) { 2 } else { 0 };
        for read in reads.into_iter().flatten() {
            // What nobody knows the time of may come first.
            let when = if order[number] == u32::MAX { 0 } else { order[number].saturating_sub(early) };
            at[read as usize] = at[read as usize].min(when);
        }
    }
    for (number, read) in network.reads.iter_mut().enumerate() {
        let slot = read.slot as usize;
        if !holds[slot] || at[number] >= last[slot] {
            continue;
        }
        if matches!(network.places.keys[slot].part, Part::Joint(_)) {
            initial.seen[slot] = true;
        } else {
            read.early = true;
        }
    }
    for (from, to) in network.places.links.iter().rev() {
        if initial.seen[*to as usize] {
            initial.seen[*from as usize] = true;
        }
    }
}

/// The places of which an operation replaces the value, and whether it does so whenever it is executed.
fn replaced(op: &Op) -> [Option<(Slot, bool)>; 2] {
    match *op {
        Op::Bit { off, follow: Follow::Latch | Follow::Beyond, .. } => [Some((off, false)), None],
        Op::Bit { on, follow: Follow::Unlatch, .. } => [Some((on, false)), None],
        Op::Bit { on, off, .. } => [Some((on, true)), Some((off, true))],
        Op::Store { slot, .. } => [Some((slot, false)), None],
        Op::Put { slot, .. } | Op::Break { slot, .. } => [Some((slot, true)), None],
        _ => [None, None],
    }
}

/// When each operation is reached first in a scan; what is not reached, or nobody knows when, last of all.
pub(super) fn order(network: &Network, units_of: &Map<Slot, std::ops::Range<u32>>, roots: &[Slot]) -> Vec<u32> {
    let mut order = vec![u32::MAX; network.ops.len()];
    let mut visited = vec![false; network.units.len()];
    let mut now = 0;
    for root in roots {
        let Some(units) = units_of.get(root) else { continue };
        // Where each open routine goes on: the unit, its end, the operation within it.
        let mut open = vec![(units.clone(), None)];
        while let Some((units, within)) = open.last_mut() {
            let next: u32 = match within {
                Some(next) => *next,
                None if units.start >= units.end => {
                    open.pop();
                    continue;
                }
                None if std::mem::replace(&mut visited[units.start as usize], true) => {
                    units.start += 1;
                    continue;
                }
                None => network.units[units.start as usize].ops.start,
            };
            if next >= network.units[units.start as usize].ops.end {
                units.start += 1;
                *within = None;
                continue;
            }
            *within = Some(next + 1);
            order[next as usize] = now;
            now += 1;
            if let Op::Store { slot, .. } | Op::Break { slot, .. } = network.ops[next as usize]
                && let Some(called) = units_of.get(&slot)
            {
                open.push((called.clone(), None));
            }
        }
    }
    order
}
