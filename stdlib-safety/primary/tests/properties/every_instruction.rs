//! What holds for every instruction of the library.

use crate::play::{Scans, implies, plays};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use twinrung_catalog::{CodeWord, Opcode};
use twinrung_safety_primary::State;

/// All instructions that the library executes.
fn library() -> Vec<Opcode> {
    Opcode::ALL.iter().copied().filter(|opcode| State::new(*opcode).is_some()).collect()
}

fn any_play() -> impl Strategy<Value = (Opcode, crate::play::Play)> {
    prop::sample::select(library()).prop_flat_map(|opcode| (Just(opcode), plays(opcode, &[])))
}

/// The outputs that can start motion or release a guard.
const SAFETY_OUTPUTS: &[&str] = &["O1", "O2", "O3", "O5", "O8", "BP", "TZ", "DZ", "UZ"];

fn any_safety_output(scans: &Scans) -> bool {
    SAFETY_OUTPUTS.iter().any(|output| scans.now.shows(output))
}

#[test]
fn library_when_listed_then_holds_every_safety_application_instruction() {
    let declared = Opcode::ALL.iter().copied().filter(|opcode| opcode.instruction().group.is_safety_library());
    assert_eq!(library(), declared.collect::<Vec<Opcode>>());
    assert_eq!(library().len(), 31);
}

/// Random runs are worth their time only if they get somewhere.
#[test]
fn safety_output_when_random_runs_are_played_then_comes_on_for_every_instruction() {
    let mut runner = TestRunner::deterministic();
    let mut idle = library();
    for _ in 0..200 {
        idle.retain(|opcode| {
            let play = plays(*opcode, &[]).new_tree(&mut runner).unwrap().current();
            play.first_violation(|scans| !any_safety_output(scans)).is_none()
        });
    }
    assert_eq!(idle, Vec::<Opcode>::new());
}

#[test]
fn backing_tag_when_its_length_is_wrong_then_reads_zero() {
    for opcode in library() {
        let mut state = State::new(opcode).unwrap();
        let mut members = vec![1; opcode.instruction().safety.unwrap().backing.members.len() + 1];
        state.prescan(&[], &mut members);
        assert!(members.iter().all(|member| *member == 0), "{opcode:?}");
        members.fill(1);
        state.scan(true, 0, &[], &mut members);
        assert!(members.iter().all(|member| *member == 0), "{opcode:?}");
    }
}

proptest! {
    #[test]
    fn outputs_when_rung_is_false_then_are_all_zero((_, play) in any_play()) {
        let violation = play.first_violation(|scans| scans.now.rung || scans.now.outputs().iter().all(|value| *value == 0));
        prop_assert!(violation.is_none(), "{violation:#?}");
    }

    /// Every scan of a run compares the members that are not the instruction's own.
    #[test]
    fn inputs_when_executed_then_are_left_alone((_, play) in any_play()) {
        prop_assert!(play.run().iter().all(|row| !row.shows("EnableIn") && !row.shows("EnableOut")));
    }

    #[test]
    fn fault_present_when_shown_then_turns_every_safety_output_off((opcode, play) in any_play()) {
        // An override energizes O1 whatever FP says (muting-and-outputs.md 2.4).
        let violation = play.first_violation(|scans| {
            implies(scans.now.shows("FP") && !scans.now.shows("Override"), !any_safety_output(scans))
        });
        prop_assert!(violation.is_none(), "{opcode:?} {violation:#?}");
    }

    #[test]
    fn fault_code_when_shown_then_comes_with_fault_present((opcode, play) in any_play()) {
        let violation = play.first_violation(|scans| implies(scans.now.shows("FaultCode"), scans.now.shows("FP")));
        prop_assert!(violation.is_none(), "{opcode:?} {violation:#?}");
    }

    #[test]
    fn fault_code_when_fault_stays_present_then_does_not_change((opcode, play) in any_play()) {
        let violation = play.first_violation(|scans| {
            implies(
                scans.before.shows("FaultCode") && scans.now.shows("FaultCode"),
                scans.before.value("FaultCode") == scans.now.value("FaultCode"),
            )
        });
        prop_assert!(violation.is_none(), "{opcode:?} {violation:#?}");
    }

    #[test]
    fn code_when_shown_then_is_declared_in_the_catalog((opcode, play) in any_play()) {
        let codes = opcode.instruction().safety.unwrap().codes;
        let declared = |word: CodeWord, value: i32| codes.iter().any(|code| code.word == word && code.value == value);
        let violation = play.first_violation(|scans| {
            implies(scans.now.shows("FaultCode"), declared(CodeWord::Fault, scans.now.value("FaultCode")))
                && implies(
                    scans.now.shows("DiagnosticCode"),
                    declared(CodeWord::Diagnostic, scans.now.value("DiagnosticCode")),
                )
        });
        prop_assert!(violation.is_none(), "{opcode:?} {violation:#?}");
    }

    #[test]
    fn run_when_played_twice_then_agrees_in_members_and_memory((_, play) in any_play()) {
        prop_assert!(play.run() == play.run());
    }

    #[test]
    fn run_when_all_times_are_shifted_then_shows_the_same((_, play) in any_play(), by_ms in 0i64..1_000_000_000) {
        let outputs = |rows: Vec<crate::play::Row>| rows.iter().map(|row| row.outputs()).collect::<Vec<_>>();
        prop_assert_eq!(outputs(play.run()), outputs(play.shifted(by_ms).run()));
    }

    #[test]
    fn state_when_operands_and_time_are_noise_then_does_not_panic(
        opcode in prop::sample::select(library()),
        scans in prop::collection::vec((any::<bool>(), any::<i64>(), prop::collection::vec(any::<i32>(), 40)), 1..30),
    ) {
        let mut state = State::new(opcode).unwrap();
        let length = opcode.instruction().safety.unwrap().backing.members.len();
        for (rung, now_ms, mut noise) in scans {
            noise.truncate(length);
            state.scan(rung, now_ms, &[], &mut noise);
            state.prescan(&[], &mut noise);
        }
    }
}
