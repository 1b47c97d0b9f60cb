//! Two OTEs on one bit. neutral-text-and-l5x.md D.10.

use twinrung_catalog::Opcode;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::project::Project;
use crate::rules::usage::{self, CellKey};

rule! {
    /// A bit with a coil and another writer.
    "W0101", Warning, "a coil is not the only writer of its bit",
    "OTE writes its bit in every scan: of two coils on one bit the last one decides, and a latch beside a coil is overwritten. Join the conditions on one rung.",
    "neutral-text-and-l5x.md D.10 (7)",
    good: sample!("    A, B, Run : BOOL (Class := Safety);\n", "      N: [XIC(A) ,XIC(B) ]OTE(Run);\n"),
    bad: sample!("    A, B, Run : BOOL (Class := Safety);\n", "      N: XIC(A)OTE(Run);\n      N: XIC(B)OTE(<<Run>>);\n")
}

/// Every written bit that has a coil.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let mut coils: Map<CellKey, Span> = Map::default();
    let mut others: Vec<(CellKey, Span, String)> = Vec::new();
    usage::accesses(project, &mut |access| {
        if !access.writes {
            return;
        }
        let Some(cell) = access.cell() else { return };
        let name = || usage::name_of(project, access.reference);
        if access.instruction.call.opcode() == Some(Opcode::Ote) {
            match coils.get(&cell) {
                Some(first) => {
                    let finding = Finding::new(&CODE, access.span, format!("`{}` has a second coil", name()));
                    let finding = finding.label(*first, "the first coil");
                    findings.push(finding.help("join the conditions on one rung: the last coil decides alone"));
                }
                None => {
                    coils.insert(cell, access.span);
                }
            }
        } else {
            others.push((cell, access.span, String::new()));
        }
    });
    for (cell, span, _) in others {
        if let Some(coil) = coils.get(&cell) {
            let finding = Finding::new(&CODE, span, "this bit has a coil and is written here too").label(*coil, "the coil");
            findings.push(finding.help("let one instruction write the bit"));
        }
    }
}
