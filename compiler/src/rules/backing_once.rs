//! A backing tag serves one call. dual-channel-inputs.md 1.1.

use twinrung_bytecode::image::{TypeReference, Usage as Direction};
use twinrung_bytecode::index::TypeIndex;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::operand::{LocationBase, Reference};
use crate::project::{AddOnId, Call, Instruction, Project, RoutineOwner};
use crate::rules::usage;

rule! {
    /// A backing tag that serves two calls.
    "S0601", Error, "a backing tag serves two calls",
    "The tag of a safety instruction holds the state of one device: two calls on one tag would overwrite each other's edges, times and faults. The same holds for an Add-On Instruction that has such an instruction within it. Give each call a tag of its own.",
    "1756-RM093 Tables 10 and 11; dual-channel-inputs.md 1.1",
    good: sample!("    E, F : DCI_STOP (Class := Safety);\n    A, B, C, D, R, S : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n      N: DCS(F,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,C,D,S,R);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, C, D, R, S : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n      N: DCS(<<E>>,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,C,D,S,R);\n")
}

/// Backing data as one call uses it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Use {
    base: LocationBase,
    bit_cell: u32,
    word_cell: u32,
    /// The structure; two that begin at one cell are different data when their types differ.
    structure: Option<TypeIndex>,
}

/// What the logic of an Add-On Instruction uses of its instance and of its InOut parameters.
#[derive(Default, Clone)]
struct Summary {
    instance: bool,
    in_out: Vec<(u16, Use)>,
}

/// Every call, those of Add-On Instructions through to the data that they are given.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any_safety() {
        return;
    }
    let mut summaries: Vec<Summary> = vec![Summary::default(); project.add_ons.len()];
    for add_on in in_call_order(project) {
        let mut seen = Map::default();
        for routine in &project.routines {
            if routine.owner == RoutineOwner::AddOn(add_on) {
                for rung in &routine.rungs {
                    rung.visit(&mut |instruction| of_call(project, instruction, &summaries, &mut seen, findings));
                }
            }
        }
        let summary = &mut summaries[add_on.position()];
        for used in seen.into_keys() {
            match used.base {
                LocationBase::Instance => summary.instance = true,
                LocationBase::InOut(parameter) => summary.in_out.push((parameter, used)),
                LocationBase::Tag(_) => {}
            }
        }
        summary.in_out.sort_by_key(|(parameter, used)| (*parameter, used.bit_cell, used.word_cell));
    }
    let mut seen = Map::default();
    for routine in project.routines.iter().filter(|routine| matches!(routine.owner, RoutineOwner::Program(_))) {
        for rung in &routine.rungs {
            rung.visit(&mut |instruction| of_call(project, instruction, &summaries, &mut seen, findings));
        }
    }
}

/// Add-On Instructions, each after those that it calls; circles are refused elsewhere.
fn in_call_order(project: &Project) -> Vec<AddOnId> {
    let mut list = Vec::new();
    let graph = super::recursion::add_on_calls(project);
    let mut state = vec![0u8; project.add_ons.len()];
    for root in 0..project.add_ons.len() {
        let mut stack = vec![(root, 0)];
        while let Some((at, next)) = stack.pop() {
            if next == 0 {
                if state[at] != 0 {
                    continue;
                }
                state[at] = 1;
            }
            match graph[at].get(next) {
                Some((called, _)) => {
                    stack.push((at, next + 1));
                    if state[called.position()] == 0 {
                        stack.push((called.position(), 0));
                    }
                }
                None => {
                    state[at] = 2;
                    list.push(AddOnId(at as u16));
                }
            }
        }
    }
    list
}

fn of_call(
    project: &Project,
    instruction: &Instruction,
    summaries: &[Summary],
    seen: &mut Map<Use, Span>,
    findings: &mut Findings,
) {
    let Some(first) = instruction.operands.first() else { return };
    let Some(reference) = project.operand(first.id).reference() else { return };
    match instruction.call {
        Call::Catalog(declaration) if declaration.safety.is_some() => {
            if !reference.is_constant() {
                let message = "a variable subscript selects the backing tag";
                let help = "write a constant subscript: one tag belongs to one device";
                findings.push(Finding::new(&CODE, first.span, message).help(help));
                return;
            }
            insert(use_of(reference), first.span, &usage::name_of(project, reference), seen, findings);
        }
        Call::Catalog(_) => {}
        Call::AddOn(add_on) => {
            let summary = &summaries[add_on.position()];
            if summary.instance {
                insert(use_of(reference), first.span, &usage::name_of(project, reference), seen, findings);
            }
            let parameters = project.add_on(add_on).parameters.iter().enumerate().filter(|(_, one)| one.argument);
            for ((position, parameter), one) in parameters.zip(instruction.operands.iter().skip(1)) {
                if parameter.usage != Direction::InOut {
                    continue;
                }
                let Some(argument) = project.operand(one.id).reference() else { continue };
                for (_, used) in summary.in_out.iter().filter(|(at, _)| usize::from(*at) == position) {
                    let passed = Use {
                        base: argument.location.base,
                        bit_cell: argument.location.bit_cell + used.bit_cell,
                        word_cell: argument.location.word_cell + used.word_cell,
                        structure: used.structure,
                    };
                    insert(passed, one.span, &usage::name_of(project, argument), seen, findings);
                }
            }
        }
    }
}

fn use_of(reference: &Reference) -> Use {
    Use {
        base: reference.location.base,
        bit_cell: reference.location.bit_cell,
        word_cell: reference.location.word_cell,
        structure: match reference.type_reference {
            TypeReference::Structure(index) => Some(index),
            TypeReference::Element(_) => None,
        },
    }
}

fn insert(
    used: Use,
    span: Span,
    name: &str,
    seen: &mut Map<Use, Span>,
    findings: &mut Findings,
) {
    match seen.get(&used) {
        None => {
            seen.insert(used, span);
        }
        Some(first) => {
            let finding = Finding::new(&CODE, span, format!("the tag `{name}` serves another call already")).label(*first, "the first call");
            findings.push(finding.help("declare another tag of the same type, and give it to this call"));
        }
    }
}
