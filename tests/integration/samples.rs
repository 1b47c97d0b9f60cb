//! Every sample gives the recording that lies beside it, to the byte. `BLESS=1` writes what a run gave, for a person to
//! read before it is committed.

use std::fs;

use crate::support::{Read, image_of, project_path, read_whole, session, stimulus, text};

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

fn expect_recording(sample: &str) {
    let path = project_path("samples").join(sample).join("recording.csv");
    let found = recorded(sample);
    if std::env::var_os("BLESS").is_some() {
        fs::write(&path, &found).unwrap();
    }
    assert_eq!(found, text(&path), "{sample}: the run gives another recording");
}

#[test]
fn estop_with_contactors_when_run_then_it_gives_its_recording() {
    expect_recording("estop-with-contactors");
}

#[test]
fn io_fault_latch_inputs_when_run_then_it_gives_its_recording() {
    expect_recording("io-fault-latch-inputs");
}

#[test]
fn io_fault_latch_internal_when_run_then_it_gives_its_recording() {
    expect_recording("io-fault-latch-internal");
}

#[test]
fn io_fault_latch_outputs_when_run_then_it_gives_its_recording() {
    expect_recording("io-fault-latch-outputs");
}

#[test]
fn qualified_standard_data_when_run_then_it_gives_its_recording() {
    expect_recording("qualified-standard-data");
}

#[test]
fn add_on_instruction_when_run_then_it_gives_its_recording() {
    expect_recording("add-on-instruction");
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
