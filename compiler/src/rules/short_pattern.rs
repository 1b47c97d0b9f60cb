//! Bit patterns beside signed words. general-instructions.md 2.2.

use twinrung_catalog::{Element, Group, OperandKind};

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::{Call, Project};
use crate::rules::usage;

rule! {
    /// A short bit pattern compared with a SINT or INT.
    "W0112", Warning, "a bit pattern meets a signed word",
    "16#FFFF is 65535 and never equals an INT, which is sign-extended: an INT of that pattern is -1. Write the decimal value, or all 32 bits.",
    "general-instructions.md 2.2",
    good: sample!("    A : INT (Class := Safety);\n    B : BOOL (Class := Safety);\n", "      N: EQU(A,-1)OTE(B);\n"),
    bad: sample!("    A : INT (Class := Safety);\n    B : BOOL (Class := Safety);\n", "      N: EQU(A,<<16#FFFF>>)OTE(B);\n")
}

/// Compare and math instructions that sign-extend.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.operands.iter().any(|one| matches!(one, Operand::Integer { radix, .. } if *radix != 10)) {
        return;
    }
    usage::instructions(project, &mut |_, instruction| {
        let Call::Catalog(declaration) = instruction.call else { return };
        if !matches!(declaration.group, Group::Compare | Group::Math) {
            return;
        }
        let narrow = instruction.operands.iter().find_map(|one| {
            let element = project.operand(one.id).reference()?.element()?;
            matches!(element, Element::Sint | Element::Int).then_some(element)
        });
        let Some(narrow) = narrow else { return };
        for (at, one) in instruction.operands.iter().enumerate() {
            let extends = declaration.operand(at).is_some_and(|declared| matches!(declared.kind, OperandKind::Number(_)));
            let Operand::Integer { value, radix } = project.operand(one.id) else { continue };
            let sign = 1i32 << (narrow.bits() - 1);
            if extends && *radix != 10 && *value >= sign {
                let message = format!("this pattern is {value}, which no {} has", narrow.name());
                findings.push(Finding::new(&CODE, one.span, message).help("write the decimal value, or the pattern with all 32 bits"));
            }
        }
    });
}
