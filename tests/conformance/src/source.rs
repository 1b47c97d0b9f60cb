//! The project text of a case.

use std::fmt::Write;

use super::table::{Case, PERIOD_MS, Program};

/// The whole project of a case as `.rll`.
pub fn text(case: &Case) -> String {
    let (controller, revision) = case.controller.clone().unwrap_or_else(|| ("1756-L73S".to_owned(), 20));
    let period = case.period.unwrap_or(PERIOD_MS);
    let mut text = format!(
        "CONTROLLER Conformance (ProcessorType := \"{controller}\", Major := {revision}, SafetyNetwork := 16#0000_0000_0001_0001)\n"
    );
    for line in &case.declarations {
        line_of(&mut text, line);
    }
    line_of(&mut text, "TAG");
    for (declared, value) in &case.tags {
        let class = if declared.contains(':') { " (Class := Safety)" } else { "" };
        line_of(&mut text, &format!("{declared}{class}{};", assigned(value)));
    }
    line_of(&mut text, "END_TAG");
    case.programs.iter().for_each(|program| add_program(&mut text, program));
    line_of(
        &mut text,
        &format!(
            "TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := {period}, Watchdog := {period}, Priority := 5)"
        ),
    );
    for program in &case.programs {
        line_of(&mut text, &format!("{};", program.name));
    }
    line_of(&mut text, "END_TASK");
    for task in &case.event_tasks {
        line_of(
            &mut text,
            &format!(
                "TASK {task} (Type := EVENT, EventTrigger := \"EVENT Instruction Only\", Priority := 10, Watchdog := 500) END_TASK"
            ),
        );
    }
    text.push_str("END_CONTROLLER\n");
    text
}

fn add_program(text: &mut String, program: &Program) {
    let fault = program.fault.as_ref().map(|name| format!(", FAULT := \"{name}\"")).unwrap_or_default();
    line_of(text, &format!("PROGRAM {} (Class := Safety, MAIN := \"Main\"{fault})", program.name));
    if !program.tags.is_empty() {
        line_of(text, "TAG");
        for (declared, value) in &program.tags {
            line_of(text, &format!("{declared}{};", assigned(value)));
        }
        line_of(text, "END_TAG");
    }
    for (name, rungs) in &program.routines {
        line_of(text, &format!("ROUTINE {name}"));
        for rung in rungs {
            line_of(text, &format!("N: {rung};"));
        }
        line_of(text, "END_ROUTINE");
    }
    line_of(text, "END_PROGRAM");
}

fn assigned(value: &Option<String>) -> String {
    value.as_ref().map(|value| format!(" := {value}")).unwrap_or_default()
}

fn line_of(text: &mut String, line: &str) {
    writeln!(text, "  {line}").expect("writing to a string succeeds");
}
