//! Safety programs and routines that nothing runs. general-instructions.md B.2.

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// A safety program that nothing runs.
    "W0110", Warning, "a safety program is not executed",
    "A program that no task schedules, that is disabled, or that has no main routine does nothing: what it should watch is not watched. Schedule it, or delete it.",
    "general-instructions.md B.2, B.5",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field_In (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n  MODULE Field_Out (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field_In (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n  MODULE Field_Out (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  PROGRAM <<Other>> (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: NOP();\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// Programs of the safety task.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let Some(task) = project.safety_task.map(|at| &project.tasks[at]) else { return };
    for (position, program) in project.programs.iter().enumerate() {
        let scheduled = task.schedule.iter().any(|one| one.program.is_some_and(|id| id.position() == position));
        let message = if !scheduled {
            format!("the safety task does not schedule `{}`", program.name)
        } else if program.disabled {
            format!("the program `{}` is disabled", program.name)
        } else if program.main.is_none() {
            format!("the program `{}` has no main routine", program.name)
        } else {
            continue;
        };
        findings.push(Finding::new(&CODE, program.span, message).help("schedule it with a main routine, or delete it"));
    }
}
