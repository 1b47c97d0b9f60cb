//! What an observer upsets: rungs and instructions that a disturbed processor skips, repeats or leaves the wrong way.
//! Of the library's ladder nothing is asked. Nothing of this is compiled for an observer that is not active.

use twinrung_bytecode::channel::Place;
use twinrung_bytecode::observer::{ElementUpset, Observer, RungUpset};

use super::Walker;
use crate::ladder::{Code, NONE, Step};

impl<O: Observer> Walker<'_, O> {
    /// Asks how the rung that begins is disturbed.
    pub(super) fn upset_rung(&mut self) {
        if self.state.in_library {
            return;
        }
        let place = Place { element: 0, ..self.place() };
        self.observer.rung_entered(place);
        match self.observer.rung_upset(place) {
            RungUpset::None => {}
            RungUpset::Skip => {
                let is_next = |step: Step| matches!(step.code, Code::Rung | Code::Region | Code::End);
                self.frame.next = self.first_step(self.frame.next, is_next);
            }
            RungUpset::Repeat => self.frame.again = self.frame.next.wrapping_sub(1),
            RungUpset::Goto(number) => {
                let begin = self.ladder.bodies.get(self.frame.body.0 as usize).map_or(NONE, |body| body.begin);
                let is_rung = |step: Step| (step.code == Code::Rung && step.first == number) || step.code == Code::End;
                self.frame.next = self.first_step(begin, is_rung);
            }
        }
    }

    /// The first step from a position on that is meant; beyond the last step every one ends a body.
    fn first_step(&self, mut position: u32, is_meant: impl Fn(Step) -> bool) -> u32 {
        while !is_meant(self.ladder.step(position)) {
            position = position.wrapping_add(1);
        }
        position
    }

    /// Behind a rung that is to be repeated: goes back to it.
    pub(super) fn goes_back(&mut self) -> bool {
        let again = core::mem::replace(&mut self.frame.again, NONE);
        if again != NONE {
            self.frame.next = again;
        }
        again != NONE
    }

    /// Counts an instruction and asks how it is disturbed; whether it is executed. One that is skipped or repeated
    /// counts once all the same.
    pub(super) fn upset_element(&mut self, step: Step) -> bool {
        if self.state.in_library || core::mem::replace(&mut self.frame.repeating, false) {
            return true;
        }
        self.count(1);
        let place = Place { element: u32::from(step.element), ..self.place() };
        self.frame.upset = self.observer.element_upset(place);
        let skips = self.frame.upset == ElementUpset::Skip;
        if skips {
            self.frame.upset = ElementUpset::None;
            self.report(step, self.frame.rail, self.frame.rail);
        }
        !skips
    }

    /// Whether the instruction at work is to be executed once more; it is asked about but once.
    pub(super) fn repeats(&mut self) -> bool {
        let repeats = O::ACTIVE && self.frame.upset == ElementUpset::Repeat;
        if repeats {
            self.frame.upset = ElementUpset::None;
        }
        repeats
    }

    /// The rung condition behind an instruction, the opposite one where that is upset.
    pub(super) fn behind(&mut self, output: bool) -> bool {
        output ^ (O::ACTIVE && core::mem::replace(&mut self.frame.upset, ElementUpset::None) == ElementUpset::Invert)
    }
}
