//! One rung as a network on its way into panels and records.

use alloc::vec::Vec;

use twinrung_catalog::{Element, Opcode, Position};

use super::Kind;
use super::effect;
use super::function::{Function, Join};
use super::lower::{Level, Lowering, Tables, Work};
use super::record::{Compare, Extract, Insert, Move, Other, Sum, Timer};
use crate::ladder::{Argument, Code, Location, NONE, Step};

/// Bits of a 32-bit word above a type's own.
fn above(element: Element) -> u8 {
    32u8.saturating_sub(element.bits())
}

/// One rung on its way.
pub(super) struct Network<'l, 't, 'a> {
    /// What it extends.
    pub(super) lowering: &'l mut Lowering,
    /// The loader's tables.
    pub(super) tables: &'t mut Tables<'a>,
    /// What stands on the open leg, or on the rung.
    pub(super) current: Function,
    /// Elements that follow the one at work.
    pub(super) left: usize,
}

impl Network<'_, '_, '_> {
    /// Takes the next step of the rung.
    pub(super) fn step(&mut self, step: Step) {
        match step.code {
            Code::Branch => {
                self.lowering.levels.push(Level { before: self.current, legs: None });
                self.current = Function::constant(true);
            }
            Code::NextLeg => {
                if self.left > 0 {
                    let legs = self.legs();
                    if let Some(level) = self.lowering.levels.last_mut() {
                        level.legs = Some(legs);
                    }
                }
                self.current = Function::constant(true);
            }
            Code::EndBranch => {
                let legs = if self.left > 0 { self.legs() } else { self.current };
                if let Some(level) = self.lowering.levels.pop() {
                    self.current = if self.left == 0 {
                        level.before
                    } else if legs.from_rail {
                        legs
                    } else {
                        self.join(level.before, legs, Join::Series)
                    };
                }
            }
            Code::Instruction(opcode) => {
                self.left = self.left.saturating_sub(1);
                self.instruction(step, opcode);
            }
            _ => {}
        }
    }

    /// All legs so far and the open one.
    fn legs(&mut self) -> Function {
        match self.lowering.levels.last().and_then(|level| level.legs) {
            Some(legs) => self.join(legs, self.current, Join::Parallel),
            None => self.current,
        }
    }

    fn instruction(&mut self, step: Step, opcode: Opcode) {
        let arguments = self.tables.arguments_of(step);
        let (first, second) = (arguments.first().copied(), arguments.get(1).copied());
        let location = |argument| match argument {
            Some(Argument::At(location)) => Some(location),
            _ => None,
        };
        match (opcode, location(first), location(second)) {
            (Opcode::Xic, Some(bit), _) => self.contact(bit, true),
            (Opcode::Xio, Some(bit), _) => self.contact(bit, false),
            (Opcode::Ote, Some(bit), _) => self.coil(bit),
            (Opcode::Otl, Some(bit), _) => self.latch(bit, true),
            (Opcode::Otu, Some(bit), _) => self.latch(bit, false),
            (Opcode::Ons, Some(storage), _) => self.one_shot(storage),
            (Opcode::Osr, Some(storage), Some(output)) => self.one_shot_output(storage, output, true),
            (Opcode::Osf, Some(storage), Some(output)) => self.one_shot_output(storage, output, false),
            (Opcode::Afi, _, _) => {
                self.current = Function::constant(false);
                self.current.from_rail = true;
            }
            (Opcode::Nop | Opcode::Lbl | Opcode::Sbr, _, _) => {}
            (Opcode::Mcr, _, _) => self.zone(),
            (Opcode::Ton | Opcode::Tof | Opcode::Rto, Some(Location::Region { bit, word, .. }), _) => {
                let condition = self.condition();
                for number in 0..3 {
                    self.keep(bit.wrapping_add(number), None);
                }
                let kind = match opcode {
                    Opcode::Ton => Kind::OnDelay,
                    Opcode::Tof => Kind::OffDelay,
                    _ => Kind::Retentive,
                };
                self.lowering.works.push(Work::Timer(kind, Timer { condition, bit, word }));
            }
            _ => {
                if !self.compare(step, opcode) && !self.arithmetic(step, opcode) {
                    self.other(step, opcode);
                }
            }
        }
    }

    // ---- networks

    fn push(&mut self, output: u32, function: &Function) {
        self.lowering.works.push(Work::Network(*function, output));
    }

    /// Evaluates a network into a cell of its own.
    fn spill(&mut self, function: &Function) -> Function {
        let cell = self.tables.scratch();
        self.push(cell, function);
        let mut spilled = Function::contact(cell, true);
        spilled.from_rail = function.from_rail;
        spilled
    }

    fn join(&mut self, left: Function, right: Function, how: Join) -> Function {
        if let Some(joined) = left.join(&right, how) {
            return joined;
        }
        let (large, small) = if left.cells().len() >= right.cells().len() { (left, right) } else { (right, left) };
        let large = self.spill(&large);
        if let Some(joined) = large.join(&small, how) {
            return joined;
        }
        let small = self.spill(&small);
        // Two contacts always fit one panel.
        large.join(&small, how).unwrap_or(large)
    }

    /// The condition from the rail on.
    fn full(&mut self) -> Function {
        let mut function = self.current;
        let mut level = self.lowering.levels.len();
        while !function.from_rail && level > 0 {
            level = level.wrapping_sub(1);
            let before = self.lowering.levels.get(level).map_or(Function::constant(true), |level| level.before);
            function = self.join(before, function, Join::Series);
        }
        function.from_rail = true;
        self.current = function;
        function
    }

    /// The cell that holds a condition; a new one where there is none.
    fn cell(&mut self, function: &Function) -> u32 {
        match (function.as_constant(), function.as_cell()) {
            (Some(true), _) => self.tables.own.true_bit,
            (Some(false), _) => self.tables.own.false_bit,
            (None, Some(cell)) => cell,
            (None, None) => {
                let cell = self.tables.scratch();
                self.push(cell, function);
                self.replace(function, cell);
                cell
            }
        }
    }

    fn condition(&mut self) -> u32 {
        let full = self.full();
        self.cell(&full)
    }

    /// From here on the cell stands for the network wherever it waits to be used.
    fn replace(&mut self, function: &Function, cell: u32) {
        let put = |waiting: &mut Function| {
            if waiting.same(function) {
                let from_rail = waiting.from_rail;
                *waiting = Function::contact(cell, true);
                waiting.from_rail = from_rail;
            }
        };
        put(&mut self.current);
        for level in &mut self.lowering.levels {
            put(&mut level.before);
            if let Some(legs) = &mut level.legs {
                put(legs);
            }
        }
    }

    /// Before a cell is written: networks that wait and look at it are evaluated first, but for `except`.
    fn keep(&mut self, cell: u32, except: Option<&Function>) {
        if self.left == 0 {
            return;
        }
        let due = |waiting: &Function| waiting.looks_at(cell) && !except.is_some_and(|except| except.same(waiting));
        if due(&self.current) {
            let waiting = self.current;
            let spilled = self.spill(&waiting);
            if let Some(cell) = spilled.as_cell() {
                self.replace(&waiting, cell);
            }
        }
        for index in 0..self.lowering.levels.len() {
            let waiting = self.lowering.levels.get(index).map(|level| (level.before, level.legs));
            let Some((before, legs)) = waiting else { continue };
            for waiting in [Some(before), legs].into_iter().flatten() {
                if due(&waiting) {
                    let spilled = self.spill(&waiting);
                    if let Some(cell) = spilled.as_cell() {
                        self.replace(&waiting, cell);
                    }
                }
            }
        }
    }

    // ---- bits

    fn read(&mut self, bit: Location) -> u32 {
        match bit {
            Location::Bit(cell) => cell,
            Location::WordBit(word, bit, _) => {
                let output = self.tables.scratch();
                self.lowering.works.push(Work::Extract(Extract { word, output, bit }));
                output
            }
            // Admission leaves nothing else.
            Location::Word(..) | Location::Region { .. } => self.tables.own.false_bit,
        }
    }

    fn insert(&mut self, location: Location, condition: u32, when_true: bool, clears: bool) {
        if let Location::WordBit(word, bit, element) = location {
            let above = above(element);
            self.lowering.works.push(Work::Insert(Insert { condition, word, bit, above, when_true, clears }));
        }
    }

    /// Writes a network into a bit.
    fn write(&mut self, bit: Location, function: &Function) {
        match bit {
            Location::Bit(cell) => {
                self.keep(cell, None);
                self.push(cell, function);
            }
            _ => {
                let condition = self.cell(function);
                self.insert(bit, condition, true, true);
            }
        }
    }

    fn contact(&mut self, bit: Location, closed: bool) {
        let cell = self.read(bit);
        self.current = self.join(self.current, Function::contact(cell, closed), Join::Series);
    }

    fn coil(&mut self, bit: Location) {
        let full = self.full();
        match bit {
            Location::Bit(cell) => {
                self.keep(cell, Some(&full));
                self.push(cell, &full);
                if full.as_cell().is_none() && full.as_constant().is_none() {
                    self.replace(&full, cell);
                }
            }
            _ => {
                let condition = self.cell(&full);
                self.insert(bit, condition, true, true);
            }
        }
    }

    fn latch(&mut self, bit: Location, sets: bool) {
        let full = self.full();
        match bit {
            Location::Bit(cell) => {
                let own = Function::contact(cell, true);
                let latched = if sets {
                    self.join(full, own, Join::Parallel)
                } else {
                    self.join(full.inverted(), own, Join::Series)
                };
                self.keep(cell, None);
                self.push(cell, &latched);
            }
            _ => {
                let condition = self.cell(&full);
                self.insert(bit, condition, sets, false);
            }
        }
    }

    fn one_shot(&mut self, storage: Location) {
        let full = self.full();
        let stored = self.read(storage);
        let pulse = self.join(full, Function::contact(stored, false), Join::Series);
        let output = self.tables.scratch();
        self.push(output, &pulse);
        self.current = Function::contact(output, true);
        self.current.from_rail = true;
        self.write(storage, &full);
    }

    fn one_shot_output(&mut self, storage: Location, output: Location, rising: bool) {
        let mut full = self.full();
        let stored = self.read(storage);
        let pulse = if rising {
            self.join(full, Function::contact(stored, false), Join::Series)
        } else {
            self.join(full.inverted(), Function::contact(stored, true), Join::Series)
        };
        if let Location::Bit(cell) = output
            && full.looks_at(cell)
        {
            let spilled = self.spill(&full);
            if let Some(cell) = spilled.as_cell() {
                self.replace(&full, cell);
            }
            full = spilled;
        }
        // The pulse looks at the stored bit as it was: it gets a cell of its own before the storage is written.
        let pulse = self.spill(&pulse);
        self.write(storage, &full);
        self.write(output, &pulse);
    }

    fn zone(&mut self) {
        let full = self.full();
        let own = Function::contact(self.tables.own.override_bit, true);
        // Toggled while the rung is false: on without a condition, off with one.
        let off = self.join(full, own, Join::Series);
        let on = self.join(full.inverted(), own.inverted(), Join::Series);
        let toggled = self.join(off, on, Join::Parallel);
        self.keep(self.tables.own.override_bit, None);
        let output = self.tables.own.override_bit;
        self.push(output, &toggled);
    }

    // ---- words

    fn word(&mut self, argument: Option<&Argument>) -> Option<u32> {
        match argument {
            Some(Argument::Integer(value)) => Some(self.tables.constant(*value)),
            Some(Argument::At(Location::Word(_, Element::Real))) => None,
            Some(Argument::At(Location::Word(cell, _))) => Some(*cell),
            _ => None,
        }
    }

    fn compare(&mut self, step: Step, opcode: Opcode) -> bool {
        let accept = match opcode {
            Opcode::Les => 0b001,
            Opcode::Equ => 0b010,
            Opcode::Leq => 0b011,
            Opcode::Grt => 0b100,
            Opcode::Neq => 0b101,
            Opcode::Geq => 0b110,
            _ => return false,
        };
        let [left, right] = *self.tables.arguments_of(step) else { return false };
        let (Some(left), Some(right)) = (self.word(Some(&left)), self.word(Some(&right))) else { return false };
        let output = self.tables.scratch();
        self.lowering.works.push(Work::Compare(Compare { left, right, output, accept }));
        self.current = self.join(self.current, Function::contact(output, true), Join::Series);
        true
    }

    fn next_sequence(&mut self) -> u32 {
        self.lowering.sequence = self.lowering.sequence.saturating_add(1);
        self.lowering.sequence
    }

    fn arithmetic(&mut self, step: Step, opcode: Opcode) -> bool {
        let arguments: Vec<Argument> = self.tables.arguments_of(step).to_vec();
        let Some(Argument::At(Location::Word(destination, element))) = arguments.last().copied() else { return false };
        if element == Element::Real {
            return false;
        }
        let above = above(element);
        match opcode {
            Opcode::Mov | Opcode::Clr => {
                let source =
                    if opcode == Opcode::Clr { Some(self.tables.constant(0)) } else { self.word(arguments.first()) };
                let Some(source) = source else { return false };
                let condition = self.condition();
                let sequence = self.next_sequence();
                self.lowering.works.push(Work::Move(Move { sequence, condition, source, destination, above }));
            }
            Opcode::Add | Opcode::Sub => {
                let (Some(left), Some(right)) = (self.word(arguments.first()), self.word(arguments.get(1))) else {
                    return false;
                };
                let condition = self.condition();
                let sequence = self.next_sequence();
                let subtract = opcode == Opcode::Sub;
                let sum = Sum { sequence, condition, left, right, destination, above, subtract };
                self.lowering.works.push(Work::Sum(sum));
            }
            _ => return false,
        }
        true
    }

    fn other(&mut self, step: Step, opcode: Opcode) {
        let condition = self.condition();
        let first = self.lowering.effects.cells.len() as u32;
        effect::of_step(self.tables, step, opcode, &mut self.lowering.effects);
        let end = self.lowering.effects.cells.len() as u32;
        for index in first..end {
            let written = self.lowering.effects.cells.get(index as usize).and_then(|effect| effect.written_bit());
            if let Some(cell) = written {
                self.keep(cell, None);
            }
        }
        let output = if opcode.instruction().position == Position::Input { self.tables.scratch() } else { NONE };
        let sequence = self.next_sequence();
        let other = Other { sequence, condition, output, step };
        self.lowering.works.push(Work::Other(other, first, end));
        if output != NONE {
            self.current = Function::contact(output, true);
            self.current.from_rail = true;
        }
    }
}
