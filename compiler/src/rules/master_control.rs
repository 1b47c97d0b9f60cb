//! Zones of MCR. general-instructions.md A.8 (pairing decided).

use twinrung_catalog::{Opcode, Position};

use crate::diagnostic::{Finding, Findings};
use crate::project::{Element, Project, RoutineOwner, Rung};

rule! {
    /// A zone of MCR that does not end as it should.
    "S0607", Error, "a zone of MCR is not closed as it should be",
    "A zone begins with an MCR behind a condition and ends with an unconditional MCR on the same routine; zones do not nest. A zone that stays open would silently disable what follows. An Add-On Instruction has no zones: the override belongs to the program, and an MCR within the instruction would switch it for its callers.",
    "general-instructions.md A.8 (decided)",
    good: sample!("    A, B : BOOL (Class := Safety);\n", "      N: XIC(A)MCR();\n      N: OTE(B);\n      N: MCR();\n"),
    bad: sample!("    A, B : BOOL (Class := Safety);\n", "      N: XIC(A)<<MCR()>>;\n      N: OTE(B);\n")
}

/// The zones of every routine.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&[Opcode::Mcr]) {
        return;
    }
    for routine in &project.routines {
        let mut open = None;
        for rung in &routine.rungs {
            let mut spans = Vec::new();
            rung.visit(&mut |instruction| {
                if instruction.call.opcode() == Some(Opcode::Mcr) {
                    spans.push(instruction.span);
                }
            });
            let Some(span) = spans.first().copied() else { continue };
            if matches!(routine.owner, RoutineOwner::AddOn(_)) {
                let finding = Finding::new(&CODE, span, "an Add-On Instruction has no MCR zones: this would switch the zone of its callers");
                findings.push(finding.help("use the EnableIn of the call, or a contact on each rung"));
                continue;
            }
            if let Some(second) = spans.get(1) {
                let finding = Finding::new(&CODE, *second, "a second MCR on one rung");
                findings.push(finding.help("write each MCR on a rung of its own"));
            }
            match (open, is_unconditional(rung)) {
                (None, false) => open = Some(span),
                (None, true) => {
                    let finding = Finding::new(&CODE, span, "this MCR ends a zone that was not begun");
                    findings.push(finding.help("begin the zone with an MCR behind a condition, or delete this one"));
                }
                (Some(_), true) => open = None,
                (Some(first), false) => {
                    let finding = Finding::new(&CODE, span, "a zone begins within a zone, or ends on a condition");
                    let finding = finding.label(first, "the zone begins here");
                    findings.push(finding.help("end the zone with an MCR alone on its rung"));
                    open = None;
                }
            }
        }
        if let Some(span) = open {
            let finding = Finding::new(&CODE, span, "the zone that begins here is not closed in this routine");
            findings.push(finding.help("end it with an MCR alone on its rung"));
        }
    }
}

/// Whether nothing on the rung can make it false before its MCR.
fn is_unconditional(rung: &Rung) -> bool {
    rung.elements.iter().all(|element| match element {
        Element::Instruction(instruction) => instruction.call.position() != Position::Input,
        Element::Branch(_) => false,
    })
}
