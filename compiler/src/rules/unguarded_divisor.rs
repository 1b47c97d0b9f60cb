//! A divisor that may be 0. general-instructions.md A.9.

use twinrung_catalog::Opcode;

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::{Instruction, Project, Rung};
use crate::rules::usage;

rule! {
    /// A tag as divisor without a guard on its rung.
    "W0107", Warning, "a divisor may be 0",
    "DIV and MOD by 0 store a value that means nothing and log a minor fault; the rung goes on. Compare the divisor on the same rung before.",
    "general-instructions.md A.9",
    good: sample!("    A, B, C : DINT (Class := Safety);\n", "      N: NEQ(B,0)DIV(A,B,C);\n"),
    bad: sample!("    A, B, C : DINT (Class := Safety);\n", "      N: DIV(A,<<B>>,C);\n")
}

/// Every DIV and MOD by a tag.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&[Opcode::Div, Opcode::Mod]) {
        return;
    }
    usage::rungs(project, &mut |_, _, rung| {
        rung.visit(&mut |instruction| {
            if !matches!(instruction.call.opcode(), Some(Opcode::Div | Opcode::Mod)) {
                return;
            }
            let Some(divisor) = instruction.operands.get(1) else { return };
            let Operand::Reference(reference) = project.operand(divisor.id) else { return };
            if !is_guarded(project, rung, instruction, reference) {
                let message = format!("nothing on the rung keeps `{}` from being 0", usage::name_of(project, reference));
                findings.push(Finding::new(&CODE, divisor.span, message).help("put NEQ, GRT or LIM on the divisor before"));
            }
        });
    });
}

/// Whether a comparison before it on the rung looks at the divisor.
fn is_guarded(project: &Project, rung: &Rung, division: &Instruction, divisor: &crate::operand::Reference) -> bool {
    let mut guarded = false;
    rung.visit(&mut |instruction| {
        let compares = matches!(
            instruction.call.opcode(),
            Some(Opcode::Neq | Opcode::Grt | Opcode::Les | Opcode::Geq | Opcode::Leq | Opcode::Lim | Opcode::Cmp)
        );
        guarded |= compares
            && instruction.element < division.element
            && instruction.operands.iter().any(|one| match project.operand(one.id) {
                Operand::Reference(reference) => reference.is_same_data(divisor),
                Operand::Expression(expression) => {
                    let mut found = false;
                    expression.visit(&mut |reference| found |= reference.is_same_data(divisor));
                    found
                }
                _ => false,
            });
    });
    guarded
}
