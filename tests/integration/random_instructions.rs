//! The two halves of the safety library under random operands: realistic rhythms, jittered vectors, noise. Every member of
//! every backing tag is compared in every scan. The long run is `docs/verification.md`, random instructions.

use twinrung_catalog::Opcode;
use twinrung_trio::instructions::{Walk, Walked};

/// Executions of each instruction here; the long run has a million.
const EXECUTIONS: u64 = 3_000;

/// Scans of each loaded program: one program for each instruction.
const SCANS: u64 = 250;

fn walks(opcodes: &[Opcode], seed: u64) -> Vec<Walked> {
    let walk = |opcode: &Opcode| Walk { opcode: *opcode, seed, executions: EXECUTIONS, scans: SCANS }.run();
    opcodes.iter().map(walk).collect()
}

/// REQ-EXEC-060, REQ-EXEC-061, REQ-EXEC-062
#[test]
fn safety_application_instructions_when_their_operands_are_random_then_both_halves_agree_in_every_scan() {
    let all = Opcode::ALL.iter().copied().filter(|opcode| opcode.instruction().safety.is_some());
    let walked = walks(&all.collect::<Vec<Opcode>>(), 20);
    walked.iter().for_each(|one| println!("{one}"));
    let differences: Vec<&String> = walked.iter().flat_map(|one| &one.differences).collect();
    assert!(differences.is_empty(), "{differences:#?}");
    assert!(walked.iter().all(|one| one.executions >= EXECUTIONS));
}
