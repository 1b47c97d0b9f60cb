//! The least fixed point: which kinds of paths lead to each place.

use super::kinds::{Kinds, NOWHERE, Value};
use super::network::{Follow, Network, Op};
use super::places::{Part, Slot};
use super::rung::Frame;
use crate::names::Set;

/// Where what a place holds first came from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Step {
    /// It is a source itself.
    Source,
    /// From this place, without an instruction.
    Link(Slot),
    /// By this read and this write.
    Rung { read: u32, write: u32 },
}

/// The solution.
pub(crate) struct Solution {
    kinds: Vec<Kinds>,
    steps: Vec<Step>,
}

impl Solution {
    /// The kinds of a place.
    pub fn kinds(&self, slot: Slot) -> Kinds {
        self.kinds[slot as usize]
    }

    /// Where a place's unqualified data came from.
    pub fn step(&self, slot: Slot) -> Step {
        self.steps[slot as usize]
    }
}

/// Who uses a place: rungs and links, in one list.
struct Users {
    first: Vec<u32>,
    list: Vec<u32>,
}

impl Users {
    fn of(slots: usize, pairs: &[(Slot, u32)]) -> Users {
        let mut first = vec![0u32; slots + 1];
        for (slot, _) in pairs {
            first[*slot as usize + 1] += 1;
        }
        for at in 1..first.len() {
            first[at] += first[at - 1];
        }
        let mut next = first.clone();
        let mut list = vec![0; pairs.len()];
        for (slot, user) in pairs {
            let at = &mut next[*slot as usize];
            list[*at as usize] = *user;
            *at += 1;
        }
        Users { first, list }
    }

    fn of_slot(&self, slot: Slot) -> &[u32] {
        &self.list[self.first[slot as usize] as usize..self.first[slot as usize + 1] as usize]
    }
}

pub(super) struct Solver<'a> {
    pub network: &'a Network,
    mended: &'a Set<u32>,
    kinds: Vec<Kinds>,
    steps: Vec<Step>,
    rungs: Users,
    links: Users,
    waiting: std::collections::VecDeque<u32>,
    queued: Vec<bool>,
    pub frames: Vec<Frame>,
    linked: Vec<Slot>,
    /// Whether a place is a source: nothing is said of its initial value.
    is_source: Vec<bool>,
    /// For each operation the reasons for which it leaves a place as it is.
    keeps: Vec<Value>,
    /// By which read and write unqualified data may keep what a place holds.
    spoiled: Vec<Option<Step>>,
    /// Places of several elements of which all are spoiled.
    spread: Vec<bool>,
}

/// Solves the network for sources: what a place holds of itself. Reads that are `mended` count as qualified.
pub(crate) fn solve(network: &Network, source: impl Fn(Slot) -> Option<Kinds>, mended: &Set<u32>) -> Solution {
    let slots = network.places.keys.len();
    let of_rungs: Vec<(Slot, u32)> = network.reads.iter().map(|read| (read.slot, read.unit)).collect();
    let mut solver = Solver {
        network,
        mended,
        kinds: vec![Kinds::NONE; slots],
        steps: vec![Step::Source; slots],
        rungs: Users::of(slots, &of_rungs),
        links: Users::of(slots, &network.places.links),
        waiting: (0..network.units.len() as u32).collect(),
        queued: vec![true; network.units.len()],
        frames: Vec::new(),
        linked: Vec::new(),
        is_source: (0..slots as u32).map(|slot| source(slot).is_some()).collect(),
        keeps: vec![Value::NONE; network.ops.len()],
        spoiled: vec![None; slots],
        spread: vec![false; slots],
    };
    for rail in &network.rails {
        solver.give(*rail, Value::NEUTRAL, Step::Source);
    }
    let written = written(network);
    for slot in 0..slots as u32 {
        match source(slot) {
            Some(kinds) => solver.give(slot, Value { kinds, from: NOWHERE }, Step::Source),
            None => solver.begin(slot, &written.at_all),
        }
    }
    solver.run();
    // A number of which only itself is known began with its initial value. Where only bits of it are written, each bit has its own.
    for slot in 0..slots as u32 {
        let key = network.places.keys[slot as usize];
        let Part::Word(cell) = key.part else { continue };
        if !solver.kinds[slot as usize].is_none() {
            continue;
        }
        let read = network.places.known(super::places::Key { tag: key.tag, part: Part::Whole(cell) });
        let number = if written.as_a_whole[slot as usize] { slot } else { read.unwrap_or(slot) };
        solver.give(number, Value::NEUTRAL, Step::Source);
    }
    solver.run();
    Solution { kinds: solver.kinds, steps: solver.steps }
}

/// The other place of a bit.
fn other(network: &Network, slot: Slot) -> Option<Slot> {
    let key = network.places.keys[slot as usize];
    let part = match key.part {
        Part::On(cell) => Part::Off(cell),
        Part::Off(cell) => Part::On(cell),
        Part::BitOn(cell, bit) => Part::BitOff(cell, bit),
        Part::BitOff(cell, bit) => Part::BitOn(cell, bit),
        Part::Word(_) | Part::Whole(_) | Part::Joint(_) => return None,
    };
    network.places.known(super::places::Key { tag: key.tag, part })
}

/// Which places something writes.
struct Written {
    /// A bit of a number is written with the number; a number, where a bit of it is.
    at_all: Vec<bool>,
    /// A number not for its bits.
    as_a_whole: Vec<bool>,
}

fn written(network: &Network) -> Written {
    let places = &network.places;
    let mut written: Vec<bool> =
        places.keys.iter().map(|key| matches!(key.part, Part::Joint(_) | Part::Whole(_))).collect();
    for op in &network.ops {
        match op {
            Op::Store { slot, .. } | Op::Put { slot, .. } | Op::Break { slot, .. } | Op::Any { slot, .. } => {
                written[*slot as usize] = true;
            }
            Op::Bit { on, off, follow, .. } => {
                written[*on as usize] |= *follow != Follow::Unlatch;
                written[*off as usize] |= *follow != Follow::Latch;
            }
            _ => {}
        }
    }
    // From ranges to their cells, from numbers to their bits, from bits to their number.
    let before = written.clone();
    for (from, to) in &places.links {
        let joint = matches!(places.keys[*from as usize].part, Part::Joint(_));
        if before[*from as usize] && joint {
            written[*to as usize] = true;
        }
    }
    let before = written.clone();
    for (from, to) in &places.links {
        let ends = (places.keys[*from as usize].part, places.keys[*to as usize].part);
        if let (Part::Word(_), Part::BitOn(..) | Part::BitOff(..)) = ends {
            written[*to as usize] |= before[*from as usize];
            written[*from as usize] |= before[*to as usize];
        }
    }
    Written { at_all: written, as_a_whole: before }
}

impl Solver<'_> {
    fn run(&mut self) {
        while let Some(unit) = self.waiting.pop_front() {
            self.queued[unit as usize] = false;
            self.unit(unit);
        }
    }

    /// What a place holds before anything runs.
    fn begin(&mut self, slot: Slot, written: &[bool]) {
        let initial = &self.network.initial;
        let holds = initial.holds[slot as usize];
        if matches!(self.network.places.keys[slot as usize].part, Part::Joint(_) | Part::Whole(_)) {
            return;
        }
        let untouched =
            !written[slot as usize] && other(self.network, slot).is_none_or(|other| !written[other as usize] || !holds);
        let kept = holds && (initial.seen[slot as usize] || !initial.writers.contains_key(&slot));
        if untouched || kept {
            self.give(slot, Value::NEUTRAL, Step::Source);
        }
    }

    pub fn give(&mut self, slot: Slot, value: Value, step: Step) {
        self.receive(slot, value.kinds, step);
        while let Some(slot) = self.linked.pop() {
            let kinds = self.kinds[slot as usize];
            let (first, end) = (self.links.first[slot as usize], self.links.first[slot as usize + 1]);
            for at in first..end {
                let to = self.links.list[at as usize];
                self.receive(to, kinds, Step::Link(slot));
            }
        }
    }

    fn receive(&mut self, slot: Slot, kinds: Kinds, step: Step) {
        let known = self.kinds[slot as usize];
        let (mut kinds, mut step) = (kinds, step);
        // What is of neither origin stays only for the reasons that are unqualified.
        if let Some(spoiled) = self.spoiled[slot as usize].filter(|_| kinds.or(known).has_neutral()) {
            if !kinds.has_unqualified() {
                step = spoiled;
            }
            kinds = kinds.or(Kinds::UNQUALIFIED);
        }
        if known.holds(kinds) {
            return;
        }
        if kinds.has_unqualified() && !known.has_unqualified() {
            self.steps[slot as usize] = step;
        }
        self.kinds[slot as usize] = known.or(kinds);
        self.linked.push(slot);
        for unit in self.rungs.of_slot(slot) {
            if !std::mem::replace(&mut self.queued[*unit as usize], true) {
                self.waiting.push_back(*unit);
            }
        }
    }

    pub fn read(&self, read: u32) -> Value {
        let one = &self.network.reads[read as usize];
        let (mut kinds, mut from) = (self.kinds[one.slot as usize], read);
        if one.early && !self.is_source[one.slot as usize] {
            kinds = kinds.or(Kinds::NEUTRAL);
            if let (false, Some(Step::Rung { read: spoiled, .. })) =
                (kinds.has_unqualified(), self.spoiled[one.slot as usize])
            {
                // The place itself has no path of unqualified data: the path goes on from what keeps the initial value.
                kinds = kinds.or(Kinds::UNQUALIFIED);
                from = spoiled;
            }
        }
        if kinds.has_unqualified() && (one.accepted || self.mended.contains(&read)) {
            return Value { kinds: kinds.without_unqualified().or(Kinds::QUALIFIED), from: NOWHERE };
        }
        Value { kinds, from }
    }

    pub fn write(&mut self, slot: Slot, value: Value, write: u32) {
        self.give(slot, value, Step::Rung { read: value.from, write });
    }

    /// An operation leaves places as they are for these reasons.
    pub fn keep(&mut self, op: u32, slots: [Option<Slot>; 2], reasons: Value, write: u32) {
        let known = self.keeps[op as usize];
        let more = !known.kinds.holds(reasons.kinds);
        self.keeps[op as usize] = known.either(reasons);
        for slot in slots.into_iter().flatten() {
            if more {
                self.seed(slot, write);
            }
            if reasons.kinds.has_unqualified() {
                self.spoil(slot, reasons, write);
            }
        }
    }

    /// What a place held before anything ran stays for the reasons of all its first writers together.
    fn seed(&mut self, slot: Slot, write: u32) {
        let initial = &self.network.initial;
        if !initial.holds[slot as usize] || self.is_source[slot as usize] {
            return;
        }
        let Some(writers) = initial.writers.get(&slot) else { return };
        let kept = writers.iter().fold(Value::NEUTRAL, |kept, op| kept.series(self.keeps[*op as usize]));
        self.write(slot, kept, write);
    }

    /// Unqualified data decides whether a bit keeps what it holds: what is of neither origin in it becomes unqualified.
    pub fn spoil(&mut self, slot: Slot, reasons: Value, write: u32) {
        let key = self.network.places.keys[slot as usize];
        match key.part {
            Part::Word(_) | Part::Whole(_) => {}
            Part::Joint(_) if key.tag.is_none() => {}
            Part::Joint(_) => self.spoil_elements(slot, reasons, write),
            Part::On(_) | Part::Off(_) | Part::BitOn(..) | Part::BitOff(..) => self.spoil_bit(slot, reasons, write),
        }
    }

    /// The same for every bit that a variable subscript or a region may mean.
    pub fn spoil_elements(&mut self, slot: Slot, reasons: Value, write: u32) {
        if !matches!(self.network.places.keys[slot as usize].part, Part::Joint(_)) {
            return;
        }
        if std::mem::replace(&mut self.spread[slot as usize], true) {
            return;
        }
        let (first, end) = (self.links.first[slot as usize], self.links.first[slot as usize + 1]);
        for at in first..end {
            let to = self.links.list[at as usize];
            if !matches!(self.network.places.keys[to as usize].part, Part::Joint(_)) {
                self.spoil_bit(to, reasons, write);
            }
        }
    }

    fn spoil_bit(&mut self, slot: Slot, reasons: Value, write: u32) {
        let number = matches!(self.network.places.keys[slot as usize].part, Part::Word(_) | Part::Whole(_));
        if number || self.spoiled[slot as usize].is_some() {
            return;
        }
        self.spoiled[slot as usize] = Some(Step::Rung { read: reasons.from, write });
        let again = self.kinds[slot as usize];
        self.give(slot, Value { kinds: again, from: NOWHERE }, Step::Rung { read: reasons.from, write });
        for unit in self.rungs.of_slot(slot) {
            if !std::mem::replace(&mut self.queued[*unit as usize], true) {
                self.waiting.push_back(*unit);
            }
        }
    }
}
