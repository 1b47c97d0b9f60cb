//! Forces keep a project from being signed. 1756-RM093, forcing.

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// A force is installed.
    "S0507", Error, "a force is installed",
    "A force holds a value against the logic: what would be signed is not what runs. Remove all forces from safety data, then export again.",
    "1756-RM093, Forcing; neutral-text-and-l5x.md D.5",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: sample!("    Run : BOOL (Class := Safety) := 0, TagForceData := <<[0,1,1]>>;\n", "      N: OTE(Run);\n")
}

/// Forces on safety data.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for span in &project.forces {
        let finding = Finding::new(&CODE, *span, "a force is installed on safety data");
        findings.push(finding.help("remove the force, then export again"));
    }
}
