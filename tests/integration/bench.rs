//! `twinrung bench`: what a report holds, that inputs take both truths, and that generated programs are those of the shared
//! generator.

use std::path::Path;
use std::process::Command;
use std::time::Duration;

use twinrung_bytecode::bound;
use twinrung_catalog::Opcode;
use twinrung_trio::Subject as Trial;
use twinrung_workbench::bench::{
    Distribution, Driven, Estimate, Measurement, Plan, Report, estimate, measure, page, picture, scans_in_all,
};
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
    let prescan = report.prescan_instructions.unwrap();
    assert!(0 < prescan && prescan <= report.bound_prescan_instructions, "{report:#?}");
    let counted: u64 = report.programs.iter().map(|program| program.max_instructions).sum();
    assert_eq!(counted, report.max_instructions, "the observer counts what `executed` counts");
}

/// A report in which every scan took so long.
fn report_of(scan: Duration) -> Report {
    let (measurement, _) = sample();
    let (image, _) = image_of(&read_whole(&project_path("samples/estop-with-contactors")));
    let mut whole = Distribution::new().unwrap();
    (0..measurement.scans).for_each(|_| whole.record(scan));
    Report::new(&image, &Measurement { whole, ..measurement }, None)
}

#[test]
fn bench_report_when_drawn_then_picture_and_page_say_what_the_watchdog_could_be() {
    let report = report_of(Duration::from_micros(1600));
    let verdict = report.verdict();
    let possible =
        "On this machine the watchdog could be set to 4 ms (2 times the slowest scan, in whole milliseconds).";
    assert!(verdict.ends_with(possible), "{verdict}");
    assert!(picture(&report, 100).ends_with(&format!("{verdict}\n")));
    let page = page(&report);
    assert!(page.contains("<svg") && page.contains("</html>") && page.contains(possible));
    assert!(!page.contains("http"), "the page needs nothing from elsewhere");
}

#[test]
fn bench_report_when_twice_the_slowest_scan_is_longer_than_the_period_then_no_watchdog_can_be_set() {
    let verdict = report_of(Duration::from_millis(12)).verdict();
    assert!(verdict.contains("longer than the watchdog of 10.0 ms."), "{verdict}");
    assert!(verdict.ends_with("A watchdog of 24 ms would be needed (2 times the slowest scan, in whole milliseconds), and the period is 20 ms."), "{verdict}");
}

#[test]
fn bench_report_when_nothing_can_be_calibrated_then_the_measurement_is_shown_with_the_reason() {
    let (measurement, _) = sample();
    let (image, _) = image_of(&read_whole(&project_path("samples/estop-with-contactors")));
    let report = Report::new(&image, &measurement, Some(Err("the reason".to_owned())));
    let said = "No time is estimated for the longest path: the reason";
    assert!(picture(&report, 100).contains(said) && page(&report).contains(said));
    assert_eq!((report.scans, report.estimate.is_none()), (300, true));
}

#[test]
fn bench_report_when_no_scan_was_measured_then_no_watchdog_is_proposed() {
    let (image, _) = image_of(&read_whole(&project_path("samples/estop-with-contactors")));
    let (measurement, _) = sample();
    let report = Report::new(&image, &Measurement { scans: 0, ..measurement }, None);
    assert_eq!(report.possible_watchdog_ms, None);
    assert!(report.verdict().starts_with("No scan was measured"), "{}", report.verdict());
}

/// Measures a project of one controller, from its text.
fn measured_text(text: &str, plan: &Plan) -> (Measurement, Report) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("project.rll");
    std::fs::write(&path, text).unwrap();
    measured(&path, plan)
}

const CALLS: &str = "CONTROLLER Calls (ProcessorType := \"1756-L73S\", Major := 20)\n\
     ADD_ON_INSTRUCTION_DEFINITION Idle (Class := Safety)\nPARAMETERS\nEND_PARAMETERS\nLOCAL_TAGS\nEND_LOCAL_TAGS\n\
     ROUTINE Logic\nN: NOP()NOP()NOP();\nN: NOP();\nEND_ROUTINE\nEND_ADD_ON_INSTRUCTION_DEFINITION\n\
     TAG\nA : BOOL (Class := Safety);\nB : BOOL (Class := Safety);\nI : Idle (Class := Safety);\nEND_TAG\n\
     PROGRAM P (Class := Safety, MAIN := \"Main\")\n\
     ROUTINE Main\nN: XIC(A)JSR(Sub,0)XIC(A)XIO(A)OTE(B);\nN: Idle(I)NOP();\nEND_ROUTINE\n\
     ROUTINE Sub\nN: NOP()NOP();\nEND_ROUTINE\nEND_PROGRAM\n\
     TASK Safety (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5)\nP;\nEND_TASK\n\
     END_CONTROLLER\n";

#[test]
fn bench_when_subroutines_and_add_on_instructions_are_called_then_each_instruction_counts_to_its_own_rung() {
    let plan = Plan { scans: 20, warm_up: 0, ..Plan::default() };
    let (measurement, report) = measured_text(CALLS, &plan);
    let mut rungs: Vec<(String, Vec<u64>)> =
        report.routines.iter().map(|row| row.routine.clone()).zip(measurement.counts.rungs).collect();
    rungs.sort();
    let expected = [("Idle/Logic", vec![3, 1]), ("P/Main", vec![5, 2]), ("P/Sub", vec![2])];
    assert_eq!(rungs, expected.map(|(name, counts)| (name.to_owned(), counts)));
}

#[test]
fn bench_report_when_a_rung_was_not_reached_then_its_longest_path_is_listed_all_the_same() {
    let text = CALLS.replace("N: XIC(A)JSR(Sub,0)", "N: XIC(S:FS)JSR(Sub,0)");
    let plan = Plan { scans: 20, warm_up: 0, ..Plan::default() };
    let (measurement, without) = measured_text(&text, &plan);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("project.rll");
    std::fs::write(&path, &text).unwrap();
    let (image, _) = image_of(&read_whole(&path));
    // Every piece of work at one cost: what a machine measures is another thing each time.
    let same = Estimate { bound_ns: 1, costs: Vec::new(), picoseconds: bound::bound(&image, &|_| 1000) };
    let report = Report::new(&image, &measurement, Some(Ok(same)));
    let listed = |report: &Report| report.most_expensive_rungs.iter().any(|row| row.routine == "P/Sub");
    assert_eq!((listed(&without), listed(&report)), (false, true));
}

#[test]
fn bench_when_the_random_inputs_have_one_seed_then_they_are_the_same() {
    let seeded = |seed| {
        let plan = Plan { scans: 60, warm_up: 0, inputs: Driven::Random(seed), ..Plan::default() };
        let (measurement, _) = measured(&project_path("samples/locked-gate/project.rll"), &plan);
        (measurement.counts, measurement.coverage, measurement.instructions_max)
    };
    assert_eq!(seeded(5), seeded(5));
}

#[test]
fn scans_in_all_when_the_plan_is_as_long_as_can_be_then_nothing_overflows() {
    assert_eq!(scans_in_all(&Plan { scans: u64::MAX, ..Plan::default() }), u64::MAX);
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
        let own = [program.rll(), program.l5x(), Toggles::csv(20, 16)];
        assert!(own == generated(&generator, mix, seed), "{mix}, seed {seed}");
    }
}

#[test]
fn bench_when_a_mix_is_toggled_then_the_same_toggles_give_the_same_hash() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("project.rll");
    std::fs::write(&path, Program::new(Mix::Plant, 200, 5).rll()).unwrap();
    let plan = |inputs| Plan { scans: 60, warm_up: 0, inputs, ..Plan::default() };
    let (toggled, _) = measured(&path, &plan(Driven::Toggles(16)));
    let (again, _) = measured(&path, &plan(Driven::Toggles(16)));
    let (still, _) = measured(&path, &plan(Driven::Toggles(0)));
    assert_eq!(toggled.hash, again.hash);
    assert_ne!(toggled.hash, still.hash);
}
