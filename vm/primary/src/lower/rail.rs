//! The rung condition while a rung is lowered: conditions in series, relative to the begin of the innermost branch.

use alloc::vec::Vec;

use super::cone::{Cone, Join};
use super::work::{VIRTUAL, Work};

/// Conditions kept open side by side before they are packed into gates.
const OPEN: usize = 16;
/// Packed functions that a further one is tried against.
const CANDIDATES: usize = 8;
/// Checks for overwritten cells on one rung before everything pending is put into scratch.
const CHECKS: u32 = 32;

/// Conditions in series.
#[derive(Debug, Clone, Default)]
struct Series {
    cones: Vec<Cone>,
    /// Whether they are the whole condition, and not only what follows the begin of the branch.
    absolute: bool,
}

/// An open branch.
#[derive(Debug, Clone, Default)]
struct Level {
    /// The condition at its begin.
    begin: Series,
    /// The same as one literal or constant, once it had to be known.
    settled: Option<Cone>,
    /// Ended legs, relative to the begin.
    relative: Vec<Cone>,
    /// Ended legs that are whole conditions.
    absolute: Vec<Cone>,
}

/// The rung condition, and the work of the block so far.
#[derive(Default)]
pub(super) struct Rails {
    pub(super) block: Vec<Work>,
    virtuals: u32,
    rail: Series,
    levels: Vec<Level>,
    /// Which cells pending conditions may read, as a filter.
    pending: u64,
    checks: u32,
    /// Cells that are always 0 and always 1.
    zero: u32,
    one: u32,
}

fn filter(cell: u32) -> u64 {
    1u64.wrapping_shl(cell.wrapping_mul(0x9E37_79B1).wrapping_shr(26))
}

impl Rails {
    /// No work yet.
    pub(super) fn new(zero: u32, one: u32) -> Rails {
        Rails { zero, one, ..Rails::default() }
    }

    /// The virtual signals of an ended block are void.
    pub(super) fn take_block(&mut self) -> Vec<Work> {
        self.virtuals = 0;
        core::mem::take(&mut self.block)
    }

    /// A new virtual signal.
    pub(super) fn signal(&mut self) -> u32 {
        let signal = VIRTUAL | self.virtuals;
        self.virtuals = self.virtuals.saturating_add(1);
        signal
    }

    /// Begins a rung, with the cell of the MCR override where it counts.
    pub(super) fn begin_rung(&mut self, rail: Option<u32>) {
        self.levels.clear();
        self.rail = Series { cones: Vec::new(), absolute: true };
        self.pending = 0;
        self.checks = 0;
        if let Some(cell) = rail {
            self.push(Cone::literal(cell, false));
        }
    }

    /// How many branches are open.
    pub(super) fn depth(&self) -> usize {
        self.levels.len()
    }

    /// Adds a condition in series.
    pub(super) fn push(&mut self, cone: Cone) {
        for input in cone.used().filter(|input| *input < VIRTUAL) {
            self.pending |= filter(input);
        }
        self.rail.cones.push(cone);
        if self.rail.cones.len() > OPEN {
            let cones = core::mem::take(&mut self.rail.cones);
            let packed = self.pack(cones, Join::And);
            self.rail.cones.push(packed);
        }
    }

    /// The condition is this signal from here on.
    pub(super) fn set(&mut self, signal: u32) {
        self.rail = Series { cones: Vec::new(), absolute: true };
        self.push(self.literal(signal));
    }

    fn literal(&self, signal: u32) -> Cone {
        match signal {
            signal if signal == self.one => Cone::TRUE,
            signal if signal == self.zero => Cone::FALSE,
            signal => Cone::literal(signal, false),
        }
    }

    /// Stores a function as a gate.
    pub(super) fn store(&mut self, cone: Cone, out: u32) {
        self.block.push(Work::Gate { cone, out });
    }

    /// A function as a signal.
    fn signal_of(&mut self, cone: Cone) -> u32 {
        if let Some(signal) = cone.signal() {
            return signal;
        }
        match (cone.count, cone.table) {
            (_, 0) => self.zero,
            (_, 0xFFFF) => self.one,
            _ => {
                let signal = self.signal();
                self.store(cone, signal);
                signal
            }
        }
    }

    /// Joins functions into one that fits a gate; what does not fit is stored as gates of its own.
    fn pack(&mut self, mut cones: Vec<Cone>, join: Join) -> Cone {
        let (neutral, decisive) = match join {
            Join::And => (Cone::TRUE.table, Cone::FALSE),
            Join::Or => (Cone::FALSE.table, Cone::TRUE),
        };
        if cones.iter().any(|cone| cone.table == decisive.table) {
            return decisive;
        }
        cones.retain(|cone| cone.table != neutral);
        // Large ones first: they leave the smallest gaps.
        cones.sort_by_key(|cone| core::cmp::Reverse(cone.count));
        let mut bins: Vec<Cone> = Vec::new();
        for cone in cones {
            self.place(&mut bins, cone, join);
        }
        while bins.len() > 1 {
            let fullest = bins.iter().enumerate().max_by_key(|(position, cone)| (cone.count, usize::MAX ^ position));
            let Some(position) = fullest.map(|(position, _)| position) else { break };
            let cone = bins.swap_remove(position);
            let signal = self.signal_of(cone);
            let literal = self.literal(signal);
            self.place(&mut bins, literal, join);
        }
        bins.pop().unwrap_or(Cone { table: neutral, ..Cone::TRUE })
    }

    fn place(&self, bins: &mut Vec<Cone>, cone: Cone, join: Join) {
        for bin in bins.iter_mut().rev().take(CANDIDATES) {
            if let Some(joined) = bin.join(cone, join) {
                *bin = joined;
                return;
            }
        }
        bins.push(cone);
    }

    /// The begin of the branch at `index` as one literal or constant, and of those around it.
    fn settle(&mut self, index: usize) -> Cone {
        let mut outer = Cone::TRUE;
        for position in 0..=index {
            let Some(level) = self.levels.get_mut(position) else { break };
            if let Some(settled) = level.settled {
                outer = settled;
                continue;
            }
            let mut cones = core::mem::take(&mut level.begin.cones);
            if !level.begin.absolute {
                cones.push(outer);
            }
            let packed = self.pack(cones, Join::And);
            let signal = self.signal_of(packed);
            outer = self.literal(signal);
            self.settled(position, outer);
        }
        outer
    }

    fn settled(&mut self, position: usize, literal: Cone) {
        for input in literal.used().filter(|input| *input < VIRTUAL) {
            self.pending |= filter(input);
        }
        if let Some(level) = self.levels.get_mut(position) {
            level.settled = Some(literal);
            level.begin = Series { cones: alloc::vec![literal], absolute: true };
        }
    }

    /// The whole condition as one function. It is no longer pending: the caller stores it or sets it anew.
    fn take_whole(&mut self) -> Cone {
        let mut cones = core::mem::take(&mut self.rail.cones);
        if !self.rail.absolute {
            let innermost = self.levels.len().saturating_sub(1);
            let begin = self.settle(innermost);
            cones.push(begin);
        }
        self.rail.absolute = true;
        self.pack(cones, Join::And)
    }

    /// The whole condition as a signal; it goes on as that.
    pub(super) fn materialise(&mut self) -> u32 {
        let relative = !self.rail.absolute && self.rail.cones.is_empty();
        let cone = self.take_whole();
        let signal = self.signal_of(cone);
        self.set(signal);
        if relative {
            self.rail = Series::default();
        }
        signal
    }

    /// OTE: the whole condition goes to a cell, and goes on as what that cell holds.
    pub(super) fn store_condition(&mut self, cell: u32) {
        let at_begin = !self.rail.absolute && self.rail.cones.is_empty();
        let innermost = self.levels.len().wrapping_sub(1);
        let unsettled = self.levels.get(innermost).is_some_and(|level| level.settled.is_none());
        if at_begin && unsettled {
            let outer = match innermost.checked_sub(1) {
                Some(around) => self.settle(around),
                None => Cone::TRUE,
            };
            let begin = self.levels.get_mut(innermost).map(|level| core::mem::take(&mut level.begin));
            let Series { mut cones, absolute } = begin.unwrap_or_default();
            if !absolute {
                cones.push(outer);
            }
            let packed = self.pack(cones, Join::And);
            self.protect(cell);
            self.store(packed, cell);
            self.settled(innermost, Cone::literal(cell, false));
            return;
        }
        let packed = self.take_whole();
        self.protect(cell);
        self.store(packed, cell);
        if at_begin {
            // The branch began with a settled condition: what follows on this leg may go on from that.
            self.rail = Series::default();
        } else {
            self.set(cell);
        }
    }

    /// OTL and OTU: a cell is joined with the condition. `last`: nothing on the rung needs the condition afterwards.
    pub(super) fn latch(&mut self, cell: u32, unlatch: bool, last: bool) {
        let condition = if last && self.levels.is_empty() {
            self.take_whole()
        } else {
            let signal = self.materialise();
            self.protect(cell);
            self.literal(signal)
        };
        let join = |condition: Cone| {
            let old = Cone::literal(cell, false);
            if unlatch { old.join(condition.inverse(), Join::And) } else { old.join(condition, Join::Or) }
        };
        let joined = join(condition).or_else(|| {
            let signal = self.signal_of(condition);
            join(Cone::literal(signal, false))
        });
        if let Some(joined) = joined {
            self.store(joined, cell);
        }
    }

    /// ONS: a pulse while the condition rises; the storage cell follows the condition.
    pub(super) fn one_shot(&mut self, storage: u32) {
        let condition = self.take_whole();
        let fresh = Cone::literal(storage, true);
        let (condition, pulse) = match condition.join(fresh, Join::And) {
            Some(pulse) => (condition, pulse),
            None => {
                let signal = self.signal_of(condition);
                let condition = self.literal(signal);
                (condition, condition.join(fresh, Join::And).unwrap_or(Cone::FALSE))
            }
        };
        let out = self.signal();
        self.store(pulse, out);
        self.protect(storage);
        self.store(condition, storage);
        self.set(out);
    }

    /// OSR and OSF: the output cell gets the pulse. The two cells are different.
    pub(super) fn one_shot_output(&mut self, storage: u32, output: u32, rising: bool) {
        let signal = self.materialise();
        self.protect(storage);
        self.protect(output);
        // The condition is an image cell at times: after the output was written only a copy may still be read.
        let condition = if signal == output {
            let copy = self.signal();
            self.store(Cone::literal(signal, false), copy);
            Cone::literal(copy, false)
        } else {
            self.literal(signal)
        };
        let was = Cone::literal(storage, rising);
        let now = if rising { condition } else { condition.inverse() };
        let pulse = now.join(was, Join::And).unwrap_or(Cone::FALSE);
        self.store(pulse, output);
        self.store(condition, storage);
    }

    /// BRANCH.
    pub(super) fn open(&mut self) {
        let begin = core::mem::take(&mut self.rail);
        self.levels.push(Level { begin, ..Level::default() });
    }

    /// NEXT_LEG.
    pub(super) fn next_leg(&mut self) {
        let Series { cones, absolute } = core::mem::take(&mut self.rail);
        let packed = self.pack(cones, Join::And);
        let innermost = self.levels.len().saturating_sub(1);
        let Some(level) = self.levels.get_mut(innermost) else { return };
        let legs = if absolute { &mut level.absolute } else { &mut level.relative };
        legs.push(packed);
        if legs.len() > OPEN {
            let legs = core::mem::take(legs);
            let packed = self.pack(legs, Join::Or);
            if let Some(level) = self.levels.get_mut(innermost) {
                if absolute { level.absolute.push(packed) } else { level.relative.push(packed) }
            }
        }
    }

    /// END_BRANCH.
    pub(super) fn close(&mut self) {
        self.next_leg();
        let innermost = self.levels.len().saturating_sub(1);
        let mixed = self.levels.last().is_some_and(|level| !level.absolute.is_empty());
        let begin = if mixed { self.settle(innermost) } else { Cone::TRUE };
        let Some(level) = self.levels.pop() else { return };
        let relative = self.pack(level.relative, Join::Or);
        if !mixed {
            self.rail = level.begin;
            if relative.table != Cone::TRUE.table {
                self.push(relative);
            }
            return;
        }
        let relative = self.pack(alloc::vec![begin, relative], Join::And);
        let mut legs = level.absolute;
        legs.push(relative);
        let packed = self.pack(legs, Join::Or);
        self.rail = Series { cones: Vec::new(), absolute: true };
        self.push(packed);
    }

    /// A cell is about to be written: pending conditions that read it are put into scratch first.
    pub(super) fn protect(&mut self, cell: u32) {
        if self.pending & filter(cell) == 0 {
            return;
        }
        self.checks = self.checks.saturating_add(1);
        let everything = self.checks > CHECKS;
        let touches = |cone: &Cone| cone.used().any(|input| input == cell || (everything && input < VIRTUAL));
        let mut copies: Vec<(Cone, u32)> = Vec::new();
        let mut virtuals = self.virtuals;
        let mut pending = 0u64;
        let levels = self.levels.iter_mut().flat_map(|level| {
            let settled = level.settled.iter_mut();
            level.begin.cones.iter_mut().chain(settled).chain(&mut level.relative).chain(&mut level.absolute)
        });
        for cone in self.rail.cones.iter_mut().chain(levels) {
            if touches(cone) {
                let known = copies.iter().find(|(copied, _)| copied == cone).map(|(_, signal)| *signal);
                let signal = known.unwrap_or_else(|| {
                    let fresh = VIRTUAL | virtuals;
                    virtuals = virtuals.saturating_add(1);
                    copies.push((*cone, fresh));
                    fresh
                });
                *cone = Cone::literal(signal, false);
            }
            for input in cone.used().filter(|input| *input < VIRTUAL) {
                pending |= filter(input);
            }
        }
        self.virtuals = virtuals;
        self.pending = pending;
        for (cone, signal) in copies {
            self.store(cone, signal);
        }
    }

    /// Before an instruction that stands alone: the condition goes to a lasting cell, and everything that is still
    /// pending on the rung too. `lasting` makes such cells. Gives the cell of the condition.
    pub(super) fn freeze(&mut self, mut lasting: impl FnMut() -> u32) -> u32 {
        let condition = self.take_whole();
        let input = self.keep(condition, &mut lasting);
        for position in 0..self.levels.len() {
            let settled = self.settle(position);
            let begin = self.keep(settled, &mut lasting);
            let begin = self.literal(begin);
            let (relative, absolute) = match self.levels.get_mut(position) {
                Some(level) => (core::mem::take(&mut level.relative), core::mem::take(&mut level.absolute)),
                None => continue,
            };
            let mut kept: [Option<Cone>; 2] = [None; 2];
            for (legs, kept) in [relative, absolute].into_iter().zip(&mut kept) {
                if !legs.is_empty() {
                    let packed = self.pack(legs, Join::Or);
                    let cell = self.keep(packed, &mut lasting);
                    *kept = Some(self.literal(cell));
                }
            }
            self.settled(position, begin);
            let [relative, absolute] = kept;
            if let Some(level) = self.levels.get_mut(position) {
                level.relative.extend(relative);
                level.absolute.extend(absolute);
            }
        }
        input
    }

    fn keep(&mut self, cone: Cone, lasting: &mut impl FnMut() -> u32) -> u32 {
        match cone.table {
            0 => self.zero,
            0xFFFF => self.one,
            _ => {
                let cell = lasting();
                self.store(cone, cell);
                cell
            }
        }
    }
}
