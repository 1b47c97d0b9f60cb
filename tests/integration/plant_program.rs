//! A plant's own safety program, a partial export that its rack's export and the command line complete: 10,000 scans.

use std::path::Path;

use twinrung_compiler::Completion;
use twinrung_grammar::read_path;
use twinrung_workbench::stimulus::StimulusRow;
use twinrung_workbench::{Stimulus, Value};

use crate::support::{Read, read, session, shared_path};

const SCANS: u64 = 10_000;
const PERIOD_MS: u32 = 20;
/// The three rungs of the latch: what sets it, what clears it, what it drives.
const LATCH: &str = "MIlling_1_Safety_Reset";
const STOP: &str = "DI_ECP103_A_1.Pt02.Data";
const RESET: &str = "Milling_1_Safety.BIT_Logic[1].0";
const OUTPUTS: [&str; 2] = ["ENET_ECP103_A_0:3:O.Pt00.Data", "ENET_ECP103_A_0:3:O.Pt01.Data"];

fn program(folder: &Path) -> Read {
    read(&folder.join("SafetyProgram_Program.L5X"), |sources| Completion {
        controller: Some("1756-L84ES".to_owned()),
        revision: Some(35),
        period_ms: Some(PERIOD_MS),
        watchdog_ms: Some(PERIOD_MS),
        contexts: vec![read_path(sources, &folder.join("ENET_ECP103_A_0_Module.L5X")).file],
        ..Completion::default()
    })
}

/// Both inputs of the latch from a fixed linear congruential sequence.
fn random_stimulus() -> Stimulus {
    let mut state = 0x1234_5678_u32;
    let mut bit = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        Some(((state >> 30) & 1).to_string())
    };
    Stimulus {
        tags: vec![STOP.to_owned(), RESET.to_owned()],
        rows: (0..SCANS)
            .map(|scan| StimulusRow { line: scan + 2, time_ms: scan * u64::from(PERIOD_MS), cells: vec![bit(), bit()] })
            .collect(),
    }
}

#[test]
fn plant_program_when_run_10000_scans_then_channels_agree_and_the_latch_does_what_its_rungs_say() {
    let Some(folder) = shared_path("corpus/acd-l5x-tool-lib") else { return };
    let read = program(&folder);
    let names: Vec<String> = [STOP, RESET, LATCH].iter().chain(&OUTPUTS).map(|name| (*name).to_owned()).collect();
    let mut session = session(&read, &random_stimulus(), &names);
    let outcome = session.until((SCANS - 1) * u64::from(PERIOD_MS), |_| {});
    assert_eq!((outcome.scans, outcome.stopped), (SCANS, None));
    let mut latched = false;
    let mut changes = 0;
    for row in &session.recording().rows {
        let on = |index: usize| row.values[index] == Value::Bool(true);
        let before = latched;
        latched = (latched || (!on(0) && on(1))) && !on(0);
        changes += u32::from(before != latched);
        assert_eq!([on(2), on(3), on(4)], [latched; 3], "at {} ms", row.time_ms);
    }
    assert!(changes > 1000, "the stimulus moves the latch: {changes}");
}
