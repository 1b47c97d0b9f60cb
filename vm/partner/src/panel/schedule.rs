//! Orders the works of a region so that records of one kind stand together and every dependency holds.

use alloc::collections::VecDeque;
use alloc::vec;
use alloc::vec::Vec;

use super::effect::{Effect, Effects, has_status};
use super::lower::Work;
use super::record::Panel;
use super::{Kind, Region, Run, WidePools};
use crate::ladder::{Code, NONE};

/// Who touched a cell last, within one region.
#[derive(Debug, Clone, Copy)]
struct Touched {
    /// Which region this is about; another one's entry counts as empty.
    region: u32,
    /// The last work that wrote it.
    writer: u32,
    /// The last entry of [`Scheduler::readers`] that read it since.
    reader: u32,
}

const UNTOUCHED: Touched = Touched { region: NONE, writer: NONE, reader: NONE };

/// A reader of a cell.
#[derive(Debug, Clone, Copy)]
struct Reader {
    work: u32,
    /// The reader before it.
    previous: u32,
}

/// Makes regions.
#[derive(Default)]
pub(crate) struct Scheduler {
    /// Regions so far.
    pub(crate) regions: Vec<Region>,
    /// Runs so far.
    pub(crate) runs: Vec<Run>,
    /// Guards so far.
    pub(crate) guards: Vec<u32>,
    /// Records so far.
    pub(crate) pools: WidePools,
    bits: Vec<Touched>,
    words: Vec<Touched>,
    readers: Vec<Reader>,
    /// Pairs of works, the second after the first.
    edges: Vec<(u32, u32)>,
}

/// How a work takes part in the arithmetic status.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Status {
    /// Not at all.
    None,
    /// It records its own flags with its place; such works need no order among themselves.
    Recorded,
    /// It changes the flags in place.
    InPlace,
}

fn kind(work: &Work) -> Kind {
    match work {
        Work::Network(function, _) if function.fits_four() => Kind::FourContacts,
        Work::Network(..) => Kind::SixContacts,
        Work::Compare(_) => Kind::Compare,
        Work::Extract(_) => Kind::Extract,
        Work::Insert(_) => Kind::Insert,
        Work::Timer(kind, _) => *kind,
        Work::Move(_) => Kind::Move,
        Work::Sum(_) => Kind::Sum,
        Work::Other(..) => Kind::Other,
    }
}

fn status(work: &Work) -> Status {
    match work {
        Work::Move(_) | Work::Sum(_) => Status::Recorded,
        Work::Other(other, ..) => match other.step.code {
            Code::Instruction(opcode) if has_status(opcode) => Status::InPlace,
            _ => Status::None,
        },
        _ => Status::None,
    }
}

/// Calls back for each cell that a work touches.
fn touches(work: &Work, effects: &Effects, mut touch: impl FnMut(Effect)) {
    let mut bit = |cell: u32, written: bool| touch(Effect { cell, word: false, written });
    match work {
        Work::Network(function, output) => {
            for cell in function.cells() {
                bit(*cell, false);
            }
            bit(*output, true);
        }
        Work::Compare(compare) => {
            bit(compare.output, true);
            touch(Effect { cell: compare.left, word: true, written: false });
            touch(Effect { cell: compare.right, word: true, written: false });
        }
        Work::Extract(extract) => {
            bit(extract.output, true);
            touch(Effect { cell: extract.word, word: true, written: false });
        }
        Work::Insert(insert) => {
            bit(insert.condition, false);
            touch(Effect { cell: insert.word, word: true, written: true });
        }
        Work::Timer(_, timer) => {
            bit(timer.condition, false);
            for number in 0..3 {
                bit(timer.bit.wrapping_add(number), true);
            }
            touch(Effect { cell: timer.word, word: true, written: false });
            touch(Effect { cell: timer.word.wrapping_add(1), word: true, written: true });
        }
        Work::Move(record) => {
            bit(record.condition, false);
            touch(Effect { cell: record.source, word: true, written: false });
            touch(Effect { cell: record.destination, word: true, written: true });
        }
        Work::Sum(record) => {
            bit(record.condition, false);
            touch(Effect { cell: record.left, word: true, written: false });
            touch(Effect { cell: record.right, word: true, written: false });
            touch(Effect { cell: record.destination, word: true, written: true });
        }
        Work::Other(other, first, end) => {
            bit(other.condition, false);
            if other.output != NONE {
                bit(other.output, true);
            }
            for effect in effects.cells.get(*first as usize..*end as usize).unwrap_or(&[]) {
                touch(*effect);
            }
        }
    }
}

impl Scheduler {
    /// Makes a region out of works in the order of the program; its number.
    pub(crate) fn region(
        &mut self,
        works: &[Work],
        effects: &Effects,
        guards: &[u32],
        bits: usize,
        end: u32,
        executed: u32,
    ) -> u32 {
        let number = self.regions.len() as u32;
        self.depend(works, effects, bits, number);
        let first_run = self.runs.len() as u32;
        self.order(works);
        let first_guard = self.guards.len() as u32;
        self.guards.extend_from_slice(guards);
        self.regions.push(Region {
            first_run,
            runs: (self.runs.len() as u32).wrapping_sub(first_run),
            end,
            executed,
            first_guard,
            guards: guards.len() as u32,
        });
        number
    }

    /// Finds the pairs of works whose order must stay.
    fn depend(&mut self, works: &[Work], effects: &Effects, bits: usize, region: u32) {
        self.edges.clear();
        self.readers.clear();
        if self.bits.len() < bits {
            self.bits.resize(bits, UNTOUCHED);
        }
        let mut in_place = NONE;
        let mut recorded: Vec<u32> = Vec::new();
        for (index, work) in works.iter().enumerate() {
            let index = index as u32;
            let (edges, readers) = (&mut self.edges, &mut self.readers);
            let (bit_cells, word_cells) = (&mut self.bits, &mut self.words);
            touches(work, effects, |effect| {
                let cells = if effect.word { &mut *word_cells } else { &mut *bit_cells };
                let position = effect.cell as usize;
                if cells.len() <= position {
                    cells.resize(position.saturating_add(1), UNTOUCHED);
                }
                let Some(touched) = cells.get_mut(position) else { return };
                if touched.region != region {
                    *touched = Touched { region, ..UNTOUCHED };
                }
                if touched.writer != NONE && touched.writer != index {
                    edges.push((touched.writer, index));
                }
                if effect.written {
                    let mut reader = touched.reader;
                    while let Some(entry) = readers.get(reader as usize) {
                        if entry.work != index {
                            edges.push((entry.work, index));
                        }
                        reader = entry.previous;
                    }
                    touched.writer = index;
                    touched.reader = NONE;
                } else if touched.writer != index {
                    readers.push(Reader { work: index, previous: touched.reader });
                    touched.reader = readers.len().wrapping_sub(1) as u32;
                }
            });
            match status(work) {
                Status::None => {}
                Status::Recorded => {
                    if in_place != NONE {
                        self.edges.push((in_place, index));
                    }
                    recorded.push(index);
                }
                Status::InPlace => {
                    if in_place != NONE {
                        self.edges.push((in_place, index));
                    }
                    self.edges.extend(recorded.drain(..).map(|earlier| (earlier, index)));
                    in_place = index;
                }
            }
        }
    }

    /// Puts the works into the pools, kind after kind, and makes runs of them.
    fn order(&mut self, works: &[Work]) {
        let mut waits = vec![0u32; works.len()];
        let mut first = vec![0u32; works.len().saturating_add(2)];
        for (from, to) in &self.edges {
            if let Some(wait) = waits.get_mut(*to as usize) {
                *wait = wait.saturating_add(1);
            }
            if let Some(count) = first.get_mut((*from as usize).saturating_add(2)) {
                *count = count.saturating_add(1);
            }
        }
        let mut sum = 0u32;
        for count in &mut first {
            sum = sum.saturating_add(*count);
            *count = sum;
        }
        // `first[w + 1]` is where the followers of `w` begin; while they are filled in it moves to their end.
        let mut followers = vec![0u32; self.edges.len()];
        for (from, to) in &self.edges {
            let Some(next) = first.get_mut((*from as usize).saturating_add(1)) else { continue };
            if let Some(follower) = followers.get_mut(*next as usize) {
                *follower = *to;
            }
            *next = next.saturating_add(1);
        }
        let mut ready: [VecDeque<u32>; Kind::ALL.len()] = Default::default();
        let enqueue = |ready: &mut [VecDeque<u32>; Kind::ALL.len()], work: u32| {
            let Some(kind) = works.get(work as usize).map(kind) else { return };
            if let Some(queue) = ready.get_mut(kind as usize) {
                queue.push_back(work);
            }
        };
        for (work, wait) in waits.iter().enumerate() {
            if *wait == 0 {
                enqueue(&mut ready, work as u32);
            }
        }
        // Comparisons first: panels look at them.
        let mut turn = Kind::Compare as usize;
        let mut idle = 0usize;
        while idle < Kind::ALL.len() {
            let kind = Kind::ALL.get(turn).copied().unwrap_or(Kind::FourContacts);
            let begin = self.pool_length(kind);
            while let Some(work) = ready.get_mut(turn).and_then(VecDeque::pop_front) {
                if let Some(record) = works.get(work as usize) {
                    self.put(record);
                }
                let from = first.get(work as usize).copied().unwrap_or(0) as usize;
                let to = first.get((work as usize).saturating_add(1)).copied().unwrap_or(0) as usize;
                for follower in followers.get(from..to).unwrap_or(&[]) {
                    let Some(wait) = waits.get_mut(*follower as usize) else { continue };
                    *wait = wait.saturating_sub(1);
                    if *wait == 0 {
                        enqueue(&mut ready, *follower);
                    }
                }
            }
            let end = self.pool_length(kind);
            if end > begin {
                self.runs.push(Run { kind, begin, end });
                idle = 0;
            } else {
                idle = idle.saturating_add(1);
            }
            // Networks as long as there are any, then one kind after the other.
            let networks_wait = ready.get(Kind::FourContacts as usize).is_some_and(|queue| !queue.is_empty());
            let last = turn.saturating_add(1) >= Kind::ALL.len();
            turn = if last || (kind == Kind::SixContacts && networks_wait) {
                Kind::FourContacts as usize
            } else {
                turn.saturating_add(1)
            };
        }
    }

    fn pool_length(&self, kind: Kind) -> u32 {
        let length = match kind {
            Kind::FourContacts => self.pools.four_contacts.len(),
            Kind::SixContacts => self.pools.six_contacts.len(),
            Kind::Compare => self.pools.compares.len(),
            Kind::Extract => self.pools.extracts.len(),
            Kind::Insert => self.pools.inserts.len(),
            Kind::OnDelay | Kind::OffDelay | Kind::Retentive => self.pools.timers.len(),
            Kind::Move => self.pools.moves.len(),
            Kind::Sum => self.pools.sums.len(),
            Kind::Other => self.pools.others.len(),
        };
        length as u32
    }

    fn put(&mut self, work: &Work) {
        match work {
            Work::Network(function, output) if function.fits_four() => {
                self.pools.four_contacts.push(Panel::new(function.table_of_four(), function, *output));
            }
            Work::Network(function, output) => {
                self.pools.six_contacts.push(Panel::new(function.table_of_six(), function, *output));
            }
            Work::Compare(compare) => self.pools.compares.push(*compare),
            Work::Extract(extract) => self.pools.extracts.push(*extract),
            Work::Insert(insert) => self.pools.inserts.push(*insert),
            Work::Timer(_, timer) => self.pools.timers.push(*timer),
            Work::Move(record) => self.pools.moves.push(*record),
            Work::Sum(record) => self.pools.sums.push(*record),
            Work::Other(other, ..) => self.pools.others.push(*other),
        }
    }
}
