//! What the elements of one routine cost, and how often its loops repeat them.

use alloc::collections::BTreeMap;
use alloc::string::String;
use alloc::vec::Vec;

use twinrung_catalog::Opcode;

use super::{RoutineBound, Work, file_elements};
use crate::admitted::AdmittedImage;
use crate::code::{Mark, Marks, Operands};
use crate::image::{Image, Owner, RoutineRecord, TypeKind};
use crate::index::{AddOnIndex, OperandIndex, RoutineIndex};
use crate::limits;
use crate::operand::{AccessType, OperandRecord};

/// A JSR, and how often one execution of its routine can execute it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Call {
    pub(super) target: RoutineIndex,
    pub(super) times: u64,
}

/// One execution of a routine: what each of its rungs costs, and what it calls.
#[derive(Debug, Clone, Default)]
pub(super) struct Walk {
    rungs: Vec<u64>,
    pub(super) calls: Vec<Call>,
    /// What a prescan of it costs, without its subroutines.
    pub(super) prescan: u64,
}

/// What a call of each Add-On Instruction costs besides the call itself.
#[derive(Debug, Clone, Default)]
pub(super) struct Bodies {
    /// In a scan: it runs Logic or EnableInFalse.
    scan: Vec<u64>,
    /// In a prescan: Logic is prescanned, then Prescan runs.
    prescan: Vec<u64>,
}

impl Bodies {
    /// Of one Add-On Instruction, in a scan and in a prescan. An admitted image calls none that it does not hold.
    fn of(&self, add_on: Option<AddOnIndex>) -> (u64, u64) {
        let body =
            |bodies: &[u64]| add_on.and_then(|add_on| bodies.get(add_on.position()).copied()).unwrap_or(u64::MAX);
        (body(&self.scan), body(&self.prescan))
    }
}

impl Walk {
    fn total(&self) -> u64 {
        self.rungs.iter().fold(0, |total: u64, rung| total.saturating_add(*rung))
    }

    pub(super) fn with_runs(&self, runs: u64) -> RoutineBound {
        RoutineBound {
            runs,
            total: self.total().saturating_mul(runs),
            rungs: self.rungs.iter().map(|rung| rung.saturating_mul(runs)).collect(),
        }
    }
}

/// The beginning of a rung, or one element on it: what it costs, the routine that it calls.
struct Element {
    rung: usize,
    cost: u64,
    call: Option<RoutineIndex>,
}

/// What each Add-On Instruction does when it is called. Callees stand before callers.
pub(super) fn add_on_bodies(image: &AdmittedImage, cost: &dyn Fn(Work) -> u64) -> Bodies {
    let mut bodies = Bodies::default();
    for add_on in &image.image().add_ons {
        let body = |routine: Option<RoutineIndex>| {
            routine
                .and_then(|routine| image.image().routines.get(routine.position()))
                .map_or_else(Walk::default, |record| walk(image, record, &bodies, cost))
        };
        let logic = body(Some(add_on.logic));
        let (scan, prescan) = (
            logic.total().max(body(add_on.enable_in_false).total()),
            logic.prescan.saturating_add(body(add_on.prescan).total()),
        );
        bodies.scan.push(scan);
        bodies.prescan.push(prescan);
    }
    bodies
}

/// Walks a routine.
pub(super) fn walk(image: &AdmittedImage, record: &RoutineRecord, bodies: &Bodies, cost: &dyn Fn(Work) -> u64) -> Walk {
    let mut walk = Walk::default();
    let mut elements: Vec<Element> = Vec::new();
    let mut labels: BTreeMap<String, Position> = BTreeMap::new();
    let mut jumps: Vec<(Position, String)> = Vec::new();
    let (mut rung, mut rung_begins) = (0_usize, 0_usize);
    for mark in Marks::new(&record.code) {
        // What it costs in a scan and in a prescan, and what it calls.
        let (scan, prescan, call) = match mark {
            Ok(Mark::Rung) => {
                walk.rungs.push(0);
                rung_begins = elements.len();
                let entered = cost(Work::Rung);
                (entered, entered, None)
            }
            Ok(Mark::EndRung) => {
                rung = rung.saturating_add(1);
                continue;
            }
            Ok(Mark::Branch | Mark::NextLeg | Mark::EndBranch) => continue,
            Ok(Mark::AddOn(operands)) => {
                let (call, (scan, prescan)) = (cost(Work::AddOnCall), bodies.of(called(image, operands)));
                (call.saturating_add(scan), call.saturating_add(prescan), None)
            }
            Ok(Mark::Instruction(instruction, operands)) => {
                let opcode = instruction.opcode;
                match (opcode, operands.get(0).and_then(|operand| label(image.image(), operand))) {
                    // A label is the first element of its rung: who jumps to it enters the rung.
                    (Opcode::Lbl, Some(label)) => drop(labels.insert(label, Position { rung, element: rung_begins })),
                    (Opcode::Jmp, Some(label)) => jumps.push((Position { rung, element: elements.len() }, label)),
                    _ => {}
                }
                let file = match file_elements::most(image, opcode, operands) {
                    0 => 0,
                    most => most.saturating_mul(cost(Work::FileElement(opcode))),
                };
                let own = cost(Work::Instruction(opcode));
                let call = if opcode == Opcode::Jsr { subroutine(image.image(), record, operands) } else { None };
                (own.saturating_add(file), own, call)
            }
            // An admitted image holds no such code.
            Err(_) => (u64::MAX, u64::MAX, None),
        };
        walk.prescan = walk.prescan.saturating_add(prescan);
        elements.push(Element { rung, cost: scan, call });
    }
    for (element, repeats) in elements.iter().zip(repeats(elements.len(), &labels, &jumps)) {
        let times = repeats.saturating_add(1);
        if let Some(rung) = walk.rungs.get_mut(element.rung) {
            *rung = rung.saturating_add(element.cost.saturating_mul(times));
        }
        walk.calls.extend(element.call.map(|target| Call { target, times }));
    }
    walk
}

/// Where a label or a jump stands: its rung, and its place among all elements of the routine.
#[derive(Debug, Clone, Copy)]
struct Position {
    rung: usize,
    element: usize,
}

/// How often each element is repeated by backward jumps: each adds one pass from the rung of its label to itself.
fn repeats(
    elements: usize,
    labels: &BTreeMap<String, Position>,
    jumps: &[(Position, String)],
) -> impl Iterator<Item = u64> {
    let mut begins = alloc::vec![0_u64; elements];
    let mut ends = alloc::vec![0_u64; elements];
    for (jump, label) in jumps {
        let Some(target) = labels.get(label) else { continue };
        if target.rung > jump.rung {
            continue;
        }
        for (counts, at) in [(&mut begins, target.element), (&mut ends, jump.element)] {
            if let Some(count) = counts.get_mut(at) {
                *count = count.saturating_add(u64::from(limits::BACKWARD_JUMPS));
            }
        }
    }
    let mut open = 0_u64;
    begins.into_iter().zip(ends).map(move |(begins, ends)| {
        let here = open.saturating_add(begins);
        open = here.saturating_sub(ends);
        here
    })
}

/// What an operand says.
pub(super) fn decoded(image: &Image, operand: OperandIndex) -> Option<OperandRecord> {
    OperandRecord::decode(image.operands.entry(operand)?).ok()
}

fn label(image: &Image, operand: OperandIndex) -> Option<String> {
    // Most first operands are references: they need no decoding to be seen not to be a text.
    if image.operands.entry(operand)?.first() != Some(&crate::format::TEXT) {
        return None;
    }
    match decoded(image, operand)? {
        OperandRecord::Text(label) => Some(label),
        _ => None,
    }
}

/// The routine that a JSR runs. One that raises a user fault runs none (REQ-EXEC-053): it is the only JSR by which a
/// fault routine may name itself.
fn subroutine(image: &Image, caller: &RoutineRecord, operands: Operands<'_>) -> Option<RoutineIndex> {
    let OperandRecord::Routine(target) = decoded(image, operands.get(0)?)? else { return None };
    let Owner::Program(program) = caller.owner else { return None };
    let is_fault = image.programs.get(program.position())?.fault == Some(target);
    let number = operands.get(2).filter(|_| is_fault && operands.len() == 3);
    match number.and_then(|number| decoded(image, number)) {
        Some(OperandRecord::Integer { value: 990..=999, .. }) => None,
        _ => Some(target),
    }
}

/// The Add-On Instruction whose instance the first operand is.
fn called(image: &AdmittedImage, operands: Operands<'_>) -> Option<AddOnIndex> {
    let OperandRecord::Reference(reference) = decoded(image.image(), operands.get(0)?)? else { return None };
    let AccessType::Structure(index) = reference.access.access_type else { return None };
    match image.image().types.get(index.position())?.kind {
        TypeKind::AddOn(add_on) => Some(add_on),
        TypeKind::Predefined | TypeKind::User => None,
    }
}
