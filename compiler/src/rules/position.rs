//! Where instructions stand on a rung. general-instructions.md A.8.

use twinrung_catalog::{Opcode, Position};

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::{Element, Instruction, Project, RoutineOwner, Rung};
use crate::rules::usage;

rule! {
    /// An instruction in the wrong place.
    "E0404", Error, "an instruction stands in the wrong place",
    "LBL and SBR are the first instruction of a rung (SBR of a routine's first rung); nothing follows a JMP or an MCR on its path. Within an Add-On Instruction there is no SBR, and RET returns nothing.",
    "general-instructions.md A.8 (JMP decided)",
    good: sample!("    A, B : BOOL (Class := Safety);\n", "      N: XIC(A)JMP(Skip);\n      N: OTE(B);\n      N: LBL(Skip)NOP();\n"),
    bad: sample!("    A, B : BOOL (Class := Safety);\n", "      N: XIC(A)<<JMP(Skip)>>OTE(B);\n      N: LBL(Skip)NOP();\n")
}

/// Every rung.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    usage::rungs(project, &mut |routine, number, rung| {
        let in_add_on = matches!(project.routine(routine).owner, RoutineOwner::AddOn(_));
        first(rung, number, in_add_on, findings);
        last(project, &rung.elements, in_add_on, findings);
    });
}

fn first(rung: &Rung, number: u32, in_add_on: bool, findings: &mut Findings) {
    rung.visit(&mut |instruction| {
        if instruction.call.position() != Position::First {
            return;
        }
        let is_first = matches!(rung.elements.first(), Some(Element::Instruction(one)) if one.element == instruction.element)
            && instruction.element == 0;
        let is_sbr = instruction.call.opcode() == Some(Opcode::Sbr);
        if is_sbr && in_add_on {
            let finding = Finding::new(&CODE, instruction.span, "an Add-On Instruction receives its values by its parameters, not by SBR");
            findings.push(finding.help("declare parameters"));
        } else if !is_first {
            let name = if is_sbr { "SBR" } else { "LBL" };
            let message = format!("{name} is not the first instruction of its rung");
            findings.push(Finding::new(&CODE, instruction.span, message).help("put it at the beginning of a rung"));
        } else if is_sbr && number > 0 {
            let finding = Finding::new(&CODE, instruction.span, "SBR does not stand on the first rung of its routine");
            findings.push(finding.help("move it to the first rung"));
        }
    });
}

/// The depth of branches is limited.
fn last(project: &Project, elements: &[Element], in_add_on: bool, findings: &mut Findings) {
    let count = elements.len();
    for (at, element) in elements.iter().enumerate() {
        match element {
            Element::Branch(branch) => branch.legs.iter().for_each(|leg| last(project, leg, in_add_on, findings)),
            Element::Instruction(instruction) => {
                let opcode = instruction.call.opcode();
                if matches!(opcode, Some(Opcode::Jmp | Opcode::Mcr)) && at + 1 < count {
                    let message = "something follows that would not be reached, or not as it reads";
                    findings.push(Finding::new(&CODE, instruction.span, message).help("put what follows on a rung of its own"));
                }
                if opcode == Some(Opcode::Ret) && in_add_on && returns(project, instruction) {
                    let finding = Finding::new(&CODE, instruction.span, "an Add-On Instruction returns its values by its parameters, not by RET");
                    findings.push(finding.help("write Output parameters, and RET()"));
                }
            }
        }
    }
}

fn returns(project: &Project, instruction: &Instruction) -> bool {
    instruction.operands.iter().any(|one| !matches!(project.operand(one.id), Operand::Unassigned))
}
