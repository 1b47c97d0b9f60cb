//! `twinrung bench`: what a report holds, that inputs take both truths, and that generated programs are those of the shared
//! generator.

use std::path::Path;
use std::process::Command;

use twinrung_catalog::Opcode;
use twinrung_trio::Subject as Trial;
use twinrung_workbench::bench::{Driven, Measurement, Plan, Report, estimate, measure, page, picture};
use twinrung_workbench::instruction_rungs::{Literals, Subject, project};
use twinrung_workbench::mix::{Mix, Program, Toggles};

use crate::support::{image_of, project_path, read_whole, shared_path, text};

fn measured(path: &Path, plan: &Plan) -> (Measurement, Report) {
    let (image, bytes) = image_of(&read_whole(path));
    let measurement = measure(&image, &bytes, plan, |_| {}).unwrap_or_else(|error| panic!("{error}"));
    let report = Report::new(&image, &measurement, None);
    (measurement, report)
}

fn sample() -> (Measurement, Report) {
    let plan = Plan { scans: 300, warm_up: 10, ..Plan::default() };
    measured(&project_path("samples/estop-with-contactors"), &plan)
}

#[test]
fn bench_report_when_written_as_json_then_it_has_the_promised_keys() {
    let json = serde_json::to_value(sample().1).unwrap();
    let numbers =
        ["rungs", "scans", "period_ns", "watchdog_ns", "bound_instructions", "max_instructions"].map(|key| &json[key]);
    assert!(numbers.iter().all(|value| value.as_u64().is_some_and(|number| number > 0)), "{json:#}");
    for part in ["scan_ns", "primary_ns", "partner_ns", "compare_ns"] {
        assert!(["p50", "p99", "p999", "max"].iter().all(|key| json[part][key].is_u64()), "{part}: {json:#}");
    }
}

/// REQ-BOUND-001
#[test]
fn bench_when_a_sample_is_driven_at_random_then_all_inputs_are_off_and_on_and_the_bound_holds() {
    let (measurement, report) = sample();
    let coverage = measurement.coverage.unwrap();
    assert_eq!(measurement.stopped, None);
    assert_eq!(measurement.whole.count(), 300);
    assert!(coverage.bools > 0);
    assert_eq!(coverage.both_truths, coverage.bools);
    assert!(report.max_instructions <= report.bound_instructions, "{report:#?}");
    let counted: u64 = report.programs.iter().map(|program| program.max_instructions).sum();
    assert_eq!(counted, report.max_instructions, "the observer counts what `executed` counts");
}

#[test]
fn bench_report_when_drawn_then_picture_and_page_say_what_the_watchdog_could_be() {
    let (_, report) = sample();
    let verdict = report.verdict();
    assert!(verdict.contains("the watchdog could be set to"), "{verdict}");
    assert!(picture(&report, 100).ends_with(&format!("{verdict}\n")));
    let page = page(&report);
    assert!(page.contains("<svg") && page.contains("</html>"));
    assert!(!page.contains("http"), "the page needs nothing from elsewhere");
}

#[test]
fn rungs_of_one_instruction_when_each_safety_application_instruction_is_tried_then_a_project_compiles() {
    let compiles = |opcode: Opcode| {
        [Literals::Least, Literals::Greatest]
            .into_iter()
            .filter_map(|literals| project(Subject::One(opcode, 1), 3, literals))
            .any(|text| Trial::from_text(&text).is_ok())
    };
    let all = Opcode::ALL.iter().copied().filter(|opcode| opcode.instruction().safety.is_some());
    let refused: Vec<&str> =
        all.filter(|opcode| !compiles(*opcode)).map(|opcode| opcode.instruction().mnemonic).collect();
    assert!(refused.is_empty(), "{refused:?}");
}

#[test]
fn estimate_when_made_for_a_sample_then_every_instruction_of_it_has_a_cost() {
    let (image, _) = image_of(&read_whole(&project_path("samples/estop-with-contactors")));
    let estimate = estimate(&image).unwrap();
    let names: Vec<&str> = estimate.costs.iter().map(|row| row.of.as_str()).collect();
    assert!(["scan", "rung", "XIC", "OTE", "CROUT"].iter().all(|name| names.contains(name)), "{names:?}");
    assert!(estimate.bound_ns > 0);
}

fn generated(generator: &Path, mix: Mix, seed: u64) -> [String; 3] {
    let folder = tempfile::tempdir().unwrap();
    let arguments =
        ["700", folder.path().to_str().unwrap(), "20", &mix.to_string(), &seed.to_string()].map(str::to_owned);
    let status = Command::new("python3").arg(generator).args(arguments).status().unwrap();
    assert!(status.success());
    ["project.rll", "project.L5X", "stimulus.csv"].map(|name| text(&folder.path().join(name)))
}

#[test]
fn mixes_when_generated_then_they_are_those_of_the_shared_generator() {
    let Some(generator) = shared_path("bench/gen.py") else { return };
    for (mix, seed) in [(Mix::Simple, 1), (Mix::Plant, 1), (Mix::Plant, 2), (Mix::Plant, 77)] {
        let program = Program::new(mix, 700, seed);
        let own = [program.rll(), program.l5x(), Toggles::csv(20)];
        assert!(own == generated(&generator, mix, seed), "{mix}, seed {seed}");
    }
}

#[test]
fn bench_when_a_mix_is_toggled_then_the_same_toggles_give_the_same_hash() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("project.rll");
    std::fs::write(&path, Program::new(Mix::Plant, 200, 5).rll()).unwrap();
    let plan = |inputs| Plan { scans: 60, warm_up: 0, inputs, realtime: false };
    let (toggled, _) = measured(&path, &plan(Driven::Toggles(16)));
    let (again, _) = measured(&path, &plan(Driven::Toggles(16)));
    let (still, _) = measured(&path, &plan(Driven::Toggles(0)));
    assert_eq!(toggled.hash, again.hash);
    assert_ne!(toggled.hash, still.hash);
}
