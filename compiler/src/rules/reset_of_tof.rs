//! RES on the timer of a TOF. general-instructions.md A.2 (decided).

use twinrung_catalog::Opcode;

use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::operand::LocationBase;
use crate::project::{AddOnId, Project, RoutineOwner};
use crate::rules::usage;

rule! {
    /// RES on the timer of a TOF.
    "S0606", Error, "RES resets the timer of a TOF",
    "RES clears DN and ACC: on the timer of a TOF that ends the delay at once, and what it kept on goes off, or stays on, at the wrong time. Use a TON with a latch.",
    "general-instructions.md A.2 (the manual warns; error decided)",
    good: sample!("    A, B : BOOL (Class := Safety);\n    T : TIMER (Class := Safety);\n", "      N: XIC(A)RTO(T,500,0);\n      N: XIC(B)RES(T);\n"),
    bad: sample!("    A, B : BOOL (Class := Safety);\n    T : TIMER (Class := Safety);\n", "      N: XIC(A)TOF(T,500,0);\n      N: XIC(B)RES(<<T>>);\n")
}

/// Every RES against every TOF.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&[Opcode::Tof]) {
        return;
    }
    let mut timers: Map<(LocationBase, Option<AddOnId>, u32), twinrung_grammar::tree::Span> = Map::default();
    let mut resets = Vec::new();
    usage::instructions(project, &mut |place, instruction| {
        let opcode = instruction.call.opcode();
        if !matches!(opcode, Some(Opcode::Tof | Opcode::Res)) {
            return;
        }
        let Some(one) = instruction.operands.first() else { return };
        let Some(reference) = project.operand(one.id).reference().filter(|one| one.is_constant()) else { return };
        let owner = match project.routine(place.routine).owner {
            RoutineOwner::AddOn(add_on) => Some(add_on),
            RoutineOwner::Program(_) => None,
        };
        let key = (reference.location.base, owner, reference.location.word_cell);
        if opcode == Some(Opcode::Tof) {
            timers.insert(key, instruction.span);
        } else {
            resets.push((key, one.span, usage::name_of(project, reference)));
        }
    });
    for (key, span, name) in resets {
        if let Some(tof) = timers.get(&key) {
            let finding = Finding::new(&CODE, span, format!("`{name}` is the timer of a TOF")).label(*tof, "the TOF");
            findings.push(finding.help("do not reset it; use a TON with a latch where the delay must end early"));
        }
    }
}
