//! The report for a terminal.

use std::fmt::Write;

use super::{CoverageReport, FailureReport, ProjectReport, ScenarioReport};
use crate::coverage::{collect, parsed};
use crate::diagram::{self, Style};
use crate::ladder::{self, Places};
use crate::pages::terminal::wrapped;
use crate::scenario::Decision;

/// Columns before what belongs to a failure.
const INDENT: usize = 6;

/// The report as text. What was not met is shown with its timing diagram and the rung that decided it.
pub fn text(report: &ProjectReport, style: Style) -> String {
    let mut out = format!("{}, safety application {}\n", report.project, report.signature);
    let mut file = "";
    for scenario in &report.scenarios {
        if scenario.file != file {
            file = &scenario.file;
            let _ = writeln!(out, "\n{file}");
        }
        one(&mut out, scenario, style);
    }
    let failed = report.failed();
    let met = report.scenarios.len() - failed;
    let _ = writeln!(out, "\n{met} of {} scenarios met", report.scenarios.len());
    coverage(&mut out, &report.coverage, style.columns);
    out
}

fn one(out: &mut String, scenario: &ScenarioReport, style: Style) {
    let (begin, end) = match (style.colour, scenario.passed) {
        (false, _) => ("", ""),
        (true, true) => ("\u{1b}[32m", "\u{1b}[0m"),
        (true, false) => ("\u{1b}[1;31m", "\u{1b}[0m"),
    };
    let word = if scenario.passed { "met    " } else { "NOT MET" };
    let plural = if scenario.expectations == 1 { "" } else { "s" };
    let _ = writeln!(
        out,
        "  {begin}{word}{end} {} ({} expectation{plural}, {} scans)",
        scenario.name, scenario.expectations, scenario.scans
    );
    for failure in &scenario.failures {
        failed(out, scenario, failure, style);
    }
}

fn failed(out: &mut String, scenario: &ScenarioReport, failure: &FailureReport, style: Style) {
    let pad = " ".repeat(INDENT);
    let _ = writeln!(out, "\n{pad}{}:{}: {}", scenario.file, failure.line, failure.expected);
    let _ = writeln!(out, "{pad}at {} ms {}\n", failure.at_ms, failure.found);
    let drawn = diagram::draw(&failure.recording, Style { columns: style.columns.saturating_sub(INDENT), ..style });
    for line in drawn.lines() {
        let _ = writeln!(out, "{pad}{line}");
    }
    if let Some(decision) = &failure.decision {
        let _ = writeln!(out, "\n{pad}{}", decided_by(decision));
        for line in ladder_of(decision, style.columns.saturating_sub(INDENT), style.colour) {
            let _ = writeln!(out, "{pad}{line}");
        }
    }
    out.push('\n');
}

/// Which rung decided a tag, and where power ended on it.
pub(super) fn decided_by(decision: &Decision) -> String {
    let ended = match decision.blocked_by.as_slice() {
        [] => String::new(),
        list => format!("; power ended at {}", list.join(", ")),
    };
    format!("{} was decided by {}, rung {}{ended}", decision.tag, decision.routine, decision.rung)
}

/// The rung as ladder, with the contacts marked at which power ended; its text where it is too large to draw.
pub(super) fn ladder_of(decision: &Decision, columns: usize, colour: bool) -> Vec<String> {
    let (_, rung) = parsed(&decision.text);
    let drawn = rung.and_then(|rung| {
        let mut spans = Vec::new();
        let mut position = 0;
        collect(&rung.elements, &mut |instruction| {
            if decision.blocking.contains(&position) {
                spans.push(instruction.span);
            }
            position += 1;
        });
        ladder::draw(&rung, Places { primary: None, related: &spans }, columns, colour)
    });
    drawn.unwrap_or_else(|| vec![decision.text.clone()])
}

fn coverage(out: &mut String, coverage: &CoverageReport, columns: usize) {
    out.push('\n');
    for (kind, share) in coverage.kinds.iter().filter(|(_, share)| share.total > 0) {
        let excluded = if share.excluded > 0 { format!(", {} excluded", share.excluded) } else { String::new() };
        let _ = writeln!(out, "  {:<24}{:>5} of {}{excluded}", kind.plural(), share.reached, share.total);
    }
    if !coverage.missing.is_empty() {
        let _ = writeln!(out, "\nNot shown by any scenario, and the way to it:");
        for item in &coverage.missing {
            let _ = writeln!(out, "  {}", item.name);
            wrapped(out, &item.way, INDENT, INDENT, columns);
        }
    }
    if !coverage.excluded.is_empty() {
        let _ = writeln!(out, "\nExcluded, each for the reason given:");
        for excluded in &coverage.excluded {
            let _ = writeln!(out, "  {}", excluded.item);
            wrapped(out, &format!("because: {}", excluded.reason), INDENT, INDENT, columns);
        }
    }
    for item in &coverage.needless {
        let _ = writeln!(out, "\nexcluded, but shown all the same: {item}; delete the exclusion");
    }
    let minimum = coverage.minimum.map_or(String::new(), |minimum| format!(", at least {minimum} % is demanded"));
    let verdict = if coverage.enough { "" } else { ": NOT ENOUGH" };
    let _ = writeln!(out, "\ncoverage {} %{minimum}{verdict}", coverage.percent);
}
