//! Pending edits keep a project from being signed. 1756-RM093, online edits; neutral-text-and-l5x.md C.4.

use twinrung_grammar::tree::{RungKind, Span};

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// An online edit that was not finished.
    "S0506", Error, "an online edit is pending",
    "A rung of another type than N is part of an online edit that was neither assembled nor cancelled: what the controller runs is not what stands here. Assemble or cancel the edits, then export again.",
    "1756-RM093, Online Edits; neutral-text-and-l5x.md C.4 (decided)",
    good: sample!("    Run : BOOL (Class := Safety);\n", "      N: OTE(Run);\n"),
    bad: sample!("    Run : BOOL (Class := Safety);\n", "      I: <<OTE(Run);>>\n")
}

/// The finding for a program with test edits.
pub(crate) fn test_edits(program: &str, span: Span) -> Finding {
    Finding::new(&CODE, span, format!("test edits of the program `{program}` are active"))
        .help("assemble or cancel the edits, then export again")
}

/// Rungs of another type than N.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for routine in &project.routines {
        for rung in routine.rungs.iter().filter(|rung| rung.kind != RungKind::Normal) {
            let message = "the rung is part of an online edit that was not finished";
            let help = "assemble or cancel the edits, then export again";
            findings.push(Finding::new(&CODE, rung.span, message).help(help));
        }
    }
}
