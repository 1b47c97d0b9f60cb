//! Findings as a SARIF 2.1.0 log: the rules that were broken with their pages, one result for each finding, and what
//! somebody has accepted as a suppressed result with its justification.

use std::io::{self, Write};
use std::path::{Component, Path};

use serde::Serialize;
use twinrung_compiler::diagnostic::{Code, Finding};
use twinrung_grammar::tree::{Sources, Span};

use super::{Report, severity_word};

const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";

#[derive(Serialize)]
struct Log<'a> {
    #[serde(rename = "$schema")]
    schema: &'static str,
    version: &'static str,
    runs: [Run<'a>; 1],
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Run<'a> {
    tool: Tool<'a>,
    column_kind: &'static str,
    results: Vec<SarifResult<'a>>,
}

#[derive(Serialize)]
struct Tool<'a> {
    driver: Driver<'a>,
}

#[derive(Serialize)]
struct Driver<'a> {
    name: &'static str,
    version: &'static str,
    rules: Vec<Rule<'a>>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Rule<'a> {
    id: &'a str,
    short_description: Message,
    full_description: Message,
    help: Message,
    default_configuration: Configuration,
}

#[derive(Serialize)]
struct Configuration {
    level: &'static str,
}

#[derive(Serialize)]
struct Message {
    text: String,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct SarifResult<'a> {
    rule_id: &'a str,
    rule_index: usize,
    level: &'static str,
    message: Message,
    locations: [Location; 1],
    #[serde(skip_serializing_if = "Vec::is_empty")]
    related_locations: Vec<Location>,
    /// Empty: nobody has accepted it. Left out it would mean that the tool knows no suppressions.
    suppressions: Vec<Suppression<'a>>,
}

#[derive(Serialize)]
struct Suppression<'a> {
    kind: &'static str,
    status: &'static str,
    justification: &'a str,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Location {
    physical_location: PhysicalLocation,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    logical_locations: Vec<LogicalLocation>,
    #[serde(skip_serializing_if = "Option::is_none")]
    message: Option<Message>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct PhysicalLocation {
    artifact_location: ArtifactLocation,
    region: Region,
}

#[derive(Serialize)]
struct ArtifactLocation {
    uri: String,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Region {
    start_line: u32,
    start_column: u32,
    end_line: u32,
    end_column: u32,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct LogicalLocation {
    fully_qualified_name: String,
}

/// Prints findings as a SARIF log.
pub fn print(out: &mut dyn Write, report: &Report<'_>) -> io::Result<()> {
    let mut codes: Vec<&'static Code> = report.findings.iter().map(|finding| finding.code).collect();
    codes.sort_by_key(|code| code.id);
    codes.dedup_by_key(|code| code.id);
    let results = report.findings.iter().map(|finding| result(report.sources, finding, &codes));
    let run = Run {
        tool: Tool {
            driver: Driver {
                name: env!("CARGO_PKG_NAME"),
                version: env!("CARGO_PKG_VERSION"),
                rules: codes.iter().map(|code| rule(code)).collect(),
            },
        },
        column_kind: "unicodeCodePoints",
        results: results.collect(),
    };
    serde_json::to_writer_pretty(&mut *out, &Log { schema: SCHEMA, version: "2.1.0", runs: [run] })?;
    writeln!(out)
}

fn rule(code: &'static Code) -> Rule<'static> {
    let message = |text: String| Message { text };
    Rule {
        id: code.id,
        short_description: message(code.title.to_owned()),
        full_description: message(code.explanation.to_owned()),
        help: message(format!("{}\nSource: {}", code.explanation, code.citation)),
        default_configuration: Configuration { level: severity_word(code.severity) },
    }
}

fn result<'a>(sources: &Sources, finding: &'a Finding, codes: &[&'static Code]) -> SarifResult<'a> {
    let text = match &finding.help {
        Some(help) => format!("{}\nThe way out: {help}", finding.message),
        None => finding.message.clone(),
    };
    let logical = finding
        .rung
        .iter()
        .map(|rung| LogicalLocation { fully_qualified_name: format!("{}/{}", rung.routine, rung.rung) });
    let related = finding.labels.iter().map(|label| Location {
        physical_location: physical(sources, label.span),
        logical_locations: Vec::new(),
        message: Some(Message { text: label.text.clone() }),
    });
    SarifResult {
        rule_id: finding.code.id,
        rule_index: codes.partition_point(|code| code.id < finding.code.id),
        level: severity_word(finding.severity),
        message: Message { text },
        locations: [Location {
            physical_location: physical(sources, finding.span),
            logical_locations: logical.collect(),
            message: None,
        }],
        related_locations: related.collect(),
        suppressions: finding
            .accepted
            .iter()
            .map(|reason| Suppression { kind: "inSource", status: "accepted", justification: reason })
            .collect(),
    }
}

fn physical(sources: &Sources, span: Span) -> PhysicalLocation {
    let begin = sources.line_column(span);
    let end = sources.line_column(Span { start: span.end.max(span.start), ..span });
    let uri = sources.get(span.source).map_or_else(String::new, |file| uri(file.path()));
    PhysicalLocation {
        artifact_location: ArtifactLocation { uri },
        region: Region {
            start_line: begin.line,
            start_column: begin.column,
            end_line: end.line,
            end_column: end.column,
        },
    }
}

/// A path as a URI: relative as it was given, or `file:///`. RFC 3986.
fn uri(path: &Path) -> String {
    let mut out = String::new();
    if path.is_absolute() {
        out.push_str("file://");
    }
    let mut first = true;
    for component in path.components() {
        let text = match component {
            Component::RootDir => {
                first = false;
                out.push('/');
                continue;
            }
            Component::CurDir => continue,
            other => other.as_os_str().to_string_lossy().into_owned(),
        };
        if !first && !out.ends_with('/') {
            out.push('/');
        }
        first = false;
        for byte in text.bytes() {
            if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
                out.push(char::from(byte));
            } else {
                out.push_str(&format!("%{byte:02X}"));
            }
        }
    }
    out
}
