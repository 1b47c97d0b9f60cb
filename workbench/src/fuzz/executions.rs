//! What an observer of a channel counts: rungs, and what its instructions reach.

use twinrung_bytecode::channel::Place;
use twinrung_bytecode::observer::Observer;

use super::Subject;
use super::coverage::{Coverage, Form};

/// What was executed.
#[derive(Debug, Clone, Default)]
pub struct Executions {
    /// For each routine of the image, each rung, its elements.
    elements: Vec<Vec<Vec<Element>>>,
    /// The instruction before: its routine, its rung, its opcode.
    before: Option<(u32, u32, u8)>,
    /// Rungs entered.
    pub rungs: u64,
    /// What they reached.
    pub coverage: Coverage,
}

/// An instruction of the program.
#[derive(Debug, Clone)]
struct Element {
    /// The opcode; 0 for the call of an Add-On Instruction.
    opcode: u8,
    /// Its operands' forms, until they have been counted once.
    forms: Vec<Form>,
}

impl Executions {
    /// Nothing executed yet.
    pub fn new(subject: &Subject) -> Executions {
        let project = &subject.project;
        let routine = |id| {
            let rungs = project.routine(id).rungs.iter();
            rungs.map(|rung| {
                let mut elements = Vec::new();
                rung.visit(&mut |one| {
                    elements.push(Element {
                        opcode: one.call.opcode().map_or(0, |opcode| opcode as u8),
                        forms: one.operands.iter().map(|operand| Form::of(project.operand(operand.id))).collect(),
                    });
                });
                elements
            })
        };
        let elements = subject.routines.iter().map(|id| routine(*id).collect()).collect();
        Executions { elements, ..Executions::default() }
    }

    /// Adds what another run executed.
    pub fn add(&mut self, other: &Executions) {
        self.rungs += other.rungs;
        self.coverage.add(&other.coverage);
    }
}

impl Observer for Executions {
    fn rung_entered(&mut self, _: Place) {
        self.rungs += 1;
        self.before = None;
    }

    fn element_result(&mut self, place: Place, condition_in: bool, _: bool) {
        let rungs = self.elements.get_mut(place.routine.0 as usize);
        let element = rungs.and_then(|rungs| rungs.get_mut(place.rung as usize)?.get_mut(place.element as usize));
        let Some(element) = element else { return };
        let here = (place.routine.0, place.rung);
        let after = self.before.filter(|before| (before.0, before.1) == here).map(|before| before.2);
        self.coverage.evaluated(element.opcode, after, condition_in);
        self.before = Some((here.0, here.1, element.opcode));
        if condition_in && !element.forms.is_empty() {
            for (operand, form) in std::mem::take(&mut element.forms).into_iter().enumerate() {
                self.coverage.formed(element.opcode, operand, form);
            }
        }
    }
}
