//! How findings are shown: for a person with the source underlined, for a program as JSON.

use std::io::{self, Write};
use std::sync::Arc;

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource, SourceCode};
use serde::Serialize;
use twinrung_compiler::diagnostic::{Finding, Severity};
use twinrung_grammar::tree::{SourceId, Sources, Span};

use crate::terminal::Terminal;

/// How findings are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// For a person: the text with the place underlined, the reason, the way out.
    Human,
    /// One JSON object.
    Json,
}

/// Findings counted by weight.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Count {
    /// Findings that keep an image from being made.
    pub errors: usize,
    /// Findings that somebody should look at.
    pub warnings: usize,
}

impl Count {
    /// Counts findings.
    pub fn of(findings: &[Finding]) -> Count {
        let of = |severity| findings.iter().filter(|finding| finding.severity == severity).count();
        Count { errors: of(Severity::Error), warnings: of(Severity::Warning) }
    }
}

/// Prints findings for a person, without notes unless `notes`.
pub fn print_human(
    out: &mut dyn Write,
    sources: &Sources,
    findings: &[Finding],
    terminal: Terminal,
    notes: bool,
) -> io::Result<()> {
    let theme = if terminal.colour { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
    let handler = GraphicalReportHandler::new_themed(theme).with_width(terminal.columns).with_context_lines(1);
    for finding in findings.iter().filter(|finding| notes || finding.severity != Severity::Note) {
        let mut text = String::new();
        handler.render_report(&mut text, &Report::new(sources, finding)).map_err(io::Error::other)?;
        out.write_all(text.as_bytes())?;
    }
    Ok(())
}

/// One line that counts findings, for the end of a human report.
pub fn summary(count: Count) -> String {
    let plural = |count: usize, word: &str| format!("{count} {word}{}", if count == 1 { "" } else { "s" });
    match (count.errors, count.warnings) {
        (0, 0) => "no findings".to_owned(),
        (0, warnings) => plural(warnings, "warning"),
        (errors, 0) => plural(errors, "error"),
        (errors, warnings) => format!("{}, {}", plural(errors, "error"), plural(warnings, "warning")),
    }
}

#[derive(Serialize)]
struct Json<'a> {
    findings: Vec<JsonFinding<'a>>,
    errors: usize,
    warnings: usize,
}

#[derive(Serialize)]
struct JsonFinding<'a> {
    code: &'a str,
    severity: &'static str,
    message: &'a str,
    file: String,
    line: u32,
    column: u32,
    routine: Option<&'a str>,
    rung: Option<u32>,
    help: Option<&'a str>,
}

/// Prints findings as one JSON object.
pub fn print_json(out: &mut dyn Write, sources: &Sources, findings: &[Finding]) -> io::Result<()> {
    let count = Count::of(findings);
    let findings = findings
        .iter()
        .map(|finding| {
            let place = sources.line_column(finding.span);
            JsonFinding {
                code: finding.code.id,
                severity: severity_word(finding.severity),
                message: &finding.message,
                file: file_name(sources, finding.span.source),
                line: place.line,
                column: place.column,
                routine: finding.rung.as_ref().map(|rung| rung.routine.as_str()),
                rung: finding.rung.as_ref().map(|rung| rung.rung),
                help: finding.help.as_deref(),
            }
        })
        .collect();
    let json = Json { findings, errors: count.errors, warnings: count.warnings };
    serde_json::to_writer(&mut *out, &json)?;
    writeln!(out)
}

fn severity_word(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

fn file_name(sources: &Sources, source: SourceId) -> String {
    sources.get(source).map_or_else(String::new, |file| file.path().display().to_string())
}

/// One finding as miette draws it. Related places in other files become reports of their own below it.
#[derive(Debug)]
struct Report {
    message: String,
    code: &'static str,
    severity: miette::Severity,
    help: Option<String>,
    source: NamedSource<Arc<str>>,
    labels: Vec<LabeledSpan>,
    elsewhere: Vec<Report>,
}

impl Report {
    fn new(sources: &Sources, finding: &Finding) -> Report {
        let here = finding.span.source;
        let mut labels = vec![LabeledSpan::new_primary_with_span(
            Some("here".to_owned()).filter(|_| !finding.labels.is_empty()),
            range(finding.span),
        )];
        let (near, far): (Vec<_>, Vec<_>) = finding.labels.iter().partition(|label| label.span.source == here);
        labels.extend(near.iter().map(|label| LabeledSpan::new_with_span(Some(label.text.clone()), range(label.span))));
        let elsewhere = far
            .iter()
            .map(|label| Report {
                message: label.text.clone(),
                code: "",
                severity: miette::Severity::Advice,
                help: None,
                labels: vec![LabeledSpan::new_with_span(None, range(label.span))],
                source: quoted(sources, label.span.source),
                elsewhere: Vec::new(),
            })
            .collect();
        let message = match &finding.rung {
            Some(rung) => format!("{} ({}, rung {})", finding.message, rung.routine, rung.rung),
            None => finding.message.clone(),
        };
        Report {
            message,
            code: finding.code.id,
            severity: match finding.severity {
                Severity::Error => miette::Severity::Error,
                Severity::Warning => miette::Severity::Warning,
                Severity::Note => miette::Severity::Advice,
            },
            help: finding.help.clone(),
            labels,
            source: quoted(sources, here),
            elsewhere,
        }
    }
}

/// The text that a report quotes from: the whole file, so that line numbers are those of the file.
fn quoted(sources: &Sources, source: SourceId) -> NamedSource<Arc<str>> {
    let text = sources.get(source).map_or("", |file| file.text());
    NamedSource::new(file_name(sources, source), Arc::from(text))
}

fn range(span: Span) -> (usize, usize) {
    (span.start as usize, span.len() as usize)
}

impl std::fmt::Display for Report {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Report {}

impl Diagnostic for Report {
    fn code<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        (!self.code.is_empty()).then(|| Box::new(self.code) as Box<dyn std::fmt::Display>)
    }

    fn severity(&self) -> Option<miette::Severity> {
        Some(self.severity)
    }

    fn help<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as Box<dyn std::fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.source)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().cloned()))
    }

    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn Diagnostic> + 'a>> {
        (!self.elsewhere.is_empty()).then(|| {
            Box::new(self.elsewhere.iter().map(|report| report as &dyn Diagnostic)) as Box<dyn Iterator<Item = _>>
        })
    }
}
