//! `twinrung evidence` and the reports that it reads.

use std::fs;
use std::path::Path;

use twinrung_workbench::evidence::{Conditions, Evidence, File, Measured, Sources, Times};
use twinrung_workbench::inject::Recorded;

use crate::command::twinrung;

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap()
}

/// REQ-EVIDENCE-002, REQ-EVIDENCE-008
#[test]
fn evidence_when_reports_are_missing_or_unreadable_then_the_exit_code_says_so() {
    let project = tempfile::tempdir().unwrap();
    let (reports, page) = (project.path().join("evidence"), project.path().join("page.html"));
    let run = || twinrung(&["evidence", "--folder", reports.to_str().unwrap(), "-o", page.to_str().unwrap()]);
    let absent = run();
    assert_eq!((absent.code, page.exists()), (Some(2), false), "{}", absent.err);
    assert!(absent.err.contains("there is no such folder"), "{}", absent.err);
    fs::create_dir_all(reports.join("fuzz")).unwrap();
    let empty = run();
    assert_eq!(empty.code, Some(1), "{}", empty.err);
    assert!(empty.out.contains("NOT MET  seeded defects: not measured (demanded: at least 60)"), "{}", empty.out);
    assert!(text(&page).contains("NOT ENOUGH for a release"));
    fs::remove_file(&page).unwrap();
    fs::write(reports.join("fuzz/broken.json"), "{").unwrap();
    let broken = run();
    assert_eq!((broken.code, page.exists()), (Some(2), false), "{}", broken.out);
    assert!(broken.err.contains("evidence/fuzz/broken.json: "), "{}", broken.err);
}

/// REQ-INJECT-008, REQ-EVIDENCE-005
#[test]
fn injection_when_asked_for_a_report_and_a_page_then_both_are_written_and_evidence_reads_the_report() {
    let project = tempfile::tempdir().unwrap();
    let reports = project.path().join("evidence");
    fs::create_dir_all(reports.join("inject")).unwrap();
    let (report, page) = (reports.join("inject/estop.json"), project.path().join("estop.html"));
    let said = twinrung(&[
        "inject",
        "samples/estop-with-contactors",
        "--injections",
        "9000",
        "--group",
        "channel,residual",
        "--jobs",
        "1",
        "--report",
        report.to_str().unwrap(),
        "--html",
        page.to_str().unwrap(),
    ]);
    let recorded: Recorded = serde_json::from_str(&text(&report)).unwrap();
    assert_eq!(
        (recorded.project.as_str(), recorded.signature.as_str()),
        ("samples/estop-with-contactors", "8245_78da")
    );
    assert!(
        recorded.provenance.command.as_ref().unwrap().starts_with("twinrung inject samples/estop-with-contactors ")
    );
    let page = text(&page);
    assert!(page.contains("No fault that the controller has to find let a wrong output out."), "{}", said.out);
    let misses: Vec<&String> = recorded.report.classes.iter().flat_map(|class| &class.misses).collect();
    assert!(!misses.is_empty() && misses.iter().all(|miss| page.contains(&format!("{} {miss}", recorded.replay))));
    let json = twinrung(&[
        "evidence",
        "--folder",
        reports.to_str().unwrap(),
        "-o",
        project.path().join("page.html").to_str().unwrap(),
        "--format",
        "json",
    ]);
    let evidence: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert_eq!(evidence["injection"]["projects"][0]["project"], "samples/estop-with-contactors");
}

/// REQ-EVIDENCE-004. The runner of the seeded defects writes what the evidence reads.
#[test]
fn times_when_the_runner_writes_them_then_the_evidence_reads_them() {
    let mut times = Times::default();
    let taken = Measured { found: true, seconds: 2.5, cases: 9 };
    let conditions = Conditions {
        jobs: 2,
        limit_s: 300,
        seed: 1,
        version: "0.1.0".to_owned(),
        rustc: "rustc 1.95.0".to_owned(),
        processor: "A fast one".to_owned(),
        cores: 8,
    };
    times.enter(false, "late", taken, conditions.clone()).unwrap();
    let file = |name: &str, text: String| File { name: name.to_owned(), bytes: text.into_bytes() };
    let sources = Sources {
        times: Some(file("tests/defects/times.toml", toml::to_string(&times).unwrap())),
        defects: vec![file("tests/defects/primary.toml", "[[defect]]\nname = \"late\"\n".to_owned())],
        ..Sources::default()
    };
    let defects = Evidence::read(&sources).unwrap().defects;
    assert_eq!((defects.guided.found, defects.guided.median, defects.defects[0].guided), (1, Some(2.5), Some(taken)));
    assert_eq!(defects.conditions["guided"], conditions);
    let text = toml::to_string(&times).unwrap();
    for field in ["jobs", "limit_s", "seed", "version", "rustc", "processor", "cores"] {
        let renamed = text.replace(&format!("\n{field} ="), &format!("\n{field}_of_another_release ="));
        assert_ne!(renamed, text);
        assert!(toml::from_str::<Times>(&renamed).is_err(), "{renamed}");
    }
}

/// REQ-EVIDENCE-004. One list of times has one set of conditions: a short look at one defect does not change what the others were
/// measured under.
#[test]
fn times_when_one_is_measured_under_other_conditions_than_the_rest_then_it_is_refused_and_nothing_changes() {
    let conditions = |limit_s| Conditions { jobs: 2, limit_s, seed: 1, ..Conditions::default() };
    let taken = Measured { found: true, seconds: 2.5, cases: 9 };
    let mut times = Times::default();
    times.enter(false, "late", taken, conditions(300)).unwrap();
    times.enter(false, "stuck", taken, conditions(300)).unwrap();
    let before = times.clone();
    assert!(times.admits(false, 2, 300, 1).is_ok() && times.admits(true, 2, 10, 1).is_ok());
    let refused = [times.admits(false, 2, 10, 1), times.enter(false, "late", taken, conditions(10))];
    for error in refused.map(Result::unwrap_err) {
        assert_eq!((error.way, error.recorded.limit_s), ("guided", 300));
        assert!(
            error.to_string().contains("--limit 300") && error.to_string().contains("move the file away"),
            "{error}"
        );
    }
    assert_eq!(times, before);
    times.enter(true, "late", taken, conditions(10)).unwrap();
}
