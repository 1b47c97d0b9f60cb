//! Turns rungs into the works of a region: networks into panels, the rest into records of the other kinds.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::vec::Vec;

use twinrung_catalog::Opcode;

use super::effect::{self, Effects, is_admissible};
use super::function::Function;
use super::network::Network;
use super::record::{Compare, Extract, Insert, Move, Other, Records, Sum, Timer};
use super::schedule::Scheduler;
use super::{Kind, Panels};
use crate::ladder::{Argument, Code, Expression, Location, Operation, OwnCells, Span, Step};
use crate::memory::Size;

/// The loader's tables, as far as lowering reads or extends them.
pub(crate) struct Tables<'a> {
    /// Arguments of steps.
    pub(crate) arguments: &'a [Argument],
    /// Operations of expressions.
    pub(crate) operations: &'a [Operation],
    /// Expressions.
    pub(crate) expressions: &'a [Expression],
    /// Spans.
    pub(crate) spans: &'a [Span],
    /// The channel's cells with a meaning.
    pub(crate) own: OwnCells,
    /// Initial bits; more cells are added behind.
    pub(crate) bits: &'a mut Vec<bool>,
    /// Initial words; more cells are added behind.
    pub(crate) words: &'a mut Vec<i32>,
    /// Word cells that hold constants.
    pub(crate) constants: &'a mut BTreeMap<i32, u32>,
}

impl Tables<'_> {
    /// The arguments of a step.
    pub(crate) fn arguments_of(&self, step: Step) -> &[Argument] {
        let begin = step.first as usize;
        self.arguments.get(begin..begin.saturating_add(usize::from(step.count))).unwrap_or(&[])
    }

    /// A bit cell of the channel's own.
    pub(super) fn scratch(&mut self) -> u32 {
        self.bits.push(false);
        self.bits.len().wrapping_sub(1) as u32
    }

    /// A word cell of the channel's own that always holds the value.
    pub(super) fn constant(&mut self, value: i32) -> u32 {
        let words = &mut *self.words;
        *self.constants.entry(value).or_insert_with(|| {
            words.push(value);
            words.len().wrapping_sub(1) as u32
        })
    }
}

/// What became of a rung.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// It is part of the open region.
    Accepted,
    /// It can be the first of another region.
    Conflict,
    /// It stays as steps.
    Refused,
}

/// One record before it has its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Work {
    /// A network, and the cell that receives what it conducts.
    Network(Function, u32),
    /// A comparison.
    Compare(Compare<u32>),
    /// A bit out of a word.
    Extract(Extract<u32>),
    /// A bit into a word.
    Insert(Insert<u32>),
    /// A timer.
    Timer(Kind, Timer<u32>),
    /// A move.
    Move(Move<u32>),
    /// A sum.
    Sum(Sum<u32>),
    /// Another instruction; its cells are effects of the region from the first to the second number.
    Other(Other, u32, u32),
}

/// Collects rungs into regions.
#[derive(Default)]
pub(crate) struct Lowering {
    /// The open region's records in the order of the program.
    pub(super) works: Vec<Work>,
    /// Cells of its instructions of no special kind.
    pub(super) effects: Effects,
    executed: u32,
    /// Place of its last instruction with a status.
    pub(super) sequence: u32,
    guards: Vec<u32>,
    /// PRE and ACC of the open region's timers.
    guarded: BTreeSet<u32>,
    /// Words that anything else of the open region writes.
    written: BTreeSet<u32>,
    /// Branches open on the rung at work.
    pub(super) levels: Vec<Level>,
    scheduler: Scheduler,
}

/// An open branch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Level {
    /// What stands before it on its leg.
    pub(super) before: Function,
    /// Its legs so far.
    pub(super) legs: Option<Function>,
}

impl Lowering {
    /// Takes a rung into the open region. In a zone's program rungs begin with the MCR override.
    pub(crate) fn rung(&mut self, tables: &mut Tables<'_>, rung: &[Step], zone: bool) -> Verdict {
        if !rung.iter().all(|step| is_admissible(tables, *step, zone)) {
            return Verdict::Refused;
        }
        match self.reserve(tables, rung) {
            Verdict::Accepted => {}
            other => return other,
        }
        self.levels.clear();
        let start = if zone { Function::contact(tables.own.override_bit, false) } else { Function::constant(true) };
        let left = rung.iter().filter(|step| is_element(**step)).count();
        self.executed = self.executed.saturating_add(left as u32);
        let mut network = Network { lowering: self, tables, current: start, left };
        for step in rung {
            network.step(*step);
        }
        Verdict::Accepted
    }

    /// Checks that no timer's PRE or ACC is written by something else within one region.
    fn reserve(&mut self, tables: &Tables<'_>, rung: &[Step]) -> Verdict {
        let (mut timers, mut writes) = (Vec::new(), Vec::new());
        for step in rung {
            match (step.code, tables.arguments_of(*step)) {
                (
                    Code::Instruction(Opcode::Ton | Opcode::Tof | Opcode::Rto),
                    [Argument::At(Location::Region { word, .. })],
                ) => timers.push(*word),
                _ => effect::written_words(tables, *step, &mut writes),
            }
        }
        let own = |word: &u32| timers.iter().any(|timer| *timer == *word || timer.wrapping_add(1) == *word);
        if writes.iter().any(own) {
            return Verdict::Refused;
        }
        let guarded = |word: &u32| self.guarded.contains(word);
        let written = |word: &u32| self.written.contains(word) || self.written.contains(&word.wrapping_add(1));
        if writes.iter().any(guarded) || timers.iter().any(written) {
            return Verdict::Conflict;
        }
        self.written.extend(writes);
        for word in timers {
            if self.guarded.insert(word) {
                self.guards.push(word);
            }
            self.guarded.insert(word.wrapping_add(1));
        }
        Verdict::Accepted
    }

    /// Ends the open region, whose rungs end before the step `end`; its number. `bits` cells exist by now.
    pub(crate) fn close(&mut self, end: u32, bits: usize) -> u32 {
        let region = self.scheduler.region(&self.works, &self.effects, &self.guards, bits, end, self.executed);
        self.works.clear();
        self.effects.clear();
        self.guards.clear();
        self.guarded.clear();
        self.written.clear();
        self.executed = 0;
        self.sequence = 0;
        region
    }

    /// All regions.
    pub(crate) fn finish(self, size: Size) -> Panels {
        let Scheduler { regions, runs, guards, pools, .. } = self.scheduler;
        Panels { regions, runs, guards, records: Records::new(pools, size) }
    }
}

fn is_element(step: Step) -> bool {
    !matches!(step.code, Code::Branch | Code::NextLeg | Code::EndBranch)
}
