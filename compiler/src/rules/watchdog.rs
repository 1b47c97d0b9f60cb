//! The watchdog of the safety task. 1756-RM093: at most the period.

use super::period::milliseconds;
use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// A watchdog above the period.
    "S0503", Error, "the watchdog of the safety task is above its period",
    "The watchdog bounds the time from the scheduled start of a scan to its end: above the period a scan could miss the next start unnoticed. Set the watchdog to what the longest scan needs with some reserve (`twinrung bench` measures it), and to the period at most.",
    "1756-RM093, Safety Task Watchdog",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := <<21>>, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// The watchdog of the safety task.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let Some(task) = project.safety_task.map(|at| &project.tasks[at]) else { return };
    let (Some((period_us, period)), Some((watchdog_us, span))) = (task.period_us, task.watchdog_us) else { return };
    if watchdog_us == 0 || watchdog_us > period_us {
        let (watchdog, limit) = (milliseconds(watchdog_us), milliseconds(period_us));
        let message = match watchdog_us {
            0 => "the safety task's watchdog is 0 ms: nothing would bound a scan".to_owned(),
            _ => format!("the safety task's watchdog of {watchdog} ms is longer than its period of {limit} ms"),
        };
        let finding = Finding::new(&CODE, span, message).label(period, "the period");
        findings.push(finding.help(format!("set Watchdog to at most {limit} (ms), or lengthen the period")));
    }
}
