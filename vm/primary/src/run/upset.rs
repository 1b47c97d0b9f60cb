//! Disturbed executions: what fault injection asks for through the observer. An execution that nobody observes holds
//! nothing of this.

use twinrung_bytecode::observer::{ElementUpset, Observer, RungUpset};

use super::Run;
use super::flow::Next;
use crate::machine::Frame;
use crate::program::{Body, Code};

impl<O: Observer> Run<'_, O> {
    /// A rung of the frame begins, its mark just passed: how it is disturbed, and where the frame goes on.
    pub(super) fn upset_rung(&mut self, body: &Body, frame: &mut Frame) {
        let place = self.place(frame, 0);
        match self.observer.rung_upset(place) {
            RungUpset::None => {}
            RungUpset::Skip => self.go_to_rung(body, frame, frame.rung.saturating_add(1)),
            // An observed execution never goes on by steps, so the place to resume at is free.
            RungUpset::Repeat => frame.resume = frame.position.saturating_sub(1),
            RungUpset::Goto(rung) => self.go_to_rung(body, frame, rung),
        }
    }

    /// The frame goes on with this rung, or behind the last one.
    fn go_to_rung(&self, body: &Body, frame: &mut Frame, rung: u32) {
        let first = body.codes.first;
        frame.position = first.saturating_add(body.codes.count);
        frame.rung = 0;
        for (offset, code) in (0u32..).zip(body.codes.of(&self.program.codes)) {
            if *code == Code::Rung && frame.rung == rung {
                frame.position = first.saturating_add(offset);
                return;
            }
            frame.rung = frame.rung.saturating_add(u32::from(*code == Code::EndRung));
        }
    }

    /// How the element at this code is disturbed.
    pub(super) fn element_upset(&mut self, frame: &Frame, code: u32) -> ElementUpset {
        if !O::ACTIVE {
            return ElementUpset::None;
        }
        let place = self.place(frame, self.element_of(code));
        self.observer.element_upset(place)
    }
}

/// What comes of an element when the rung condition behind it may be turned round. A call gives none yet.
pub(super) fn upset(next: Next, upset: ElementUpset) -> Next {
    match next {
        Next::Out(out) => Next::Out(out != (upset == ElementUpset::Invert)),
        next => next,
    }
}
