//! One safety task, periodic, that runs. 1756-RM093, safety task.

use crate::diagnostic::{Finding, Findings, NO_TASK, VALUE_RANGE};
use crate::project::{Project, TagClass};

rule! {
    /// Not exactly one periodic safety task.
    "S0501", Error, "there is not exactly one periodic safety task",
    "A safety application has one safety task, of type PERIODIC and not inhibited; its schedule is the order of execution. Put all safety programs into one such task.",
    "1756-RM093, Safety Task; neutral-text-and-l5x.md D.7",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\n  TASK <<Second>> (Type := PERIODIC, Class := Safety, Rate := 50, Watchdog := 50, Priority := 6)\n  END_TASK\nEND_CONTROLLER\n"
}

/// The tasks of class Safety.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let mut safety = project.tasks.iter().filter(|task| task.class == TagClass::Safety);
    let Some(first) = safety.next() else {
        if !project.library {
            let finding = Finding::new(&NO_TASK, project.span, "the file holds no safety task");
            findings.push(finding.help("complete it with --period MS and --watchdog MS, or declare a TASK with Class := Safety"));
        }
        return;
    };
    if first.task_type != "PERIODIC" {
        let message = format!("the safety task `{}` is not of type PERIODIC", first.name);
        findings.push(Finding::new(&CODE, first.span, message).help("write Type := PERIODIC and a Rate"));
    }
    if let Some(span) = first.inhibited {
        let message = format!("the safety task `{}` is inhibited: it would not run", first.name);
        findings.push(Finding::new(&CODE, span, message).help("take InhibitTask away"));
    }
    if first.priority.0 > 15 {
        let message = format!("no task has the priority {}", first.priority.0);
        findings.push(Finding::new(&VALUE_RANGE, first.priority.1, message).help("write 1 (highest) to 15"));
    }
    for other in safety {
        let message = format!("`{}` is a second safety task", other.name);
        let finding = Finding::new(&CODE, other.span, message).label(first.span, "the first safety task");
        findings.push(finding.help("schedule its programs in the first one"));
    }
}
