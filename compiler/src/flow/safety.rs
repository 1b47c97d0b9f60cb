//! Safety application instructions.

use twinrung_catalog::{Instruction as Declaration, MemberRole, OperandKind, STATUS_OPERANDS, SafetyApplication};
use twinrung_grammar::tree::Span;

use super::builder::Builder;
use super::network::{Follow, Join, Op};
use super::places::Slot;
use crate::operand::Reference;
use crate::project::Instruction;

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
                    Some(read) => read.with_selectors(),
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

    /// What the instruction switches on is of the origin of the operands that decide; what it reports (a fault, a code)
    /// says nothing about a device. Any other operand can spoil what it switches on, a status also what it switches off.
    fn outputs(&mut self, reference: &'a Reference, safety: &SafetyApplication, inputs: &[Input], write: u32) {
        let decides = |input: &&Input| safety.decides.contains(&input.name);
        let status = |input: &&Input| STATUS_OPERANDS.contains(&input.name);
        let members = || safety.backing.members.iter().filter(|member| member.role == MemberRole::Output);
        let mut switched = Vec::new();
        self.op(Op::Clear);
        for input in inputs {
            let how = if decides(&input) { Join::Series } else { Join::Taint };
            self.join_all(&input.on, how);
        }
        for member in members().filter(|member| !member.reports()) {
            match self.member(reference, member.name) {
                Some((base, true)) => {
                    let (on, off) = self.network.places.bit(base.tag, base.bit);
                    self.op(Op::Store { slot: on, write });
                    switched.push(off);
                }
                Some((base, false)) => {
                    let slot = self.network.places.word(base.tag, base.word).0;
                    self.op(Op::Any { slot, write });
                }
                None => {}
            }
        }
        self.op(Op::Nothing);
        for input in inputs {
            if decides(&input) {
                self.join_all(&input.off, Join::Either);
            } else if status(&input) {
                self.join_all(&input.off, Join::Spoil);
            }
        }
        for slot in switched {
            self.op(Op::Break { slot, write });
        }
        self.op(Op::Clear);
        for input in inputs.iter().filter(status) {
            self.join_all(&input.on, Join::Taint);
            self.join_all(&input.off, Join::Taint);
        }
        for member in members().filter(|member| member.reports()) {
            match self.member(reference, member.name) {
                Some((base, true)) => {
                    let (on, off) = self.network.places.bit(base.tag, base.bit);
                    self.op(Op::Any { slot: on, write });
                    self.op(Op::Any { slot: off, write });
                }
                Some((base, false)) => {
                    let slot = self.network.places.word(base.tag, base.word).0;
                    self.op(Op::Any { slot, write });
                }
                None => {}
            }
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
    pub fn put(&mut self, reads: &[u32], slot: Slot, write: u32) {
        self.op(Op::Clear);
        self.join_all(reads, Join::Mixed);
        self.op(Op::Put { slot, write });
    }
}
