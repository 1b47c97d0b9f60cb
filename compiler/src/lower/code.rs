//! Code bytes of every routine. See [`mod@twinrung_bytecode::format`].

use twinrung_bytecode::format;
use twinrung_bytecode::image::{Owner, RoutineRecord};

use super::operands::Interner;
use super::order::Order;
use crate::project::{Call, Element, Project, RoutineOwner};

/// The routines in the order of the image, without their texts.
pub(super) fn routines(project: &Project, order: &Order, operands: &mut Interner<'_>) -> Vec<RoutineRecord> {
    let mut list = Vec::with_capacity(order.routines.len());
    for id in &order.routines {
        let routine = project.routine(*id);
        let mut code = Vec::with_capacity(routine.rungs.len() * 48);
        for rung in &routine.rungs {
            code.push(format::RUNG);
            series(&rung.elements, operands, &mut code);
            code.push(format::END_RUNG);
        }
        list.push(RoutineRecord {
            owner: match routine.owner {
                RoutineOwner::Program(program) => Owner::Program(order.program(program)),
                RoutineOwner::AddOn(add_on) => Owner::AddOn(order.add_on(add_on)),
            },
            name: canonical_name(project, routine),
            code,
            text: String::new(),
        });
    }
    list
}

/// Routines of Add-On Instructions have fixed names.
fn canonical_name(project: &Project, routine: &crate::project::Routine) -> String {
    let _ = project;
    if let RoutineOwner::AddOn(_) = routine.owner {
        for name in ["Logic", "Prescan", "EnableInFalse"] {
            if routine.name.eq_ignore_ascii_case(name) {
                return name.to_owned();
            }
        }
    }
    routine.name.to_string()
}

/// Bounded by the depth of branches, which the grammar limits.
fn series(elements: &[Element], operands: &mut Interner<'_>, code: &mut Vec<u8>) {
    for element in elements {
        match element {
            Element::Instruction(instruction) => {
                code.push(match instruction.call {
                    Call::Catalog(declaration) => declaration.opcode as u8,
                    Call::AddOn(_) => format::ADD_ON,
                });
                code.push(instruction.operands.len() as u8);
                for one in &instruction.operands {
                    code.extend_from_slice(&operands.id(one.id).0.to_le_bytes());
                }
            }
            Element::Branch(branch) => {
                for (position, leg) in branch.legs.iter().enumerate() {
                    code.push(if position == 0 { format::BRANCH } else { format::NEXT_LEG });
                    series(leg, operands, code);
                }
                code.push(format::END_BRANCH);
            }
        }
    }
}
