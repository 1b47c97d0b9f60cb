//! Major faults and the fault routine. general-instructions.md 2.5, B.7; REQ-EXEC-050 to 054.

use twinrung_bytecode::channel::{MajorFault, Place, ScanEnd};
use twinrung_bytecode::observer::Observer;

use super::Walker;
use super::frame::{Link, Mode};
use super::path::Event;
use crate::state::RECORD_WORDS;

/// A major fault's code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Fault(pub(crate) u16);

/// Subscript or bit number out of range.
pub(crate) const SUBSCRIPT: Fault = Fault(20);
/// CONTROL with LEN or POS below 0.
pub(crate) const CONTROL: Fault = Fault(21);
/// Timer with PRE or ACC below 0.
pub(crate) const TIMER: Fault = Fault(34);
/// JMP to a label that does not exist.
pub(crate) const LABEL: Fault = Fault(42);
/// Too many subroutines within subroutines.
pub(crate) const STACK: Fault = Fault(84);
/// Too many backward jumps.
pub(crate) const NESTING: Fault = Fault(94);

/// The type of a major fault that an instruction raises.
const TYPE: i32 = 4;

impl<O: Observer> Walker<'_, O> {
    /// A fault of the element at work: the fault routine begins, or the scan ends.
    pub(crate) fn raise(&mut self, fault: Fault) -> Option<ScanEnd> {
        if self.state.in_library {
            // A safety application instruction raises no fault of its own (REQ-EXEC-062): its ladder goes on false.
            self.frame.go_on_false();
            return None;
        }
        self.follow(Event::Faults, u32::from(fault.0));
        let place = self.place();
        self.record(fault, place);
        let handler = self.ladder.programs.get(self.program.position()).and_then(|program| program.fault);
        let first = !self.state.faulted && !self.state.in_fault_routine && !self.prescanning;
        self.state.faulted = true;
        let end = Some(ScanEnd::MajorFault(MajorFault { code: fault.0, place }));
        let Some(handler) = handler.filter(|_| first) else { return end };
        self.frame.go_on_false();
        if !self.state.frames.push(self.frame) {
            return end;
        }
        let own = self.ladder.own.override_bit;
        let link = Link::Fault(self.state.memory.bit(own));
        self.state.memory.set_bit(own, false);
        self.state.in_fault_routine = true;
        let bound = self.state.bound.len() as u32;
        self.enter(handler, Mode::Normal, link, bound);
        None
    }

    /// After the fault routine: the program goes on where the record was cleared.
    pub(crate) fn leave_fault_routine(&mut self, override_was_on: bool) -> Option<ScanEnd> {
        self.state.in_fault_routine = false;
        self.pop_frame();
        self.state.memory.set_bit(self.ladder.own.override_bit, override_was_on);
        let record = self.state.records.get(self.program.position()).copied().unwrap_or_default();
        let [_, _, kind_and_code, ..] = record;
        if kind_and_code == 0 {
            self.state.cleared_faults = self.state.cleared_faults.wrapping_add(1);
            return None;
        }
        Some(ScanEnd::MajorFault(self.pending.unwrap_or_else(|| MajorFault { code: 0, place: self.place() })))
    }

    fn record(&mut self, fault: Fault, place: Place) {
        self.pending = Some(MajorFault { code: fault.0, place });
        let now = self.inputs.now_ms;
        let mut record = [0i32; RECORD_WORDS];
        let values = [
            now as i32,
            (now >> 32) as i32,
            TYPE | (i32::from(fault.0) << 16),
            i32::from(place.program.0),
            place.routine.0 as i32,
            place.rung as i32,
            place.element as i32,
        ];
        for (word, value) in record.iter_mut().zip(values) {
            *word = value;
        }
        if let Some(own) = self.state.records.get_mut(self.program.position()) {
            *own = record;
        }
    }
}
