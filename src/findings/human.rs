//! Findings for a person: what is wrong, the place in the text, the rung as ladder with the operand marked, related
//! places, the way out.

use std::io::{self, Write};

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, SourceCode};
use twinrung_compiler::diagnostic::{Finding, Label, PlacedRung, RungIndex, Severity};
use twinrung_grammar::tree::{FileForm, SourceId, Sources, Span};
use twinrung_workbench::ladder::{self, Places};
use twinrung_workbench::pages::terminal::wrapped;

use super::quote::{Quote, range};
use super::{Report, file_name};
use crate::terminal::Terminal;

/// Columns before a drawing.
const INDENT: usize = 6;

/// What drawing needs.
struct Printer<'a, 'o> {
    out: &'o mut dyn Write,
    sources: &'a Sources,
    rungs: RungIndex<'a>,
    /// Files in which a rung reads better drawn than quoted.
    exports: Vec<SourceId>,
    terminal: Terminal,
    handler: GraphicalReportHandler,
}

/// Prints findings, without notes unless `notes`; then what is suppressed, with the reasons.
pub fn print_human(out: &mut dyn Write, report: &Report<'_>, terminal: Terminal, notes: bool) -> io::Result<()> {
    let theme = if terminal.colour { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
    let handler =
        GraphicalReportHandler::new_themed(theme).with_width(terminal.columns).with_context_lines(1).with_links(false);
    let exports = report.trees.iter().filter(|file| file.form == FileForm::Xml).flat_map(|file| file.sources.clone());
    let mut printer = Printer {
        out,
        sources: report.sources,
        rungs: RungIndex::new(report.trees),
        exports: exports.collect(),
        terminal,
        handler,
    };
    let shown = |finding: &&Finding| finding.accepted.is_none() && (notes || finding.severity != Severity::Note);
    for finding in report.findings.iter().filter(shown) {
        printer.finding(finding)?;
    }
    printer.suppressed(report.findings)
}

impl<'a> Printer<'a, '_> {
    fn finding(&mut self, finding: &Finding) -> io::Result<()> {
        let rung = self.rungs.at(finding.span).copied();
        let here = finding.span.source;
        let drawn = rung.and_then(|rung| self.draw(&rung, finding));
        let export = self.exports.contains(&here);
        // In an export the drawing says it better than XML; in text the line is what one edits.
        let quotes = drawn.is_none() || !export;
        let (near, far): (Vec<&Label>, Vec<&Label>) =
            finding.labels.iter().partition(|label| quotes && label.span.source == here);
        let mut labels = Vec::new();
        if quotes {
            let first = Some("here".to_owned()).filter(|_| !near.is_empty());
            labels.push(LabeledSpan::new_primary_with_span(first, range(self.sources, finding.span)));
            labels
                .extend(near.iter().map(|label| {
                    LabeledSpan::new_with_span(Some(label.text.clone()), range(self.sources, label.span))
                }));
        }
        let message = match &rung {
            Some(rung) => format!("{} ({}, rung {})", finding.message, rung.routine_name(), rung.number),
            None => finding.message.clone(),
        };
        self.report(&Quoted {
            message,
            code: finding.code.id,
            severity: match finding.severity {
                Severity::Error => miette::Severity::Error,
                Severity::Warning => miette::Severity::Warning,
                Severity::Note => miette::Severity::Advice,
            },
            source: Quote::of(self.sources, finding.span),
            labels,
        })?;
        if let (Some(lines), Some(rung)) = (drawn, &rung) {
            let head = if quotes { title(rung) } else { format!("{} {}", self.place(finding.span), title(rung)) };
            self.frame(&head, &lines)?;
        }
        for label in far {
            self.related(label, finding)?;
        }
        if let Some(help) = &finding.help {
            self.help(help)?;
        }
        writeln!(self.out)
    }

    /// A related place that stands in another file, or in an export: its rung drawn, or its line.
    fn related(&mut self, label: &Label, finding: &Finding) -> io::Result<()> {
        if let Some(rung) = self.rungs.at(label.span).copied() {
            // On the same rung it is marked in the drawing above.
            let same = self.rungs.at(finding.span).is_some_and(|own| own.rung.span == rung.rung.span);
            let places = Places { primary: None, related: &[label.span] };
            let lines = if same { None } else { self.lines(&rung, places) };
            let head = format!("{}: {} {}", label.text, self.place(label.span), title(&rung));
            return self.frame(&head, &lines.unwrap_or_default());
        }
        self.report(&Quoted {
            message: label.text.clone(),
            code: "",
            severity: miette::Severity::Advice,
            source: Quote::of(self.sources, label.span),
            labels: vec![LabeledSpan::new_with_span(None, range(self.sources, label.span))],
        })
    }

    fn suppressed(&mut self, findings: &[Finding]) -> io::Result<()> {
        let mut list = findings.iter().filter_map(|finding| Some((finding, finding.accepted.as_deref()?))).peekable();
        if list.peek().is_some() {
            writeln!(self.out, "Suppressed, each for the reason given:")?;
        }
        for (finding, reason) in list {
            let place = self.place(finding.span);
            writeln!(self.out, "  {} {place} {}\n        because: {reason}", finding.code.id, finding.message)?;
        }
        Ok(())
    }

    fn draw(&self, rung: &PlacedRung<'_>, finding: &Finding) -> Option<Vec<String>> {
        let related: Vec<Span> = finding.labels.iter().map(|label| label.span).collect();
        self.lines(rung, Places { primary: Some(finding.span), related: &related })
    }

    fn lines(&self, rung: &PlacedRung<'_>, places: Places<'_>) -> Option<Vec<String>> {
        ladder::draw(rung.rung, places, self.terminal.columns.saturating_sub(INDENT), self.terminal.colour)
    }

    fn report(&mut self, quoted: &Quoted<'_>) -> io::Result<()> {
        let mut text = String::new();
        self.handler.render_report(&mut text, quoted).map_err(io::Error::other)?;
        self.out.write_all(text.as_bytes())
    }

    fn frame(&mut self, head: &str, lines: &[String]) -> io::Result<()> {
        if lines.is_empty() {
            return writeln!(self.out, "    ╶─[{head}]");
        }
        writeln!(self.out, "    ╭─[{head}]")?;
        for line in lines {
            writeln!(self.out, "    · {line}")?;
        }
        writeln!(self.out, "    ╰────")
    }

    fn help(&mut self, help: &str) -> io::Result<()> {
        let (begin, end) = if self.terminal.colour { ("\u{1b}[36m", "\u{1b}[0m") } else { ("", "") };
        let hang = "  help: ".len();
        let mut text = String::new();
        wrapped(&mut text, help, hang, hang, self.terminal.columns);
        write!(self.out, "  {begin}help:{end} {}", text.trim_start())
    }

    fn place(&self, span: Span) -> String {
        let place = self.sources.line_column(span);
        format!("{}:{}:{}", file_name(self.sources, span.source), place.line, place.column)
    }
}

fn title(rung: &PlacedRung<'_>) -> String {
    format!("{}, rung {}", rung.routine_name(), rung.number)
}

/// One text with marked places, as miette draws it.
#[derive(Debug)]
struct Quoted<'a> {
    message: String,
    code: &'static str,
    severity: miette::Severity,
    source: Quote<'a>,
    labels: Vec<LabeledSpan>,
}

impl std::fmt::Display for Quoted<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Quoted<'_> {}

impl Diagnostic for Quoted<'_> {
    fn code<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        (!self.code.is_empty()).then(|| Box::new(self.code) as Box<dyn std::fmt::Display>)
    }

    fn severity(&self) -> Option<miette::Severity> {
        Some(self.severity)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&self.source)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().cloned()))
    }
}
