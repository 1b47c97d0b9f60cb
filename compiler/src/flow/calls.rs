//! Calls: safety application instructions, Add-On Instructions, subroutines.

use twinrung_bytecode::image::Usage;
use twinrung_catalog::{Instruction as Declaration, MemberRole, Opcode, OperandKind, SafetyApplication};
use twinrung_grammar::tree::Span;

use super::builder::{Binding, Builder};
use super::network::{Follow, Join, Op};
use super::places::Slot;
use crate::operand::{Operand, Reference, Shape};
use crate::project::{AddOnId, Instruction, OperandUse, RoutineId, Rung};

/// The reads of an input of a call.
struct Input {
    name: &'static str,
    mirrored: &'static str,
    on: Vec<u32>,
    off: Vec<u32>,
    span: Span,
}

impl<'a> Builder<'a> {
    /// A safety application instruction: its outputs need all operands that decide; the others can spoil them.
    pub fn safety_call(
        &mut self,
        declaration: &'static Declaration,
        safety: &'static SafetyApplication,
        instruction: &'a Instruction,
    ) {
        let Some((backing, rest)) = instruction.operands.split_first() else { return };
        let Some(reference) = self.reference(backing) else { return };
        let mut inputs = Vec::new();
        for (at, one) in rest.iter().enumerate() {
            let Some(declared) = declaration.operand(at + 1) else { continue };
            let mirrored = safety.mirrored.get(at).copied().unwrap_or_default();
            let (on, off) = match declared.kind {
                OperandKind::SafetyBit { .. } => match self.bit_read(one) {
                    Some(read) => {
                        let with = |first: u32| std::iter::once(first).chain(read.selectors.iter().copied()).collect();
                        (with(read.on), with(read.off))
                    }
                    None => continue,
                },
                OperandKind::SafetyInteger { .. } | OperandKind::SafetyReal { .. } => {
                    let reads = self.operand_values(one);
                    (reads.clone(), reads)
                }
                _ => continue,
            };
            inputs.push(Input { name: declared.name, mirrored, on, off, span: one.span });
        }
        let write = self.write(backing.span);
        for input in &inputs {
            let decides = safety.decides.contains(&input.name);
            if safety.safety_only.contains(&input.name) {
                let also = if decides { &[][..] } else { &input.off };
                let list = input.on.iter().chain(also).map(|read| (*read, input.name));
                self.network.safety_only.extend(list);
            }
            self.mirror(reference, input);
        }
        self.outputs(reference, safety, &inputs, write);
    }

    fn outputs(&mut self, reference: &'a Reference, safety: &SafetyApplication, inputs: &[Input], write: u32) {
        let decides = |input: &&Input| safety.decides.contains(&input.name);
        self.op(Op::Clear);
        for input in inputs {
            let how = if decides(&input) { Join::Series } else { Join::Taint };
            self.join_all(&input.on, how);
        }
        let mut bits = Vec::new();
        for member in safety.backing.members.iter().filter(|member| member.role == MemberRole::Output) {
            match self.member(reference, member.name) {
                Some((base, true)) => {
                    let (on, off) = self.network.places.bit(base.tag, base.bit);
                    self.op(Op::Store { slot: on, write });
                    bits.push(off);
                }
                Some((base, false)) => {
                    let slot = self.network.places.word(base.tag, base.word).0;
                    self.op(Op::Any { slot, write });
                }
                None => {}
            }
        }
        self.op(Op::Nothing);
        for input in inputs.iter().filter(decides) {
            self.join_all(&input.off, Join::Either);
        }
        for slot in bits {
            self.op(Op::Break { slot, write });
        }
        for name in ["EnableIn", "EnableOut"] {
            if let Some((base, true)) = self.member(reference, name) {
                let (on, off) = self.network.places.bit(base.tag, base.bit);
                self.op(Op::Clear);
                self.op(Op::Bit { on, off, follow: Follow::Coil, write });
            }
        }
    }

    /// The member of the backing tag that shows an operand.
    fn mirror(&mut self, reference: &'a Reference, input: &Input) {
        if input.mirrored.is_empty() {
            return;
        }
        let write = self.write(input.span);
        match self.member(reference, input.mirrored) {
            Some((base, true)) => {
                let (on, off) = self.network.places.bit(base.tag, base.bit);
                self.put(&input.on, on, write);
                self.put(&input.off, off, write);
            }
            Some((base, false)) => {
                let slot = self.network.places.word(base.tag, base.word).0;
                self.put(&input.on, slot, write);
            }
            None => {}
        }
    }

    /// A place shows what is read, whatever the rung condition is.
    fn put(&mut self, reads: &[u32], slot: Slot, write: u32) {
        self.op(Op::Clear);
        self.join_all(reads, Join::Mixed);
        self.op(Op::Put { slot, write });
    }

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
        let Some(rails) = self.instance(id, binding) else {
            self.not_followed(add_on.parameters.iter().map(|one| one.usage).collect(), &given, reference, tag.span);
            return;
        };
        for (at, one) in &given {
            let parameter = &add_on.parameters[*at];
            if parameter.usage == Usage::Input {
                self.pass_in(reference, &parameter.name, one);
            }
        }
        let write = self.write(instruction.span);
        self.op(Op::Clear);
        self.op(Op::Store { slot: rails.enabled, write });
        self.op(Op::Nothing);
        self.op(Op::Break { slot: rails.disabled, write });
        self.op(Op::Clear);
        for name in ["EnableIn", "EnableOut"] {
            if let Some((base, true)) = self.member(reference, name) {
                let (on, off) = self.network.places.bit(base.tag, base.bit);
                self.op(Op::Bit { on, off, follow: Follow::Coil, write });
            }
        }
        for (at, one) in &given {
            let parameter = &add_on.parameters[*at];
            if parameter.usage == Usage::Output {
                self.pass_out(reference, &parameter.name, one);
            }
        }
        // Its logic may write EnableOut, which is the rung condition from here on.
        if let Some((base, true)) = self.member(reference, "EnableOut") {
            let (on, off) = self.network.places.bit(base.tag, base.bit);
            let (on, off) = (self.read(on, instruction.span), self.read(off, instruction.span));
            self.op(Op::Contact { on, off, selected: false });
        }
    }

    fn pass_in(&mut self, instance: &'a Reference, name: &str, one: &'a OperandUse) {
        let write = self.write(one.span);
        match self.member(instance, name) {
            Some((base, true)) => {
                let (on, off) = self.network.places.bit(base.tag, base.bit);
                let (of_on, of_off) = match self.bit_read(one) {
                    Some(read) => {
                        let with = |first: u32| std::iter::once(first).chain(read.selectors.iter().copied()).collect();
                        (with(read.on), with(read.off))
                    }
                    None => (Vec::new(), Vec::new()),
                };
                self.put(&of_on, on, write);
                self.put(&of_off, off, write);
            }
            Some((base, false)) => {
                let slot = self.network.places.word(base.tag, base.word).0;
                let reads = self.operand_values(one);
                self.put(&reads, slot, write);
            }
            None => {}
        }
    }

    fn pass_out(&mut self, instance: &'a Reference, name: &str, one: &'a OperandUse) {
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
        let from = [self.read(on, one.span), self.read(off, one.span)];
        let to = match (target.bit, target.word) {
            (Some((on, off)), _) => [Some(on), Some(off)],
            (None, word) => [word, None],
        };
        for (read, slot) in from.into_iter().zip(to) {
            let Some(slot) = slot else { continue };
            self.op(Op::Clear);
            self.op(Op::Join { read, how: Join::Series });
            self.join_all(&target.selectors, Join::Series);
            self.op(Op::Put { slot, write });
        }
    }

    /// A call beyond the number that is followed: everything that goes in reaches everything that it writes.
    fn not_followed(
        &mut self,
        usages: Vec<Usage>,
        given: &[(usize, &'a OperandUse)],
        instance: &'a Reference,
        span: Span,
    ) {
        self.op(Op::Clear);
        for (at, one) in given {
            if usages[*at] != Usage::Output {
                let reads = self.operand_values(one);
                self.join_all(&reads, Join::Mixed);
            }
        }
        let write = self.write(span);
        if let Some(base) = self.base(&instance.location) {
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

    /// JSR: the routine runs while the rung is true; its SBR receives, its RETs return.
    pub fn subroutine_call(&mut self, instruction: &'a Instruction) {
        let [routine, count, parameters @ ..] = &*instruction.operands else { return };
        let (Operand::Routine(id), Operand::Integer { value, .. }) =
            (self.project.operand(routine.id), self.project.operand(count.id))
        else {
            return;
        };
        let Some(rail) = self.rails.get(id).copied() else { return };
        let write = self.write(instruction.span);
        self.op(Op::Clear);
        self.op(Op::Store { slot: rail, write });
        let inputs = usize::try_from(*value).unwrap_or(0).min(parameters.len());
        let (given, taken) = parameters.split_at(inputs);
        for sbr in self.within(*id, Opcode::Sbr) {
            for (from, to) in given.iter().zip(sbr.operands.iter()) {
                self.parameter(from, to);
            }
        }
        for ret in self.within(*id, Opcode::Ret) {
            for (from, to) in ret.operands.iter().zip(taken) {
                self.parameter(from, to);
            }
        }
    }

    fn within(&self, routine: RoutineId, opcode: Opcode) -> Vec<&'a Instruction> {
        let mut found = Vec::new();
        let rungs: &'a [Rung] = &self.project.routine(routine).rungs;
        for rung in rungs {
            rung.visit(&mut |instruction| {
                if instruction.call.opcode() == Some(opcode) {
                    found.push(instruction);
                }
            });
        }
        found
    }

    fn parameter(&mut self, from: &'a OperandUse, to: &'a OperandUse) {
        let Some(target) = self.reference(to) else { return };
        if let Some(source) = self.reference(from).filter(|_| target.shape() == Shape::Region) {
            let count = twinrung_bytecode::layout::elements(target.dimensions).unwrap_or(1);
            self.copied(source, from.span, target, to.span, count);
            return;
        }
        if target.shape() != Shape::Word
            && let Some(read) = self.bit_read(from)
            && let Some(place) = self.target(target, to.span)
            && let Some((on, off)) = place.bit
        {
            let write = self.write(to.span);
            for (read, slot) in [(read.on, on), (read.off, off)] {
                self.op(Op::Clear);
                self.op(Op::Join { read, how: Join::Series });
                self.op(Op::Store { slot, write });
            }
            return;
        }
        let reads = self.operand_values(from);
        self.op(Op::Clear);
        self.join_all(&reads, Join::Mixed);
        self.store(to);
    }
}
