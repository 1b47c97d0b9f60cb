//! Every sample gives the recording that lies beside it, to the byte, and its README explains every change of it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use twinrung_controller::{Partner, Primary};
use twinrung_workbench::line::{Joining, Line};

use crate::support::{Read, expect_reviewed, image_of, lines, project_path, read_whole, session, stimulus, text};

/// Periods that a sample goes on after its stimulus.
const PERIODS_AFTER: u64 = 10;

fn recorded(sample: &str) -> String {
    let folder = project_path("samples").join(sample);
    let read = read_whole(&folder.join("project.rll"));
    let stimulus = stimulus(&folder.join("stimulus.csv"));
    let names: Vec<String> = text(&folder.join("record.txt")).lines().map(str::to_owned).collect();
    let mut session = session(&read, &stimulus, &names);
    let until = stimulus.last_ms() + PERIODS_AFTER * session.period_ms();
    let outcome = session.until(until, |_| {});
    assert_eq!(outcome.stopped, None, "{sample}");
    session.recording().to_csv()
}

/// REQ-SAMPLE-001
#[test]
fn samples_when_run_then_each_gives_the_recording_beside_it() {
    for sample in samples() {
        expect_reviewed(&project_path("samples").join(&sample).join("recording.csv"), &recorded(&sample));
    }
}

fn samples() -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(project_path("samples"))
        .unwrap()
        .map(|entry| entry.unwrap())
        .filter(|entry| entry.path().join("project.rll").is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// REQ-SAMPLE-004
#[test]
fn sil_2_outputs_when_both_controllers_run_then_the_line_gives_the_recording_beside_the_producer() {
    let folder = project_path("samples/sil-2-outputs-produced");
    let members = [&folder, &project_path("samples/sil-2-outputs-consumed")].map(|sample| {
        let (image, bytes) = image_of(&read_whole(&sample.join("project.rll")));
        Joining { name: image.image().controller.name.clone(), image, bytes, phase_ms: 0, execution_us: 0 }
    });
    let mut line: Line<Primary, Partner> = Line::new(members.into(), 1_000, |_| 0).unwrap();
    line.stimulate(&stimulus(&folder.join("line.csv"))).unwrap();
    let names: Vec<String> = text(&folder.join("line.txt")).lines().map(str::to_owned).collect();
    line.record(&names).unwrap();
    line.until(2_000);
    expect_reviewed(&folder.join("line-recording.csv"), &line.recording().to_csv());
}

/// REQ-IMAGE-004
#[test]
fn samples_when_read_from_l5x_then_they_carry_the_same_application_signature() {
    let differing: Vec<String> = samples()
        .into_iter()
        .filter(|sample| {
            let folder = project_path("samples").join(sample);
            let signature = |read: &Read| *image_of(read).0.application_signature();
            signature(&read_whole(&folder.join("project.rll"))) != signature(&read_whole(&folder.join("project.L5X")))
        })
        .collect();
    assert!(differing.is_empty(), "{differing:?}");
}

/// REQ-IMAGE-003
#[test]
fn samples_when_built_in_two_folders_then_the_images_are_the_same_bytes() {
    let elsewhere = tempfile::tempdir().unwrap();
    for sample in samples() {
        let here = project_path("samples").join(&sample).join("project.rll");
        let there = elsewhere.path().join(format!("{sample}.rll"));
        fs::copy(&here, &there).unwrap();
        assert_eq!(image_of(&read_whole(&here)).1, image_of(&read_whole(&there)).1, "{sample}");
    }
}

/// Warnings and notes that a sample gives and its README answers.
const ANSWERED: &[(&str, &str)] = &[("io-fault-latch-inputs", "W0111"), ("io-fault-latch-internal", "W0101")];

/// REQ-SAMPLE-003
#[test]
fn samples_when_checked_then_nothing_is_found_that_is_not_answered() {
    let unanswered: Vec<String> = samples()
        .iter()
        .flat_map(|sample| ["project.rll", "project.L5X"].map(|file| (sample.as_str(), file)))
        .flat_map(|(sample, file)| {
            let found = lines(&read_whole(&project_path("samples").join(sample).join(file)));
            let answered =
                move |line: &String| ANSWERED.iter().any(|(at, code)| *at == sample && line.starts_with(code));
            found.into_iter().filter(move |line| !answered(line)).map(move |line| format!("{sample}/{file}: {line}"))
        })
        .collect();
    assert!(unanswered.is_empty(), "{unanswered:#?}");
}

/// What changes at one time of a recording: names and their new values.
type Changes = BTreeMap<String, String>;

/// What changes in a recording, by its time in ms. Before the first scan everything is 0.
fn recorded_changes(recording: &str) -> BTreeMap<u64, Changes> {
    let mut rows = recording.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = rows.next().unwrap();
    let mut before = vec!["0"; names.len()];
    let mut changes = BTreeMap::new();
    for row in rows {
        let changed = names.iter().zip(&before).zip(&row).skip(1).filter(|((_, was), is)| number(was) != number(is));
        let at: Changes = changed.map(|((name, _), is)| ((*name).to_owned(), number(is))).collect();
        changes.extend((!at.is_empty()).then(|| (row[0].parse().unwrap(), at)));
        before = row;
    }
    changes
}

/// A value as one text, however it is written: codes stand in a README in hexadecimal (`16#F150`).
fn number(value: &str) -> String {
    let plain = match value.strip_prefix("16#") {
        Some(digits) => f64::from(u32::from_str_radix(digits, 16).unwrap()),
        None => value.parse().unwrap(),
    };
    plain.to_string()
}

/// The rows `| at ms | what changes | what happens, and why |` of a README.
fn explained_changes(readme: &str) -> BTreeMap<u64, Changes> {
    let cells = |line: &'_ str| line.split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    let mut explained = BTreeMap::new();
    for row in readme.lines().map(cells).filter(|row| row.len() == 5 && row[1].parse::<u64>().is_ok()) {
        let at: u64 = row[1].parse().unwrap();
        let change = |text: &str| {
            let (name, value) =
                text.split_once(" = ").unwrap_or_else(|| panic!("{at} ms: `{text}` is not `NAME` = value"));
            (name.trim_matches('`').to_owned(), number(value))
        };
        assert!(!row[3].is_empty(), "{at} ms is not explained");
        let before = explained.insert(at, row[2].split(", ").map(change).collect());
        assert_eq!(before, None, "{at} ms is explained twice");
    }
    explained
}

/// REQ-SAMPLE-002
#[test]
fn samples_when_explained_then_the_table_is_what_changes_in_the_recording() {
    for sample in samples() {
        let folder = project_path("samples").join(&sample);
        let explained = explained_changes(&text(&folder.join("README.md")));
        let recorded = recorded_changes(&text(&folder.join("recording.csv")));
        let times: BTreeSet<u64> = explained.keys().chain(recorded.keys()).copied().collect();
        let differing: Vec<_> = times
            .into_iter()
            .map(|at| (at, explained.get(&at), recorded.get(&at)))
            .filter(|(_, says, is)| says != is)
            .collect();
        assert!(differing.is_empty(), "{sample}: (ms, what the README says, what changes): {differing:#?}");
    }
}
