//! A program and its inputs, chosen by the bytes, on primary, partner and judge; what the fuzzer guides itself by is the
//! coverage of all three.
#![no_main]

use libfuzzer_sys::fuzz_target;
use twinrung_trio::Trios;
use twinrung_workbench::fuzz::{Case, Outcome, replay};
use twinrung_workbench::generate::{Random, Size, program_of, stimulus_of};

/// Scans of a program: long enough for a timer and a subroutine.
const SCANS: usize = 24;

fuzz_target!(|data: &[u8]| {
    let (program, inputs) = data.split_at(data.len() / 2);
    let generated = program_of(&mut Random::of_bytes(program), Size::of_rungs(6));
    let stimulus = stimulus_of(&mut Random::of_bytes(inputs), &generated, SCANS);
    if let Outcome::Failed { report, .. } = replay::<Trios>(&generated.text, &stimulus) {
        let case = Case { text: generated.text, stimulus };
        panic!("{report}\n{}\n{}", case.text, case.to_csv());
    }
});
