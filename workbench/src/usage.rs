//! On which rungs tags, and single values of them, are read and written: gathered once, from the accesses that the rules
//! look at.

use std::collections::{BTreeSet, HashMap};

use twinrung_compiler::operand::{Reference, Shape};
use twinrung_compiler::project::{Project, RoutineId, TagId};
use twinrung_compiler::rules::usage::accesses;

/// Most rungs that one line names; the others are counted.
const RUNGS_LISTED: usize = 12;

/// A rung: its routine and its number.
pub type Rung = (u32, u32);

/// A BOOL or a number within a tag: its bit cell, or its word cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Cell {
    /// A BOOL.
    Bit(u32),
    /// A number, or a bit of it.
    Word(u32),
}

/// Rungs on which something is used.
#[derive(Debug, Clone, Default)]
pub struct Uses {
    read: BTreeSet<Rung>,
    written: BTreeSet<Rung>,
}

impl Uses {
    fn add(&mut self, rung: Rung, reads: bool, writes: bool) {
        self.read.extend(reads.then_some(rung));
        self.written.extend(writes.then_some(rung));
    }

    /// These and others.
    pub fn and(&self, other: &Uses) -> Uses {
        Uses { read: &self.read | &other.read, written: &self.written | &other.written }
    }

    /// Whether no rung looks at it.
    pub fn is_unread(&self) -> bool {
        self.read.is_empty()
    }

    /// The rungs that look at it: `Main/Stop rung 3, Main/Stop rung 4`, or `nowhere`.
    pub fn read_places(&self, project: &Project) -> String {
        places(project, &self.read)
    }

    /// The rungs that write it.
    pub fn writers(&self) -> &BTreeSet<Rung> {
        &self.written
    }

    /// The rungs that write it, in words.
    pub fn written_places(&self, project: &Project) -> String {
        places(project, &self.written)
    }
}

fn places(project: &Project, rungs: &BTreeSet<Rung>) -> String {
    if rungs.is_empty() {
        return "nowhere".to_owned();
    }
    let name = |(routine, rung): &Rung| format!("{} rung {rung}", project.routine_name(RoutineId(*routine)));
    let mut list: Vec<String> = rungs.iter().take(RUNGS_LISTED).map(name).collect();
    let more = rungs.len().saturating_sub(RUNGS_LISTED);
    list.extend((more > 0).then(|| format!("and {more} more")));
    list.join(", ")
}

/// What uses a tag.
#[derive(Debug, Default)]
struct TagUses {
    all: Uses,
    /// What uses more than one value at once, or one that only the run selects.
    regions: Uses,
    cells: HashMap<Cell, Uses>,
}

/// What uses each tag of a project.
#[derive(Debug, Default)]
pub struct Index {
    tags: HashMap<TagId, TagUses>,
}

impl Index {
    /// Goes through all rungs once.
    pub fn new(project: &Project) -> Index {
        let mut tags: HashMap<TagId, TagUses> = HashMap::new();
        accesses(project, &mut |access| {
            let Some(tag) = access.reference.base_tag() else { return };
            let uses = tags.entry(tag).or_default();
            let rung = (access.place.routine.0, access.place.rung);
            uses.all.add(rung, access.reads, access.writes);
            let of_cell = match cell(access.reference) {
                Some(cell) => uses.cells.entry(cell).or_default(),
                None => &mut uses.regions,
            };
            of_cell.add(rung, access.reads, access.writes);
        });
        Index { tags }
    }

    /// What uses any part of a tag.
    pub fn of_tag(&self, tag: TagId) -> Uses {
        self.tags.get(&tag).map(|uses| uses.all.clone()).unwrap_or_default()
    }

    /// What uses one value of a tag, alone or with others.
    pub fn of_cell(&self, tag: TagId, cell: Cell) -> Uses {
        let Some(uses) = self.tags.get(&tag) else { return Uses::default() };
        uses.cells.get(&cell).map_or_else(|| uses.regions.clone(), |own| own.and(&uses.regions))
    }
}

/// The one value that a reference reaches.
pub fn cell(reference: &Reference) -> Option<Cell> {
    let location = &reference.location;
    if !location.terms.is_empty() {
        return None;
    }
    match reference.shape() {
        Shape::Bit => Some(Cell::Bit(location.bit_cell)),
        Shape::Word | Shape::WordBit => Some(Cell::Word(location.word_cell)),
        _ => None,
    }
}
