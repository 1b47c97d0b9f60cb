//! Execution: one machine that goes through bodies either by steps (lowered, the usual way) or by codes (in the order
//! of the text: prescan, observed scans, and what is left of a rung after a fault).

mod bit;
mod block;
mod call;
mod cells;
mod compare;
mod copy;
mod counter;
mod execute;
mod fault;
mod file;
mod flow;
mod formula;
mod math;
mod move_;
mod path;
mod prescan;
mod safety;
mod system;
mod timer;
mod transfer;
mod upset;

use twinrung_bytecode::channel::{FaultRecord, Place, ScanEnd, ScanInputs};
use twinrung_bytecode::index::{ProgramIndex, RoutineIndex};
use twinrung_bytecode::limits;
use twinrung_bytecode::observer::Observer;

pub(crate) use compare::relation;
pub(crate) use math::binary;
use path::Event;
pub(crate) use transfer::jsr_operands;

use crate::machine::{FRAMES, Frame, Machine, Role};
use crate::program::{NONE, Program, Range};

/// The code of a major fault, type 4.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct FaultCode(pub(crate) u16);

/// A subscript, bit number, POS or range beyond its array.
pub(crate) const SUBSCRIPT: FaultCode = FaultCode(20);
/// CONTROL LEN or POS below 0.
pub(crate) const CONTROL_NEGATIVE: FaultCode = FaultCode(21);
/// JSR parameters do not match SBR or RET.
pub(crate) const PARAMETERS: FaultCode = FaultCode(31);
/// TIMER PRE or ACC below 0.
pub(crate) const TIMER_NEGATIVE: FaultCode = FaultCode(34);
/// No such label.
pub(crate) const NO_LABEL: FaultCode = FaultCode(42);
/// Too many routines within routines.
pub(crate) const STACK: FaultCode = FaultCode(84);
/// Too many backward jumps.
pub(crate) const LOOPS: FaultCode = FaultCode(94);

/// One execution of the safety task.
pub(crate) struct Run<'a, O: Observer> {
    pub(crate) program: &'a Program,
    pub(crate) machine: &'a mut Machine,
    pub(crate) inputs: ScanInputs<'a>,
    pub(crate) observer: &'a mut O,
}

impl<O: Observer> Run<'_, O> {
    /// Program to Run (B.4).
    pub(crate) fn prescan(&mut self) -> ScanEnd {
        self.begin();
        let executed = self.machine.status.executed;
        self.machine.status = twinrung_bytecode::channel::Status { executed, ..Default::default() };
        self.machine.first_scan_armed = true;
        self.machine.records.fill(FaultRecord::default());
        // A fault in prescan runs no fault routine: it ends the prescan (REQ-EXEC-051).
        self.machine.handled = true;
        self.machine.hidden.fill(self.inputs.now_ms);
        self.machine.put_bit(self.program.first_scan, false);
        for index in &self.program.schedule {
            let Some(entry) = self.enter_program(*index) else { continue };
            self.machine.visited.fill(false);
            for (body, role) in [(entry.main, Role::Main), (entry.fault, Role::FaultPrescan)] {
                if body == NONE || self.visited(body) {
                    continue;
                }
                if let Err(end) = self.start(body, role, true).and_then(|()| self.go()) {
                    return self.end(end);
                }
            }
        }
        self.end(ScanEnd::Completed)
    }

    /// One normal execution (B.2 step 5).
    pub(crate) fn scan(&mut self) -> ScanEnd {
        self.begin();
        let first_scan = core::mem::take(&mut self.machine.first_scan_armed);
        let status = &mut self.machine.status;
        status.first_scan = first_scan;
        status.overflow = false;
        status.zero = false;
        status.negative = false;
        status.carry = false;
        self.machine.put_bit(self.program.first_scan, first_scan);
        for index in &self.program.schedule {
            let Some(entry) = self.enter_program(*index) else { continue };
            if entry.main == NONE {
                continue;
            }
            if let Err(end) = self.start(entry.main, Role::Main, false).and_then(|()| self.go()) {
                return self.end(end);
            }
        }
        self.end(ScanEnd::Completed)
    }

    fn begin(&mut self) {
        let machine = &mut *self.machine;
        machine.frames.clear();
        machine.branches.clear();
        machine.events.fill(0);
        machine.handling = None;
        machine.handled = false;
        machine.spent = 0;
        machine.path = 0;
        if machine.doubtful {
            machine.doubtful = self.program.watched_timers.iter().any(|timer| {
                let (preset, accumulated) = (machine.word(*timer), machine.word(timer.saturating_add(1)));
                preset < 0 || accumulated < 0
            });
        }
    }

    fn end(&mut self, end: ScanEnd) -> ScanEnd {
        let status = &mut self.machine.status;
        status.executed = status.executed.saturating_add(self.machine.spent);
        if end == ScanEnd::Completed && self.over_budget() { ScanEnd::BudgetExceeded } else { end }
    }

    /// Whether this scan has executed more than its budget.
    pub(crate) fn over_budget(&self) -> bool {
        self.machine.spent > self.inputs.budget
    }

    /// Whether it has executed more than its budget and what an admitted program can execute without a backward jump:
    /// the program is no longer what was loaded.
    pub(crate) fn runs_away(&self) -> bool {
        self.machine.spent > self.inputs.budget.saturating_add(limits::STRAIGHT_INSTRUCTIONS)
    }

    fn enter_program(&mut self, index: u16) -> Option<crate::program::ProgramEntry> {
        let entry = *self.program.programs.get(usize::from(index))?;
        if entry.disabled {
            return None;
        }
        self.machine.program = index;
        self.machine.put_bit(self.program.rail, true);
        Some(entry)
    }

    /// Marks a body as prescanned; whether it was already.
    pub(crate) fn visited(&mut self, body: u32) -> bool {
        match self.machine.visited.get_mut(body as usize) {
            Some(visited) => core::mem::replace(visited, true),
            None => true,
        }
    }

    fn start(&mut self, body: u32, role: Role, prescan: bool) -> Result<(), ScanEnd> {
        match self.push(body, role, prescan) {
            Ok(()) => Ok(()),
            Err(code) => self.fault(code, 0, 0),
        }
    }

    /// Begins a body.
    pub(crate) fn push(&mut self, body: u32, role: Role, prescan: bool) -> Result<(), FaultCode> {
        let machine = &mut *self.machine;
        if machine.frames.len() >= FRAMES {
            return Err(STACK);
        }
        let entry = self.program.bodies.get(body as usize);
        let stepped = entry.is_some_and(|body| body.stepped);
        // A fault routine and what it calls go by codes: they may reach a body whose rung is halted by the fault, and
        // the lasting cells of that rung must stay.
        let stepping = stepped && !prescan && !O::ACTIVE && !machine.doubtful && machine.handling.is_none();
        machine.went(Event::Begins { routine: entry.map_or(NONE, |body| body.routine) });
        let jumps = entry.map_or(Range::default(), |body| body.jumps);
        if jumps.count != 0 {
            machine.clear_jumps(jumps);
        }
        let position = entry.map_or(0, |body| if stepping { body.steps.first } else { body.codes.first });
        machine.frames.push(Frame {
            body,
            position,
            rung: 0,
            stepping,
            condition: false,
            halted: false,
            branches: machine.branches.len() as u32,
            resume: NONE,
            role,
            prescan,
        });
        Ok(())
    }

    /// Executes until no frame is left.
    fn go(&mut self) -> Result<(), ScanEnd> {
        while let Some(frame) = self.machine.frames.last().copied() {
            if frame.stepping {
                self.by_steps(frame)?;
            } else {
                self.by_codes(frame)?;
            }
        }
        Ok(())
    }

    /// Where an instruction stands.
    pub(crate) fn place(&self, frame: &Frame, element: u32) -> Place {
        let routine = self.program.bodies.get(frame.body as usize).map_or(0, |body| body.routine);
        Place { program: ProgramIndex(self.machine.program), routine: RoutineIndex(routine), rung: frame.rung, element }
    }

    /// Counts one reached instruction.
    pub(crate) fn retire(&mut self, count: u64) {
        self.machine.spent = self.machine.spent.saturating_add(count);
        if O::ACTIVE {
            self.observer.instructions_retired(count);
        }
    }
}
