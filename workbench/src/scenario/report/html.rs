//! The report as one HTML page that needs nothing else.

use std::fmt::Write as _;

use super::human::{decided_by, ladder_of};
use super::{CoverageReport, FailureReport, ProjectReport, ScenarioReport};
use crate::diagram::{self, Style};
use crate::html::{self, escaped};

/// Columns of drawings on the page.
const COLUMNS: usize = 120;

/// The reports of several projects as one page.
pub fn page(reports: &[ProjectReport]) -> String {
    let mut out = html::head("Project verification test");
    for report in reports {
        project(&mut out, report);
    }
    out.push_str(html::END);
    out
}

fn project(out: &mut String, report: &ProjectReport) {
    let met = report.scenarios.len() - report.failed();
    let coverage = &report.coverage;
    let minimum = coverage.minimum.map_or(String::new(), |minimum| format!(" (at least {minimum} % is demanded)"));
    let _ = write!(
        out,
        "<h1>{}</h1>\n<p class=\"verdict\">Safety application {}: {met} of {} scenarios met, coverage {} %{minimum}: \
         <span class=\"{}\">{}</span></p>\n<h2>Scenarios</h2>\n<table><tr><th>scenario<th>verdict<th>expectations<th>simulated</tr>\n",
        escaped(&report.project),
        escaped(&report.signature),
        report.scenarios.len(),
        coverage.percent,
        if report.is_good() { "met" } else { "not" },
        if report.is_good() { "passed" } else { "not passed" },
    );
    for scenario in &report.scenarios {
        let (class, word) = if scenario.passed { ("met", "met") } else { ("not", "not met") };
        let _ = writeln!(
            out,
            "<tr><td>{}<br><small>{}:{}</small><td class=\"{class}\">{word}<td class=\"n\">{}<td class=\"n\">{} ms</tr>",
            escaped(&scenario.name),
            escaped(&scenario.file),
            scenario.line,
            scenario.expectations,
            scenario.end_ms
        );
    }
    out.push_str("</table>\n");
    for scenario in report.scenarios.iter().filter(|scenario| !scenario.passed) {
        let _ = writeln!(out, "<h2>Not met: {}</h2>", escaped(&scenario.name));
        scenario.failures.iter().for_each(|failure| failed(out, scenario, failure));
    }
    covered(out, coverage);
}

fn failed(out: &mut String, scenario: &ScenarioReport, failure: &FailureReport) {
    let _ = writeln!(
        out,
        "<p><code>{}:{}</code> {}<br><span class=\"not\">at {} ms {}</span></p>",
        escaped(&scenario.file),
        failure.line,
        escaped(&failure.expected),
        failure.at_ms,
        escaped(&failure.found)
    );
    let drawn = diagram::draw(&failure.recording, Style { columns: COLUMNS, colour: false });
    let _ = writeln!(out, "<pre>{}</pre>", escaped(&drawn));
    if let Some(decision) = &failure.decision {
        let ladder = ladder_of(decision, COLUMNS, false).join("\n");
        let _ = writeln!(out, "<p>{}</p>\n<pre>{}</pre>", escaped(&decided_by(decision)), escaped(&ladder));
    }
}

fn covered(out: &mut String, coverage: &CoverageReport) {
    out.push_str("<h2>Coverage</h2>\n<table><tr><th>what<th>shown<th>of<th>excluded</tr>\n");
    for (kind, share) in coverage.kinds.iter().filter(|(_, share)| share.total > 0) {
        let _ = writeln!(
            out,
            "<tr><td>{}<td class=\"n\">{}<td class=\"n\">{}<td class=\"n\">{}</tr>",
            kind.plural(),
            share.reached,
            share.total,
            share.excluded
        );
    }
    out.push_str("</table>\n");
    let missing = coverage.missing.iter().map(|item| (&item.name, &item.way));
    rows(out, "Not shown by any scenario", "the way to it", missing);
    rows(out, "Excluded", "because", coverage.excluded.iter().map(|excluded| (&excluded.item, &excluded.reason)));
}

fn rows<'a>(out: &mut String, heading: &str, column: &str, list: impl Iterator<Item = (&'a String, &'a String)>) {
    let mut list = list.peekable();
    if list.peek().is_none() {
        return;
    }
    let _ = writeln!(out, "<h3>{heading}</h3>\n<table><tr><th>item<th>{column}</tr>");
    for (item, text) in list {
        let _ = writeln!(out, "<tr><td>{}<td>{}</tr>", escaped(item), escaped(text));
    }
    out.push_str("</table>\n");
}
