//! The period of the safety task. 1756-RM093: at most 500 ms.

use twinrung_bytecode::limits;

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// A period out of range.
    "S0502", Error, "the period of the safety task is out of range",
    "The safety task runs at least every 500 ms; the reaction time of every safety function contains its period. At least 1 ms (decided).",
    "1756-RM093, Safety Task Period",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 500, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := <<501>>, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// The period of the safety task.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let Some(task) = project.safety_task.map(|at| &project.tasks[at]) else { return };
    let Some((period_us, span)) = task.period_us else {
        let message = format!("the safety task `{}` has no period", task.name);
        findings.push(Finding::new(&CODE, task.span, message).help("write Rate := 20 (ms)"));
        return;
    };
    if !(u64::from(limits::PERIOD_US_LEAST)..=u64::from(limits::PERIOD_US)).contains(&period_us) {
        let message = format!("the safety task's period is {} ms, which is not within 1 to 500 ms", milliseconds(period_us));
        findings.push(Finding::new(&CODE, span, message).help("set Rate to 1 to 500 (ms); a shorter period shortens every reaction time"));
    }
}

/// Microseconds as people read them.
pub(crate) fn milliseconds(microseconds: u64) -> String {
    let text = format!("{}.{:03}", microseconds / 1000, microseconds % 1000);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
