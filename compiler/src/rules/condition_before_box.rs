//! Conditions before a safety instruction. dual-channel-inputs.md 1.1.

use twinrung_catalog::Position;

use crate::diagnostic::{Finding, Findings};
use crate::project::{Call, Element, Project};
use crate::rules::usage;

rule! {
    /// A condition before a safety instruction.
    "W0108", Warning, "a condition stands before a safety instruction",
    "While its rung is false a safety instruction switches its outputs off and does not watch its device: faults pass unseen. Leave its rung unconditional, and put conditions behind its outputs.",
    "dual-channel-inputs.md 1.1; 1756-RM093 Tables 10 and 11",
    good: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S, Run : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n      N: XIC(E.O1)OTE(Run);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S, Run : BOOL (Class := Safety);\n", "      N: XIC(Run)<<DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R)>>;\n")
}

/// Every rung with a safety instruction.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any_safety() {
        return;
    }
    usage::rungs(project, &mut |_, _, rung| {
        let mut boxes = false;
        rung.visit(&mut |instruction| {
            boxes |= matches!(instruction.call, Call::Catalog(declaration) if declaration.safety.is_some());
        });
        if boxes {
            series(&rung.elements, false, findings);
        }
    });
}

/// Walks a series; whether an input instruction stands before. The depth of branches is limited.
fn series(elements: &[Element], mut conditioned: bool, findings: &mut Findings) -> bool {
    for element in elements {
        match element {
            Element::Branch(branch) => {
                let mut any = false;
                for leg in &branch.legs {
                    any |= series(leg, conditioned, findings);
                }
                conditioned |= any;
            }
            Element::Instruction(instruction) => match instruction.call {
                Call::Catalog(declaration) if declaration.safety.is_some() => {
                    if conditioned {
                        let message = format!("{} is watched only while the condition before it is true", declaration.mnemonic);
                        let help = "put the condition behind its outputs";
                        findings.push(Finding::new(&CODE, instruction.span, message).help(help));
                    }
                }
                call => conditioned |= call.position() == Position::Input,
            },
        }
    }
    conditioned
}
