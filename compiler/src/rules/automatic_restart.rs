//! Automatic restart and cold start. dual-channel-inputs.md 1.3.

use twinrung_catalog::OperandKind;

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::{Call, Project};
use crate::rules::usage;

rule! {
    /// A safety instruction that restarts by itself.
    "W0109", Warning, "a safety function restarts by itself",
    "With automatic restart the output returns as soon as the device is released, with automatic cold start at power-up. That is admitted only where nobody can stand in the hazard unseen and another condition prevents an unexpected start.",
    "1756-RM093 Tables 10 and 11; dual-channel-inputs.md 1.3",
    good: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,<<AUTOMATIC>>,MANUAL,A,B,S,R);\n")
}

/// Every safety instruction with a restart choice.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any_safety() {
        return;
    }
    usage::instructions(project, &mut |_, instruction| {
        let Call::Catalog(declaration) = instruction.call else { return };
        if declaration.safety.is_none() {
            return;
        }
        for (declared, one) in declaration.operands.iter().zip(&instruction.operands) {
            let (OperandKind::Choice(list), Operand::Choice(value)) = (declared.kind, project.operand(one.id)) else {
                continue;
            };
            let restarts = matches!(declared.name, "Restart Type" | "Cold Start Type" | "Reset Type");
            if restarts && list.word(*value) == Some("AUTOMATIC") {
                let message = format!("{} of `{}` is automatic", declared.name, declaration.mnemonic);
                let help = "choose MANUAL, or show in the risk assessment why nobody can be in the hazard";
                findings.push(Finding::new(&CODE, one.span, message).help(help));
            }
        }
    });
}
