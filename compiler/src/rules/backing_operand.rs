//! An instruction does not take a member of its own backing tag. dual-channel-inputs.md 1.2, v14-and-metal-form.md 1.4.

use crate::diagnostic::{Finding, Findings};
use crate::operand::{Reference, Shape};
use crate::project::{Call, Project};
use crate::rules::usage;

rule! {
    /// A member of a backing tag as an operand of the call that it backs.
    "S0608", Error, "an instruction takes a member of its own backing tag",
    "The members of a backing tag change while their instruction executes: one that is an operand of the same call could be read before or after. Give the instruction a tag of your own; another instruction may read the member.",
    "1756-RM093 Tables 10 and 11; dual-channel-inputs.md 1.2 and C3",
    good: sample!("    M : DCI_MONITOR (Class := Safety);\n    E : DCI_STOP (Class := Safety);\n    A, B, C, D, R, S : BOOL (Class := Safety);\n", "      N: DCM(M,USER-DEFINED,EQUIVALENT - ACTIVE HIGH,500,A,B,S,R);\n      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,C,D,M.IS,R);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, S : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,S,<<E.FP>>);\n")
}

/// Every call of a safety instruction.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any_safety() {
        return;
    }
    usage::instructions(project, &mut |_, instruction| {
        let Call::Catalog(declaration) = instruction.call else { return };
        let [backing, operands @ ..] = &*instruction.operands else { return };
        let Some(own) = project.operand(backing.id).reference().filter(|_| declaration.safety.is_some()) else {
            return;
        };
        for (one, declared) in operands.iter().zip(declaration.operands.iter().skip(1)) {
            let Some(reference) = project.operand(one.id).reference() else { continue };
            if within(project, reference, own) {
                let name = usage::name_of(project, reference);
                let message = format!("`{name}` belongs to the very call that takes it as an operand");
                findings.push(Finding::new(&CODE, one.span, message).help(format!(
                    "give {} a tag that your logic or a module writes; a member of another instruction's backing tag will do",
                    declared.name
                )));
            }
        }
    });
}

/// Whether a reference reaches a cell of a structure.
fn within(project: &Project, inner: &Reference, outer: &Reference) -> bool {
    let (bits, words) = project.types.cells(outer.type_reference);
    let reaches = match inner.shape() {
        Shape::Bit => (outer.location.bit_cell..outer.location.bit_cell + bits).contains(&inner.location.bit_cell),
        _ => (outer.location.word_cell..outer.location.word_cell + words).contains(&inner.location.word_cell),
    };
    reaches && inner.location.base == outer.location.base
}
