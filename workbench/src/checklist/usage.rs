//! On which rungs a tag, or one value of it, is used.

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::Position;
use twinrung_compiler::operand::{LocationBase, Operand, Reference};
use twinrung_compiler::project::{Call, Project, RoutineId, TagId};

/// What is looked for: a tag, or one BOOL or number within it.
#[derive(Debug, Clone, Copy)]
pub struct Sought {
    /// The tag.
    pub tag: TagId,
    /// Its first bit cell and word cell, with the type there; nothing for any part of the tag.
    pub cell: Option<(u32, u32, TypeReference)>,
}

/// Rungs as `Program/Routine rung 3`, each once: those that only look at it, and those that act on it.
#[derive(Debug, Default)]
pub struct Uses {
    /// Where an input instruction has it as an operand, or a box takes it.
    pub read: Vec<String>,
    /// Where an output instruction has it as an operand.
    pub acted_on: Vec<String>,
}

/// Looks through all rungs.
pub fn uses(project: &Project, sought: Sought) -> Uses {
    let mut uses = Uses::default();
    for (position, routine) in project.routines.iter().enumerate() {
        for (number, rung) in routine.rungs.iter().enumerate() {
            rung.visit(&mut |instruction| {
                let mentioned = instruction.operands.iter().any(|one| mentions(project.operand(one.id), sought));
                if !mentioned {
                    return;
                }
                let output = instruction.call.position() != Position::Input;
                let is_box = matches!(instruction.call, Call::AddOn(_)) || instruction.operands.len() > 1;
                let list = if output && !is_box { &mut uses.acted_on } else { &mut uses.read };
                let place = format!("{} rung {number}", project.routine_name(RoutineId(position as u32)));
                if list.last() != Some(&place) {
                    list.push(place);
                }
            });
        }
    }
    uses.read.sort();
    uses.acted_on.sort();
    uses
}

fn mentions(operand: &Operand, sought: Sought) -> bool {
    match operand {
        Operand::Reference(reference) => {
            let mut found = false;
            reference.visit(&mut |one| found |= is_it(one, sought));
            found
        }
        Operand::Expression(expression) => {
            let mut found = false;
            expression.visit(&mut |one| found |= is_it(one, sought));
            found
        }
        _ => false,
    }
}

fn is_it(reference: &Reference, sought: Sought) -> bool {
    if reference.location.base != LocationBase::Tag(sought.tag) {
        return false;
    }
    match (sought.cell, reference.type_reference) {
        (None, _) | (_, TypeReference::Structure(_)) => true,
        (Some((bit, word, type_reference)), own) => {
            own == type_reference && reference.location.bit_cell == bit && reference.location.word_cell == word
        }
    }
}
