//! Every rule has a test that reaches it.

use twinrung_bytecode::ImageError;

const TESTS: [&str; 9] = [
    include_str!("code.rs"),
    include_str!("container.rs"),
    include_str!("declarations.rs"),
    include_str!("hostile.rs"),
    include_str!("instructions.rs"),
    include_str!("operands.rs"),
    include_str!("subroutines.rs"),
    include_str!("tags.rs"),
    include_str!("text.rs"),
];

#[test]
fn rule_when_listed_then_a_test_names_it() {
    let named = |rule: &&&str| {
        let quoted = format!("\"{rule}\"");
        let matched = format!("ImageError::{rule})");
        TESTS.iter().any(|test| test.contains(&quoted) || test.contains(&matched))
    };
    let missing: Vec<&&str> = ImageError::RULES.iter().filter(|rule| !named(rule)).collect();
    assert!(missing.is_empty(), "no test reaches {missing:?}");
}

#[test]
fn error_when_printed_then_is_one_lower_case_sentence_with_its_place() {
    let error = ImageError::WriteMapped {
        at: twinrung_bytecode::error::Site { routine: crate::support::MAIN, rung: 2, element: 1 },
        tag: crate::support::TagIndex(7),
    };
    assert_eq!(error.to_string(), "routine 0, rung 2, element 1: it writes tag 7, which receives a standard tag");
    assert_eq!(error.rule(), "WriteMapped");
}
