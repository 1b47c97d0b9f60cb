//! Major faults and the program's fault routine. general-instructions.md B.7, REQ-EXEC-050 to 054.

use twinrung_bytecode::channel::{MajorFault, ScanEnd};
use twinrung_bytecode::observer::Observer;

use super::path::Event;
use super::{FaultCode, Run};
use crate::machine::{BRANCHES, Role};
use crate::program::NONE;

/// The type of every fault that an instruction raises.
const PROGRAM_FAULT: i32 = 4;

impl<O: Observer> Run<'_, O> {
    /// A fault of the element at this code of the frame on top.
    pub(super) fn fault_at(&mut self, code: FaultCode, position: u32) -> Result<(), ScanEnd> {
        let rung = self.machine.frames.last().map_or(0, |frame| frame.rung);
        let element = self.element_of(position);
        self.fault(code, rung, element)
    }

    /// A fault of the element that called a body which has just ended.
    pub(super) fn fault_caller(&mut self, code: FaultCode) -> Result<(), ScanEnd> {
        let Some(frame) = self.machine.frames.last().copied() else { return self.fault(code, 0, 0) };
        let position = match self.single(&frame) {
            Some(single) if frame.stepping => single.code,
            _ => frame.position.saturating_sub(1),
        };
        self.fault_at(code, position)
    }

    /// Records a fault of the frame on top and runs the fault routine, or ends the scan.
    pub(super) fn fault(&mut self, code: FaultCode, rung: u32, element: u32) -> Result<(), ScanEnd> {
        self.machine.went(Event::Faults { code: code.0 });
        let place = match self.machine.frames.last().copied() {
            Some(frame) => twinrung_bytecode::channel::Place { rung, ..self.place(&frame, element) },
            None => twinrung_bytecode::channel::Place {
                program: twinrung_bytecode::index::ProgramIndex(self.machine.program),
                routine: twinrung_bytecode::index::RoutineIndex(0),
                rung,
                element,
            },
        };
        let fault = MajorFault { code: code.0, place };
        let now = self.inputs.now_ms;
        let record = [
            now as i32,
            (now >> 32) as i32,
            PROGRAM_FAULT | (i32::from(code.0) << 16),
            i32::from(place.program.0),
            place.routine.0 as i32,
            place.rung as i32,
            place.element as i32,
            0,
            0,
            0,
            0,
        ];
        if let Some(slot) = self.machine.records.get_mut(place.program.position()) {
            *slot = record;
        }
        let routine = self.program.programs.get(place.program.position()).map_or(NONE, |program| program.fault);
        let refused = self.machine.handled || routine == NONE || self.machine.frames.is_empty();
        if refused {
            return Err(ScanEnd::MajorFault(fault));
        }
        self.machine.handled = true;
        self.machine.handling = Some(fault);
        let rail = u8::from(self.machine.bit(self.program.rail));
        self.machine.put_bit(self.program.rail, true);
        self.push(routine, Role::FaultRoutine { rail }, false).map_err(|_| ScanEnd::MajorFault(fault))
    }

    /// The fault routine has ended: a cleared record lets the program go on.
    pub(super) fn after_fault_routine(&mut self, rail: u8) -> Result<(), ScanEnd> {
        self.machine.put_bit(self.program.rail, rail != 0);
        let record = self.machine.records.get(usize::from(self.machine.program));
        let cleared = record.is_none_or(|[_, _, kind, ..]| *kind == 0);
        if let (false, Some(fault)) = (cleared, self.machine.handling) {
            return Err(ScanEnd::MajorFault(fault));
        }
        self.machine.handling = None;
        self.machine.status.cleared_faults = self.machine.status.cleared_faults.saturating_add(1);
        self.falsify();
        Ok(())
    }

    /// What is left of the rung goes on false, every open branch included (REQ-EXEC-051). It goes by codes.
    fn falsify(&mut self) {
        let Some(frame) = self.machine.frames.last().copied() else { return };
        if frame.stepping {
            let Some(single) = self.single(&frame) else { return };
            let room = BRANCHES.saturating_sub(self.machine.branches.len());
            for _ in 0..(single.depth as usize).min(room) {
                self.machine.branches.push((false, false));
            }
            if let Some(top) = self.machine.frames.last_mut() {
                top.stepping = false;
                top.position = single.code.saturating_add(1);
                top.rung = single.rung;
                top.resume = single.resume;
                top.condition = false;
                top.halted = true;
            }
            return;
        }
        for branch in self.machine.branches.iter_mut().skip(frame.branches as usize) {
            *branch = (false, false);
        }
        if let Some(top) = self.machine.frames.last_mut() {
            top.condition = false;
            top.halted = true;
        }
    }
}
