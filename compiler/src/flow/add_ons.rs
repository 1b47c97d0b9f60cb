//! Calls of Add-On Instructions.

use twinrung_bytecode::image::Usage;
use twinrung_grammar::tree::Span;

use super::builder::{Binding, Builder};
use super::network::{Follow, Join, Op};
use crate::operand::Reference;
use crate::project::{AddOnId, Instruction, OperandUse};

impl<'a> Builder<'a> {
    /// An Add-On Instruction: arguments into parameters, its rungs as rungs of this instance, parameters into arguments.
    pub fn add_on_call(&mut self, id: AddOnId, instruction: &'a Instruction) {
        let project = self.project;
        let add_on = project.add_on(id);
        let Some((tag, arguments)) = instruction.operands.split_first() else { return };
        let Some(reference) = self.reference(tag) else { return };
        let Some(base) = self.base(&reference.location) else { return };
        let given: Vec<(usize, &OperandUse)> =
            (0..add_on.parameters.len()).filter(|at| add_on.parameters[*at].argument).zip(arguments).collect();
        let mut binding = Binding { instance: Some(base), in_out: vec![None; add_on.parameters.len()] };
        for (at, one) in &given {
            if add_on.parameters[*at].usage == Usage::InOut {
                binding.in_out[*at] = self.reference(one).and_then(|argument| self.base(&argument.location));
            }
        }
        let always = add_on.enable_in_false.is_some();
        let Some(rails) = self.instance(id, binding) else {
            let usages: Vec<Usage> = add_on.parameters.iter().map(|one| one.usage).collect();
            self.not_followed(&usages, &given, reference, tag.span);
            self.resume(reference, instruction.span, always);
            return;
        };
        for (at, one) in &given {
            let parameter = &add_on.parameters[*at];
            if parameter.usage == Usage::Input {
                self.pass_in(reference, &parameter.name, one, always);
            }
        }
        let write = self.write(instruction.span);
        for name in ["EnableIn", "EnableOut"] {
            if let Some((base, true)) = self.member(reference, name) {
                let (on, off) = self.network.places.bit(base.tag, base.bit);
                self.op(Op::Clear);
                self.op(Op::Bit { on, off, follow: Follow::Coil, write });
            }
        }
        self.op(Op::Skipped { slot: rails.enabled.off, write });
        self.op(Op::NotFalse { slot: rails.disabled.off, write });
        self.op(Op::Clear);
        self.op(Op::Store { slot: rails.enabled.on, write });
        self.op(Op::Nothing);
        self.op(Op::Break { slot: rails.disabled.on, write });
        for (at, one) in &given {
            let parameter = &add_on.parameters[*at];
            if parameter.usage == Usage::Output {
                self.pass_out(reference, &parameter.name, one, always);
            }
        }
        self.resume(reference, instruction.span, always);
    }

    /// The rung condition goes on from EnableOut, which the instruction's logic may write: where something runs while the
    /// rung is false, also then.
    fn resume(&mut self, instance: &'a Reference, span: Span, always: bool) {
        if let Some((base, true)) = self.member(instance, "EnableOut") {
            let (on, off) = self.network.places.bit(base.tag, base.bit);
            let (on, off) = (self.read(on, span), self.read(off, span));
            self.op(if always { Op::Resume { on, off } } else { Op::Contact { on, off, selected: false } });
        }
    }

    fn pass_in(&mut self, instance: &'a Reference, name: &str, one: &'a OperandUse, always: bool) {
        let write = self.write(one.span);
        let (list, slots) = match self.member(instance, name) {
            Some((base, true)) => {
                let (on, off) = self.network.places.bit(base.tag, base.bit);
                let (of_on, of_off) = match self.bit_read(one) {
                    Some(read) => {
                        let from = [read.on, read.off].map(|read| self.network.reads[read as usize].slot);
                        self.network.copied_by_prescan.extend([(from[0], on), (from[1], off)]);
                        read.with_selectors()
                    }
                    None => (Vec::new(), Vec::new()),
                };
                (vec![of_on, of_off], vec![on, off])
            }
            Some((base, false)) => {
                let slot = self.network.places.word(base.tag, base.word).0;
                (vec![self.operand_values(one)], vec![slot])
            }
            None => return,
        };
        for (reads, slot) in list.iter().zip(slots) {
            self.op(Op::Clear);
            self.join_all(reads, Join::Mixed);
            self.op(if always { Op::Put { slot, write } } else { Op::Store { slot, write } });
        }
    }

    fn pass_out(&mut self, instance: &'a Reference, name: &str, one: &'a OperandUse, always: bool) {
        let Some(reference) = self.reference(one) else { return };
        let Some(target) = self.target(reference, one.span) else { return };
        let write = self.write(one.span);
        let (on, off) = match self.member(instance, name) {
            Some((base, true)) => self.network.places.bit(base.tag, base.bit),
            Some((base, false)) => {
                let slot = self.network.places.word(base.tag, base.word).1;
                (slot, slot)
            }
            None => return,
        };
        if let Some((to_on, to_off)) = target.bit {
            self.network.copied_by_prescan.extend([(on, to_on), (off, to_off)]);
        }
        let from = [self.read(on, one.span), self.read(off, one.span)];
        let to = match (target.bit, target.word) {
            (Some((on, off)), _) => [Some(on), Some(off)],
            (None, word) => [word, None],
        };
        for (read, slot) in from.into_iter().zip(to) {
            let Some(slot) = slot else { continue };
            self.op(Op::Clear);
            self.op(Op::Join { read, how: Join::Series });
            self.join_all(&target.selectors, Join::Mixed);
            self.op(if always { Op::Put { slot, write } } else { Op::Store { slot, write } });
        }
    }

    /// A call beyond the number that is followed: what is unqualified in anything that goes in reaches everything that it
    /// may write, and nothing that goes in qualifies anything.
    fn not_followed(
        &mut self,
        usages: &[Usage],
        given: &[(usize, &'a OperandUse)],
        instance: &'a Reference,
        span: Span,
    ) {
        self.op(Op::Clear);
        for (at, one) in given {
            if usages[*at] != Usage::Output {
                let reads = self.operand_values(one);
                self.join_all(&reads, Join::Taint);
            }
        }
        let write = self.write(span);
        if let Some(base) = self.base(&instance.location) {
            let own = self.region_slots(base, instance.type_reference, 1, &[], false);
            for slot in own {
                let read = self.read(slot, span);
                self.op(Op::Join { read, how: Join::Taint });
            }
            for slot in self.region_slots(base, instance.type_reference, 1, &[], true) {
                self.op(Op::Any { slot, write });
            }
        }
        for (at, one) in given {
            if usages[*at] != Usage::Input
                && let Some(reference) = self.reference(one)
                && let Some(target) = self.target(reference, one.span)
            {
                for slot in target.bit.into_iter().flat_map(|(on, off)| [on, off]).chain(target.word) {
                    self.op(Op::Any { slot, write });
                }
            }
        }
    }
}
