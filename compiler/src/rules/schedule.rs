//! What tasks schedule. 1756-RM093, safety programs.

use crate::diagnostic::{Finding, Findings};
use crate::names::Set;
use crate::project::{Project, TagClass};

rule! {
    /// A program in a task of the other class.
    "S0504", Error, "a program stands in a task of the other class",
    "The safety task runs safety programs and nothing else, and safety programs run nowhere else. Move the program.",
    "1756-RM093, Safety Programs",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  PROGRAM Panel (MAIN := \"Main\")\n    ROUTINE Main\n      N: NOP();\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  PROGRAM Panel (MAIN := \"Main\")\n    ROUTINE Main\n      N: NOP();\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n    <<Panel>>;\n  END_TASK\nEND_CONTROLLER\n"
}

/// The schedules of all tasks.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for task in &project.tasks {
        let mut seen = Set::default();
        for one in &task.schedule {
            let finding = match (task.class, one.program) {
                (TagClass::Safety, None) => {
                    let message = format!("the safety task schedules the standard program `{}`", one.name);
                    Finding::new(&CODE, one.span, message).help("schedule it in a standard task, or declare it with Class := Safety")
                }
                (TagClass::Standard, Some(_)) => {
                    let message = format!("the standard task `{}` schedules the safety program `{}`", task.name, one.name);
                    Finding::new(&CODE, one.span, message).help("schedule it in the safety task")
                }
                (TagClass::Safety, Some(program)) if !seen.insert(program) => {
                    let message = format!("the safety task schedules `{}` twice", one.name);
                    Finding::new(&CODE, one.span, message).help("schedule it once")
                }
                _ => continue,
            };
            findings.push(finding);
        }
    }
}
