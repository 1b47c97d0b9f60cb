//! The vector files against the catalog.

use std::collections::BTreeSet;
use twinrung_catalog::{CodeWord, Element, MemberRole, Opcode};
use twinrung_safety_vectors::{Vector, VectorErrorKind, coverage, for_instruction, normal_operation, parse};

fn instructions() -> impl Iterator<Item = Opcode> {
    Opcode::ALL.iter().copied().filter(|opcode| opcode.instruction().safety.is_some())
}

fn vectors() -> Vec<Vector> {
    instructions().flat_map(|opcode| for_instruction(opcode).unwrap_or_else(|error| panic!("{error}"))).collect()
}

#[test]
fn vector_files_when_parsed_then_every_safety_application_has_vectors_with_unique_names() {
    for opcode in instructions() {
        let names: Vec<&str> = for_instruction(opcode).unwrap().iter().map(|vector| vector.name).collect();
        let unique: BTreeSet<&str> = names.iter().copied().collect();
        assert!(!names.is_empty(), "{opcode:?}");
        assert_eq!(names.len(), unique.len(), "{opcode:?}");
    }
}

#[test]
fn vectors_when_they_begin_then_they_name_every_output_member_and_every_configuration_operand() {
    for vector in vectors() {
        let declaration = vector.declaration().unwrap();
        let named: BTreeSet<&str> = vector.steps[0].expected.iter().map(|expectation| expectation.name).collect();
        let members = declaration.backing.members.iter();
        let outputs: BTreeSet<&str> = members
            .clone()
            .filter(|member| member.role == MemberRole::Output && member.name != "EnableOut")
            .map(|member| member.name)
            .collect();
        assert_eq!(named, outputs, "{}", vector.name);
        let configured: BTreeSet<&str> = vector.configuration.iter().map(|setting| setting.name).collect();
        let configuration: BTreeSet<&str> =
            members.filter(|member| member.role == MemberRole::Configuration).map(|member| member.name).collect();
        assert_eq!(configured, configuration, "{}", vector.name);
    }
}

#[test]
fn vectors_when_they_expect_a_code_then_the_catalog_declares_it() {
    for vector in vectors() {
        let declaration = vector.declaration().unwrap();
        let undeclared: Vec<_> = vector
            .steps
            .iter()
            .flat_map(|step| &step.expected)
            .filter(|expectation| {
                let word = match expectation.name {
                    "FaultCode" => Some(CodeWord::Fault),
                    "DiagnosticCode" => Some(CodeWord::Diagnostic),
                    _ => None,
                };
                word.is_some_and(|word| {
                    expectation.value != 0
                        && !declaration.codes.iter().any(|code| code.word == word && code.value == expectation.value)
                })
            })
            .collect();
        assert!(undeclared.is_empty(), "{}: {undeclared:?}", vector.name);
    }
}

#[test]
fn declared_codes_when_vectors_are_read_then_each_is_expected_at_least_once() {
    let missing: Vec<String> = instructions()
        .map(|opcode| coverage(opcode).unwrap())
        .inspect(|found| {
            println!(
                "{:8} {:3} vectors, codes {} of {}",
                found.opcode.instruction().mnemonic,
                found.vectors,
                found.reached.len(),
                found.reached.len() + found.missing.len()
            );
        })
        .flat_map(|found| {
            found
                .missing
                .into_iter()
                .map(move |code| format!("{:?}: {:?} 16#{:X}", found.opcode, code.word, code.value))
        })
        .collect();
    assert_eq!(missing, Vec::<String>::new());
}

#[test]
fn replay_when_run_then_it_scans_from_zero_to_the_end_with_the_settings_in_force() {
    let text = "vector X\nsource s\nmark decided\nperiod 10 5\nconfig FeedbackType=POSITIVE FeedbackReactionTime=200\n\
                0 InputStatus=1 -> O1=0\n10 Actuate=1 rung=0 -> O1=1\n20 prescan\n30 end\n";
    let vectors = parse(Opcode::Crout, text).unwrap();
    let mut replay = vectors[0].replay(10);
    let scans: Vec<_> = std::iter::from_fn(|| {
        let scan = replay.next_scan()?;
        Some((scan.now_ms, scan.prescan, scan.rung, replay.operands().to_vec()))
    })
    .collect();
    assert_eq!(
        scans,
        vec![
            (0, true, true, vec![1, 200, 0, 0, 0, 1, 0, 0]),
            (10, false, false, vec![1, 200, 1, 0, 0, 1, 0, 0]),
            (20, true, false, vec![1, 200, 1, 0, 0, 1, 0, 0]),
            (30, false, false, vec![1, 200, 1, 0, 0, 1, 0, 0]),
        ]
    );
}

/// The reason for which a text is refused, and the line.
fn refusal(text: &'static str) -> (usize, VectorErrorKind) {
    let error = parse(Opcode::Crout, text).unwrap_err();
    (error.line, error.kind)
}

#[test]
fn vector_text_when_malformed_then_the_line_and_the_reason_are_told() {
    assert_eq!(refusal("shows x\n"), (1, VectorErrorKind::OutOfPlace));
    assert_eq!(refusal("vector X\nperiod 0\n"), (2, VectorErrorKind::BadNumber));
    assert_eq!(refusal("vector X\nperiod 10\n5 Actuate=1\n"), (3, VectorErrorKind::BadTime));
    assert_eq!(refusal("vector X\nperiod 10\n0 Actuate\n"), (3, VectorErrorKind::BadItem));
    assert_eq!(refusal("vector X\nperiod 10\n0 Lever=1\n"), (3, VectorErrorKind::UnknownOperand));
    assert_eq!(refusal("vector X\nperiod 10\n0 Actuate=2\n"), (3, VectorErrorKind::BadValue));
    assert_eq!(refusal("vector X\nperiod 10\n0 -> Actuate=1\n"), (3, VectorErrorKind::UnknownMember));
    assert_eq!(refusal("vector X\nperiod 10\n0 Actuate=1\n10 end\n"), (4, VectorErrorKind::Incomplete));
    assert_eq!(refusal("vector X\nhums\n"), (2, VectorErrorKind::UnknownLine));
    assert_eq!(refusal("vector X\n"), (1, VectorErrorKind::Incomplete));
    assert_eq!(for_instruction(Opcode::Xic).unwrap_err().kind, VectorErrorKind::NoVectors);
}

#[test]
fn vectors_when_their_configuration_is_out_of_range_or_changes_then_they_are_not_admissible() {
    let corrupt: BTreeSet<String> = vectors()
        .iter()
        .filter(|vector| !vector.is_admissible())
        .map(|vector| format!("{:?}", vector.opcode))
        .collect();
    let expected = ["Cbcm", "Cbim", "Cbssm", "Fsbm", "Tsam", "Tssm"].map(str::to_owned);
    assert_eq!(corrupt, BTreeSet::from(expected));
}

#[test]
fn replay_when_steps_leap_then_their_scans_and_all_after_them_come_later() {
    let text =
        "vector X\nsource s\nmark decided\nperiod 10\n0 InputStatus=1\n20 leap=3000000000\n30 leap=4 Reset=1\n40 end\n";
    let vectors = parse(Opcode::Csm, text).unwrap();
    let mut replay = vectors[0].replay(10);
    let times: Vec<i64> = std::iter::from_fn(|| replay.next_scan().map(|scan| scan.now_ms)).collect();
    assert_eq!(times, vec![0, 10, 3_000_000_020, 3_000_000_034, 3_000_000_044]);
}

#[test]
fn normal_operation_when_looked_up_then_one_vector_of_each_instruction_is_marked_and_it_shows_no_fault() {
    for opcode in instructions() {
        let vectors = for_instruction(opcode).unwrap();
        let marked: Vec<&Vector> = vectors.iter().filter(|vector| !vector.normal.is_empty()).collect();
        assert_eq!(marked.len(), 1, "{opcode:?}");
        assert_eq!(normal_operation(opcode).unwrap().as_ref(), Some(marked[0]));
        let faults: Vec<&str> =
            marked[0].expected_codes().filter(|code| code.word == CodeWord::Fault).map(|code| code.cause).collect();
        assert_eq!(faults, Vec::<&str>::new(), "{opcode:?}");
        let shown = |name, value| {
            let mut expected = marked[0].steps.iter().flat_map(|step| &step.expected);
            expected.any(|expectation| expectation.name == name && expectation.value == value)
        };
        assert!(!shown("FP", 1), "{opcode:?} shows a fault");
        assert!(marked[0].is_admissible(), "{opcode:?} is no call that compiles");
        assert!(
            marked[0].steps.iter().all(|step| step.rung.is_none() && !step.prescan && step.leap_ms == 0),
            "{opcode:?}"
        );
    }
}

#[test]
fn normal_operation_when_looked_up_then_an_output_is_off_and_turns_on() {
    for opcode in instructions() {
        let vector = normal_operation(opcode).unwrap().unwrap();
        let outputs = opcode.instruction().safety.unwrap().backing.members.iter().filter(|member| {
            member.role == MemberRole::Output && member.element == Element::Bool && member.name != "EnableOut"
        });
        let moving = outputs
            .filter(|member| {
                let mut values = vector.steps.iter().flat_map(|step| &step.expected);
                let takes = |value| values.any(|found| found.name == member.name && found.value == value);
                [0, 1].into_iter().all(takes)
            })
            .count();
        assert!(moving > 0, "{opcode:?} shows no output that turns on");
    }
}
