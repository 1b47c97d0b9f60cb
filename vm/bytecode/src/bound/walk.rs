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

/// One element of a routine: its rung, its cost, the routine that it calls.
struct Element {
    rung: usize,
    cost: u64,
    call: Option<RoutineIndex>,
}

/// What a call of each Add-On Instruction costs besides the call itself: it runs Logic or EnableInFalse. Callees stand before
/// callers.
pub(super) fn add_on_bodies(image: &AdmittedImage, cost: &dyn Fn(Work) -> u64) -> Vec<u64> {
    let mut bodies = Vec::with_capacity(image.image().add_ons.len());
    for add_on in &image.image().add_ons {
        let body = |routine: Option<RoutineIndex>| {
            routine
                .and_then(|routine| image.image().routines.get(routine.position()))
                .map_or(0, |record| walk(image, record, &bodies, cost).total())
        };
        bodies.push(body(Some(add_on.logic)).max(body(add_on.enable_in_false)));
    }
    bodies
}

/// Walks a routine.
pub(super) fn walk(image: &AdmittedImage, record: &RoutineRecord, bodies: &[u64], cost: &dyn Fn(Work) -> u64) -> Walk {
    let mut walk = Walk::default();
    let mut elements: Vec<Element> = Vec::new();
    let mut labels: BTreeMap<String, (usize, usize)> = BTreeMap::new();
    let mut jumps: Vec<(usize, usize, String)> = Vec::new();
    let mut rung = 0_usize;
    for mark in Marks::new(&record.code) {
        let (cost, call) = match mark {
            Ok(Mark::Rung) => {
                walk.rungs.push(cost(Work::Rung));
                continue;
            }
            Ok(Mark::EndRung) => {
                rung = rung.saturating_add(1);
                continue;
            }
            Ok(Mark::Branch | Mark::NextLeg | Mark::EndBranch) => continue,
            Ok(Mark::AddOn(operands)) => {
                let body = called(image, operands).and_then(|add_on| bodies.get(add_on.position()));
                (cost(Work::AddOnCall).saturating_add(body.copied().unwrap_or(u64::MAX)), None)
            }
            Ok(Mark::Instruction(instruction, operands)) => {
                let opcode = instruction.opcode;
                let at = elements.len();
                match (opcode, operands.get(0).and_then(|operand| label(image.image(), operand))) {
                    (Opcode::Lbl, Some(label)) => drop(labels.insert(label, (at, rung))),
                    (Opcode::Jmp, Some(label)) => jumps.push((at, rung, label)),
                    _ => {}
                }
                let file = match file_elements::most(image, opcode, operands) {
                    0 => 0,
                    most => most.saturating_mul(cost(Work::FileElement(opcode))),
                };
                (
                    cost(Work::Instruction(opcode)).saturating_add(file),
                    if opcode == Opcode::Jsr { subroutine(image.image(), record, operands) } else { None },
                )
            }
            // An admitted image holds no such code.
            Err(_) => (u64::MAX, None),
        };
        elements.push(Element { rung, cost, call });
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

/// How often each element is repeated by backward jumps: each adds one pass from its label to itself.
fn repeats(
    elements: usize,
    labels: &BTreeMap<String, (usize, usize)>,
    jumps: &[(usize, usize, String)],
) -> impl Iterator<Item = u64> {
    let mut begins = alloc::vec![0_u64; elements];
    let mut ends = alloc::vec![0_u64; elements];
    for (at, rung, label) in jumps {
        let Some((target, target_rung)) = labels.get(label) else { continue };
        if target_rung > rung {
            continue;
        }
        for (counts, at) in [(&mut begins, *target), (&mut ends, *at)] {
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

fn decoded(image: &Image, operand: OperandIndex) -> Option<OperandRecord> {
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
