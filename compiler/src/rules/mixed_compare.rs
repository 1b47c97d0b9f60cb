//! DINT beside REAL. general-instructions.md A.4.

use twinrung_catalog::{Element, Opcode};

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::Project;
use crate::rules::usage;

rule! {
    /// A DINT compared with a REAL.
    "W0113", Warning, "a DINT is compared with a REAL",
    "The DINT is converted to REAL, which has 24 bits of precision: two large values that differ may compare equal. Compare values of one type.",
    "general-instructions.md A.4",
    good: sample!("    A, B : DINT (Class := Safety);\n    C : BOOL (Class := Safety);\n", "      N: EQU(A,B)OTE(C);\n"),
    bad: sample!("    A : DINT (Class := Safety);\n    B : REAL (Class := Safety);\n    C : BOOL (Class := Safety);\n", "      N: EQU(<<A>>,B)OTE(C);\n")
}

/// Compare instructions with both.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let real = |operand: &Operand| match operand {
        Operand::Real(_) => true,
        Operand::Reference(reference) => reference.element() == Some(Element::Real),
        _ => false,
    };
    if !project.operands.iter().any(real) {
        return;
    }
    usage::instructions(project, &mut |_, instruction| {
        let compares = matches!(
            instruction.call.opcode(),
            Some(Opcode::Equ | Opcode::Neq | Opcode::Grt | Opcode::Geq | Opcode::Les | Opcode::Leq | Opcode::Lim)
        );
        if !compares {
            return;
        }
        let element = |operand: &Operand| match operand {
            Operand::Real(_) => Some(Element::Real),
            Operand::Reference(reference) => reference.element(),
            _ => None,
        };
        let any_real = instruction.operands.iter().any(|one| element(project.operand(one.id)) == Some(Element::Real));
        let dint = instruction.operands.iter().find(|one| element(project.operand(one.id)) == Some(Element::Dint));
        if let (true, Some(one)) = (any_real, dint) {
            let finding = Finding::new(&CODE, one.span, "this DINT is compared as a REAL and loses its low bits above 16777216");
            findings.push(finding.help("compare values of one type"));
        }
    });
}
