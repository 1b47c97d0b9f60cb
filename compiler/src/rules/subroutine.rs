//! Parameters of subroutines. general-instructions.md A.8 (counts and types decided).

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::{Element, Opcode};
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::{Instruction, OperandUse, Project, RoutineId, RoutineOwner};
use crate::rules::usage;

rule! {
    /// Parameters that do not match.
    "E0405", Error, "parameters of a subroutine do not match",
    "The inputs of a JSR match the operands of the routine's SBR in number, order and type, and its returns those of every RET. Nothing is converted: a literal integer is a DINT.",
    "general-instructions.md A.8 (decided)",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    A, B, C : DINT (Class := Safety);\n    F : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: JSR(Part,1,A,B);\n    END_ROUTINE\n    ROUTINE Part\n      N: SBR(C)NOP();\n      N: RET(C);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    A, B, C : DINT (Class := Safety);\n    F : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: <<JSR(Part,1,F,B)>>;\n    END_ROUTINE\n    ROUTINE Part\n      N: SBR(C)NOP();\n      N: RET(C);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

type Passed = (TypeReference, [u32; 3]);

/// What a routine receives and returns.
#[derive(Default, Clone)]
struct Signature {
    receives: Vec<Passed>,
    sbr: Option<Span>,
    returns: Option<(Vec<Passed>, Span)>,
}

fn passed(project: &Project, one: &OperandUse) -> Option<Passed> {
    match project.operand(one.id) {
        Operand::Integer { .. } => Some((TypeReference::Element(Element::Dint), [0; 3])),
        Operand::Real(_) => Some((TypeReference::Element(Element::Real), [0; 3])),
        Operand::Reference(reference) if reference.location.bit.is_some() => {
            Some((TypeReference::Element(Element::Bool), [0; 3]))
        }
        Operand::Reference(reference) => Some((reference.type_reference, reference.dimensions)),
        _ => None,
    }
}

fn list(project: &Project, uses: &[OperandUse]) -> Vec<Passed> {
    uses.iter().filter_map(|one| passed(project, one)).collect()
}

/// Every JSR against the SBR and RETs of its routine.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&[Opcode::Jsr, Opcode::Sbr, Opcode::Ret]) {
        return;
    }
    let mut signatures = vec![Signature::default(); project.routines.len()];
    let mut calls: Vec<(RoutineId, &Instruction)> = Vec::new();
    usage::instructions(project, &mut |place, instruction| {
        if matches!(project.routine(place.routine).owner, RoutineOwner::AddOn(_)) {
            return;
        }
        let signature = &mut signatures[place.routine.position()];
        match instruction.call.opcode() {
            Some(Opcode::Sbr) => {
                signature.receives = list(project, &instruction.operands);
                signature.sbr = Some(instruction.span);
            }
            Some(Opcode::Ret) => {
                let returns = list(project, &instruction.operands);
                match &signature.returns {
                    None => signature.returns = Some((returns, instruction.span)),
                    Some((first, span)) if *first != returns => {
                        let message = "this RET returns other values than the one before it";
                        let finding = Finding::new(&CODE, instruction.span, message).label(*span, "the other RET");
                        findings.push(finding.help("let every RET of the routine return the same number and types"));
                    }
                    Some(_) => {}
                }
            }
            Some(Opcode::Jsr) => calls.push((place.routine, instruction)),
            _ => {}
        }
    });
    for (caller, instruction) in calls {
        judge(project, caller, instruction, &signatures, findings);
    }
}

fn judge(
    project: &Project,
    caller: RoutineId,
    instruction: &Instruction,
    signatures: &[Signature],
    findings: &mut Findings,
) {
    let Some(Operand::Routine(target)) = instruction.operands.first().map(|one| project.operand(one.id)) else { return };
    let Some(Operand::Integer { value, .. }) = instruction.operands.get(1).map(|one| project.operand(one.id)) else { return };
    let given = &instruction.operands[2..];
    let count = usize::try_from(*value).unwrap_or(0);
    if count > given.len() {
        let message = format!("{count} inputs are announced, and {} operands follow", given.len());
        findings.push(Finding::new(&CODE, instruction.operands[1].span, message).help("correct the number of inputs"));
        return;
    }
    let (inputs, returns) = given.split_at(count);
    if let RoutineOwner::Program(program) = project.routine(caller).owner {
        let number = match inputs {
            [one] => match project.operand(one.id) {
                Operand::Integer { value, .. } => *value,
                _ => 0,
            },
            _ => 0,
        };
        if project.program(program).fault == Some(*target) && returns.is_empty() && (990..=999).contains(&number) {
            return;
        }
    }
    let signature = &signatures[target.position()];
    let name = &project.routine(*target).name;
    if list(project, inputs) != signature.receives {
        let message = format!(
            "`{name}` receives {}, and {} are passed",
            texts(project, &signature.receives),
            texts(project, &list(project, inputs))
        );
        let finding = Finding::new(&CODE, instruction.span, message);
        let finding = match signature.sbr {
            Some(span) => finding.label(span, "what the routine receives"),
            None => finding.label(project.routine(*target).span, "the routine has no SBR"),
        };
        findings.push(finding.help("pass what SBR lists, in number, order and type"));
    }
    let expected = signature.returns.as_ref().map(|(list, _)| list.as_slice()).unwrap_or_default();
    if list(project, returns) != expected {
        let message = format!(
            "`{name}` returns {}, and {} are taken",
            texts(project, expected),
            texts(project, &list(project, returns))
        );
        let finding = Finding::new(&CODE, instruction.span, message);
        let finding = match &signature.returns {
            Some((_, span)) => finding.label(*span, "what the routine returns"),
            None => finding.label(project.routine(*target).span, "the routine has no RET"),
        };
        findings.push(finding.help("take what RET lists, in number, order and type"));
    }
}

fn texts(project: &Project, list: &[Passed]) -> String {
    if list.is_empty() {
        return "nothing".to_owned();
    }
    let one = |(reference, dimensions): &Passed| {
        let sizes: Vec<String> = dimensions.iter().take_while(|size| **size > 0).map(u32::to_string).collect();
        let name = project.types.name(*reference);
        if sizes.is_empty() { name.to_owned() } else { format!("{name}[{}]", sizes.join(",")) }
    };
    list.iter().map(one).collect::<Vec<_>>().join(", ")
}
