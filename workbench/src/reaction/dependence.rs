//! Which safety inputs reach an output through the logic.
//!
//! An over-approximation: within a rung everything that is written depends on everything that is read, and what steers control
//! (JMP, JSR, MCR, RET, TND) reaches every rung of its routine and of the routines that it calls. It may name an input that
//! never decides the output; it leaves none out that does.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use twinrung_catalog::Opcode;
use twinrung_compiler::operand::Operand;
use twinrung_compiler::project::{Call, Instruction, Project, RoutineId, TagId, TagKind};
use twinrung_compiler::rules::usage::accesses;

use crate::usage::{Cell, Index, Rung, cell};

/// Data that the logic reads or writes: one value of a tag, or any part of it.
pub type Data = (TagId, Option<Cell>);

/// Who depends on what.
pub struct Dependence<'a> {
    project: &'a Project,
    index: Index,
    reads: BTreeMap<Rung, BTreeSet<Data>>,
    /// What steers each routine, through the routines that call it too.
    steering: BTreeMap<u32, BTreeSet<Data>>,
}

impl<'a> Dependence<'a> {
    /// Goes through all rungs.
    pub fn new(project: &'a Project) -> Dependence<'a> {
        let mut reads: BTreeMap<Rung, BTreeSet<Data>> = BTreeMap::new();
        accesses(project, &mut |access| {
            let Some(tag) = access.reference.base_tag().filter(|_| access.reads) else { return };
            reads.entry((access.place.routine.0, access.place.rung)).or_default().insert((tag, cell(access.reference)));
        });
        let calls = give_back(project, &mut reads);
        let steering = steering(project, &reads, &calls);
        Dependence { project, index: Index::new(project), reads, steering }
    }

    /// Data of input modules and consumed tags on which `output` depends.
    pub fn sources(&self, output: Data) -> BTreeSet<Data> {
        let mut seen = BTreeSet::from([output]);
        let mut open = VecDeque::from([output]);
        let (mut rungs, mut routines) = (BTreeSet::new(), BTreeSet::new());
        while let Some(data) = open.pop_front() {
            for rung in self.writers(data) {
                let own = self.reads.get(&rung).filter(|_| rungs.insert(rung));
                let steering = self.steering.get(&rung.0).filter(|_| routines.insert(rung.0));
                for read in own.into_iter().chain(steering).flatten() {
                    if seen.insert(*read) {
                        open.push_back(*read);
                    }
                }
            }
        }
        let comes_in =
            |(tag, _): &Data| matches!(self.project.tag(*tag).kind, TagKind::ModuleInput(_) | TagKind::Consumed);
        seen.into_iter().filter(comes_in).collect()
    }

    fn writers(&self, (tag, cell): Data) -> BTreeSet<Rung> {
        let uses = cell.map_or_else(|| self.index.of_tag(tag), |cell| self.index.of_cell(tag, cell));
        uses.writers().clone()
    }
}

/// The routine that a JSR calls.
fn called(project: &Project, instruction: &Instruction) -> Option<RoutineId> {
    if instruction.call.opcode() != Some(Opcode::Jsr) {
        return None;
    }
    match project.operand(instruction.operands.first()?.id) {
        Operand::Routine(routine) => Some(*routine),
        _ => None,
    }
}

fn each_instruction(project: &Project, mut visitor: impl FnMut(Rung, &Instruction)) {
    for (routine, body) in project.routines.iter().enumerate() {
        for (number, rung) in body.rungs.iter().enumerate() {
            rung.visit(&mut |instruction| visitor((routine as u32, number as u32), instruction));
        }
    }
}

/// What a routine gives back is written on the rung of the call: it reads what the called routine's RET reads. The calls, by
/// their rungs.
fn give_back(project: &Project, reads: &mut BTreeMap<Rung, BTreeSet<Data>>) -> Vec<(Rung, RoutineId)> {
    let mut returned: BTreeMap<u32, BTreeSet<Data>> = BTreeMap::new();
    let mut calls = Vec::new();
    each_instruction(project, |rung, instruction| {
        if let Some(routine) = called(project, instruction) {
            calls.push((rung, routine));
        }
        if instruction.call.opcode() == Some(Opcode::Ret) {
            let read = reads.get(&rung).cloned().unwrap_or_default();
            returned.entry(rung.0).or_default().extend(read);
        }
    });
    for (rung, routine) in &calls {
        let given = returned.get(&routine.0).cloned().unwrap_or_default();
        reads.entry(*rung).or_default().extend(given);
    }
    calls
}

fn steering(
    project: &Project,
    reads: &BTreeMap<Rung, BTreeSet<Data>>,
    calls: &[(Rung, RoutineId)],
) -> BTreeMap<u32, BTreeSet<Data>> {
    let mut steering: BTreeMap<u32, BTreeSet<Data>> = BTreeMap::new();
    each_instruction(project, |rung, instruction| {
        if let Call::Catalog(declaration) = instruction.call
            && matches!(declaration.opcode, Opcode::Jmp | Opcode::Mcr | Opcode::Ret | Opcode::Tnd)
        {
            steering.entry(rung.0).or_default().extend(reads.get(&rung).into_iter().flatten());
        }
    });
    // Least fixed point; calls are not recursive, so that each round settles one more level of them.
    loop {
        let mut grown = false;
        for (rung, routine) in calls {
            let of_caller = steering.get(&rung.0).into_iter().flatten();
            let passed: BTreeSet<Data> = reads.get(rung).into_iter().flatten().chain(of_caller).copied().collect();
            let own = steering.entry(routine.0).or_default();
            let before = own.len();
            own.extend(passed);
            grown |= own.len() > before;
        }
        if !grown {
            return steering;
        }
    }
}
