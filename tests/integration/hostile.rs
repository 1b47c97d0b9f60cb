//! Hostile files on the command line: every verb ends with one of its exit codes and says why.

use std::fs;
use std::process::Command;

use twinrung_hostile::{Mutator, Target, seeds};

use crate::support::project_path;

/// Mutants of each kind: each is a process.
const MUTANTS: usize = 40;

/// REQ-CHECK-008
#[test]
fn files_when_mutated_then_check_ends_with_a_verdict_in_every_form() {
    let folder = tempfile::tempdir().unwrap();
    for (target, ending) in [(Target::Source, "rll"), (Target::L5x, "L5X"), (Target::Image, "image")] {
        let seeds = seeds(target).unwrap();
        let mut mutator = Mutator::new(0x636c_6921);
        for number in 0..MUTANTS {
            let seed = &seeds[number % seeds.len()].1;
            let path = folder.path().join(format!("mutant.{ending}"));
            fs::write(&path, mutator.mutant(seed, &seeds[(number + 1) % seeds.len()].1)).unwrap();
            let format = ["human", "json", "sarif"][number % 3];
            let output = Command::new(env!("CARGO_BIN_EXE_twinrung"))
                .args(["check", "--notes", "--format", format])
                .arg(&path)
                .current_dir(project_path(""))
                .output()
                .unwrap();
            let said = String::from_utf8_lossy(&output.stderr);
            let ended = matches!(output.status.code(), Some(0..=2));
            assert!(ended && !said.contains("panicked"), "{format} mutant {number} of {ending}: {said}");
        }
    }
}
