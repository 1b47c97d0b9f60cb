//! Walks the steps of bodies: rungs that regions cannot take, prescan, and everything while an observer looks on.

pub(crate) mod address;
mod arithmetic;
mod bit;
mod call;
mod compare;
mod control;
mod copy;
mod count;
mod fault;
mod file;
pub(crate) mod frame;
mod math;
mod path;
mod prescan;
mod system;
mod upset;
pub(crate) mod value;

use twinrung_bytecode::channel::{MajorFault, Place, ScanEnd, ScanInputs};
use twinrung_bytecode::index::{BitCell, ProgramIndex, WordCell};
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use crate::ladder::{BodyIndex, Code, Ladder, Location, Step};
use crate::state::State;
use fault::Fault;
use frame::{Frame, Link, Mode, is_control};
use path::Event;
use value::low_bits;

/// One execution on its way.
pub(crate) struct Walker<'a, O> {
    /// The application.
    pub(crate) ladder: &'a Ladder,
    /// What it changes.
    pub(crate) state: &'a mut State,
    /// Who looks on.
    pub(crate) observer: &'a mut O,
    /// What the scan receives.
    pub(crate) inputs: ScanInputs<'a>,
    /// The program at work.
    program: ProgramIndex,
    /// The body at work.
    frame: Frame,
    /// The fault whose routine is at work.
    pending: Option<MajorFault>,
    /// Whether this is a prescan.
    prescanning: bool,
    /// Bodies that elements have begun.
    begun: u64,
    /// Of them, within the safety application instruction at work.
    begun_in_library: u64,
}

/// What a step does to the walk.
enum Flow {
    /// The next step follows.
    On,
    /// The scan ends.
    Ends(ScanEnd),
    /// The program has ended.
    Over,
}

impl<'a, O: Observer> Walker<'a, O> {
    /// An execution that has not begun.
    pub(crate) fn new(
        ladder: &'a Ladder,
        state: &'a mut State,
        observer: &'a mut O,
        inputs: ScanInputs<'a>,
    ) -> Walker<'a, O> {
        let frame = Frame::new(BodyIndex(0), 0, Mode::Normal, Link::Program, 0);
        Walker {
            ladder,
            state,
            observer,
            inputs,
            program: ProgramIndex(0),
            frame,
            pending: None,
            prescanning: false,
            begun: 0,
            begun_in_library: 0,
        }
    }

    /// One execution of the safety task.
    pub(crate) fn scan(&mut self) -> ScanEnd {
        self.all(Mode::Normal)
    }

    /// Prescans every scheduled program.
    pub(crate) fn prescan(&mut self) -> ScanEnd {
        self.all(Mode::Prescan)
    }

    fn all(&mut self, mode: Mode) -> ScanEnd {
        self.prescanning = mode == Mode::Prescan;
        let ladder = self.ladder;
        for index in &ladder.schedule {
            let Some(program) = ladder.programs.get(index.position()).filter(|program| !program.disabled) else {
                continue;
            };
            self.program = *index;
            self.state.memory.set_bit(ladder.own.override_bit, false);
            if self.prescanning {
                self.state.visited.fill(false);
            }
            let bodies = match mode {
                Mode::Normal => [program.main, None],
                Mode::Prescan => [program.main, program.fault],
            };
            for body in bodies.into_iter().flatten() {
                if self.prescanning && !self.visit(body) {
                    continue;
                }
                if let Some(end) = self.body(body, mode) {
                    return end;
                }
            }
        }
        if self.budget_is_exceeded() { ScanEnd::BudgetExceeded } else { ScanEnd::Completed }
    }

    /// Runs a body of the program to its end; `Some` where the scan ends with it.
    fn body(&mut self, body: BodyIndex, mode: Mode) -> Option<ScanEnd> {
        self.enter(body, mode, Link::Program, 0);
        loop {
            match self.step() {
                Flow::On => {}
                Flow::Ends(end) => return Some(end),
                Flow::Over => return None,
            }
        }
    }

    fn step(&mut self) -> Flow {
        let step = self.ladder.step(self.frame.next);
        self.frame.next = self.frame.next.wrapping_add(1);
        match step.code {
            Code::Region => {
                if !O::ACTIVE
                    && self.frame.mode == Mode::Normal
                    && let Some(end) = self.region(step.first)
                {
                    // Never back, even where the region is damaged.
                    self.frame.next = self.frame.next.max(end);
                }
            }
            Code::Rung if O::ACTIVE && self.goes_back() => {}
            Code::End if O::ACTIVE && self.goes_back() => {}
            Code::Rung => self.begin_rung(step.first),
            Code::Branch => self.frame.branch(),
            Code::NextLeg => self.frame.next_leg(),
            Code::EndBranch => self.frame.end_branch(),
            Code::End => {
                self.follow(Event::Ends, step.first);
                return self.leave();
            }
            Code::Instruction(_) | Code::AddOn | Code::Safety => return self.element(step),
        }
        Flow::On
    }

    fn element(&mut self, step: Step) -> Flow {
        if !O::ACTIVE {
            self.count(1);
        } else if !self.upset_element(step) {
            return Flow::On;
        }
        let result = match step.code {
            Code::AddOn => self.add_on(step),
            Code::Safety => self.safety(step),
            Code::Instruction(opcode) if self.frame.mode == Mode::Prescan => self.prescan_instruction(step, opcode),
            Code::Instruction(opcode) if is_control(opcode) => return self.control(step, opcode),
            Code::Instruction(opcode) => self.computes_on_its_rung(step, opcode),
            _ => Ok(()),
        };
        self.after(result)
    }

    fn computes_on_its_rung(&mut self, step: Step, opcode: Opcode) -> Result<(), Fault> {
        let input = self.frame.rail;
        let mut output = self.instruction(step, opcode, input)?;
        if self.repeats() {
            output = self.instruction(step, opcode, input)?;
        }
        let output = self.behind(output);
        self.report(step, input, output);
        self.frame.rail = output;
        Ok(())
    }

    /// The next step, or what a fault leads to.
    fn after(&mut self, result: Result<(), Fault>) -> Flow {
        match result {
            Ok(()) => Flow::On,
            Err(fault) => self.raise(fault).map_or(Flow::On, Flow::Ends),
        }
    }

    fn begin_rung(&mut self, number: u32) {
        let body = self.ladder.bodies.get(self.frame.body.0 as usize);
        let free = body.is_some_and(|body| body.add_on) || !self.state.memory.bit(self.ladder.own.override_bit);
        self.frame.begin_rung(number, free && self.frame.mode == Mode::Normal);
        if O::ACTIVE {
            self.upset_rung();
        }
    }

    /// An instruction that computes: the condition after it.
    pub(crate) fn instruction(&mut self, step: Step, opcode: Opcode, input: bool) -> Result<bool, Fault> {
        let ladder = self.ladder;
        let arguments = ladder.arguments(step);
        match opcode {
            Opcode::Xic | Opcode::Xio => self.contact(arguments, opcode == Opcode::Xic, input),
            Opcode::Ote => self.coil(arguments, input),
            Opcode::Otl | Opcode::Otu => self.latch(arguments, opcode == Opcode::Otl, input),
            Opcode::Ons => self.one_shot(arguments, input),
            Opcode::Osr => self.one_shot_rising(arguments, input),
            Opcode::Osf => self.one_shot_falling(arguments, input),
            Opcode::Ton | Opcode::Tof | Opcode::Rto => self.timer(opcode, arguments, input),
            Opcode::Ctu | Opcode::Ctd => self.counter(opcode, arguments, input),
            Opcode::Res => self.resets(arguments, input),
            Opcode::Equ | Opcode::Neq | Opcode::Grt | Opcode::Geq | Opcode::Les | Opcode::Leq => {
                self.relation(opcode, arguments, input)
            }
            Opcode::Lim => self.limit(arguments, input),
            Opcode::Meq => self.masked_equal(arguments, input),
            Opcode::Cmp => self.compare_expression(arguments, input),
            Opcode::Mov => self.moves(arguments, input),
            Opcode::Mvm => self.masked_move(arguments, input),
            Opcode::Clr => self.clear(arguments, input),
            Opcode::Cop => self.copies(arguments, input),
            Opcode::Swpb => self.swaps_bytes(arguments, input),
            Opcode::And | Opcode::Or | Opcode::Xor => self.bitwise(opcode, arguments, input),
            Opcode::Not => self.bitwise_not(arguments, input),
            Opcode::Add | Opcode::Sub | Opcode::Mul | Opcode::Div | Opcode::Mod => {
                self.binary_math(opcode, arguments, input)
            }
            Opcode::Sqr | Opcode::Neg | Opcode::Abs => self.unary_math(opcode, arguments, input),
            Opcode::Cpt => self.computes(arguments, input),
            Opcode::Fal => self.file_arithmetic(arguments, input),
            Opcode::Fsc => self.file_search(arguments, input),
            Opcode::Fll => self.fills(arguments, input),
            Opcode::Size => self.sizes(arguments, input),
            Opcode::Mcr => {
                let own = self.ladder.own.override_bit;
                let on = self.state.memory.bit(own);
                self.state.memory.set_bit(own, on ^ !input);
                Ok(input)
            }
            Opcode::Afi => Ok(false),
            Opcode::Event => self.triggers(arguments, input),
            Opcode::Gsv => self.gets_system_value(arguments, input),
            Opcode::Ssv => self.sets_system_value(arguments, input),
            // Labels and SBR do nothing when they are executed; jumps and the library are not met here.
            _ => Ok(input),
        }
    }

    // ---- what everything uses

    /// Puts a body to work from its beginning; it counts its backward jumps anew (REQ-EXEC-016).
    fn enter(&mut self, index: BodyIndex, mode: Mode, link: Link, bound: u32) {
        let body = self.ladder.bodies.get(index.0 as usize);
        self.frame = Frame::new(index, body.map_or(u32::MAX, |body| body.begin), mode, link, bound);
        let Some(body) = body else { return };
        self.follow(Event::Begins, body.routine.0);
        if body.counters == 0 {
            return;
        }
        let counters = body.counter as usize..body.counter.saturating_add(body.counters) as usize;
        let within = usize::from(self.state.in_fault_routine);
        for taken in self.state.jumps.get_mut(counters).into_iter().flatten().filter_map(|pair| pair.get_mut(within)) {
            *taken = 0;
        }
    }

    /// Marks a body as reached by this prescan; whether it was not yet.
    fn visit(&mut self, body: BodyIndex) -> bool {
        match self.state.visited.get_mut(body.0 as usize) {
            Some(visited) => !core::mem::replace(visited, true),
            None => false,
        }
    }

    fn pop_frame(&mut self) {
        self.state.bound.truncate(self.frame.bound as usize);
        if let Some(frame) = self.state.frames.pop() {
            self.frame = frame;
        }
    }

    /// Counts executed instructions; those of the library do not count.
    pub(crate) fn count(&mut self, instructions: u64) {
        if self.state.in_library {
            return;
        }
        self.state.executed = self.state.executed.wrapping_add(instructions);
        if O::ACTIVE {
            self.observer.instructions_retired(instructions);
        }
    }

    fn budget_is_exceeded(&self) -> bool {
        self.state.executed.saturating_sub(self.state.executed_before) > self.inputs.budget
    }

    /// Where the element before the next step stands.
    fn place(&self) -> Place {
        let step = self.ladder.step(self.frame.next.wrapping_sub(1));
        let routine = self.ladder.bodies.get(self.frame.body.0 as usize).map(|body| body.routine);
        Place {
            program: self.program,
            routine: routine.unwrap_or(twinrung_bytecode::index::RoutineIndex(u32::MAX)),
            rung: self.frame.rung,
            element: u32::from(step.element),
        }
    }

    /// Tells the observer an element's result.
    fn report(&mut self, step: Step, input: bool, output: bool) {
        if O::ACTIVE && !self.state.in_library {
            let place = Place { element: u32::from(step.element), ..self.place() };
            self.observer.element_result(place, input, output);
        }
    }

    /// A bit's value.
    fn bit_at(&self, location: Location) -> bool {
        match location {
            Location::Bit(cell) => self.state.memory.bit(cell),
            Location::WordBit(cell, number, _) => {
                (self.state.memory.word(cell).wrapping_shr(u32::from(number))) & 1 != 0
            }
            Location::Word(..) | Location::Region { .. } => false,
        }
    }

    /// Writes a bit cell or a bit of a word.
    fn write_bit(&mut self, location: Location, value: bool) {
        match location {
            Location::Bit(cell) => self.write_bit_cell(cell, value),
            Location::WordBit(cell, number, element) => {
                let mask = 1i32.wrapping_shl(u32::from(number));
                let old = self.state.memory.word(cell);
                let new = if value { old | mask } else { old & !mask };
                self.write_word_cell(cell, low_bits(new, element));
            }
            Location::Word(..) | Location::Region { .. } => {}
        }
    }

    fn write_bit_cell(&mut self, cell: u32, mut value: bool) {
        if O::ACTIVE && (cell as usize) < self.state.memory.image_bits {
            value = self.observer.bit_arrives(BitCell(cell), value);
            self.observer.bit_written(BitCell(cell), value);
        }
        self.state.memory.set_bit(cell, value);
    }

    fn write_word_cell(&mut self, cell: u32, mut value: i32) {
        if O::ACTIVE && (cell as usize) < self.state.memory.image_words {
            value = self.observer.word_arrives(WordCell(cell), value);
            self.observer.word_written(WordCell(cell), value);
        }
        self.state.memory.set_word(cell, value);
    }
}
