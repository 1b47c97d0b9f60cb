//! `twinrung bench` as its users run it, and what `run`, `bench` and `build` have in common: what they require of a program,
//! and how they end.

use std::fs;
use std::path::Path;

use serde_json::Value;
use twinrung_workbench::mix::{Mix, Program, Toggles};

use crate::command::{Said, twinrung};
use crate::support::text;

const SAMPLE: &str = "samples/estop-with-contactors";

/// Measures a few scans, without calibration, as JSON.
fn bench(arguments: &[&str]) -> Said {
    twinrung(&[&["bench", "--no-estimate", "--format", "json"], arguments].concat())
}

fn json(said: &Said) -> Value {
    serde_json::from_str(&said.out).unwrap_or_else(|error| panic!("{error}: {}{}", said.out, said.err))
}

/// A project with one rung, in a folder that lives as long as the answer.
fn project(tags: &str, rung: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("project.rll");
    let text = format!(
        "CONTROLLER One (ProcessorType := \"1756-L73S\", Major := 20)\nTAG\n{tags}END_TAG\n\
         PROGRAM P (Class := Safety, MAIN := \"Main\")\nROUTINE Main\n{rung}\nEND_ROUTINE\nEND_PROGRAM\n\
         TASK Safety (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5)\nP;\nEND_TASK\n\
         END_CONTROLLER\n"
    );
    fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

const BITS: &str = "A : BOOL (Class := Safety);\nB : BOOL (Class := Safety);\n";

#[test]
fn bench_when_the_folder_holds_a_stimulus_then_it_drives_the_inputs() {
    let of_folder = bench(&[SAMPLE, "--scans", "20"]);
    assert_eq!((of_folder.code, &json(&of_folder)["inputs"]), (Some(0), &Value::Null));
    let of_file = bench(&[&format!("{SAMPLE}/project.rll"), "--scans", "20"]);
    assert!(json(&of_file)["inputs"]["bools"].as_u64().unwrap() > 0, "{}", of_file.out);
    let named = format!("{SAMPLE}/stimulus.csv");
    let of_named = bench(&[&format!("{SAMPLE}/project.rll"), "--scans", "20", "--stimulus", &named]);
    assert_eq!(json(&of_named)["inputs"], Value::Null);
}

#[test]
fn bench_when_shown_to_a_person_then_scan_and_prescan_stand_beside_their_bounds() {
    let said = twinrung(&["bench", SAMPLE, "--scans", "20", "--no-estimate"]);
    assert_eq!(said.code, Some(0));
    let row = |name: &str| {
        let line = said.out.lines().find(|line| line.starts_with(name)).unwrap_or_else(|| panic!("{}", said.out));
        line.split_whitespace().skip(1).filter_map(|word| word.replace(',', "").parse().ok()).collect::<Vec<u64>>()
    };
    let (all, prescan) = (row("all "), row("prescan "));
    assert!(all[1] <= all[2] && prescan[0] <= prescan[1], "{all:?} {prescan:?}");
}

#[test]
fn bench_when_a_page_is_asked_for_then_it_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scan-time.html");
    let said = bench(&[SAMPLE, "--scans", "20", "--html", path.to_str().unwrap()]);
    assert_eq!(said.code, Some(0));
    assert!(said.err.contains("wrote "), "{}", said.err);
    let page = text(&path);
    assert!(page.contains("<td>prescan</td>") && page.ends_with("</html>\n"), "{page}");
}

#[test]
fn bench_when_in_real_time_then_it_shows_how_late_scans_began() {
    let (_folder, path) = project(BITS, "N: XIC(A)OTE(B);");
    let said = bench(&[&path, "--scans", "3", "--realtime"]);
    // A busy machine may let the watchdog expire.
    assert!([Some(0), Some(3)].contains(&said.code), "{}", said.err);
    assert!(json(&said)["jitter_ns"]["max"].is_u64(), "{}", said.out);
    assert_eq!(json(&bench(&[&path, "--scans", "3"]))["jitter_ns"], Value::Null);
}

#[test]
fn bench_when_a_mix_is_kept_then_program_and_stimulus_lie_in_the_folder() {
    let folder = tempfile::tempdir().unwrap();
    let keep = folder.path().join("kept");
    let said = bench(&[
        "--mix",
        "plant",
        "--rungs",
        "50",
        "--seed",
        "3",
        "--scans",
        "20",
        "--toggles",
        "4",
        "--keep",
        keep.to_str().unwrap(),
    ]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert_eq!(json(&said)["hash"].as_str().unwrap().len(), 16);
    let program = Program::new(Mix::Plant, 50, 3);
    assert!(text(&keep.join("project.rll")) == program.rll() && text(&keep.join("project.L5X")) == program.l5x());
    assert_eq!(text(&keep.join("stimulus.csv")), Toggles::csv(20, 4));
}

#[test]
fn bench_when_a_mix_is_to_be_completed_then_the_command_line_is_refused() {
    let said = bench(&["--mix", "simple", "--controller", "1756-L73S/20"]);
    assert_eq!(said.code, Some(2));
    assert!(said.err.contains("cannot be used with"), "{}", said.err);
}

#[test]
fn bench_when_more_scans_than_time_stamps_hold_are_asked_for_then_the_command_line_is_refused() {
    let said = bench(&[SAMPLE, "--scans", "18446744073709551615"]);
    assert_eq!(said.code, Some(2));
    assert!(said.err.contains("1..=1000000000000"), "{}", said.err);
    assert_eq!(twinrung(&["run", SAMPLE, "--until", "18446744073709551615"]).code, Some(2));
}

/// REQ-BOUND-007
#[test]
fn verbs_when_the_bound_is_required_then_a_program_beyond_its_budget_is_refused() {
    let tags = format!("{BITS}C : CONTROL (Class := Safety) := [0,5,0];\nS : DINT (Class := Safety);\n");
    let (folder, beyond) = project(&tags, "N: MOV(S,C.LEN);\nN: FSC(C,5,0,ALL,S > 1);");
    let image = folder.path().join("project.image");
    let build = ["build", &beyond, "-o", image.to_str().unwrap()];
    for verb in [&["run", beyond.as_str()][..], &["bench", "--no-estimate", "--scans", "1", &beyond], &build] {
        let said = twinrung(&[verb, &["--require-bound"]].concat());
        assert_eq!(said.code, Some(1), "{verb:?}: {}{}", said.out, said.err);
        assert!(said.out.contains("a scan can execute 1048578 instructions"), "{}", said.out);
    }
    assert!(!image.exists());
    assert_eq!(twinrung(&build).code, Some(0));
    let (_folder, within) = project(BITS, "N: XIC(A)OTE(B);");
    assert_eq!(twinrung(&["run", &within, "--require-bound"]).code, Some(0));
}

#[test]
fn verbs_when_another_signature_is_expected_then_the_program_is_refused() {
    for verb in ["run", "bench"] {
        let said = twinrung(&[verb, SAMPLE, "--expect", "0000_0000"]);
        assert_eq!(said.code, Some(1), "{verb}: {}", said.err);
        assert!(said.out.starts_with("expected the signature 0000_0000, found "), "{}", said.out);
    }
    assert_eq!(twinrung(&["run", SAMPLE, "--quiet", "--expect", "8245_78da"]).code, Some(0));
}

/// REQ-CHECK-010
#[test]
fn verbs_when_a_file_cannot_be_read_as_a_whole_then_the_exit_code_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("empty.rll");
    fs::write(&path, "").unwrap();
    for verb in ["check", "checklist", "build", "run", "bench", "show"] {
        let said = twinrung(&[verb, path.to_str().unwrap()]);
        assert_eq!(said.code, Some(2), "{verb}: {}{}", said.out, said.err);
    }
}

/// Runs the command with a standard output and a standard error that nobody reads.
fn unread(arguments: &[&str]) -> Option<i32> {
    let closed = || std::io::pipe().unwrap().1;
    let command = env!("CARGO_BIN_EXE_twinrung");
    let mut child = std::process::Command::new(command);
    child.args(arguments).current_dir(crate::support::project_path("")).stdout(closed()).stderr(closed());
    child.status().unwrap().code()
}

/// REQ-CHECK-011
#[test]
fn verbs_when_nobody_reads_their_output_then_they_do_their_work_and_end_as_ever() {
    let folder = tempfile::tempdir().unwrap();
    let recording = folder.path().join("recording.csv");
    let page = folder.path().join("page.html");
    let (recording, page) = (recording.to_str().unwrap(), page.to_str().unwrap());
    let project = &format!("{SAMPLE}/project.L5X");
    let cases: [(&[&str], i32); 12] = [
        (&["run", SAMPLE, "--record", "EStop.O1", "--out", recording], 0),
        (&["bench", SAMPLE, "--scans", "5", "--no-estimate", "--html", page], 0),
        (&["check", "tests/verdict/several.rll"], 1),
        (&["check", "no-such-file.rll"], 2),
        (&["checklist", SAMPLE], 0),
        (&["build", SAMPLE], 0),
        (&["show", SAMPLE], 0),
        (&["diff", SAMPLE, "samples/locked-gate"], 1),
        (&["fmt", project], 0),
        (&["explain", "DCS"], 0),
        (&["explain", "nothing"], 2),
        (&["fuzz", "--programs", "1", "--scans", "2", "--rungs", "3"], 0),
    ];
    for (arguments, code) in cases {
        assert_eq!(unread(arguments), Some(code), "{arguments:?}");
    }
    assert!(Path::new(recording).exists() && Path::new(page).exists());
}

#[test]
fn check_when_there_are_only_notes_then_it_counts_them() {
    let good = twinrung_compiler::rules::input_written::CODE.good.replace(['<', '>'], "");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("project.rll");
    let noted = good.replace("    END_ROUTINE", "      N: XIO(Run)OTU(Field_In:I.Pt00Data);\n    END_ROUTINE");
    fs::write(&path, noted).unwrap();
    let path = path.to_str().unwrap();
    let said = twinrung(&["check", path]);
    assert_eq!((said.code, said.out), (Some(0), format!("{path}: 1 note (--notes shows the notes)\n")));
    let said = twinrung(&["check", path, "--notes", "--deny", "warnings"]);
    assert_eq!(said.code, Some(0));
    assert!(said.out.contains("W0111") && said.out.ends_with(&format!("{path}: 1 note\n")), "{}", said.out);
}

/// REQ-SCAN-031
#[test]
fn bench_when_asked_for_two_threads_then_the_state_is_that_of_one_and_the_report_says_how_many() {
    let of = |threads: &str| {
        let said = bench(&["--mix", "plant", "--rungs", "60", "--seed", "3", "--scans", "40", "--threads", threads]);
        let json = json(&said);
        (said.code, json["threads"].as_u64(), json["hash"].as_str().map(str::to_owned))
    };
    let (one, two) = (of("1"), of("2"));
    assert_eq!((one.0, one.1, two.0, two.1), (Some(0), Some(1), Some(0), Some(2)));
    assert!(one.2.is_some());
    assert_eq!(one.2, two.2);
    assert_eq!(bench(&[SAMPLE, "--threads", "3"]).code, Some(2));
}

/// REQ-SCAN-031
#[test]
fn run_when_asked_for_two_threads_then_the_recording_is_that_of_one() {
    let folder = tempfile::tempdir().unwrap();
    let recorded = |threads: &str| {
        let path = folder.path().join(threads);
        let arguments = ["run", SAMPLE, "--quiet", "--threads", threads, "--out", path.to_str().unwrap()];
        assert_eq!(twinrung(&arguments).code, Some(0));
        text(&path)
    };
    let one = recorded("1");
    assert!(one.lines().count() > 10);
    assert_eq!(one, recorded("2"));
}
