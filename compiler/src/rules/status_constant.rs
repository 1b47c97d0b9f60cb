//! A status operand that is always good. dual-channel-inputs.md C9.

use twinrung_catalog::STATUS_OPERANDS;

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::Project;
use crate::rules::usage;

rule! {
    /// Input Status or Output Status that is the number 1.
    "W0120", Warning, "a status operand is always good",
    "With 1 in the place of its status a safety instruction takes the zeros of a lost connection for what the device says. Name the combined or point status of the module that the channels come from.",
    "dual-channel-inputs.md 1.6 and C9",
    good: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, S, R : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,<<1>>,R);\n")
}

/// Every operand of a safety instruction.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    usage::safety_operands(project, &mut |one| {
        let status = STATUS_OPERANDS.contains(&one.name);
        if status && matches!(one.operand, Operand::Integer { value: 1, .. }) {
            let message = format!("{} of {} is 1: a lost connection passes for good data", one.name, one.mnemonic);
            findings.push(Finding::new(&CODE, one.span, message).help("name the status of the module"));
        }
    });
}
