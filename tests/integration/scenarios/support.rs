//! Scenario texts on small projects.

use std::path::Path;

use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::{AdmittedImage, admit};
use twinrung_compiler::diagnostic::{Finding, reading_finding};
use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::tree::Sources;
use twinrung_grammar::{read, read_scenarios};
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::scenario::Suite;
use twinrung_workbench::scenario::report::ProjectReport;

use crate::support::{project_path, text};

/// The image of a project's text, with its bytes.
pub fn image(project: &str) -> (AdmittedImage, Vec<u8>) {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "project.rll", project.as_bytes().to_vec());
    let checked = check(&reading, &Completion::default());
    let messages: Vec<&String> = checked.findings.iter().map(|finding| &finding.message).collect();
    let project = checked.project.unwrap_or_else(|| panic!("refused: {messages:#?}"));
    let bytes = compile(&project).unwrap_or_else(|finding| panic!("{}", finding.message)).bytes;
    (admit(&bytes).unwrap_or_else(|error| panic!("{error}")), bytes)
}

/// A project of the emergency stop sample's shape around these tags and rungs, one scan each 20 ms.
pub fn project(tags: &str, rungs: &str) -> String {
    format!(
        "CONTROLLER T (ProcessorType := \"1756-L73S\", Major := 20)\nTAG\n{tags}\nEND_TAG\n\
         PROGRAM P (Class := Safety, MAIN := \"Main\")\nROUTINE Main\n{rungs}\nEND_ROUTINE\nEND_PROGRAM\n\
         TASK S (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 10, Priority := 5)\nP;\nEND_TASK\nEND_CONTROLLER\n"
    )
}

/// The heater of docs/scenarios.md.
pub fn heater() -> String {
    text(&project_path("tests/scenario/heater.rll"))
}

/// What is wrong with scenarios, as `code line: message; help`; their report where nothing is.
pub fn tried<A: Channel, B: Channel>(
    (image, bytes): &(AdmittedImage, Vec<u8>),
    scenarios: &str,
) -> Result<ProjectReport, Vec<String>> {
    let mut sources = Sources::new();
    let reading = read_scenarios(&mut sources, Path::new("x.scenario"), scenarios.as_bytes().to_vec());
    let line = |finding: &Finding| {
        let place = sources.line_column(finding.span);
        let help = finding.help.as_ref().map_or(String::new(), |help| format!("; {help}"));
        format!("{} {}: {}{help}", finding.code.id, place.line, finding.message)
    };
    let mut suite = Suite::new(image, bytes);
    let mut wrong: Vec<String> = reading.errors.iter().map(reading_finding).map(|finding| line(&finding)).collect();
    wrong.extend(suite.add(Path::new("x.scenario"), &reading.file).iter().map(line));
    let report = |suite: Suite<'_>| suite.run::<A, B>("x".to_owned(), &sources, |_| {});
    if wrong.is_empty() { Ok(report(suite).unwrap_or_else(|error| panic!("{error}"))) } else { Err(wrong) }
}

/// The report of scenarios in which nothing is wrong.
pub fn report(project: &str, scenarios: &str) -> ProjectReport {
    tried::<Primary, Partner>(&image(project), scenarios).unwrap_or_else(|wrong| panic!("{wrong:#?}"))
}

/// What is wrong with scenarios.
pub fn refused(project: &str, scenarios: &str) -> Vec<String> {
    tried::<Primary, Partner>(&image(project), scenarios).err().unwrap_or_default()
}

/// What was not met, as `line: at ms found`.
pub fn failures(report: &ProjectReport) -> Vec<String> {
    let all = report.scenarios.iter().flat_map(|scenario| &scenario.failures);
    all.map(|failure| format!("{}: at {} ms {}", failure.line, failure.at_ms, failure.found)).collect()
}

/// What is not met of one scenario on the heater.
pub fn on_heater(lines: &str) -> Vec<String> {
    failures(&report(&heater(), &format!("scenario \"x\"\n{lines}\nend\n")))
}

/// Items that are missing.
pub fn missing(report: &ProjectReport) -> Vec<&str> {
    report.coverage.missing.iter().map(|item| item.name.as_str()).collect()
}
