//! A rung that does nothing. general-instructions.md 2.4.

use twinrung_catalog::Position;

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;
use crate::rules::usage;

rule! {
    /// A rung without an output instruction.
    "W0102", Warning, "a rung has no output instruction",
    "The rung examines and does nothing; the editor would not accept it. Add an output, or NOP() where the rung is kept for its comment.",
    "general-instructions.md 2.4",
    good: sample!("    A, B : BOOL (Class := Safety);\n", "      N: XIC(A)OTE(B);\n"),
    bad: sample!("    A, B : BOOL (Class := Safety);\n", "      N: <<XIC(A);>>\n      N: XIC(A)OTE(B);\n")
}

/// Every rung.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    usage::rungs(project, &mut |_, _, rung| {
        if rung.incomplete || rung.elements.is_empty() {
            return;
        }
        let mut acts = false;
        rung.visit(&mut |instruction| acts |= instruction.call.position() != Position::Input);
        if !acts {
            let finding = Finding::new(&CODE, rung.span, "the rung has no output instruction");
            findings.push(finding.help("add an output, or delete the rung"));
        }
    });
}
