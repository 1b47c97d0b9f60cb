//! What an observer of the primary counts: rungs, and each instruction of the catalog with a true and a false rung.

use std::fmt;

use twinrung_bytecode::channel::Place;
use twinrung_bytecode::observer::Observer;
use twinrung_catalog::Opcode;

use crate::Subject;

/// What was executed.
#[derive(Debug, Clone, Default)]
pub struct Executions {
    /// For each routine of the image, each rung, each element: the opcode; 0 for the call of an Add-On Instruction.
    opcodes: Vec<Vec<Vec<u8>>>,
    /// Rungs entered.
    pub rungs: u64,
    /// For each opcode, evaluations with a false and with a true rung; at 0 calls of Add-On Instructions.
    seen: Vec<[u64; 2]>,
}

impl Executions {
    /// Nothing executed yet.
    pub fn new(subject: &Subject) -> Executions {
        let routine = |id| {
            let rungs = subject.project.routine(id).rungs.iter();
            rungs.map(|rung| {
                let mut opcodes = Vec::new();
                rung.visit(&mut |one| opcodes.push(one.call.opcode().map_or(0, |opcode| opcode as u8)));
                opcodes
            })
        };
        let opcodes = subject.routines.iter().map(|id| routine(*id).collect()).collect();
        Executions { opcodes, rungs: 0, seen: vec![[0; 2]; 256] }
    }

    /// Adds what another run executed.
    pub fn add(&mut self, other: &Executions) {
        self.rungs += other.rungs;
        self.seen.resize(256, [0; 2]);
        for (sum, one) in self.seen.iter_mut().zip(&other.seen) {
            sum[0] += one[0];
            sum[1] += one[1];
        }
    }

    /// Evaluations of an instruction with a false and with a true rung.
    pub fn of(&self, opcode: Opcode) -> [u64; 2] {
        self.seen.get(usize::from(opcode as u8)).copied().unwrap_or_default()
    }
}

impl Observer for Executions {
    fn rung_entered(&mut self, _: Place) {
        self.rungs += 1;
    }

    fn element_result(&mut self, place: Place, condition_in: bool, _: bool) {
        let rungs = self.opcodes.get(place.routine.0 as usize);
        let opcode = rungs.and_then(|rungs| rungs.get(place.rung as usize)?.get(place.element as usize));
        if let Some(opcode) = opcode {
            self.seen[usize::from(*opcode)][usize::from(condition_in)] += 1;
        }
    }
}

impl fmt::Display for Executions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let base = Opcode::ALL.iter().filter(|opcode| !opcode.instruction().group.is_safety_library());
        for opcode in base {
            let [off, on] = self.of(*opcode);
            writeln!(f, "{:<6} {on:>12} true {off:>12} false", opcode.instruction().mnemonic)?;
        }
        let [off, on] = self.seen.first().copied().unwrap_or_default();
        writeln!(f, "Add-On {on:>12} true {off:>12} false")
    }
}
