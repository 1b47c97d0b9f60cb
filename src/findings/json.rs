//! Findings as one JSON object, whose keys are a promise.

use std::io::{self, Write};

use serde::Serialize;
use twinrung_compiler::diagnostic::Finding;
use twinrung_grammar::tree::{Sources, Span};

use super::{Count, Report, file_name, severity_word};

#[derive(Serialize)]
struct Json<'a> {
    findings: Vec<JsonFinding<'a>>,
    suppressed: Vec<Suppressed<'a>>,
    errors: usize,
    warnings: usize,
}

#[derive(Serialize)]
struct JsonFinding<'a> {
    code: &'a str,
    severity: &'static str,
    message: &'a str,
    #[serde(flatten)]
    place: Place,
    routine: Option<&'a str>,
    rung: Option<u32>,
    help: Option<&'a str>,
    related: Vec<Related<'a>>,
}

#[derive(Serialize)]
struct Place {
    file: String,
    line: u32,
    column: u32,
}

#[derive(Serialize)]
struct Related<'a> {
    message: &'a str,
    #[serde(flatten)]
    place: Place,
}

#[derive(Serialize)]
struct Suppressed<'a> {
    #[serde(flatten)]
    finding: JsonFinding<'a>,
    reason: &'a str,
}

/// Prints findings as one JSON object.
pub fn print(out: &mut dyn Write, report: &Report<'_>) -> io::Result<()> {
    let count = Count::of(report.findings);
    let open = report.findings.iter().filter(|finding| finding.accepted.is_none());
    let suppressed = report.findings.iter().filter_map(|finding| {
        let reason = finding.accepted.as_deref()?;
        Some(Suppressed { finding: of_finding(report.sources, finding), reason })
    });
    let json = Json {
        findings: open.map(|finding| of_finding(report.sources, finding)).collect(),
        suppressed: suppressed.collect(),
        errors: count.errors,
        warnings: count.warnings,
    };
    serde_json::to_writer(&mut *out, &json)?;
    writeln!(out)
}

fn of_finding<'a>(sources: &Sources, finding: &'a Finding) -> JsonFinding<'a> {
    let related =
        finding.labels.iter().map(|label| Related { message: &label.text, place: place(sources, label.span) });
    JsonFinding {
        code: finding.code.id,
        severity: severity_word(finding.severity),
        message: &finding.message,
        place: place(sources, finding.span),
        routine: finding.rung.as_ref().map(|rung| rung.routine.as_str()),
        rung: finding.rung.as_ref().map(|rung| rung.rung),
        help: finding.help.as_deref(),
        related: related.collect(),
    }
}

fn place(sources: &Sources, span: Span) -> Place {
    let place = sources.line_column(span);
    Place { file: file_name(sources, span.source), line: place.line, column: place.column }
}
