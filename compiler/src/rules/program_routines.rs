//! The routines that a safety program begins with.

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// One routine as main and fault routine.
    "S0505", Error, "one routine is main and fault routine",
    "The fault routine runs when an instruction of the program has failed: it cannot be the routine that failed. Write a routine of its own.",
    "general-instructions.md B.5, B.7",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM <<Safety_Main>> (Class := Safety, MAIN := \"Main\", FAULT := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// Main and fault routine of every safety program.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for program in &project.programs {
        if program.main.is_some() && program.main == program.fault {
            let message = format!("`{}` names one routine as main routine and as fault routine", program.name);
            findings.push(Finding::new(&CODE, program.span, message).help("give the program a fault routine of its own, or none"));
        }
    }
}
