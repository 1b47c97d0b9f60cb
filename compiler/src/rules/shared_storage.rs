//! Storage bits of one-shots. general-instructions.md A.1.

use twinrung_catalog::Opcode;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::project::Project;
use crate::rules::usage::{self, Cell, CellKey};

rule! {
    /// A storage bit with a second writer.
    "W0103", Warning, "a storage bit has a second user",
    "The storage bit of ONS, OSR and OSF remembers the last rung condition of that one instruction. A second writer makes edges appear or vanish. Give each one-shot a bit of its own.",
    "general-instructions.md A.1",
    good: sample!("    A, B, S1, S2, Run : BOOL (Class := Safety);\n", "      N: XIC(A)ONS(S1)OTL(Run);\n      N: XIC(B)ONS(S2)OTU(Run);\n"),
    bad: sample!("    A, B, S1, Run : BOOL (Class := Safety);\n", "      N: XIC(A)ONS(S1)OTL(Run);\n      N: XIC(B)ONS(<<S1>>)OTU(Run);\n")
}

/// Storage bits against every writer.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&[Opcode::Ons, Opcode::Osr, Opcode::Osf]) {
        return;
    }
    let mut storage: Map<CellKey, Span> = Map::default();
    let mut others: Vec<(CellKey, Span)> = Vec::new();
    usage::accesses(project, &mut |access| {
        if !access.writes {
            return;
        }
        let Some(cell) = access.cell() else { return };
        let one_shot = matches!(access.instruction.call.opcode(), Some(Opcode::Ons | Opcode::Osr | Opcode::Osf));
        if one_shot && access.operand == 0 {
            match storage.get(&cell) {
                Some(_) => others.push((cell, access.span)),
                None => {
                    storage.insert(cell, access.span);
                    // A number that is written as a whole is written with all its bits.
                    if let (base, owner, Cell::WordBit(word, _)) = cell {
                        storage.entry((base, owner, Cell::Word(word))).or_insert(access.span);
                    }
                }
            }
        } else {
            others.push((cell, access.span));
        }
    });
    for (cell, span) in others {
        if let Some(first) = storage.get(&cell) {
            let finding = Finding::new(&CODE, span, "the storage bit of a one-shot is written here too");
            let finding = finding.label(*first, "the one-shot that stores its edge in it");
            findings.push(finding.help("give each one-shot a storage bit of its own"));
        }
    }
}
