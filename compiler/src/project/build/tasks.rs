//! Tasks and what they schedule.

use twinrung_grammar::tree::{Class, CompactString, Span};

use super::Inputs;
use crate::diagnostic::{DUPLICATE_NAME, Finding, Findings, UNKNOWN_PROGRAM};
use crate::names::{Map, Set, closest, fold};
use crate::project::tags::class_of;
use crate::project::task::Scheduled;
use crate::project::{Program, ProgramId, TagClass, Task};

/// The tasks of the file, or the one that the command line describes; and the names of standard event tasks.
pub(super) fn build(
    inputs: &Inputs<'_>,
    programs: &[Program],
    span: Span,
    findings: &mut Findings,
) -> (Vec<Task>, Vec<CompactString>) {
    let mut list: Vec<Task> = Vec::new();
    let by_name: Map<CompactString, ProgramId> =
        programs.iter().enumerate().map(|(at, program)| (fold(&program.name), ProgramId(at as u16))).collect();
    let known_names: Set<CompactString> =
        inputs.file.programs.iter().map(|program| fold(program.name.as_str())).collect();
    let mut seen: Map<CompactString, Span> = Map::default();
    for shown in &inputs.file.tasks {
        if let Some(first) = seen.insert(fold(shown.name.as_str()), shown.name.span) {
            let message = format!("the task `{}` is declared twice", shown.name);
            let finding = Finding::new(&DUPLICATE_NAME, shown.name.span, message).label(first, "first declared here");
            findings.push(finding.help("rename one of the two"));
            continue;
        }
        let class = shown.class.map_or(TagClass::Standard, |class| class_of(class.value));
        let mut schedule = Vec::new();
        for name in &shown.programs {
            let folded = fold(name.as_str());
            let program = by_name.get(&folded).copied();
            let known = program.is_some() || known_names.contains(&folded);
            if !known {
                let message = format!("the task schedules `{name}`, which is no program of this file");
                let finding = Finding::new(&UNKNOWN_PROGRAM, name.span, message);
                let names = inputs.file.programs.iter().map(|program| program.name.as_str());
                findings.push(match closest(name.as_str(), names) {
                    Some(like) => finding.help(format!("did you mean `{like}`?")),
                    None => finding.help("declare the program, or take it out of the schedule"),
                });
                continue;
            }
            schedule.push(Scheduled { name: name.text.clone(), span: name.span, program });
        }
        list.push(Task {
            name: shown.name.text.clone(),
            span: shown.name.span,
            class,
            task_type: shown.task_type.as_ref().map(|name| name.text.to_ascii_uppercase()).unwrap_or_default(),
            period_us: shown.rate_us.map(|rate| (rate.value, rate.span)),
            watchdog_us: shown.watchdog_us.map(|watchdog| (watchdog.value, watchdog.span)),
            priority: shown.priority.map_or((10, shown.name.span), |priority| (priority.value, priority.span)),
            inhibited: shown.inhibited.filter(|inhibited| inhibited.value).map(|inhibited| inhibited.span),
            schedule,
        });
    }
    let events = inputs.files().flat_map(|(file, _)| &file.tasks);
    let event_tasks = events
        .filter(|task| task.class.is_none_or(|class| class.value == Class::Standard))
        .filter(|task| task.task_type.as_ref().is_some_and(|kind| kind.is("EVENT")))
        .map(|task| task.name.text.clone())
        .collect();
    let has_safety = list.iter().any(|task| task.class == TagClass::Safety);
    if let (false, Some(period_ms), false) = (has_safety, inputs.completion.period_ms, inputs.library) {
        let period_us = u64::from(period_ms) * 1000;
        let watchdog_us = inputs.completion.watchdog_ms.map_or(period_us, |watchdog| u64::from(watchdog) * 1000);
        let scheduled = |(at, program): (usize, &Program)| Scheduled {
            name: program.name.clone(),
            span: program.span,
            program: Some(ProgramId(at as u16)),
        };
        list.push(Task {
            name: "SafetyTask".into(),
            span,
            class: TagClass::Safety,
            task_type: "PERIODIC".into(),
            period_us: Some((period_us, span)),
            watchdog_us: Some((watchdog_us, span)),
            priority: (10, span),
            inhibited: None,
            schedule: programs.iter().enumerate().map(scheduled).collect(),
        });
    }
    (list, event_tasks)
}

/// The safety task: the first of its class.
pub(super) fn safety_task(tasks: &mut [Task]) -> Option<usize> {
    tasks.iter().position(|task| task.class == TagClass::Safety)
}
