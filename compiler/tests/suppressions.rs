//! Warnings that somebody accepts.

mod support;

use support::project;
use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::Sources;

/// Codes of the findings of a text, each with the reason for which it is accepted.
fn judged(text: &str) -> Vec<(&'static str, Option<String>)> {
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read(&mut sources, "sample.rll", text.into());
    let checked = check(&reading, &Completion::default());
    checked.findings.iter().map(|one| (one.code.id, one.accepted.as_deref().map(str::to_owned))).collect()
}

const TAGS: &str = "    A, B, X, Y : BOOL (Class := Safety);";

/// Two rungs with a coil for `X`, and these comments before each of them.
fn two_coils(first: &str, second: &str) -> String {
    project("", TAGS, "XIC(A)OTE(X)\nXIC(B)OTE(X)", "")
        .replace("      N: XIC(A)", &format!("      {first}\n      N: XIC(A)"))
        .replace("      N: XIC(B)", &format!("      {second}\n      N: XIC(B)"))
}

#[test]
fn warning_when_its_rung_says_why_it_is_accepted_then_kept_with_the_reason() {
    let text = two_coils("", "// allow W0101: the last one decides");
    assert_eq!(judged(&text), [("W0101", Some("the last one decides".to_owned()))]);
}

#[test]
fn warning_when_another_rung_accepts_its_code_then_not_accepted_and_the_suppression_covers_nothing() {
    let text = two_coils("// allow W0101: the last one decides", "");
    assert_eq!(judged(&text), [("W0901", None), ("W0101", None)]);
}

#[test]
fn suppression_when_the_project_has_an_error_then_nobody_says_that_it_covers_nothing() {
    let text = two_coils("// allow W0101: the last one decides", "N: XIC(Missing)OTE(Y);");
    assert_eq!(judged(&text), [("E0201", None), ("W0101", None)]);
}

#[test]
fn suppression_when_it_gives_no_reason_or_accepts_an_error_then_refused() {
    assert_eq!(judged(&two_coils("", "// allow W0101")), [("E0411", None), ("W0101", None)]);
    let error = judged(&two_coils("", "// allow E0201: why not"));
    assert_eq!(error, [("E0411", None), ("W0101", None)]);
}

#[test]
fn suppression_when_further_findings_are_not_listed_then_nobody_says_that_it_covers_nothing() {
    let pairs: String = (0..1001).map(|at| format!("XIC(A)OTE(Many[{at}])\nXIC(B)OTE(Many[{at}])\n")).collect();
    let tags = format!("{TAGS}\n    Many : BOOL[1024] (Class := Safety);");
    let text = project("", &tags, pairs.trim_end(), "").replacen("      N:", "      // allow W0101: once\n      N:", 1);
    let found = judged(&text);
    assert_eq!(found.iter().filter(|(code, _)| *code == "W0901").count(), 0);
    assert_eq!(found.last().map(|(code, _)| *code), Some("E0109"));
}

#[test]
fn comment_when_it_only_begins_like_a_suppression_then_prose() {
    for prose in
        ["allow Water: in the tank", "allow W01: no", "allow 10101: no", "allow WABCD: no", "allowing W0101: no"]
    {
        assert_eq!(judged(&two_coils("", &format!("// {prose}"))), [("W0101", None)], "{prose}");
    }
}
