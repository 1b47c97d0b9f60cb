//! The least fixed point: which kinds of paths lead to each place.

use super::kinds::{Condition, Kinds, NOWHERE, Value};
use super::network::{Follow, Join, Network, Op};
use super::places::{Part, Slot};
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

/// Frames of branches.
struct Frame {
    absolute: Condition,
    relative: Condition,
    sum: Condition,
}

const NO_LEG: Condition = Condition { on: Value::NONE, off: Value::NEUTRAL };

struct Solver<'a> {
    network: &'a Network,
    mended: &'a Set<u32>,
    kinds: Vec<Kinds>,
    steps: Vec<Step>,
    rungs: Users,
    links: Users,
    waiting: std::collections::VecDeque<u32>,
    queued: Vec<bool>,
    frames: Vec<Frame>,
    linked: Vec<Slot>,
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
    };
    for rail in &network.rails {
        solver.give(*rail, Value::NEUTRAL, Step::Source);
    }
    let written = written(network);
    for slot in 0..slots as u32 {
        match source(slot) {
            Some(kinds) => solver.give(slot, Value { kinds, from: NOWHERE }, Step::Source),
            None if !written[slot as usize] => solver.give(slot, Value::NEUTRAL, Step::Source),
            None => {}
        }
    }
    solver.run();
    // What only itself leads to began with its initial value.
    for slot in 0..slots as u32 {
        let initial =
            matches!(network.places.keys[slot as usize].part, Part::Off(_) | Part::Word(_) | Part::BitOff(..));
        if initial && solver.kinds[slot as usize].is_none() {
            solver.give(slot, Value::NEUTRAL, Step::Source);
        }
    }
    solver.run();
    Solution { kinds: solver.kinds, steps: solver.steps }
}

/// Which places something writes. A bit of a number is written with the number; a number, where a bit of it is.
fn written(network: &Network) -> Vec<bool> {
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
    written
}

impl Solver<'_> {
    fn run(&mut self) {
        while let Some(unit) = self.waiting.pop_front() {
            self.queued[unit as usize] = false;
            self.unit(unit);
        }
    }

    fn give(&mut self, slot: Slot, value: Value, step: Step) {
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

    fn read(&self, read: u32) -> Value {
        let one = &self.network.reads[read as usize];
        let kinds = self.kinds[one.slot as usize];
        if kinds.has_unqualified() && (one.accepted || self.mended.contains(&read)) {
            return Value { kinds: kinds.without_unqualified().or(Kinds::QUALIFIED), from: NOWHERE };
        }
        Value { kinds, from: read }
    }

    fn contact(&self, on: u32, off: u32) -> Condition {
        Condition { on: self.read(on), off: self.read(off) }
    }

    fn unit(&mut self, number: u32) {
        let network = self.network;
        let unit = &network.units[number as usize];
        let guard = self.read(unit.guard);
        if guard.kinds.is_none() {
            return;
        }
        let mut absolute = match unit.zone {
            Some((on, off)) => self.contact(on, off),
            None => Condition::RAIL,
        };
        if unit.incomplete {
            absolute = absolute.series(Condition { on: Value::SAFETY, off: Value::SAFETY });
        }
        let mut relative = Condition::RAIL;
        let mut value = Value::NEUTRAL;
        self.frames.clear();
        for op in &network.ops[unit.ops.start as usize..unit.ops.end as usize] {
            let mut series = |contact: Condition| {
                absolute = absolute.series(contact);
                relative = relative.series(contact);
            };
            match *op {
                Op::Contact { on, off, selected: false } => series(self.contact(on, off)),
                Op::Contact { on, off, selected: true } => {
                    let contact = self.contact(on, off);
                    series(Condition { on: contact.on.mixed(value), off: contact.off.mixed(value) });
                }
                Op::Test => series(Condition { on: value, off: value }),
                Op::Never => series(Condition { on: Value::NONE, off: Value::NEUTRAL }),
                Op::Edge => {
                    let held = absolute.on;
                    absolute.off = absolute.off.either(held);
                    relative.off = relative.off.either(held);
                }
                Op::Open => {
                    self.frames.push(Frame { absolute, relative, sum: NO_LEG });
                    relative = Condition::RAIL;
                }
                Op::Leg | Op::Close => {
                    let Some(frame) = self.frames.last_mut() else { return };
                    frame.sum.on = frame.sum.on.either(relative.on);
                    frame.sum.off = frame.sum.off.series(relative.off);
                    if matches!(op, Op::Leg) {
                        absolute = frame.absolute;
                        relative = Condition::RAIL;
                    } else {
                        absolute = frame.absolute.series(frame.sum);
                        relative = frame.relative.series(frame.sum);
                        self.frames.pop();
                    }
                }
                Op::Clear => value = Value::NEUTRAL,
                Op::Nothing => value = Value::NONE,
                Op::Join { read, how } => {
                    let joined = self.read(read);
                    value = match how {
                        Join::Series => value.series(joined),
                        Join::Either => value.either(joined),
                        Join::Mixed => value.mixed(joined),
                        Join::Taint => value.series(joined.taint()),
                    };
                }
                // What is moved on is named before the conditions on which it is.
                Op::Store { slot, write } => self.write(slot, value.series(guard.series(absolute.on)), write),
                Op::Put { slot, write } => self.write(slot, value, write),
                Op::Break { slot, write } => self.write(slot, guard.series(absolute.off.either(value)), write),
                Op::Any { slot, write } => {
                    self.write(slot, guard.series(absolute.on.either(absolute.off)).series(value), write);
                }
                Op::Bit { on, off, follow, write } => {
                    let when_true = guard.series(absolute.on).series(value);
                    let when_false = guard.series(absolute.off).series(value);
                    match follow {
                        Follow::Coil => {
                            self.write(on, when_true, write);
                            self.write(off, when_false, write);
                        }
                        Follow::Latch => self.write(on, when_true, write),
                        Follow::Unlatch => self.write(off, when_true, write),
                        Follow::Pulse => {
                            self.write(on, when_true, write);
                            self.write(off, when_true.either(when_false), write);
                        }
                        Follow::Falling => {
                            self.write(on, when_false, write);
                            self.write(off, when_true.either(when_false), write);
                        }
                    }
                }
            }
        }
    }

    fn write(&mut self, slot: Slot, value: Value, write: u32) {
        self.give(slot, value, Step::Rung { read: value.from, write });
    }
}
