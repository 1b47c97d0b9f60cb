//! A safety instruction does not read its own backing tag. dual-channel-inputs.md 1.2, C3; muting-and-outputs.md 1.1;
//! v14-and-metal-form.md 1.4.

use crate::diagnostic::{Finding, Findings};
use crate::project::{Call, Project};
use crate::rules::usage;

rule! {
    /// A member of a backing tag among the operands of its own call.
    "S0608", Error, "a safety instruction has a member of its own tag as operand",
    "An instruction writes its tag while it executes: what an operand out of that tag would read is not defined, and the maker's controller may stop with a fault that cannot be cleared. Copy the member to a tag of your own on a rung before, or name what the operand really depends on.",
    "dual-channel-inputs.md 1.2; muting-and-outputs.md 1.1; v14-and-metal-form.md 1.4",
    good: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S, Seen : BOOL (Class := Safety);\n", "      N: XIC(E.O1)OTE(Seen);\n      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,<<E.InputStatus>>,R);\n")
}

/// Every operand of a safety instruction, what its subscripts read included.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any_safety() {
        return;
    }
    usage::accesses(project, &mut |access| {
        let is_safety = matches!(access.instruction.call, Call::Catalog(declaration) if declaration.safety.is_some());
        if !is_safety || access.operand == 0 {
            return;
        }
        let backing = access.instruction.operands.first().and_then(|one| project.operand(one.id).reference());
        let own = backing.is_some_and(|backing| {
            backing.root == access.reference.root && access.reference.steps.starts_with(&backing.steps)
        });
        if own {
            let name = usage::name_of(project, access.reference);
            let message = format!("`{name}` belongs to the tag of this very call");
            findings.push(Finding::new(&CODE, access.span, message).help("name a tag of your own"));
        }
    });
}
