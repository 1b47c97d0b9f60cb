//! JMP, JSR, RET, TND, and the end of a body. general-instructions.md A.8; REQ-EXEC-014 to 016, 022, 023.

use twinrung_bytecode::channel::ScanEnd;
use twinrung_bytecode::limits;
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use super::fault::{Fault, LABEL, NESTING, STACK};
use super::frame::{Link, Mode};
use super::path::Event;
use super::value::Value;
use super::{Flow, Walker};
use crate::ladder::{Argument, BodyIndex, Location, NONE, Step};
use crate::state::Bound;

/// Bodies within one safety application instruction: none of the library has nearly as many.
const LIBRARY_BODIES: u64 = 64;

/// User faults: JSR to the fault routine with one of these raises it (REQ-EXEC-053).
const USER_FAULTS: core::ops::RangeInclusive<i32> = 990..=999;

impl<O: Observer> Walker<'_, O> {
    /// Begins a body; the one at work waits.
    pub(super) fn begin(&mut self, body: BodyIndex, mode: Mode, link: Link, bound: usize) -> Result<(), Fault> {
        if !self.may_begin() || !self.state.frames.push(self.frame) {
            self.state.bound.truncate(bound);
            return Err(STACK);
        }
        self.enter(body, mode, link, bound as u32);
        Ok(())
    }

    /// An admitted image never begins too many bodies: each costs an instruction, the budget is compared at backward jumps,
    /// and what lies between two is limited. A damaged one must end too.
    fn may_begin(&mut self) -> bool {
        let (begun, most) = match self.state.in_library {
            true => (&mut self.begun_in_library, LIBRARY_BODIES),
            false => (&mut self.begun, self.inputs.budget.saturating_add(limits::STRAIGHT_INSTRUCTIONS)),
        };
        *begun = begun.saturating_add(1);
        *begun <= most
    }

    /// Finds the places of arguments and keeps them for the call; on a fault none is kept.
    pub(super) fn bind_all(&mut self, arguments: impl Iterator<Item = Argument>) -> Result<usize, Fault> {
        let first = self.state.bound.len();
        for argument in arguments {
            let bound = if self.state.bound.is_full() { Err(STACK) } else { self.bind(argument) };
            let kept = bound.and_then(|bound| if self.state.bound.push(bound) { Ok(()) } else { Err(STACK) });
            kept.inspect_err(|_| self.state.bound.truncate(first))?;
        }
        Ok(first)
    }

    /// A kept place.
    pub(super) fn bound(&self, index: usize) -> Bound {
        let nothing = Bound { argument: Argument::Nothing, location: Location::Bit(u32::MAX) };
        self.state.bound.get(index).unwrap_or(nothing)
    }

    /// The value of a kept number.
    pub(super) fn bound_value(&self, bound: Bound) -> Value {
        match bound.argument {
            Argument::Integer(value) => Value::dint(value),
            Argument::Real(bits) => Value { element: twinrung_catalog::Element::Real, bits: bits as i32 },
            _ => self.value_at(bound.location),
        }
    }

    /// The value of a kept bit.
    pub(super) fn bound_bit(&self, bound: Bound) -> bool {
        match bound.argument {
            Argument::Integer(value) => value != 0,
            Argument::Status(keyword) => self.status_bit(keyword),
            _ => self.bit_at(bound.location),
        }
    }

    /// Copies a scalar by value, converted as MOV does with S:V alone.
    pub(super) fn pass(&mut self, from: Bound, to: Bound) {
        match to.location {
            Location::Bit(_) | Location::WordBit(..) => {
                let value = self.bound_bit(from);
                self.write_bit(to.location, value);
            }
            Location::Word(..) => {
                let value = self.bound_value(from);
                self.store_value(to.location, value);
            }
            Location::Region { .. } => {}
        }
    }

    /// Copies parameters of JSR or RET by value: all are read before the first is written.
    fn pass_all(&mut self, from: usize, to: usize, count: usize) {
        let mut next = 0usize;
        for number in 0..count {
            let to = self.bound(to.saturating_add(number));
            next = self.read_parameter(self.bound(from.saturating_add(number)), to, next);
        }
        next = 0;
        for number in 0..count {
            next = self.write_parameter(self.bound(to.saturating_add(number)), next);
        }
    }

    /// Cells of a parameter that is passed as a whole: bits, then words.
    fn parameter_cells(&self, to: Bound) -> (u32, u32) {
        match to.argument {
            Argument::Span(span) => {
                // Loading made room for what an admitted image passes.
                let room = self.state.passed.len() as u32;
                let cells = |of_an_element: u32, count: u32| of_an_element.saturating_mul(count).min(room);
                let span = self.ladder.spans.get(span as usize);
                span.map_or((0, 0), |span| (cells(span.bits, span.count), cells(span.words, span.count)))
            }
            _ => (0, 0),
        }
    }

    fn hold(&mut self, next: &mut usize, value: Value) {
        if let Some(place) = self.state.passed.get_mut(*next) {
            *place = value;
        }
        *next = next.saturating_add(1);
    }

    fn held(&self, next: &mut usize) -> Value {
        let value = self.state.passed.get(*next).copied().unwrap_or_default();
        *next = next.saturating_add(1);
        value
    }

    fn read_parameter(&mut self, from: Bound, to: Bound, mut next: usize) -> usize {
        match (to.location, from.location) {
            (Location::Bit(_) | Location::WordBit(..), _) => {
                let value = self.bound_bit(from);
                self.hold(&mut next, Value::dint(i32::from(value)));
            }
            (Location::Word(..), _) => {
                let value = self.bound_value(from);
                self.hold(&mut next, value);
            }
            (Location::Region { .. }, Location::Region { bit, word, .. }) => {
                let (bits, words) = self.parameter_cells(to);
                for number in 0..bits {
                    let value = self.state.memory.bit(bit.wrapping_add(number));
                    self.hold(&mut next, Value::dint(i32::from(value)));
                }
                for number in 0..words {
                    let value = self.state.memory.word(word.wrapping_add(number));
                    self.hold(&mut next, Value::dint(value));
                }
            }
            (Location::Region { .. }, _) => {}
        }
        next
    }

    fn write_parameter(&mut self, to: Bound, mut next: usize) -> usize {
        match to.location {
            Location::Bit(_) | Location::WordBit(..) => {
                let value = self.held(&mut next);
                self.write_bit(to.location, value.bits != 0);
            }
            Location::Word(..) => {
                let value = self.held(&mut next);
                self.store_value(to.location, value);
            }
            Location::Region { bit, word, .. } => {
                let (bits, words) = self.parameter_cells(to);
                for number in 0..bits {
                    let value = self.held(&mut next);
                    self.write_bit_cell(bit.wrapping_add(number), value.bits != 0);
                }
                for number in 0..words {
                    let value = self.held(&mut next);
                    self.write_word_cell(word.wrapping_add(number), value.bits);
                }
            }
        }
        next
    }

    /// An instruction that may leave its rung or body.
    pub(super) fn control(&mut self, step: Step, opcode: Opcode) -> Flow {
        let input = self.frame.rail;
        if !input {
            let output = self.behind(input);
            self.report(step, input, output);
            self.frame.rail = output;
            return Flow::On;
        }
        let result = match opcode {
            Opcode::Jmp => return self.jump(step),
            Opcode::Jsr => self.call_subroutine(step),
            Opcode::Ret => match self.returns(step) {
                Ok(()) => {
                    self.report(step, input, input);
                    return self.leave_early();
                }
                Err(fault) => Err(fault),
            },
            _ => {
                self.report(step, input, input);
                return self.leave_early();
            }
        };
        self.after(result)
    }

    fn jump(&mut self, step: Step) -> Flow {
        let jump = self.ladder.jumps.get(step.first as usize).copied();
        let Some(jump) = jump.filter(|jump| jump.target != NONE) else { return self.after(Err(LABEL)) };
        // Whatever its counter says: a jump that leads back is compared with the budget.
        if jump.target < self.frame.next {
            let within = usize::from(self.state.in_fault_routine);
            if let Some(taken) = self.state.jumps.get_mut(jump.counter as usize).and_then(|pair| pair.get_mut(within)) {
                if *taken >= limits::BACKWARD_JUMPS {
                    return self.after(Err(NESTING));
                }
                *taken = taken.wrapping_add(1);
            }
            if self.budget_is_exceeded() {
                return Flow::Ends(ScanEnd::BudgetExceeded);
            }
            // The library does not jump, and does not count: only damage leads here.
            if self.state.in_library {
                return self.after(Err(NESTING));
            }
        }
        self.report(step, true, true);
        self.follow(Event::Jumps, jump.rung);
        self.frame.next = jump.target;
        Flow::On
    }

    fn call_subroutine(&mut self, step: Step) -> Result<(), Fault> {
        let Some(call) = self.ladder.subroutines.get(step.first as usize) else { return Ok(()) };
        let first = self.bind_all(call.inputs.iter().chain(&call.returns).copied())?;
        if call.fault_routine && call.inputs.len() == 1 {
            let number = self.bound_value(self.bound(first));
            if !number.is_real() && USER_FAULTS.contains(&number.bits) {
                self.state.bound.truncate(first);
                return Err(Fault(number.bits as u16));
            }
        }
        // A user fault calls nothing: only behind it the operands of the SBR matter. Admission: they fit those of the JSR.
        let receivers = self.bind_all(call.receivers.iter().copied());
        let receivers = receivers.inspect_err(|_| self.state.bound.truncate(first))?;
        self.pass_all(first, receivers, call.receivers.len());
        self.begin(call.body, Mode::Normal, Link::Subroutine(step.first), first)
    }

    /// Hands the operands of a RET to the JSR that runs this body.
    fn returns(&mut self, step: Step) -> Result<(), Fault> {
        let ladder = self.ladder;
        let arguments = ladder.arguments(step);
        let first = self.bind_all(arguments.iter().copied())?;
        // In a routine that no JSR runs there is nobody to hand anything to.
        let Link::Subroutine(call) = self.frame.link else {
            self.state.bound.truncate(first);
            return Ok(());
        };
        let Some(call) = ladder.subroutines.get(call as usize) else { return Ok(()) };
        // Admission: the operands of the RET fit those of the JSR.
        let destinations = (self.frame.bound as usize).saturating_add(call.inputs.len());
        self.pass_all(first, destinations, call.returns.len());
        Ok(())
    }

    /// RET or TND ends the body at work.
    fn leave_early(&mut self) -> Flow {
        self.follow(Event::Returns, self.frame.rung);
        self.leave()
    }

    /// Ends the body at work; what called it goes on.
    pub(super) fn leave(&mut self) -> Flow {
        match self.frame.link {
            Link::Program => return Flow::Over,
            Link::Subroutine(_) => {
                self.pop_frame();
                let rail = self.frame.rail;
                self.finish_call(rail);
            }
            Link::AddOn(call) => return self.leave_add_on(call),
            Link::AddOnPrescan(call) => return self.leave_prescanned_logic(call),
            Link::Safety(call, flags) => self.leave_safety(call, flags),
            Link::SafetyPrescan(call, flags) => return self.leave_safety_prescan(call, flags),
            Link::SafetyPrescanned(call, flags) => return self.leave_safety_prescanned(call, flags),
            Link::Fault(override_was_on) => {
                return self.leave_fault_routine(override_was_on).map_or(Flow::On, Flow::Ends);
            }
        }
        Flow::On
    }

    /// The element that called goes on with a condition.
    pub(super) fn finish_call(&mut self, output: bool) {
        if self.repeats() {
            self.frame.next = self.frame.next.wrapping_sub(1);
            self.frame.repeating = true;
            return;
        }
        let step = self.ladder.step(self.frame.next.wrapping_sub(1));
        let input = self.frame.rail;
        let output = self.behind(output);
        self.report(step, input, output);
        self.frame.rail = output;
    }
}
