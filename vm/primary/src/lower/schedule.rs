//! Orders the work of a block so that equal work stands together, and gives scratch signals their cells.
//!
//! The order keeps every dependency of the text: what reads a cell stays behind what wrote it before and ahead of
//! what writes it next. Work without dependencies between it may change places, which nobody can see: it cannot
//! fault, and the status is taken from the last instruction in the order of the text.

use alloc::collections::VecDeque;
use alloc::vec;
use alloc::vec::Vec;

use super::table::{
    ArithmeticRecord, CompareRecord, Gate, GeneralRecord, KINDS, Tables, TimerRecord, WordBitRecord, WorkRun,
};
use super::work::{Resource, VIRTUAL, Work};
use crate::program::{NONE, Range};

/// Scratch cells count from here until the size of the image's part of the bank is known.
pub(crate) const SCRATCH: u32 = 1 << 30;

/// What is known of a cell while dependencies are collected.
#[derive(Clone, Copy)]
struct Known {
    resource: Resource,
    writer: u32,
    /// Head of the list of work that read it since.
    readers: u32,
}

/// Tables that outlive a block, so that a block costs time for what it holds and not for all cells.
#[derive(Default)]
pub(crate) struct Scheduler {
    bits: Vec<u32>,
    virtuals: Vec<u32>,
    words: Vec<u32>,
    known: Vec<Known>,
    /// Lists: a piece of work and the next entry.
    readers: Vec<(u32, u32)>,
    successors: Vec<(u32, u32)>,
    heads: Vec<u32>,
    waiting: Vec<u32>,
    /// The cells of one piece of work.
    touched: Vec<Resource>,
    /// Most scratch cells that any block needs.
    pub(crate) scratch: u32,
}

impl Scheduler {
    fn entry(&mut self, resource: Resource) -> usize {
        let (table, index) = match resource {
            Resource::Bit(signal) if signal >= VIRTUAL => (&mut self.virtuals, (signal & !VIRTUAL) as usize),
            Resource::Bit(cell) => (&mut self.bits, cell as usize),
            Resource::Word(cell) => (&mut self.words, cell as usize),
        };
        if index >= table.len() {
            table.resize(index.saturating_add(1), NONE);
        }
        let fresh = self.known.len();
        let Some(slot) = table.get_mut(index) else { return fresh };
        let position = *slot as usize;
        if self.known.get(position).is_some_and(|known| known.resource == resource) {
            return position;
        }
        *slot = fresh as u32;
        self.known.push(Known { resource, writer: NONE, readers: NONE });
        fresh
    }

    fn edge(&mut self, before: u32, after: u32) {
        if before == NONE || before == after {
            return;
        }
        let position = self.successors.len() as u32;
        if let Some(head) = self.heads.get_mut(before as usize) {
            self.successors.push((after, *head));
            *head = position;
        }
        if let Some(count) = self.waiting.get_mut(after as usize) {
            *count = count.saturating_add(1);
        }
    }

    fn depend(&mut self, index: u32, work: &Work) {
        let mut touched = core::mem::take(&mut self.touched);
        touched.clear();
        work.reads(|resource| touched.push(resource));
        for resource in touched.drain(..) {
            let entry = self.entry(resource);
            let position = self.readers.len() as u32;
            let Some(known) = self.known.get_mut(entry) else { continue };
            let writer = known.writer;
            self.readers.push((index, known.readers));
            known.readers = position;
            self.edge(writer, index);
        }
        work.writes(|resource| touched.push(resource));
        for resource in touched.drain(..) {
            let entry = self.entry(resource);
            let Some(known) = self.known.get_mut(entry) else { continue };
            let (writer, mut reader) = (known.writer, known.readers);
            known.writer = index;
            known.readers = NONE;
            if reader == NONE {
                self.edge(writer, index);
            }
            while let Some((before, next)) = self.readers.get(reader as usize).copied() {
                self.edge(before, index);
                // A reader that is this very work does not stand for the writer before it.
                if before == index {
                    self.edge(writer, index);
                }
                reader = next;
            }
        }
        self.touched = touched;
    }

    /// Orders a block and appends its records. Gives the range of its runs.
    pub(crate) fn schedule(&mut self, mut block: Vec<Work>, tables: &mut Tables) -> Range {
        let virtuals = remove_dead(&mut block);
        self.known.clear();
        self.readers.clear();
        self.successors.clear();
        self.heads.clear();
        self.heads.resize(block.len(), NONE);
        self.waiting.clear();
        self.waiting.resize(block.len(), 0);
        for (index, work) in block.iter().enumerate() {
            self.depend(index as u32, work);
        }
        let order = self.order(&block);
        self.assign_scratch(&mut block, &order, virtuals);
        append(tables, &block, &order)
    }

    /// Takes ready work kind by kind, each kind until none of it is ready.
    fn order(&mut self, block: &[Work]) -> Vec<u32> {
        let mut ready: Vec<VecDeque<u32>> = vec![VecDeque::new(); KINDS];
        let rank = |index: u32| block.get(index as usize).map_or(0, |work| work.kind().rank());
        for (index, waiting) in self.waiting.iter().enumerate() {
            if *waiting == 0
                && let Some(queue) = ready.get_mut(rank(index as u32))
            {
                queue.push_back(index as u32);
            }
        }
        let mut order = Vec::with_capacity(block.len());
        while let Some(kind) = ready.iter().position(|queue| !queue.is_empty()) {
            while let Some(index) = ready.get_mut(kind).and_then(VecDeque::pop_front) {
                order.push(index);
                let mut successor = self.heads.get(index as usize).copied().unwrap_or(NONE);
                while let Some((after, next)) = self.successors.get(successor as usize).copied() {
                    successor = next;
                    let Some(waiting) = self.waiting.get_mut(after as usize) else { continue };
                    *waiting = waiting.saturating_sub(1);
                    if *waiting == 0
                        && let Some(queue) = ready.get_mut(rank(after))
                    {
                        queue.push_back(after);
                    }
                }
            }
        }
        order
    }

    /// Gives each virtual signal a cell, free again after its last use.
    fn assign_scratch(&mut self, block: &mut [Work], order: &[u32], virtuals: u32) {
        let mut last_use: Vec<u32> = vec![0; virtuals as usize];
        for (position, index) in order.iter().enumerate() {
            let Some(work) = block.get(*index as usize) else { continue };
            let mut touch = |resource: Resource| {
                if let Resource::Bit(signal) = resource
                    && let Some(last) = last_use.get_mut((signal ^ VIRTUAL) as usize)
                {
                    *last = position as u32;
                }
            };
            work.reads(&mut touch);
            work.writes(&mut touch);
        }
        let mut cells: Vec<u32> = vec![NONE; virtuals as usize];
        let mut free: Vec<u32> = Vec::new();
        let mut ended: Vec<u32> = Vec::new();
        let mut count = 0u32;
        for (position, index) in order.iter().enumerate() {
            let Some(work) = block.get_mut(*index as usize) else { continue };
            ended.clear();
            let mut cell_of = |signal: u32| -> u32 {
                if signal < VIRTUAL || signal == NONE {
                    return signal;
                }
                let slot = (signal ^ VIRTUAL) as usize;
                let Some(cell) = cells.get_mut(slot) else { return signal };
                if *cell == NONE {
                    *cell = free.pop().unwrap_or_else(|| {
                        let fresh = SCRATCH.saturating_add(count);
                        count = count.saturating_add(1);
                        fresh
                    });
                }
                if last_use.get(slot).is_some_and(|last| *last == position as u32) && !ended.contains(cell) {
                    ended.push(*cell);
                }
                *cell
            };
            match work {
                Work::Gate { cone, out } => {
                    for input in cone.inputs.iter_mut().take(cone.count) {
                        *input = cell_of(*input);
                    }
                    *out = cell_of(*out);
                }
                Work::Timer { input, .. } | Work::Arithmetic { input, .. } | Work::Move { input, .. } => {
                    *input = cell_of(*input);
                }
                Work::Compare { out, .. } | Work::WordBit { out, .. } => *out = cell_of(*out),
                Work::General { input, output, .. } => {
                    *input = cell_of(*input);
                    *output = cell_of(*output);
                }
            }
            free.append(&mut ended);
        }
        self.scratch = self.scratch.max(count);
    }
}

/// Drops work whose only result nobody reads. Gives the number of virtual signals.
fn remove_dead(block: &mut Vec<Work>) -> u32 {
    let mut virtuals = 0u32;
    for work in block.iter() {
        let mut count = |resource: Resource| {
            if let Resource::Bit(signal) = resource
                && signal >= VIRTUAL
                && signal != NONE
            {
                virtuals = virtuals.max((signal ^ VIRTUAL).saturating_add(1));
            }
        };
        work.writes(&mut count);
    }
    let mut used = vec![false; virtuals as usize];
    let mut keep = vec![true; block.len()];
    for (work, keep) in block.iter().zip(&mut keep).rev() {
        let needed = match work.only_result() {
            Some(signal) => used.get((signal ^ VIRTUAL) as usize).copied().unwrap_or(true),
            None => true,
        };
        *keep = needed;
        if needed {
            work.reads(|resource| {
                if let Resource::Bit(signal) = resource
                    && let Some(used) = used.get_mut((signal ^ VIRTUAL) as usize)
                {
                    *used = true;
                }
            });
        }
    }
    let mut keep = keep.into_iter();
    block.retain(|_| keep.next().unwrap_or(true));
    virtuals
}

/// Appends the records of a block in their order.
fn append(tables: &mut Tables, block: &[Work], order: &[u32]) -> Range {
    let first_run = tables.runs.len();
    for index in order {
        let Some(work) = block.get(*index as usize) else { continue };
        let kind = work.kind();
        let first = match work {
            Work::Gate { cone, out } => {
                // Unused inputs read what the first reads: a cell that is loaded anyway.
                let [known, ..] = cone.inputs;
                let mut inputs = [if cone.count == 0 { *out } else { known }; 4];
                for (input, used) in inputs.iter_mut().zip(cone.used()) {
                    *input = used;
                }
                push(&mut tables.wide, Gate { inputs, out: *out, table: cone.table })
            }
            Work::Timer { input, word, bit, .. } => {
                push(&mut tables.timers, TimerRecord { input: *input, word: *word, bit: *bit })
            }
            Work::Compare { left, right, out, .. } => {
                push(&mut tables.compares, CompareRecord { left: *left, right: *right, out: *out })
            }
            Work::WordBit { word, bit, out } => {
                push(&mut tables.word_bits, WordBitRecord { word: *word, bit: u32::from(*bit), out: *out })
            }
            Work::Arithmetic { input, left, right, destination, order, .. } => push(
                &mut tables.arithmetic,
                ArithmeticRecord {
                    input: *input,
                    left: *left,
                    right: *right,
                    destination: *destination,
                    order: *order,
                },
            ),
            Work::Move { input, source, destination, order } => push(
                &mut tables.arithmetic,
                ArithmeticRecord {
                    input: *input,
                    left: *source,
                    right: *source,
                    destination: *destination,
                    order: *order,
                },
            ),
            Work::General { instruction, input, output, order, .. } => push(
                &mut tables.general,
                GeneralRecord { instruction: *instruction, input: *input, output: *output, order: *order },
            ),
        };
        let fresh = tables.runs.len() == first_run;
        match tables.runs.last_mut() {
            Some(run) if !fresh && run.kind == kind => run.range.count = run.range.count.saturating_add(1),
            _ => tables.runs.push(WorkRun { kind, range: Range { first, count: 1 } }),
        }
    }
    Range::since(first_run, &tables.runs)
}

fn push<T>(table: &mut Vec<T>, record: T) -> u32 {
    let position = table.len() as u32;
    table.push(record);
    position
}
