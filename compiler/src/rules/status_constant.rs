//! A status operand that is always good. dual-channel-inputs.md C9.

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::{Call, Project};
use crate::rules::usage;

rule! {
    /// Input Status or Output Status that is the number 1.
    "W0120", Warning, "a status operand is always good",
    "With 1 in the place of its status a safety instruction takes the zeros of a lost connection for what the device says. Name the combined or point status of the module that the channels come from.",
    "dual-channel-inputs.md 1.6 and C9",
    good: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, S, R : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,<<1>>,R);\n")
}

/// Every call of a safety instruction.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any_safety() {
        return;
    }
    usage::instructions(project, &mut |_, instruction| {
        let Call::Catalog(declaration) = instruction.call else { return };
        for (declared, one) in declaration.operands.iter().zip(&instruction.operands) {
            let status = matches!(declared.name, "Input Status" | "Output Status");
            if status && matches!(project.operand(one.id), Operand::Integer { value: 1, .. }) {
                let message = format!(
                    "{} of {} is 1: a lost connection passes for good data",
                    declared.name, declaration.mnemonic
                );
                findings.push(Finding::new(&CODE, one.span, message).help("name the status of the module"));
            }
        }
    });
}
