//! Branches within branches. neutral-text-and-l5x.md C.1.

use crate::diagnostic::{Finding, Findings};
use crate::project::{Element, Project};
use crate::rules::usage;

rule! {
    /// Branches nested deeper than the editor takes.
    "W0106", Warning, "branches are nested deeply",
    "More than six branches within each other cannot be entered in the editor, and nobody reads them. Split the rung with an intermediate bit.",
    "neutral-text-and-l5x.md C.1 (6 recalled)",
    good: sample!("    A, B : BOOL (Class := Safety);\n", "      N: [[[[[[XIC(A) ,XIC(B) ] ,XIC(A) ] ,XIC(B) ] ,XIC(A) ] ,XIC(B) ] ,XIC(A) ]OTE(B);\n"),
    bad: sample!("    A, B : BOOL (Class := Safety);\n", "      N: [[[[[[<<[XIC(A) ,XIC(B) ]>> ,XIC(A) ] ,XIC(B) ] ,XIC(A) ] ,XIC(B) ] ,XIC(A) ] ,XIC(B) ]OTE(B);\n")
}

/// Levels that the editor takes.
const LEVELS: usize = 6;

/// Every rung; the first branch that is too deep is reported.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    usage::rungs(project, &mut |_, _, rung| {
        deepest(&rung.elements, 0, findings);
    });
}

/// The grammar limits the depth.
fn deepest(elements: &[Element], depth: usize, findings: &mut Findings) -> bool {
    for element in elements {
        let Element::Branch(branch) = element else { continue };
        if depth == LEVELS {
            let message = format!("this branch lies within {LEVELS} others");
            findings.push(Finding::new(&CODE, branch.span, message).help("split the rung with an intermediate bit"));
            return true;
        }
        if branch.legs.iter().any(|leg| deepest(leg, depth + 1, findings)) {
            return true;
        }
    }
    false
}
