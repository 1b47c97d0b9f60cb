//! EnableIn of a safety instruction is not referenced. dual-channel-inputs.md 2.

use twinrung_bytecode::image::TypeReference;
use twinrung_catalog::MemberRole;

use crate::diagnostic::{Finding, Findings};
use crate::operand::Step;
use crate::project::Project;
use crate::rules::usage;

rule! {
    /// EnableIn of a backing tag in logic.
    "S0603", Error, "logic references EnableIn of a safety instruction",
    "EnableIn mirrors the rung condition and belongs to the instruction alone. Use EnableOut, or the condition itself.",
    "dual-channel-inputs.md 2",
    good: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S, Run : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n      N: XIC(E.EnableOut)OTE(Run);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, R, S, Run : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,R);\n      N: XIC(<<E.EnableIn>>)OTE(Run);\n")
}

/// References that end in such a member.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any_safety() {
        return;
    }
    usage::accesses(project, &mut |access| {
        let Some(Step::Member(member)) = access.reference.steps.last() else { return };
        let path = usage::types_on_path(project, access.reference);
        let Some(TypeReference::Structure(_)) = path.iter().rev().nth(1) else { return };
        let Some(known) = path.iter().rev().nth(1).and_then(|parent| project.types.predefined(*parent)) else { return };
        if known.members.get(usize::from(*member)).is_some_and(|member| member.role == MemberRole::Internal) {
            let message = format!("`{}` is private to its instruction", usage::name_of(project, access.reference));
            findings.push(Finding::new(&CODE, access.span, message).help("use EnableOut, or the rung's own condition"));
        }
    });
}
