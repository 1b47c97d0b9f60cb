//! Jumps backward. general-instructions.md A.8.

use twinrung_catalog::Opcode;

use crate::diagnostic::{Finding, Findings};
use crate::names::Map;
use crate::operand::Operand;
use crate::project::Project;

rule! {
    /// A jump to an earlier rung.
    "W0115", Warning, "a jump leads backward",
    "A backward jump repeats rungs within one scan; when its condition stays true the scan ends with a fault after a bounded number of rounds. Count the rounds, or use FAL and FSC.",
    "general-instructions.md A.8 (bound decided)",
    good: sample!("    A, B : BOOL (Class := Safety);\n", "      N: XIC(A)JMP(Skip);\n      N: OTE(B);\n      N: LBL(Skip)NOP();\n"),
    bad: sample!("    A : BOOL (Class := Safety);\n    N : DINT (Class := Safety);\n", "      N: LBL(Again)ADD(N,1,N);\n      N: LES(N,10)<<JMP(Again)>>;\n")
}

/// Every JMP to a rung that is not after it.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    if !project.opcodes.any(&[Opcode::Jmp]) {
        return;
    }
    for routine in &project.routines {
        let mut labels: Map<&str, usize> = Map::default();
        let mut jumps = Vec::new();
        for (number, rung) in routine.rungs.iter().enumerate() {
            rung.visit(&mut |instruction| {
                let Some(Operand::Text(label)) = instruction.operands.first().map(|one| project.operand(one.id)) else {
                    return;
                };
                match instruction.call.opcode() {
                    Some(Opcode::Lbl) => {
                        labels.insert(label, number);
                    }
                    Some(Opcode::Jmp) => jumps.push((label.as_str(), number, instruction.span)),
                    _ => {}
                }
            });
        }
        for (label, number, span) in jumps {
            if labels.get(label).is_some_and(|target| *target <= number) {
                let finding = Finding::new(&CODE, span, format!("the jump to `{label}` leads backward"));
                findings.push(finding.help("bound the number of rounds by a counter on the rung"));
            }
        }
    }
}
