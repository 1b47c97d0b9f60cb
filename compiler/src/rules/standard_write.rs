//! Standard logic writes no safety tag. 1756-RM093, safety tags.

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// Standard logic writes a safety tag.
    "S0302", Error, "standard logic writes a safety tag",
    "Standard logic may read safety tags and never writes them. Write a standard tag and map it, or move the logic to the safety task.",
    "1756-RM093, Safety Tags",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n    Lamp : BOOL;\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  PROGRAM Panel (MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Run)OTE(Lamp);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n    Lamp : BOOL;\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  PROGRAM Panel (MAIN := \"Main\")\n    ROUTINE Main\n      N: XIC(Lamp)OTE(<<Run>>);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// Writes that the standard programs were read for.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for write in &project.standard_writes {
        let tag = project.tag(write.tag);
        let message = format!("{} in a standard program writes the safety tag `{}`", write.mnemonic, tag.name);
        let finding = Finding::new(&CODE, write.span, message).label(tag.span, "declared here, of class Safety");
        findings.push(finding.help("write a standard tag and map it to a safety tag that safety logic reads"));
    }
}
