//! Two OTEs on one bit. neutral-text-and-l5x.md D.10.

use twinrung_catalog::Opcode;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::project::{Place, Project, RoutineId};
use crate::rules::usage::{self, CellKey};

rule! {
    /// A bit with a coil and another writer.
    "W0101", Warning, "a coil is not the only writer of its bit",
    "OTE writes its bit in every scan: of two coils on one bit the last one decides, and a latch beside a coil is overwritten. Join the conditions on one rung.",
    "neutral-text-and-l5x.md D.10 (7)",
    good: sample!("    A, B, Run : BOOL (Class := Safety);\n", "      N: [XIC(A) ,XIC(B) ]OTE(Run);\n"),
    bad: sample!("    A, B, Run : BOOL (Class := Safety);\n", "      N: XIC(A)OTE(Run);\n      N: XIC(B)OTE(<<Run>>);\n")
}

/// A bit, and within an Add-On Instruction its routine.
type Key = (CellKey, Option<RoutineId>);

/// Every written bit that has a coil.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let mut coils: Map<Key, (Span, Place)> = Map::default();
    let mut others: Vec<(Key, Span, Place, bool)> = Vec::new();
    usage::accesses(project, &mut |access| {
        if !access.writes {
            return;
        }
        let Some(cell) = access.cell() else { return };
        // Logic and EnableInFalse of an Add-On Instruction never run in the same call.
        let cell: Key = (cell, access.owner.map(|_| access.place.routine));
        let name = || usage::name_of(project, access.reference);
        if access.instruction.call.opcode() == Some(Opcode::Ote) {
            match coils.get(&cell) {
                Some((first, _)) => {
                    let finding = Finding::new(&CODE, access.span, format!("`{}` has a second coil", name()));
                    let finding = finding.label(*first, "the first coil");
                    findings.push(finding.help("join the conditions on one rung: the last coil decides alone"));
                }
                None => {
                    coils.insert(cell, (access.span, access.place));
                }
            }
        } else {
            let unlatches = access.instruction.call.opcode() == Some(Opcode::Otu);
            others.push((cell, access.span, access.place, unlatches));
        }
    });
    for (cell, span, place, unlatches) in others {
        if let Some((coil, coil_place)) = coils.get(&cell) {
            // A later OTU can only switch off what the coil switched on: Appendix F of 1756-RM093 does it.
            if unlatches && place.routine == coil_place.routine && place > *coil_place {
                continue;
            }
            let finding = Finding::new(&CODE, span, "this bit has a coil and is written here too").label(*coil, "the coil");
            findings.push(finding.help("let one instruction write the bit"));
        }
    }
}
