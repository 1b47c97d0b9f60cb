//! What an observer of a channel sees of a program: what its instructions reach, and what is new to a fuzzer.

use std::hash::{DefaultHasher, Hash, Hasher};

use twinrung_bytecode::channel::Place;
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use crate::signal::{Signal, Value};

use super::Subject;
use super::coverage::{Bits, Class, Coverage, Universe, What};
use super::listing::{Element, Listing, Source, State};

/// Features are told apart by so many bits of a hash.
const FEATURE_BITS: u32 = 18;

/// What was executed.
#[derive(Debug, Clone, Default)]
pub struct Executions {
    listing: Listing,
    /// What the channel holds, as its writes tell.
    bits: Vec<bool>,
    words: Vec<i32>,
    /// Writes of the instruction that is being evaluated: what it read was there before them.
    written_bits: Vec<(BitCell, bool)>,
    written_words: Vec<(WordCell, i32)>,
    /// Where the instruction before was, and what it is.
    before: Option<(Place, u8)>,
    /// Rungs entered.
    pub rungs: u64,
    /// What they reached.
    pub coverage: Coverage,
    /// What guides: reached points, pairs, transitions of control, states of structures and outputs.
    pub features: Bits,
}

/// What a feature is about; two of different kinds differ.
#[derive(Hash)]
enum Feature<'f> {
    Point(u32),
    /// An instruction after another, with their rung conditions.
    Pair(u8, u8, bool, bool),
    /// The classes of all that an instruction read.
    Read(u8, &'f [Class]),
    /// A rung after another: the instruction that led there, and which way.
    Control(u8, i8),
    /// The state of a structure after an instruction.
    State(u8, u64),
    /// A state after another.
    Change(u8, u64, u64),
}

impl Executions {
    /// Nothing executed yet.
    pub fn new(subject: &Subject) -> Executions {
        let image = subject.image.image();
        Executions {
            listing: Listing::of(&subject.image),
            bits: image.initial_bits.iter().map(|bit| *bit != 0).collect(),
            words: image.initial_words.clone(),
            ..Executions::default()
        }
    }

    /// Adds what another run executed.
    pub fn add(&mut self, other: &Executions) {
        self.rungs += other.rungs;
        self.coverage.add(&other.coverage);
        self.features.add(&other.features);
    }

    /// A value that somebody else than logic has set.
    pub fn set(&mut self, values: &[(Signal, Value)]) {
        for (signal, value) in values {
            let held = crate::cells::held(*value);
            match signal {
                Signal::Bit(cell) => put(&mut self.bits, cell.position(), held != 0),
                Signal::Word(cell, _) => put(&mut self.words, cell.position(), held),
                _ => {}
            }
        }
    }

    fn feature(&mut self, feature: &Feature<'_>) {
        let mut hasher = DefaultHasher::new();
        feature.hash(&mut hasher);
        self.features.insert((hasher.finish() >> (u64::BITS - FEATURE_BITS)) as u32);
    }

    fn point(&mut self, number: u32) {
        if self.coverage.reached(number) {
            self.feature(&Feature::Point(number));
        }
    }

    /// What the instruction read, before it wrote.
    fn read(&mut self, opcode: Opcode, element: &Element) {
        if element.reads.is_empty() {
            return;
        }
        let mut classes = [Class::Zero; 8];
        let mut count = 0;
        for read in &element.reads {
            let held = match &read.source {
                Source::Literal(value) => Some(*value),
                Source::Cell { cell, terms } => terms
                    .iter()
                    .try_fold(*cell, |sum, term| {
                        let at = u32::try_from(*self.words.get(term.cell as usize)?).ok()?;
                        (at < term.length).then(|| sum + at * term.stride)
                    })
                    .and_then(|cell| self.words.get(cell as usize).copied()),
            };
            let Some(held) = held else { continue };
            let class = Class::of(read.element, held);
            if let Some(point) = Universe::get().number(opcode, What::Value(read.position, class)) {
                self.point(point);
            }
            if let Some(place) = classes.get_mut(count) {
                *place = class;
                count += 1;
            }
        }
        self.feature(&Feature::Read(opcode as u8, &classes[..count]));
    }

    /// What the structure that the instruction keeps holds behind it.
    fn kept(&mut self, opcode: u8, state: &mut State) {
        let mut hasher = DefaultHasher::new();
        state.bits.iter().for_each(|cell| self.bits.get(*cell as usize).hash(&mut hasher));
        state.words.iter().for_each(|cell| self.words.get(*cell as usize).hash(&mut hasher));
        let now = hasher.finish();
        let last = std::mem::replace(&mut state.last, now);
        if last != now {
            self.feature(&Feature::State(opcode, now));
            self.feature(&Feature::Change(opcode, last, now));
        }
    }
}

fn put<T>(cells: &mut [T], position: usize, value: T) {
    if let Some(cell) = cells.get_mut(position) {
        *cell = value;
    }
}

impl Observer for Executions {
    fn rung_entered(&mut self, place: Place) {
        self.rungs += 1;
        if let Some((before, opcode)) = self.before.take() {
            let way = match before.routine == place.routine {
                false => 2,
                true => {
                    (i64::from(place.rung) - i64::from(before.rung)).signum() as i8
                        * if place.rung.abs_diff(before.rung) == 1 { 1 } else { 3 }
                }
            };
            self.feature(&Feature::Control(opcode, way));
        }
    }

    fn element_result(&mut self, place: Place, condition_in: bool, condition_out: bool) {
        // Taken out while it is used, so that what it says and what is held can be used together.
        let Some(mut element) = self.listing.take(place) else { return };
        let opcode = element.opcode.map_or(0, |opcode| opcode as u8);
        let same_rung = |before: &Place| {
            (before.program, before.routine, before.rung) == (place.program, place.routine, place.rung)
        };
        let after = self.before.filter(|(before, _)| same_rung(before)).map(|(_, opcode)| opcode);
        self.coverage.evaluated(opcode, after, condition_in);
        self.feature(&Feature::Pair(after.unwrap_or_default(), opcode, condition_in, condition_out));
        self.before = Some((place, opcode));
        if let Some(known) = element.opcode {
            let points = Universe::get();
            let out = if known.instruction().position == twinrung_catalog::Position::Input {
                condition_out
            } else {
                condition_in
            };
            if let Some(point) = points.number(known, What::Outcome(condition_in, out)) {
                self.point(point);
            }
            if condition_in {
                std::mem::take(&mut element.points).into_iter().for_each(|point| self.point(point));
                self.read(known, &element);
            }
        }
        for (cell, value) in self.written_bits.drain(..) {
            put(&mut self.bits, cell.position(), value);
        }
        for (cell, value) in self.written_words.drain(..) {
            put(&mut self.words, cell.position(), value);
        }
        if let Some(state) = &mut element.state {
            self.kept(opcode, state);
        }
        self.listing.put_back(place, element);
    }

    fn bit_written(&mut self, cell: BitCell, value: bool) {
        self.written_bits.push((cell, value));
    }

    fn word_written(&mut self, cell: WordCell, value: i32) {
        self.written_words.push((cell, value));
    }
}
