//! Limits of muting that are switched off. muting-and-outputs.md 1.2 and 4.3.

use crate::diagnostic::{Finding, Findings};
use crate::operand::Operand;
use crate::project::Project;
use crate::rules::usage;

rule! {
    /// A time of a muting instruction that is 0.
    "W0122", Warning, "a limit of muting is switched off",
    "A time of 0 switches the limit off. Without a limit on the sensors' times a person can walk in beside a load; without a Maximum Mute Time a curtain stays muted for as long as something stands in it; without a Minimum Time nothing tells a load from one common cause. Give each a time that fits the speed of the conveyor.",
    "muting-and-outputs.md 1.2 (rule 3), 2.2 and 4.3",
    good: sample!("    M : MUTING_TWO_SENSOR_SYM (Class := Safety);\n    A, B, C, D, E, F, G, R : BOOL (Class := Safety);\n", "      N: TSSM(M,MANUAL,300,60,800,5,0,A,B,C,D,E,F,G,R);\n"),
    bad: sample!("    M : MUTING_TWO_SENSOR_SYM (Class := Safety);\n    A, B, C, D, E, F, G, R : BOOL (Class := Safety);\n", "      N: TSSM(M,MANUAL,<<0>>,60,800,<<0>>,0,A,B,C,D,E,F,G,R);\n")
}

/// The operands of TSAM, TSSM and FSBM for which 0 means no limit. A Maximum Override Time of 0 means no override.
const LIMITS: &[&str] = &[
    "S1-S2 Time",
    "S2-LC Time",
    "LC-S3 Time",
    "S3-S4 Time",
    "S1S2 Discrepancy Time",
    "S1S2-LC Minimum Time",
    "S1S2-LC Maximum Time",
    "Maximum Mute Time",
];

/// Every operand of a safety instruction.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    usage::safety_operands(project, &mut |one| {
        if LIMITS.contains(&one.name) && matches!(one.operand, Operand::Integer { value: 0, .. }) {
            let message = format!("{} of {} is 0: it limits nothing", one.name, one.mnemonic);
            findings.push(Finding::new(&CODE, one.span, message).help("give it a time that fits the speed of the load"));
        }
    });
}
