//! No routine and no Add-On Instruction calls itself. DESIGN 4; general-instructions.md A.8 (decided).

use twinrung_bytecode::limits;
use twinrung_grammar::tree::Span;

use crate::diagnostic::{Finding, Findings, OVER_LIMIT};
use crate::operand::Operand;
use crate::project::{AddOnId, Call, Project, RoutineId, RoutineOwner};

rule! {
    /// Recursion.
    "S0604", Error, "a routine calls itself",
    "A routine that calls itself, directly or through others, has no bound on its time. Write a loop with a bounded count, or call the parts one after the other. The same holds for Add-On Instructions.",
    "DESIGN 4; general-instructions.md A.8 (decided)",
    good: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: JSR(Part,0);\n    END_ROUTINE\n    ROUTINE Part\n      N: OTE(Run);\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n",
    bad: "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n    Run : BOOL (Class := Safety);\n  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: JSR(Part,0);\n    END_ROUTINE\n    ROUTINE Part\n      N: XIC(Run)<<JSR(Main,0)>>;\n    END_ROUTINE\n  END_PROGRAM\n  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
}

/// For each Add-On Instruction those that it calls, with the place of the call.
pub(crate) fn add_on_calls(project: &Project) -> Vec<Vec<(AddOnId, Span)>> {
    let mut graph = vec![Vec::new(); project.add_ons.len()];
    for routine in &project.routines {
        let RoutineOwner::AddOn(owner) = routine.owner else { continue };
        for rung in &routine.rungs {
            rung.visit(&mut |instruction| {
                if let Call::AddOn(called) = instruction.call {
                    graph[owner.position()].push((called, instruction.span));
                }
            });
        }
    }
    graph
}

/// For each routine those that it calls, with the place of the call.
fn routine_calls(project: &Project) -> Vec<Vec<(RoutineId, Span)>> {
    let mut graph = vec![Vec::new(); project.routines.len()];
    for (at, routine) in project.routines.iter().enumerate() {
        let fault = match routine.owner {
            RoutineOwner::Program(program) => project.program(program).fault,
            RoutineOwner::AddOn(_) => None,
        };
        for rung in &routine.rungs {
            rung.visit(&mut |instruction| {
                let Some(Operand::Routine(called)) = instruction.operands.first().map(|one| project.operand(one.id)) else {
                    return;
                };
                // A call of the fault routine with 990 to 999 raises that fault and calls nothing (A.8).
                let number = match instruction.operands.get(2).map(|one| project.operand(one.id)) {
                    Some(Operand::Integer { value, .. }) => Some(*value),
                    _ => None,
                };
                let raises = fault == Some(*called)
                    && instruction.operands.len() == 3
                    && number.is_some_and(|number| (990..=999).contains(&number));
                if !raises {
                    graph[at].push((*called, instruction.span));
                }
            });
        }
    }
    graph
}

/// Circles and depth of calls.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    let routines: Vec<Vec<(usize, Span)>> = routine_calls(project)
        .into_iter()
        .map(|calls| calls.into_iter().map(|(called, span)| (called.position(), span)).collect())
        .collect();
    let name = |at: usize| project.routines[at].name.to_string();
    judge(&routines, limits::CALL_DEPTH, &name, "subroutines", findings);
    let add_ons: Vec<Vec<(usize, Span)>> = add_on_calls(project)
        .into_iter()
        .map(|calls| calls.into_iter().map(|(called, span)| (called.position(), span)).collect())
        .collect();
    let name = |at: usize| project.add_ons[at].name.to_string();
    judge(&add_ons, limits::ADD_ON_DEPTH, &name, "Add-On Instructions", findings);
}

/// Depth first; the call that closes a circle is the finding.
fn judge(
    graph: &[Vec<(usize, Span)>],
    deepest: usize,
    name: &dyn Fn(usize) -> String,
    what: &str,
    findings: &mut Findings,
) {
    let mut state = vec![0u8; graph.len()];
    let mut depth = vec![0usize; graph.len()];
    for root in 0..graph.len() {
        if state[root] != 0 {
            continue;
        }
        state[root] = 1;
        let mut stack = vec![(root, 0usize)];
        while let Some((at, next)) = stack.pop() {
            match graph[at].get(next) {
                Some((called, span)) => {
                    stack.push((at, next + 1));
                    match state[*called] {
                        0 => {
                            state[*called] = 1;
                            stack.push((*called, 0));
                        }
                        1 => {
                            let message = format!("`{}` calls `{}`, which is still running", name(at), name(*called));
                            let finding = Finding::new(&CODE, *span, message);
                            findings.push(finding.help("call the parts one after the other, or loop within one routine"));
                        }
                        _ => {}
                    }
                }
                None => {
                    state[at] = 2;
                    depth[at] = graph[at].iter().map(|(called, _)| depth[*called] + 1).max().unwrap_or(0);
                    if depth[at] == deepest + 1
                        && let Some((_, span)) = graph[at].iter().find(|(called, _)| depth[*called] == deepest) {
                            let message = format!("{what} within {what} go deeper than {deepest}");
                            findings.push(Finding::new(&OVER_LIMIT, *span, message).help("call the parts one after the other"));
                        }
                }
            }
        }
    }
}
