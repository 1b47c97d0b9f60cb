//! The report as JUnit XML, as build servers take it: a suite for each project, a case for each scenario, and one for the
//! coverage where a minimum is demanded.

use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};

use super::human::decided_by;
use super::{ProjectReport, ScenarioReport};
use crate::diagram::{self, Style};

/// Columns of the diagrams.
const COLUMNS: usize = 100;

/// The reports of several projects as one document.
///
/// # Errors
///
/// None but those of writing into memory.
pub fn junit(reports: &[ProjectReport]) -> io::Result<String> {
    let mut writer = Writer::new_with_indent(Vec::new(), b' ', 2);
    writer.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    writer
        .create_element("testsuites")
        .write_inner_content(|writer| reports.iter().try_for_each(|report| suite(writer, report)))?;
    let mut bytes = writer.into_inner();
    bytes.push(b'\n');
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn suite(writer: &mut Writer<Vec<u8>>, report: &ProjectReport) -> io::Result<()> {
    let judged = report.coverage.minimum.is_some();
    let tests = (report.scenarios.len() + usize::from(judged)).to_string();
    let failures = (report.failed() + usize::from(!report.coverage.enough)).to_string();
    let element = writer.create_element("testsuite").with_attributes([
        ("name", report.project.as_str()),
        ("tests", tests.as_str()),
        ("failures", failures.as_str()),
    ]);
    element.write_inner_content(|writer| {
        report.scenarios.iter().try_for_each(|scenario| case(writer, scenario))?;
        if judged { coverage(writer, report) } else { Ok(()) }
    })?;
    Ok(())
}

fn case(writer: &mut Writer<Vec<u8>>, scenario: &ScenarioReport) -> io::Result<()> {
    let line = scenario.line.to_string();
    // Simulated time: the same on every machine.
    let seconds = format!("{:.3}", scenario.end_ms as f64 / 1000.0);
    let element = writer.create_element("testcase").with_attributes([
        ("classname", scenario.file.as_str()),
        ("name", scenario.name.as_str()),
        ("file", scenario.file.as_str()),
        ("line", line.as_str()),
        ("time", seconds.as_str()),
    ]);
    if scenario.failures.is_empty() {
        element.write_empty()?;
        return Ok(());
    }
    element.write_inner_content(|writer| {
        for failure in &scenario.failures {
            let message = format!("{}: at {} ms {}", failure.expected, failure.at_ms, failure.found);
            let drawn = diagram::draw(&failure.recording, Style { columns: COLUMNS, colour: false });
            let decided = failure.decision.as_ref().map(decided_by).unwrap_or_default();
            let text = format!("{}:{}\n{drawn}{decided}\n", scenario.file, failure.line);
            writer
                .create_element("failure")
                .with_attributes([("message", message.as_str()), ("type", "expectation")])
                .write_text_content(BytesText::new(&text))?;
        }
        Ok(())
    })?;
    Ok(())
}

fn coverage(writer: &mut Writer<Vec<u8>>, report: &ProjectReport) -> io::Result<()> {
    let element = writer
        .create_element("testcase")
        .with_attributes([("classname", report.project.as_str()), ("name", "coverage")]);
    if report.coverage.enough {
        element.write_empty()?;
        return Ok(());
    }
    let minimum = report.coverage.minimum.unwrap_or_default();
    let message = format!("coverage {} %, at least {minimum} % is demanded", report.coverage.percent);
    let missing: Vec<String> =
        report.coverage.missing.iter().map(|item| format!("{}: {}", item.name, item.way)).collect();
    element.write_inner_content(|writer| {
        writer
            .create_element("failure")
            .with_attributes([("message", message.as_str()), ("type", "coverage")])
            .write_text_content(BytesText::new(&missing.join("\n")))?;
        Ok(())
    })?;
    Ok(())
}
