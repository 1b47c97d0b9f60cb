//! Places: which data is judged as one. A BOOL has two, what makes it 1 and what makes it 0; a number one; a bit of a
//! number two of its own where logic uses it; data that a variable subscript selects, and regions, are gathered in
//! places that every cell of them leads to or is led to from.

use crate::names::{Map, Set};
use crate::operand::Term;
use crate::project::TagId;

/// A place.
pub(crate) type Slot = u32;

/// What a place holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Part {
    /// What makes a BOOL 1.
    On(u32),
    /// What makes a BOOL 0.
    Off(u32),
    /// A number, written as a whole.
    Word(u32),
    /// A number, read as a whole: what wrote it as a whole or a bit of it.
    Whole(u32),
    /// What makes a bit of a number 1.
    BitOn(u32, u8),
    /// What makes a bit of a number 0.
    BitOff(u32, u8),
    /// Something that gathers or spreads, or that belongs to no tag: a rung condition, a zone.
    Joint(u32),
}

/// What a place belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Key {
    /// The tag; of a joint the tag that it gathers, where it is one.
    pub tag: Option<TagId>,
    /// Which part.
    pub part: Part,
}

/// Cells of a tag: runs of bit and word cells, repeated for each value of the variable subscripts.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct Range {
    /// The tag.
    pub tag: TagId,
    /// First bit cell.
    pub bit: u32,
    /// First word cell.
    pub word: u32,
    /// Bit cells of a run.
    pub bits: u32,
    /// Word cells of a run.
    pub words: u32,
    /// Variable subscripts.
    pub terms: Vec<Term>,
}

impl Range {
    /// Cells in all.
    fn size(&self) -> u64 {
        let run = u64::from(self.bits) + u64::from(self.words);
        self.terms.iter().fold(run, |size, term| size.saturating_mul(u64::from(term.length)))
    }

    /// The first bit and word cell of every run.
    fn runs(&self) -> Vec<(u32, u32)> {
        let mut list = vec![(self.bit, self.word)];
        for term in &self.terms {
            list = list
                .into_iter()
                .flat_map(|(bit, word)| {
                    (0..term.length).map(move |at| (bit + at * term.bit_stride, word + at * term.word_stride))
                })
                .collect();
        }
        list
    }
}

/// A range of more cells is judged as if all cells of its tag were one.
pub(crate) const RANGE_CELLS_MAX: u64 = 4_096;
/// When the ranges of a project have more cells in all, each tag with one is judged as one cell.
const CELLS_OF_RANGES_MAX: u64 = 2_000_000;

/// All places.
#[derive(Default)]
pub(crate) struct Places {
    slots: Map<Key, Slot>,
    /// What each place is.
    pub keys: Vec<Key>,
    /// Places that lead to others without an instruction.
    pub links: Vec<(Slot, Slot)>,
    gathered: Map<(Range, bool), [Slot; 3]>,
    joined: Map<Vec<Slot>, Slot>,
    /// Tags that are judged as one cell.
    pub merged: Set<TagId>,
    /// Tags that turned out to be too large.
    pub too_large: Set<TagId>,
    ranged: Set<TagId>,
    cells_of_ranges: u64,
}

impl Places {
    /// No places so far; these tags are judged as one cell.
    pub fn new(merged: Set<TagId>) -> Places {
        Places { merged, ..Places::default() }
    }

    fn cell(&self, tag: TagId, cell: u32) -> u32 {
        if self.merged.contains(&tag) { 0 } else { cell }
    }

    fn slot(&mut self, key: Key) -> (Slot, bool) {
        if let Some(slot) = self.slots.get(&key) {
            return (*slot, false);
        }
        let slot = self.keys.len() as Slot;
        self.slots.insert(key, slot);
        self.keys.push(key);
        (slot, true)
    }

    fn of(&mut self, tag: TagId, part: Part) -> (Slot, bool) {
        self.slot(Key { tag: Some(tag), part })
    }

    /// A place that something named already.
    pub fn known(&self, key: Key) -> Option<Slot> {
        self.slots.get(&key).copied()
    }

    /// The place of a value that may be any of several.
    pub fn any_of(&mut self, tag: Option<TagId>, of: &[Slot]) -> Slot {
        if let [only] = of {
            return *only;
        }
        if let Some(known) = self.joined.get(of) {
            return *known;
        }
        let joint = self.joint(tag);
        self.links.extend(of.iter().map(|slot| (*slot, joint)));
        self.joined.insert(of.to_vec(), joint);
        joint
    }

    /// The two places of a BOOL.
    pub fn bit(&mut self, tag: TagId, cell: u32) -> (Slot, Slot) {
        let cell = self.cell(tag, cell);
        (self.of(tag, Part::On(cell)).0, self.of(tag, Part::Off(cell)).0)
    }

    /// The places of a number: where it is written, where it is read.
    pub fn word(&mut self, tag: TagId, cell: u32) -> (Slot, Slot) {
        let cell = self.cell(tag, cell);
        let (written, new) = self.of(tag, Part::Word(cell));
        let (read, _) = self.of(tag, Part::Whole(cell));
        if new {
            self.links.push((written, read));
        }
        (written, read)
    }

    /// The two places of a bit of a number.
    pub fn word_bit(&mut self, tag: TagId, cell: u32, bit: u8) -> (Slot, Slot) {
        let (written, read) = self.word(tag, cell);
        let cell = self.cell(tag, cell);
        let (on, new) = self.of(tag, Part::BitOn(cell, bit));
        let (off, _) = self.of(tag, Part::BitOff(cell, bit));
        if new {
            self.links.extend([(written, on), (written, off), (on, read), (off, read)]);
        }
        (on, off)
    }

    /// A place of no tag.
    pub fn joint(&mut self, tag: Option<TagId>) -> Slot {
        let part = Part::Joint(self.keys.len() as u32);
        self.slot(Key { tag, part }).0
    }

    /// The places of a range: what makes one of its BOOLs 1, what makes one 0, and its numbers. To read, every cell leads
    /// to them; to write, they lead to every cell.
    pub fn range(&mut self, range: Range, writes: bool) -> [Slot; 3] {
        if let Some(known) = self.gathered.get(&(range.clone(), writes)) {
            return *known;
        }
        let tag = range.tag;
        let merged = self.merged.contains(&tag);
        if !merged {
            self.cells_of_ranges = self.cells_of_ranges.saturating_add(range.size());
            self.ranged.insert(tag);
        }
        let joints = [self.joint(Some(tag)), self.joint(Some(tag)), self.joint(Some(tag))];
        let mut runs = Vec::new();
        let mut run = (range.bits, range.words);
        if merged {
            runs.push((0, 0));
            run = (run.0.min(1), run.1.min(1));
        } else if range.size() > RANGE_CELLS_MAX {
            self.too_large.insert(tag);
        } else if self.cells_of_ranges > CELLS_OF_RANGES_MAX {
            self.too_large.extend(self.ranged.iter().copied());
        } else {
            runs = range.runs();
        }
        for (bit, word) in runs {
            for cell in bit..bit + run.0 {
                let (on, off) = self.bit(tag, cell);
                self.join(on, joints[0], writes);
                self.join(off, joints[1], writes);
            }
            for cell in word..word + run.1 {
                let (written, read) = self.word(tag, cell);
                self.join(if writes { written } else { read }, joints[2], writes);
            }
        }
        self.gathered.insert((range, writes), joints);
        joints
    }

    fn join(&mut self, cell: Slot, joint: Slot, writes: bool) {
        self.links.push(if writes { (joint, cell) } else { (cell, joint) });
    }
}
