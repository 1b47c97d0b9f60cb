//! Hostile files on the command line: every verb ends with one of its exit codes and says why.

use std::fs;

use twinrung_hostile::{Mutator, Target, seeds};

use crate::command::twinrung;

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
            let said = twinrung(&["check", "--notes", "--format", format, path.to_str().unwrap()]);
            let ended = matches!(said.code, Some(0..=2));
            assert!(ended && !said.err.contains("panicked"), "{format} mutant {number} of {ending}: {}", said.err);
        }
    }
}
