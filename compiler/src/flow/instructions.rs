//! What each instruction does to places.

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::{Element, Instruction as Declaration, Opcode, OperandKind, Position};
use twinrung_grammar::tree::Span;

use super::builder::Builder;
use super::network::{Follow, Join, Op};
use super::operands::Target;
use crate::operand::{Operand, Reference, Shape};
use crate::project::{Call, Instruction, OperandUse};

/// A copy of more cells is judged as a whole: every cell of the destination comes from every cell of the source.
const CELLS_COPIED_ONE_BY_ONE: u32 = 256;
/// When so many cells were copied one by one, every further copy is judged as a whole.
const CELLS_COPIED_IN_ALL: u32 = 500_000;

impl<'a> Builder<'a> {
    pub fn instruction(&mut self, instruction: &'a Instruction) {
        match instruction.call {
            Call::AddOn(add_on) => self.add_on_call(add_on, instruction),
            Call::Catalog(declaration) => match declaration.safety {
                Some(safety) => self.safety_call(declaration, safety, instruction),
                None => self.base_instruction(declaration, instruction),
            },
        }
    }

    fn base_instruction(&mut self, declaration: &'static Declaration, instruction: &'a Instruction) {
        let operands = &instruction.operands;
        let first = operands.first();
        match declaration.opcode {
            Opcode::Xic => self.contact(first, false),
            Opcode::Xio => self.contact(first, true),
            Opcode::Afi => self.op(Op::Never),
            Opcode::Ons => {
                self.set_by_prescan(first);
                self.coil(first, Follow::Coil);
                self.edge(first);
            }
            Opcode::Ote => self.coil(first, Follow::Coil),
            Opcode::Otl => self.coil(first, Follow::Latch),
            Opcode::Otu => self.coil(first, Follow::Unlatch),
            Opcode::Osr => {
                self.set_by_prescan(first);
                self.coil(first, Follow::Coil);
                // The output follows the edge, the rung goes on as it was.
                self.op(Op::Open);
                self.edge(first);
                self.coil(operands.get(1), Follow::Coil);
                self.op(Op::Leg);
                self.op(Op::Close);
            }
            Opcode::Osf => {
                self.coil(first, Follow::Coil);
                self.falling(first, operands.get(1));
            }
            Opcode::Ton | Opcode::Tof | Opcode::Rto => self.timer(declaration.opcode, first),
            Opcode::Ctu | Opcode::Ctd => self.counter(declaration.opcode, first),
            Opcode::Res => self.reset(first),
            Opcode::Fal | Opcode::Fsc => self.file(instruction),
            Opcode::Cop => self.copy(instruction),
            Opcode::Fll => self.fill(instruction),
            Opcode::Gsv => self.system_value(instruction),
            Opcode::Jmp | Opcode::Tnd => self.leave(instruction.span),
            Opcode::Ret => self.return_from(instruction),
            Opcode::Jsr => self.subroutine_call(instruction),
            Opcode::Mcr => self.zone(instruction.span),
            Opcode::Ssv | Opcode::Sbr | Opcode::Lbl | Opcode::Nop | Opcode::Event => {}
            _ if declaration.position == Position::Input => {
                self.op(Op::Clear);
                for one in operands {
                    let reads = self.operand_values(one);
                    self.join_all(&reads, Join::Mixed);
                }
                self.op(Op::Test);
            }
            _ => self.computation(declaration, instruction),
        }
    }

    fn contact(&mut self, operand: Option<&'a OperandUse>, inverted: bool) {
        let Some(read) = operand.and_then(|one| self.bit_read(one)) else {
            self.op(Op::Clear);
            self.op(Op::Test);
            return;
        };
        let selected = !read.selectors.is_empty();
        if selected {
            self.op(Op::Clear);
            self.join_all(&read.selectors, Join::Mixed);
        }
        let (on, off) = if inverted { (read.off, read.on) } else { (read.on, read.off) };
        self.op(Op::Contact { on, off, selected });
    }

    fn coil(&mut self, operand: Option<&'a OperandUse>, follow: Follow) {
        let Some((one, reference)) = operand.and_then(|one| self.reference(one).map(|reference| (one, reference)))
        else {
            return;
        };
        let Some(target) = self.target(reference, one.span) else { return };
        let write = self.write(one.span);
        self.op(Op::Clear);
        self.join_all(&target.selectors, Join::Series);
        match (target.bit, target.word) {
            (Some((on, off)), _) => self.op(Op::Bit { on, off, follow, write }),
            (None, Some(slot)) => self.op(Op::Any { slot, write }),
            (None, None) => {}
        }
    }

    /// What a one-shot makes of the condition.
    fn edge(&mut self, storage: Option<&'a OperandUse>) {
        if let Some(read) = storage.and_then(|one| self.bit_read(one)) {
            self.op(Op::Edge { on: read.on, off: read.off });
        }
    }

    /// The output of OSF: 1 in the scan in which the condition falls, while the storage bit is still 1.
    fn falling(&mut self, storage: Option<&'a OperandUse>, output: Option<&'a OperandUse>) {
        let stored = storage.and_then(|one| self.bit_read(one));
        let Some((one, reference)) = output.and_then(|one| self.reference(one).map(|reference| (one, reference)))
        else {
            return;
        };
        let Some(Target { bit: Some((on, off)), selectors, .. }) = self.target(reference, one.span) else { return };
        let write = self.write(one.span);
        self.op(Op::Clear);
        self.join_all(&selectors, Join::Series);
        if let Some(stored) = stored {
            self.join_all(&[stored.on, stored.off], Join::Taint);
        }
        self.op(Op::Bit { on, off, follow: Follow::Falling, write });
    }

    /// A prescan sets the storage bit of a one-shot.
    fn set_by_prescan(&mut self, operand: Option<&'a OperandUse>) {
        if let Some(one) = operand
            && let Some(reference) = self.reference(one)
            && let Some(Target { bit: Some((on, _)), .. }) = self.target(reference, one.span)
        {
            self.network.set_by_prescan.push(on);
        }
    }

    /// Everything that is only read decides what is written.
    fn computation(&mut self, declaration: &'static Declaration, instruction: &'a Instruction) {
        let written = |at: usize| {
            declaration.operand(at).is_some_and(|one| match one.kind {
                OperandKind::Bit(access) | OperandKind::Number(access) | OperandKind::Integer(access) => {
                    access.writes()
                }
                _ => false,
            })
        };
        let targets: Vec<&OperandUse> =
            (0..instruction.operands.len()).filter(|at| written(*at)).map(|at| &instruction.operands[at]).collect();
        let accepted = self.sequences.accepts(instruction);
        self.op(Op::Clear);
        for (at, one) in instruction.operands.iter().enumerate() {
            let itself = targets.iter().any(|target| target.id == one.id);
            if written(at) || itself {
                // What a tag is computed from itself brings nothing new to it.
                continue;
            }
            let reads = self.operand_values(one);
            if accepted {
                for read in &reads {
                    self.network.reads[*read as usize].accepted = true;
                }
            }
            self.join_all(&reads, Join::Mixed);
        }
        for one in targets {
            self.store(one);
        }
    }

    /// An operand receives what was computed.
    pub fn store(&mut self, one: &'a OperandUse) {
        let Some(reference) = self.reference(one) else { return };
        let Some(target) = self.target(reference, one.span) else { return };
        let write = self.write(one.span);
        self.join_all(&target.selectors, Join::Series);
        for slot in target.bit.into_iter().flat_map(|(on, off)| [on, off]).chain(target.word) {
            self.op(Op::Store { slot, write });
        }
    }

    /// A member of a TIMER, COUNTER or CONTROL: a bit that follows, or a number that both conditions change.
    fn follows(&mut self, reference: &'a Reference, name: &str, follow: Follow, write: u32) {
        let terms = &reference.location.terms;
        match self.member(reference, name) {
            Some((base, true)) => {
                let (on, off) = self.bit_slots(base, terms, true);
                self.op(Op::Bit { on, off, follow, write });
            }
            Some((base, false)) => {
                let slot = self.word_slot(base, terms, true);
                self.op(Op::Any { slot, write });
            }
            None => {}
        }
    }

    /// Begins what follows with the numbers that an instruction keeps in its tag.
    fn presets(&mut self, reference: &'a Reference, span: Span) {
        let selectors = self.selectors(reference, span);
        self.op(Op::Clear);
        self.join_all(&selectors, Join::Series);
        for name in ["PRE", "ACC"] {
            if let Some((base, false)) = self.member(reference, name) {
                let slot = self.word_slot(base, &reference.location.terms, false);
                let read = self.read(slot, span);
                self.op(Op::Join { read, how: Join::Taint });
            }
        }
    }

    fn timer(&mut self, opcode: Opcode, operand: Option<&'a OperandUse>) {
        let Some(one) = operand else { return };
        let Some(reference) = self.reference(one) else { return };
        let write = self.write(one.span);
        self.presets(reference, one.span);
        self.follows(reference, "EN", Follow::Coil, write);
        self.follows(reference, "ACC", Follow::Pulse, write);
        let (timing, done) = match opcode {
            Opcode::Tof => (Follow::Falling, Follow::Held),
            // 0 also while the rung is true and the time has not passed. RTO keeps it while the rung is false; a prescan clears it.
            _ => (Follow::Pulse, Follow::Pulse),
        };
        self.follows(reference, "TT", timing, write);
        self.follows(reference, "DN", done, write);
    }

    fn counter(&mut self, opcode: Opcode, operand: Option<&'a OperandUse>) {
        let Some(one) = operand else { return };
        let Some(reference) = self.reference(one) else { return };
        let write = self.write(one.span);
        self.presets(reference, one.span);
        let (enabled, overflow) = if opcode == Opcode::Ctu { ("CU", "OV") } else { ("CD", "UN") };
        // A prescan sets it, so that a rung that is true at first does not count.
        if let Some((base, true)) = self.member(reference, enabled) {
            let (on, _) = self.bit_slots(base, &reference.location.terms, true);
            self.network.set_by_prescan.push(on);
        }
        self.follows(reference, enabled, Follow::Coil, write);
        self.follows(reference, overflow, Follow::Beyond, write);
        // 0 also while the rung is true and the count is not reached; made anew while it is false, too.
        self.follows(reference, "DN", Follow::Pulse, write);
        self.follows(reference, "ACC", Follow::Pulse, write);
    }

    fn reset(&mut self, operand: Option<&'a OperandUse>) {
        let Some(one) = operand else { return };
        let Some(reference) = self.reference(one) else { return };
        let TypeReference::Structure(index) = reference.type_reference else { return };
        let write = self.write(one.span);
        let selectors = self.selectors(reference, one.span);
        self.op(Op::Clear);
        self.join_all(&selectors, Join::Series);
        let project = self.project;
        for member in &project.types.record(index).members {
            if !["PRE", "LEN"].contains(&member.name.as_str()) {
                self.follows(reference, &member.name, Follow::Unlatch, write);
            }
        }
    }

    /// FAL and FSC: the expression decides, and the position selects.
    fn file(&mut self, instruction: &'a Instruction) {
        let Some((control, rest)) = instruction.operands.split_first() else { return };
        let target = match instruction.call.opcode() {
            Some(Opcode::Fal) => rest.get(3),
            _ => None,
        };
        self.op(Op::Clear);
        for one in rest.iter().filter(|one| target.is_none_or(|target| target.span != one.span)) {
            let reads = self.operand_values(one);
            self.join_all(&reads, Join::Mixed);
        }
        if let Some(reference) = self.reference(control) {
            let write = self.write(control.span);
            for name in ["EN", "EU", "DN", "EM", "ER", "UL", "IN", "FD", "POS"] {
                self.follows(reference, name, Follow::Pulse, write);
            }
        }
        if let Some(target) = target {
            self.store(target);
        }
    }

    fn copy(&mut self, instruction: &'a Instruction) {
        let [from, to, length] = &*instruction.operands else { return };
        let (Some(source), Some(destination)) = (self.reference(from), self.reference(to)) else { return };
        let count = match self.project.operand(length.id) {
            Operand::Integer { value, .. } => u32::try_from(*value).unwrap_or(0),
            _ => 0,
        };
        self.copied(source, from.span, destination, to.span, count);
    }

    /// `count` elements of the destination's type, cell by cell where both sides are laid out alike.
    pub fn copied(&mut self, source: &'a Reference, from: Span, target: &'a Reference, to: Span, count: u32) {
        let (Some(source_base), Some(target_base)) = (self.base(&source.location), self.base(&target.location)) else {
            return;
        };
        let write = self.write(to);
        let (bits, words) = self.project.types.cells(target.type_reference);
        let (bits, words) = (bits.saturating_mul(count), words.saturating_mul(count));
        let alike = source.type_reference == target.type_reference && source.is_constant() && target.is_constant();
        let cells = bits.saturating_add(words);
        if alike && cells <= CELLS_COPIED_ONE_BY_ONE && self.cells_copied + cells <= CELLS_COPIED_IN_ALL {
            self.cells_copied += cells;
            for at in 0..bits {
                let (source, target) = (source_base.at(at, 0), target_base.at(at, 0));
                let read = self.network.places.bit(source.tag, source.bit);
                let written = self.network.places.bit(target.tag, target.bit);
                self.moved(read.0, from, written.0, write);
                self.moved(read.1, from, written.1, write);
            }
            for at in 0..words {
                let (source, target) = (source_base.at(0, at), target_base.at(0, at));
                let read = self.network.places.word(source.tag, source.word).1;
                let written = self.network.places.word(target.tag, target.word).0;
                self.moved(read, from, written, write);
            }
            return;
        }
        // Of another type, how many of its elements are as many bytes is not looked at: all to the end of the array.
        let taken = if source.type_reference == target.type_reference { count } else { source.location.count };
        let selected = self.selectors(source, from);
        let joints = self.region_slots(source_base, source.type_reference, taken, &source.location.terms, false);
        self.op(Op::Nothing);
        for slot in joints {
            let read = self.read(slot, from);
            self.op(Op::Join { read, how: Join::Either });
        }
        self.join_all(&selected, Join::Mixed);
        let selected = self.selectors(target, to);
        self.join_all(&selected, Join::Series);
        for slot in self.region_slots(target_base, target.type_reference, count, &target.location.terms, true) {
            self.op(Op::Store { slot, write });
        }
    }

    fn moved(&mut self, from: u32, span: Span, to: u32, write: u32) {
        let read = self.read(from, span);
        self.op(Op::Clear);
        self.op(Op::Join { read, how: Join::Series });
        self.op(Op::Store { slot: to, write });
    }

    fn fill(&mut self, instruction: &'a Instruction) {
        let [from, to, length] = &*instruction.operands else { return };
        let Some(reference) = self.reference(to) else { return };
        let Some(base) = self.base(&reference.location) else { return };
        let count = match self.project.operand(length.id) {
            Operand::Integer { value, .. } => u32::try_from(*value).unwrap_or(0),
            _ => 0,
        };
        let reads = self.operand_values(from);
        let selected = self.selectors(reference, to.span);
        let write = self.write(to.span);
        self.op(Op::Clear);
        self.join_all(&reads, Join::Mixed);
        self.join_all(&selected, Join::Series);
        for slot in self.region_slots(base, reference.type_reference, count, &reference.location.terms, true) {
            self.op(Op::Store { slot, write });
        }
    }

    /// A system value is of neither origin.
    fn system_value(&mut self, instruction: &'a Instruction) {
        let Some(one) = instruction.operands.get(3) else { return };
        let length = match instruction.operands.get(2).map(|one| self.project.operand(one.id)) {
            Some(Operand::SystemValue(value)) => value.attribute.length,
            _ => 1,
        };
        let Some(reference) = self.reference(one) else { return };
        let Some(base) = self.base(&reference.location) else { return };
        let write = self.write(one.span);
        let selected = self.selectors(reference, one.span);
        self.op(Op::Clear);
        self.join_all(&selected, Join::Series);
        let kind = match reference.shape() {
            Shape::Word | Shape::Region => reference.type_reference,
            Shape::Bit | Shape::WordBit => TypeReference::Element(Element::Dint),
        };
        for slot in self.region_slots(base, kind, length, &reference.location.terms, true) {
            self.op(Op::Store { slot, write });
        }
    }
}
