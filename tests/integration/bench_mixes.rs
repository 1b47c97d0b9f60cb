//! The shared mixes: both channels end with the hash that the C program ends with.

use std::path::Path;
use std::process::Command;

use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_workbench::{Signal, names};

use crate::support::{Read, read_whole, session, shared_path, stimulus};

/// Scans that the generator writes a stimulus for.
const SCANS: u64 = 300;

fn generated(generator: &Path, folder: &Path, rungs: &str, mix: &str) -> String {
    let scans = SCANS.to_string();
    let run = |program: &str, arguments: &[&str]| {
        let output =
            Command::new(program).args(arguments).output().unwrap_or_else(|error| panic!("{program}: {error}"));
        assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let shared = generator.parent().unwrap().to_str().unwrap();
    let out = folder.to_str().unwrap();
    run("python3", &[generator.to_str().unwrap(), rungs, out, &scans, mix, "1"]);
    let reference = folder.join("reference");
    let reference = reference.to_str().unwrap();
    let (main, program) = (format!("{shared}/main.c"), format!("{out}/prog.c"));
    let (include_out, include_shared) = (format!("-I{out}"), format!("-I{shared}"));
    // What it computes is asked, not how fast: ten thousand rungs in one function take an optimizer a minute.
    run("gcc", &["-O0", "-fno-strict-aliasing", &include_out, &include_shared, &main, &program, "-o", reference]);
    let printed = run(reference, &[&scans, "0", "16"]);
    let at = printed.find("yn=").unwrap() + 3;
    printed[at..at + 16].to_owned()
}

fn fnv(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(1_099_511_628_211))
}

fn hash_of_run(read: &Read, folder: &Path) -> String {
    let mut session = session(read, &stimulus(&folder.join("stimulus.csv")), &[]);
    let outcome = session.until((SCANS - 1) * 10, |_| {});
    assert_eq!(outcome.stopped, None);
    assert_eq!(outcome.scans, SCANS);
    let controller = session.controller();
    let mut hash = 14_695_981_039_346_656_037;
    let bit = |name: String| match names::signal(controller.image(), &name) {
        Ok(Signal::Bit(cell)) => Some(cell),
        _ => None,
    };
    let word = |name: String| match names::signal(controller.image(), &name) {
        Ok(Signal::Word(cell, _)) => Some(cell),
        _ => None,
    };
    let bits: Vec<BitCell> = (0..).map_while(|index| bit(format!("y{index}"))).collect();
    let words: Vec<WordCell> = (0..).map_while(|index| word(format!("n{index}"))).collect();
    for cell in bits {
        hash = fnv(hash, &[u8::from(controller.bit(cell).unwrap())]);
    }
    for cell in words {
        hash = fnv(hash, &controller.word(cell).unwrap().to_le_bytes());
    }
    format!("{hash:016x}")
}

fn expect_the_hash_of_c(mix: &str, rungs: &str) {
    let Some(generator) = shared_path("bench/gen.py") else { return };
    let folder = tempfile::tempdir().unwrap();
    let expected = generated(&generator, folder.path(), rungs, mix);
    for project in ["project.rll", "project.L5X"] {
        let read = read_whole(&folder.path().join(project));
        assert_eq!(hash_of_run(&read, folder.path()), expected, "{mix}, {rungs} rungs, {project}");
    }
}

#[test]
fn simple_mix_when_run_with_1000_rungs_then_the_hash_is_that_of_c() {
    expect_the_hash_of_c("simple", "1000");
}

#[test]
fn simple_mix_when_run_with_10000_rungs_then_the_hash_is_that_of_c() {
    expect_the_hash_of_c("simple", "10000");
}

#[test]
fn plant_mix_when_run_with_1000_rungs_then_the_hash_is_that_of_c() {
    expect_the_hash_of_c("plant", "1000");
}

#[test]
fn plant_mix_when_run_with_10000_rungs_then_the_hash_is_that_of_c() {
    expect_the_hash_of_c("plant", "10000");
}
