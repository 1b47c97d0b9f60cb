//! Building the network: routines of programs once, those of Add-On Instructions once for each instance.

use twinrung_catalog::Opcode;
use twinrung_grammar::tree::Span;

use super::network::{Network, Op, Read, Unit, Write};
use super::places::{Places, Slot};
use super::sequence::Sequences;
use crate::names::{Map, Set};
use crate::operand::{Location, LocationBase, Operand};
use crate::project::{AddOnId, Element, Instruction, Project, RoutineId, RoutineOwner, Rung, TagId};

/// Where the cells of something lie in its tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Base {
    pub tag: TagId,
    pub bit: u32,
    pub word: u32,
}

impl Base {
    /// So many cells further.
    pub fn at(self, bits: u32, words: u32) -> Base {
        Base { tag: self.tag, bit: self.bit + bits, word: self.word + words }
    }
}

/// What the names of an Add-On Instruction's routines stand for in one instance.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub(super) struct Binding {
    pub instance: Option<Base>,
    pub in_out: Vec<Option<Base>>,
}

/// The rails of an instance: of Logic, and of what runs while the rung is false.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rails {
    pub enabled: Slot,
    pub disabled: Slot,
}

/// More instances than this are not followed one by one: what goes into a further one is taken to reach all that it writes.
const INSTANCES_MAX: usize = 20_000;

pub(super) struct Builder<'a> {
    pub project: &'a Project,
    pub network: Network,
    /// The rail of each routine of a program.
    pub rails: Map<RoutineId, Slot>,
    instances: Map<(AddOnId, Binding), Rails>,
    waiting: Vec<(AddOnId, Binding, Rails)>,
    /// What the rungs of the routine at hand count from.
    pub binding: Binding,
    pub unit: u32,
    pub sequences: Sequences,
    /// The rail of what follows on the routine at hand, where a rung may end or jump.
    next_rail: Option<Slot>,
    /// The zone of MCR.
    zone: Option<(Slot, Slot, Span)>,
}

/// Builds the network of a project. Tags that are too large to be followed cell by cell are judged as one cell.
pub(crate) fn build(project: &Project) -> Network {
    let mut merged: Set<TagId> = Set::default();
    loop {
        let network = Builder::new(project, merged.clone()).build();
        if network.places.too_large.is_empty() {
            return network;
        }
        merged.extend(network.places.too_large.iter().copied());
    }
}

impl<'a> Builder<'a> {
    fn new(project: &'a Project, merged: Set<TagId>) -> Builder<'a> {
        Builder {
            project,
            network: Network { places: Places::new(merged), ..Network::default() },
            rails: Map::default(),
            instances: Map::default(),
            waiting: Vec::new(),
            binding: Binding::default(),
            unit: 0,
            sequences: Sequences::of(project),
            next_rail: None,
            zone: None,
        }
    }

    fn build(mut self) -> Network {
        let project = self.project;
        let called = called_routines(project);
        for (at, routine) in project.routines.iter().enumerate() {
            if matches!(routine.owner, RoutineOwner::AddOn(_)) {
                continue;
            }
            let id = RoutineId(at as u32);
            let rail = self.network.places.joint(None);
            self.rails.insert(id, rail);
            let entered = project.programs.iter().any(|one| one.main == Some(id) || one.fault == Some(id));
            if entered || !called.contains(&id) {
                self.network.rails.push(rail);
            }
        }
        for (at, routine) in project.routines.iter().enumerate() {
            let id = RoutineId(at as u32);
            if let (RoutineOwner::Program(_), Some(rail)) = (routine.owner, self.rails.get(&id)) {
                self.routine(id, *rail);
            }
        }
        while let Some((add_on, binding, rails)) = self.waiting.pop() {
            self.binding = binding;
            let declared = project.add_on(add_on);
            if let Some(logic) = declared.logic {
                self.routine(logic, rails.enabled);
            }
            if let Some(disabled) = declared.enable_in_false {
                self.routine(disabled, rails.disabled);
            }
            if let Some(prescan) = declared.prescan {
                let rail = self.network.places.joint(None);
                self.network.rails.push(rail);
                self.routine(prescan, rail);
            }
        }
        self.network
    }

    /// The rails of an instance; nothing when there are too many to follow.
    pub fn instance(&mut self, add_on: AddOnId, binding: Binding) -> Option<Rails> {
        let key = (add_on, binding);
        if let Some(known) = self.instances.get(&key) {
            return Some(*known);
        }
        if self.instances.len() >= INSTANCES_MAX {
            return None;
        }
        let rails = Rails { enabled: self.network.places.joint(None), disabled: self.network.places.joint(None) };
        self.waiting.push((add_on, key.1.clone(), rails));
        self.instances.insert(key, rails);
        Some(rails)
    }

    fn routine(&mut self, id: RoutineId, rail: Slot) {
        let routine = self.project.routine(id);
        let labels = self.labels(&routine.rungs);
        let mut rail = rail;
        let mut at_labels: Map<&str, (Slot, u32)> = Map::default();
        let mut ended = 0;
        self.zone = None;
        for (number, rung) in routine.rungs.iter().enumerate() {
            if let Some(label) = label_of(self.project, rung)
                && let Some((before, endings)) = at_labels.remove(label)
                && endings == ended
            {
                rail = before;
            }
            self.next_rail = None;
            let before = rail;
            self.rung(id, number as u32, rung, rail);
            if let Some(next) = self.next_rail.take() {
                rail = next;
                let mut jumps = Vec::new();
                rung.visit(&mut |instruction| match instruction.call.opcode() {
                    Some(Opcode::Jmp) => jumps.extend(label_name(self.project, instruction)),
                    Some(Opcode::Tnd | Opcode::Ret) => ended += 1,
                    _ => {}
                });
                for label in jumps.into_iter().filter(|label| labels.get(label).is_some_and(|at| *at > number)) {
                    at_labels.entry(label).or_insert((before, ended));
                }
            }
        }
    }

    fn labels(&self, rungs: &'a [Rung]) -> Map<&'a str, usize> {
        let project = self.project;
        rungs.iter().enumerate().filter_map(|(at, rung)| label_of(project, rung).map(|label| (label, at))).collect()
    }

    fn rung(&mut self, routine: RoutineId, number: u32, rung: &'a Rung, rail: Slot) {
        self.unit = self.network.units.len() as u32;
        let begin = self.network.ops.len() as u32;
        let guard = self.read(rail, rung.span);
        let zone = self.zone.map(|(on, off, span)| (self.read(on, span), self.read(off, span)));
        self.series(&rung.elements);
        let ops = begin..self.network.ops.len() as u32;
        self.network.units.push(Unit { ops, routine, rung: number, guard, zone, incomplete: rung.incomplete });
    }

    fn series(&mut self, elements: &'a [Element]) {
        for element in elements {
            match element {
                Element::Instruction(instruction) => self.instruction(instruction),
                Element::Branch(branch) => {
                    self.op(Op::Open);
                    for (at, leg) in branch.legs.iter().enumerate() {
                        if at > 0 {
                            self.op(Op::Leg);
                        }
                        self.series(leg);
                    }
                    self.op(Op::Close);
                }
            }
        }
    }

    /// What follows on this routine is executed only when the rung condition is false here.
    pub fn may_end(&mut self, span: Span) {
        let slot = match self.next_rail {
            Some(slot) => slot,
            None => self.network.places.joint(None),
        };
        self.next_rail = Some(slot);
        let write = self.write(span);
        self.op(Op::Nothing);
        self.op(Op::Break { slot, write });
    }

    /// A zone of MCR begins or ends.
    pub fn zone(&mut self, span: Span) {
        if self.zone.take().is_some() {
            return;
        }
        let (on, off) = (self.network.places.joint(None), self.network.places.joint(None));
        let write = self.write(span);
        self.op(Op::Clear);
        self.op(Op::Store { slot: on, write });
        self.op(Op::Nothing);
        self.op(Op::Break { slot: off, write });
        self.zone = Some((on, off, span));
    }

    pub fn op(&mut self, op: Op) {
        self.network.ops.push(op);
    }

    pub fn read(&mut self, slot: Slot, span: Span) -> u32 {
        let number = self.network.reads.len() as u32;
        self.network.reads.push(Read { slot, unit: self.unit, span, accepted: false });
        number
    }

    pub fn write(&mut self, span: Span) -> u32 {
        let number = self.network.writes.len() as u32;
        self.network.writes.push(Write { unit: self.unit, span });
        number
    }

    /// Where something lies; nothing where an argument is not known.
    pub fn base(&self, location: &Location) -> Option<Base> {
        let from = match location.base {
            LocationBase::Tag(tag) => Base { tag, bit: 0, word: 0 },
            LocationBase::Instance => self.binding.instance?,
            LocationBase::InOut(parameter) => (*self.binding.in_out.get(usize::from(parameter))?)?,
        };
        Some(Base { tag: from.tag, bit: from.bit + location.bit_cell, word: from.word + location.word_cell })
    }
}

/// Routines that a JSR calls.
fn called_routines(project: &Project) -> Set<RoutineId> {
    let mut called = Set::default();
    if project.opcodes.any(&[Opcode::Jsr]) {
        crate::rules::usage::instructions(project, &mut |_, instruction| {
            if let (Some(Opcode::Jsr), Some(first)) = (instruction.call.opcode(), instruction.operands.first())
                && let Operand::Routine(routine) = project.operand(first.id)
            {
                called.insert(*routine);
            }
        });
    }
    called
}

fn label_name<'a>(project: &'a Project, instruction: &Instruction) -> Option<&'a str> {
    match project.operand(instruction.operands.first()?.id) {
        Operand::Text(label) => Some(label.as_str()),
        _ => None,
    }
}

fn label_of<'a>(project: &'a Project, rung: &Rung) -> Option<&'a str> {
    match rung.elements.first() {
        Some(Element::Instruction(first)) if first.call.opcode() == Some(Opcode::Lbl) => label_name(project, first),
        _ => None,
    }
}
