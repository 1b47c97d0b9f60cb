//! How findings are shown: for a person with the rung drawn, for a program as JSON or SARIF.

mod human;
mod json;
mod quote;
mod sarif;

use std::io::{self, Write};

use twinrung_compiler::diagnostic::{Finding, Severity};
use twinrung_grammar::tree::{File, SourceId, Sources};

use crate::terminal::Terminal;

pub use human::print_human;

/// How findings are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// For a person: the rung with the place marked, the reason, the way out.
    Human,
    /// One JSON object.
    Json,
    /// A SARIF 2.1.0 log, as code reviews take it.
    Sarif,
}

/// Findings with what they point into.
#[derive(Debug, Clone, Copy)]
pub struct Report<'a> {
    /// The files.
    pub sources: &'a Sources,
    /// Their trees: the project and what completes it.
    pub trees: &'a [File],
    /// What was found, ordered.
    pub findings: &'a [Finding],
}

/// Findings counted by weight. What a suppression covers weighs nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Count {
    /// Findings that keep an image from being made.
    pub errors: usize,
    /// Findings that somebody should look at.
    pub warnings: usize,
    /// What is worth knowing and is shown on demand.
    pub notes: usize,
    /// Warnings that somebody has accepted with a reason.
    pub suppressed: usize,
}

impl Count {
    /// Counts findings.
    pub fn of(findings: &[Finding]) -> Count {
        let open = |severity| {
            findings.iter().filter(|finding| finding.severity == severity && finding.accepted.is_none()).count()
        };
        Count {
            errors: open(Severity::Error),
            warnings: open(Severity::Warning),
            notes: open(Severity::Note),
            suppressed: findings.iter().filter(|finding| finding.accepted.is_some()).count(),
        }
    }
}

/// Prints findings in the form asked for.
pub fn print(
    out: &mut dyn Write,
    report: &Report<'_>,
    format: Format,
    terminal: Terminal,
    notes: bool,
) -> io::Result<()> {
    match format {
        Format::Human => print_human(out, report, terminal, notes),
        Format::Json => json::print(out, report),
        Format::Sarif => sarif::print(out, report),
    }
}

/// One line that counts findings, for the end of a human report.
pub fn summary(count: Count) -> String {
    let plural = |count: usize, word: &str| format!("{count} {word}{}", if count == 1 { "" } else { "s" });
    let mut parts = Vec::new();
    if count.errors > 0 {
        parts.push(plural(count.errors, "error"));
    }
    if count.warnings > 0 {
        parts.push(plural(count.warnings, "warning"));
    }
    if count.notes > 0 {
        parts.push(plural(count.notes, "note"));
    }
    if parts.is_empty() {
        parts.push("no findings".to_owned());
    }
    if count.suppressed > 0 {
        parts.push(format!("{} suppressed", count.suppressed));
    }
    parts.join(", ")
}

/// How a severity is called in every form.
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
