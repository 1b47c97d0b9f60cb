//! Discrepancy times that the safety task cannot resolve. dual-channel-inputs.md C11.

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::Project;
use crate::rules::period::milliseconds;
use crate::rules::usage;

rule! {
    /// A Discrepancy Time below two periods.
    "W0121", Warning, "a discrepancy time is below two periods of the safety task",
    "Times are judged once in a scan: two channels of a healthy device, seen one scan apart, would be a fault. Make the Discrepancy Time two periods of the safety task at least, or the period shorter.",
    "dual-channel-inputs.md 1.4 and C11",
    good: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, S, R : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,40,MANUAL,MANUAL,A,B,S,R);\n"),
    bad: sample!("    E : DCI_STOP (Class := Safety);\n    A, B, S, R : BOOL (Class := Safety);\n", "      N: DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,<<39>>,MANUAL,MANUAL,A,B,S,R);\n")
}

/// Every operand of a safety instruction.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let Some((period_us, _)) = project.safety_task.and_then(|at| project.tasks[at].period_us) else { return };
    usage::safety_operands(project, &mut |one| {
        let Operand::Integer { value, .. } = *one.operand else { return };
        let time_us = u64::from(value.unsigned_abs()) * 1000;
        if one.name == "Discrepancy Time" && time_us < 2 * period_us {
            let message = format!(
                "Discrepancy Time of {} is {value} ms, and the safety task runs each {} ms",
                one.mnemonic,
                milliseconds(period_us)
            );
            findings.push(Finding::new(&CODE, one.span, message).help(format!("make it two periods at least: {} ms", milliseconds(2 * period_us))));
        }
    });
}
