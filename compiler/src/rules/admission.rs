//! An instruction that this controller or revision does not admit. 1756-RM093 Table 12, footnote 1 and column "from".

use twinrung_catalog::{Family, Instruction, Requires};
use twinrung_grammar::tree::Name;

use crate::diagnostic::{Finding, Findings};
use crate::project::{Profile, Project};

/// First version that has safety Add-On Instructions (1756-RM093, neutral-text-and-l5x.md D.8).
const ADD_ON_INSTRUCTIONS_FROM: u16 = 18;

rule! {
    /// An instruction that this controller does not admit.
    "S0102", Error, "an instruction is not admitted on this controller",
    "Some certified instructions are certified for some controllers only, or from a revision of the firmware on: those that evaluate expressions or work on REAL are not for the 1756-L6xS and 1768-L4xS. `twinrung explain` of the instruction says from which version and on which controllers it is admitted. Use the instructions that compare or compute one step each, or another controller or revision.",
    "1756-RM093 Table 12, footnote 1; catalog of the certified set",
    good: sample!(on "1756-L73S", "20"; "    A : DINT (Class := Safety);\n    B : BOOL (Class := Safety);\n", "      N: CMP(A > 7)OTE(B);\n"),
    bad: sample!(on "1756-L63S", "20"; "    A : DINT (Class := Safety);\n    B : BOOL (Class := Safety);\n", "      N: <<CMP>>(A > 7)OTE(B);\n")
}

/// Whether a controller offers what something requires.
pub(crate) fn offers(profile: &Profile, requires: Requires) -> bool {
    match requires {
        Requires::Any => true,
        Requires::L7x => profile.controller.family == Family::L7x,
        Requires::Real => profile.has_real(),
    }
}

/// The finding, when the instruction is not admitted.
pub(crate) fn finding(profile: &Profile, declaration: &Instruction, mnemonic: &Name) -> Option<Finding> {
    let name = declaration.mnemonic;
    if !offers(profile, declaration.requires) {
        let message = format!("{name} is not admitted on the {}", profile.controller.catalog_number);
        let help = match declaration.requires {
            Requires::Real => "it works on REAL, which safety data of this controller may not be",
            Requires::Any | Requires::L7x => "compare with EQU, NEQ, GRT, GEQ, LES, LEQ or LIM, compute with ADD, SUB, MUL, DIV or MOV step by step, or take a 1756-L7xS or a later controller",
        };
        return Some(Finding::new(&CODE, mnemonic.span, message).help(help));
    }
    if profile.revision < u16::from(declaration.first_version) {
        let message =
            format!("{name} is admitted from revision {} on; this is {}", declaration.first_version, profile.display());
        return Some(Finding::new(&CODE, mnemonic.span, message).help("use another instruction, or a later revision"));
    }
    None
}

/// Safety Add-On Instructions on a revision that has none.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let Some(profile) = project.profile.filter(|profile| profile.revision < ADD_ON_INSTRUCTIONS_FROM) else { return };
    for add_on in &project.add_ons {
        let message = format!(
            "safety Add-On Instructions exist from revision {ADD_ON_INSTRUCTIONS_FROM} on; this is {}",
            profile.display()
        );
        findings.push(Finding::new(&CODE, add_on.span, message).help("write its rungs as a subroutine, or take a later revision"));
    }
}
