//! Building the network: routines of programs once, those of Add-On Instructions once for each instance.

use twinrung_catalog::Opcode;
use twinrung_grammar::tree::Span;

use super::initial;
use super::jumps::Jumps;
use super::network::{Network, Op, Read, Unit, Write, Zone};
use super::places::{Places, Slot};
use super::sequence::Sequences;
use super::subroutines::Returns;
use crate::names::{Map, Set};
use crate::operand::{Location, LocationBase, Operand};
use crate::project::{AddOnId, Element, Project, RoutineId, RoutineOwner, Rung, TagId};

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

/// The rail of a routine: why it is executed, and why it is not.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rail {
    pub on: Slot,
    pub off: Slot,
}

/// The rails of an instance: of Logic, and of what runs while the rung is false.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rails {
    pub enabled: Rail,
    pub disabled: Rail,
}

/// More instances than this are not followed one by one: what goes into a further one is taken to reach all that it writes.
const INSTANCES_MAX: usize = 20_000;
/// Nor are further instances when those so far have as many operands in all.
const OPERANDS_OF_INSTANCES_MAX: usize = 1_000_000;

/// A zone of MCR that is open.
#[derive(Debug, Clone, Copy)]
struct Open {
    on: Slot,
    off: Slot,
    span: Span,
    entered: bool,
}

pub(super) struct Builder<'a> {
    pub project: &'a Project,
    pub network: Network,
    /// The rail of each routine of a program.
    pub rails: Map<RoutineId, Rail>,
    /// What the RETs of each routine hand back.
    pub returns: Map<RoutineId, Returns>,
    /// The routine at hand.
    pub at: RoutineId,
    instances: Map<(AddOnId, Binding), Rails>,
    waiting: Vec<(AddOnId, Binding, Rails)>,
    /// Operands of each Add-On Instruction's own routines.
    sizes: Map<AddOnId, usize>,
    operands_of_instances: usize,
    /// What the rungs of the routine at hand count from.
    pub binding: Binding,
    pub unit: u32,
    pub sequences: &'a Sequences,
    /// The jumps of the routine at hand, and which rung of it.
    jumps: Jumps,
    number: u32,
    /// The rungs of the routine at hand on which an MCR stands.
    zones: Vec<u32>,
    zone: Option<Open>,
    /// Cells that were copied one by one.
    pub cells_copied: u32,
    /// The rungs of each routine that was built, by its rail.
    units_of: Map<Slot, std::ops::Range<u32>>,
}

/// Builds the network of a project. Tags that are too large to be followed cell by cell are judged as one cell.
pub(crate) fn build(project: &Project, sequences: &Sequences) -> Network {
    let mut merged: Set<TagId> = Set::default();
    loop {
        let network = Builder::new(project, sequences, merged.clone()).build();
        if network.places.too_large.is_empty() {
            return network;
        }
        merged.extend(network.places.too_large.iter().copied());
    }
}

impl<'a> Builder<'a> {
    fn new(project: &'a Project, sequences: &'a Sequences, merged: Set<TagId>) -> Builder<'a> {
        Builder {
            project,
            network: Network { places: Places::new(merged), ..Network::default() },
            rails: Map::default(),
            returns: Map::default(),
            at: RoutineId(0),
            instances: Map::default(),
            waiting: Vec::new(),
            sizes: Map::default(),
            operands_of_instances: 0,
            binding: Binding::default(),
            unit: 0,
            sequences,
            jumps: Jumps::default(),
            number: 0,
            zones: Vec::new(),
            zone: None,
            cells_copied: 0,
            units_of: Map::default(),
        }
    }

    fn build(mut self) -> Network {
        let project = self.project;
        let called = called_routines(project);
        for (at, routine) in project.routines.iter().enumerate() {
            let RoutineOwner::Program(program) = routine.owner else { continue };
            let id = RoutineId(at as u32);
            let rail = self.rail();
            self.rails.insert(id, rail);
            let program = project.program(program);
            if program.main == Some(id) || (program.main.is_none() && !called.contains(&id)) {
                self.network.rails.push(rail.on);
            } else if program.fault == Some(id) || !called.contains(&id) {
                // Whether it is executed nobody knows.
                self.network.rails.extend([rail.on, rail.off]);
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
                let rail = self.rail();
                self.network.rails.extend([rail.on, rail.off]);
                self.routine(prescan, rail);
            }
        }
        let order = initial::order(&self.network, &self.units_of, &self.roots());
        self.network.initial = initial::of(project, &mut self.network, &order);
        self.network
    }

    /// The rails with which a scan begins, in their order.
    fn roots(&self) -> Vec<Slot> {
        let project = self.project;
        let scheduled = project.safety_task.into_iter().flat_map(|task| &project.tasks[task].schedule);
        let mut programs: Vec<usize> = scheduled.filter_map(|one| one.program).map(|id| id.position()).collect();
        // A part of a project has no schedule.
        let further: Vec<usize> = (0..project.programs.len()).filter(|at| !programs.contains(at)).collect();
        if programs.is_empty() {
            programs = further;
        }
        programs
            .into_iter()
            .flat_map(|at| match project.programs[at].main {
                Some(main) => vec![main],
                None => project.programs[at].routines.clone(),
            })
            .filter_map(|routine| self.rails.get(&routine))
            .map(|rail| rail.on)
            .collect()
    }

    fn rail(&mut self) -> Rail {
        Rail { on: self.network.places.joint(None), off: self.network.places.joint(None) }
    }

    /// The rails of an instance; nothing when there are too many to follow.
    pub fn instance(&mut self, add_on: AddOnId, binding: Binding) -> Option<Rails> {
        let key = (add_on, binding);
        if let Some(known) = self.instances.get(&key) {
            return Some(*known);
        }
        let size = self.size(add_on);
        if self.instances.len() >= INSTANCES_MAX || self.operands_of_instances + size > OPERANDS_OF_INSTANCES_MAX {
            return None;
        }
        self.operands_of_instances += size;
        let rails = Rails { enabled: self.rail(), disabled: self.rail() };
        self.waiting.push((add_on, key.1.clone(), rails));
        self.instances.insert(key, rails);
        Some(rails)
    }

    /// Rungs, instructions and operands of an Add-On Instruction's own routines.
    fn size(&mut self, id: AddOnId) -> usize {
        if let Some(known) = self.sizes.get(&id) {
            return *known;
        }
        let add_on = self.project.add_on(id);
        let mut size = 0;
        for routine in [add_on.logic, add_on.prescan, add_on.enable_in_false].into_iter().flatten() {
            for rung in &self.project.routine(routine).rungs {
                size += 1;
                rung.visit(&mut |instruction| size += 1 + instruction.operands.len());
            }
        }
        self.sizes.insert(id, size);
        size
    }

    fn routine(&mut self, id: RoutineId, rail: Rail) {
        let rungs: &'a [Rung] = &self.project.routine(id).rungs;
        self.at = id;
        self.jumps = self.jumps(rungs);
        self.zone = None;
        self.zones = zones(self.project, rungs);
        let begin = self.network.units.len() as u32;
        for (number, rung) in rungs.iter().enumerate() {
            self.rung(number as u32, rung, rail);
        }
        self.units_of.insert(rail.on, begin..self.network.units.len() as u32);
    }

    fn rung(&mut self, number: u32, rung: &'a Rung, rail: Rail) {
        self.number = number;
        self.unit = self.network.units.len() as u32;
        let begin = self.network.ops.len() as u32;
        let rail = (self.read(rail.on, rung.span), self.read(rail.off, rung.span));
        let spoil = self.jumps.spoil(number).map(|slot| self.read(slot, rung.span));
        let zone = self.zone.map(|open| Zone {
            on: self.read(open.on, open.span),
            off: self.read(open.off, open.span),
            entered: open.entered,
        });
        self.series(&rung.elements);
        let ops = begin..self.network.ops.len() as u32;
        let (routine, incomplete) = (self.at, rung.incomplete);
        self.network.units.push(Unit { ops, routine, rung: number, rail, spoil, zone, incomplete });
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

    /// The routine may go on elsewhere, or end, when the rung condition is true here.
    pub fn leave(&mut self, span: Span) {
        let Some(slot) = self.jumps.leave(self.number) else { return };
        let write = self.write(span);
        self.op(Op::Leave { slot, write });
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
        let next = self.zones.partition_point(|rung| *rung <= self.number);
        let end = self.zones.get(next).copied().unwrap_or(u32::MAX - 1);
        self.zone = Some(Open { on, off, span, entered: self.jumps.enters(self.number..=end) });
    }

    pub fn op(&mut self, op: Op) {
        self.network.ops.push(op);
    }

    pub fn read(&mut self, slot: Slot, span: Span) -> u32 {
        let number = self.network.reads.len() as u32;
        self.network.reads.push(Read { slot, unit: self.unit, span, accepted: false, early: false });
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

/// Rungs on which an MCR stands.
fn zones(project: &Project, rungs: &[Rung]) -> Vec<u32> {
    let mut list = Vec::new();
    if project.opcodes.any(&[Opcode::Mcr]) {
        for (number, rung) in rungs.iter().enumerate() {
            rung.visit(&mut |instruction| {
                if instruction.call.opcode() == Some(Opcode::Mcr) {
                    list.push(number as u32);
                }
            });
        }
    }
    list
}
