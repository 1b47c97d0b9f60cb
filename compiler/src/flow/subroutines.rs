//! Subroutines: JSR, SBR and RET.

use twinrung_bytecode::layout::elements;
use twinrung_catalog::Opcode;

use super::builder::Builder;
use super::jumps::first_instruction;
use super::network::{Join, Op};
use super::operands::Target;
use super::places::Slot;
use crate::operand::{Operand, Shape};
use crate::project::{Instruction, OperandUse, RoutineId};

/// What the RETs of a routine hand back, gathered once however many RETs and calls there are.
#[derive(Debug, Clone, Default)]
pub(super) struct Returns {
    /// For each operand of RET: what makes it 1, what makes it 0, its number.
    values: Vec<[Slot; 3]>,
    /// Why no RET hands anything back.
    skipped: Option<Slot>,
}

impl<'a> Builder<'a> {
    /// JSR: the routine runs while the rung is true; its SBR receives, its RETs return.
    pub fn subroutine_call(&mut self, instruction: &'a Instruction) {
        let [routine, count, parameters @ ..] = &*instruction.operands else { return };
        let (Operand::Routine(id), Operand::Integer { value, .. }) =
            (self.project.operand(routine.id), self.project.operand(count.id))
        else {
            return;
        };
        let Some(rail) = self.rails.get(id).copied() else { return };
        let inputs = usize::try_from(*value).unwrap_or(0).min(parameters.len());
        let (given, taken) = parameters.split_at(inputs);
        let first = self.project.routine(*id).rungs.first().and_then(|rung| first_instruction(&rung.elements));
        if let Some(sbr) = first.filter(|first| first.call.opcode() == Some(Opcode::Sbr)) {
            for (from, to) in given.iter().zip(sbr.operands.iter()) {
                self.parameter(from, to);
            }
        }
        let write = self.write(instruction.span);
        self.op(Op::Skipped { slot: rail.off, write });
        self.op(Op::Clear);
        self.op(Op::Store { slot: rail.on, write });
        let returns = self.returned(*id, taken.len());
        for (values, to) in returns.values.iter().zip(taken) {
            self.take(*values, to, returns.skipped);
        }
    }

    /// RET: its operands are handed back when it ends the routine.
    pub fn return_from(&mut self, instruction: &'a Instruction) {
        if !instruction.operands.is_empty() {
            let write = self.write(instruction.span);
            let returns = self.returned(self.at, instruction.operands.len());
            for (from, to) in instruction.operands.iter().zip(&returns.values) {
                self.hand_back(from, *to, write);
            }
            if let Some(slot) = returns.skipped {
                self.op(Op::Skipped { slot, write });
            }
        }
        self.leave(instruction.span);
    }

    /// The places for what a routine hands back.
    fn returned(&mut self, id: RoutineId, count: usize) -> Returns {
        let mut returns = self.returns.remove(&id).unwrap_or_default();
        let places = &mut self.network.places;
        returns.skipped.get_or_insert_with(|| places.joint(None));
        while returns.values.len() < count {
            returns.values.push([places.joint(None), places.joint(None), places.joint(None)]);
        }
        self.returns.insert(id, returns.clone());
        returns
    }

    fn hand_back(&mut self, from: &'a OperandUse, [on, off, word]: [Slot; 3], write: u32) {
        if let Some(region) = self.reference(from).filter(|one| one.shape() == Shape::Region)
            && let Some(base) = self.base(&region.location)
        {
            let count = elements(region.dimensions).unwrap_or(1);
            let terms = &region.location.terms;
            let slots = self.region_slots(base, region.type_reference, count, terms, false);
            let selectors = self.selectors(region, from.span);
            for (slot, to) in slots.into_iter().zip([on, off, word]) {
                let read = self.read(slot, from.span);
                self.hand(&[read], &selectors, to, write);
            }
        } else if let Some(read) =
            self.reference(from).filter(|one| one.shape() != Shape::Word).and_then(|_| self.bit_read(from))
        {
            self.hand(&[read.on], &read.selectors, on, write);
            self.hand(&[read.off], &read.selectors, off, write);
        } else {
            let reads = self.operand_values(from);
            self.hand(&reads, &[], word, write);
        }
    }

    fn hand(&mut self, reads: &[u32], selectors: &[u32], slot: Slot, write: u32) {
        self.op(Op::Clear);
        self.join_all(reads, Join::Mixed);
        self.join_all(selectors, Join::Mixed);
        self.op(Op::Store { slot, write });
    }

    /// What was handed back goes to an operand of the call.
    fn take(&mut self, values: [Slot; 3], to: &'a OperandUse, skipped: Option<Slot>) {
        let Some(reference) = self.reference(to) else { return };
        let Some(target) = self.target(reference, to.span) else { return };
        let write = self.write(to.span);
        let Target { bit, word, selectors } = target;
        let (on, off) = (bit.map(|(on, _)| on), bit.map(|(_, off)| off));
        for (value, slot) in values.into_iter().zip([on, off, word]) {
            let Some(slot) = slot else { continue };
            let read = self.read(value, to.span);
            self.op(Op::Clear);
            self.join_all(&[read], Join::Mixed);
            self.join_all(&selectors, Join::Mixed);
            if let Some(skipped) = skipped {
                let read = self.read(skipped, to.span);
                self.op(Op::Unless { read });
            }
            self.op(Op::Store { slot, write });
        }
    }

    fn parameter(&mut self, from: &'a OperandUse, to: &'a OperandUse) {
        let Some(target) = self.reference(to) else { return };
        if let Some(source) = self.reference(from).filter(|_| target.shape() == Shape::Region) {
            let count = elements(target.dimensions).unwrap_or(1);
            self.copied(source, from.span, target, to.span, count);
            return;
        }
        if target.shape() != Shape::Word
            && let Some(read) = self.bit_read(from)
            && let Some(Target { bit: Some((on, off)), selectors, .. }) = self.target(target, to.span)
        {
            let write = self.write(to.span);
            for (read_bit, slot) in [(read.on, on), (read.off, off)] {
                let chosen: Vec<u32> = read.selectors.iter().chain(&selectors).copied().collect();
                self.hand(&[read_bit], &chosen, slot, write);
            }
            return;
        }
        let reads = self.operand_values(from);
        self.op(Op::Clear);
        self.join_all(&reads, Join::Mixed);
        self.store(to);
    }
}
