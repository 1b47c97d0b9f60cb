//! The command as its users run it.

use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

use crate::command::twinrung;
use crate::support::project_path;

const SAMPLE: &str = "samples/estop-with-contactors";

/// A scenario file in a folder of its own, beside the heater.
fn beside_heater(scenarios: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(project_path("tests/scenario/heater.rll"), folder.path().join("heater.rll")).unwrap();
    let path = folder.path().join("x.scenario");
    fs::write(&path, scenarios).unwrap();
    let name = path.to_string_lossy().into_owned();
    (folder, name)
}

fn code(scenarios: &str, more: &[&str]) -> Option<i32> {
    let (_folder, path) = beside_heater(scenarios);
    twinrung(&[&["test", path.as_str()], more].concat()).code
}

/// REQ-TEST-016
#[test]
fn exit_code_when_scenarios_end_then_it_says_how() {
    let met = "scenario \"x\"\nthen Run is off\nend\n";
    assert_eq!(code(met, &[]), Some(0));
    assert_eq!(code(met, &["--minimum", "100"]), Some(1));
    assert_eq!(code(met, &["--minimum", "10"]), Some(0));
    assert_eq!(code(&format!("minimum coverage 100 %\n{met}"), &[]), Some(1));
    assert_eq!(code(&format!("minimum coverage 100 %\n{met}"), &["--minimum", "0"]), Some(0));
    assert_eq!(code(&format!("minimum coverage 100 %\n{met}"), &["--filter", "x"]), Some(0));
    assert_eq!(code("scenario \"x\"\nthen Run is on\nend\n", &[]), Some(1));
    assert_eq!(code("scenario \"x\"\nthen Run = on\nend\n", &[]), Some(1));
    assert_eq!(code("scenario \"x\"\ngiven Index is 4, Fetch is on\nthen Run is off\nend\n", &[]), Some(4));
    assert_eq!(code("project \"other.rll\"\nscenario \"x\"\nthen Run is off\nend\n", &[]), Some(2));
    assert_eq!(twinrung(&["test", "samples/none"]).code, Some(2));
    assert_eq!(code(met, &["--expect", "0000_0000"]), Some(1));
}

/// REQ-TEST-016
#[test]
fn folder_when_tested_then_every_scenario_file_in_it_is_played() {
    let said = twinrung(&["test", "samples"]);
    assert_eq!((said.code, said.err.contains("error")), (Some(0), false), "{}{}", said.out, said.err);
    let projects = said.out.matches("coverage 100 %, at least 100 % is demanded").count();
    assert!(projects >= 3, "{}", said.out);
}

#[test]
fn filter_when_it_concerns_one_project_of_several_then_the_others_are_left_out_and_none_is_an_error() {
    let said = twinrung(&["test", "samples", "--filter", "WELDED"]);
    assert_eq!((said.code, said.out.matches("  met     ").count()), (Some(0), 3), "{}", said.out);
    assert!(!said.out.contains("two-hand-press"), "{}", said.out);
    assert_eq!(twinrung(&["test", "samples", "--filter", "no such name"]).code, Some(2));
}

/// A process that ends with the test, however the test ends.
struct Watching(Child);

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// REQ-TEST-019
#[test]
fn watch_when_a_file_changes_then_its_scenarios_are_played_again() {
    let (folder, path) = beside_heater("scenario \"x\"\nthen Run is off\nend\n");
    let printed = folder.path().join("printed");
    let child = Command::new(env!("CARGO_BIN_EXE_twinrung"))
        .args(["test", path.as_str(), "--watch"])
        .stdout(fs::File::create(&printed).unwrap())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut watching = Watching(child);
    let mut told = BufReader::new(watching.0.stderr.take().unwrap()).lines().map(Result::unwrap);
    assert!(told.by_ref().any(|line| line == "waiting for a change"));
    assert_eq!(fs::read_to_string(&printed).unwrap().matches("coverage").count(), 1);
    fs::write(&path, "scenario \"renamed\"\nthen Run is off\nend\n").unwrap();
    assert!(told.by_ref().any(|line| line == "waiting for a change"));
    assert!(fs::read_to_string(&printed).unwrap().contains("renamed"));
}

/// REQ-TEST-017
#[test]
fn reports_when_written_then_json_and_junit_say_what_the_terminal_says() {
    let folder = tempfile::tempdir().unwrap();
    let (junit, html) = (folder.path().join("out.xml"), folder.path().join("out.html"));
    let said = twinrung(&[
        "test",
        SAMPLE,
        "--format",
        "json",
        "--junit",
        &junit.to_string_lossy(),
        "--html",
        &html.to_string_lossy(),
    ]);
    let json: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    let project = &json["projects"][0];
    let scenarios = project["scenarios"].as_array().unwrap().len();
    assert_eq!((project["passed"].as_bool(), project["coverage"]["percent"].as_u64()), (Some(true), Some(100)));
    let xml = fs::read_to_string(junit).unwrap();
    assert_eq!(xml.matches("<testcase").count(), scenarios + 1);
    assert!(xml.contains(&format!("tests=\"{}\" failures=\"0\"", scenarios + 1)), "{xml}");
    assert!(fs::read_to_string(html).unwrap().contains(&format!("{scenarios} of {scenarios} scenarios met")));
}

/// REQ-TEST-018
#[test]
fn layout_when_asked_for_then_the_file_is_rewritten_and_then_canonical() {
    let (_folder, path) = beside_heater("scenario \"x\"\n at 20ms\nthen Run is off\nend");
    assert_eq!(twinrung(&["fmt", "--check", &path]).code, Some(1));
    assert_eq!(twinrung(&["fmt", &path]).code, Some(0));
    assert_eq!(fs::read_to_string(&path).unwrap(), "scenario \"x\"\n  at 20 ms\n    then Run is off\nend\n");
    assert_eq!(twinrung(&["fmt", "--check", &path]).code, Some(0));
    assert_eq!(twinrung(&["test", &path]).code, Some(0));
}
