//! What cannot be resolved is reported once, at its place, with a way out. Marks << >> enclose the place.

mod support;

use support::{lines, project, read};
use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::Sources;

/// Checks a marked text: exactly these errors, in this order, at the marks.
fn refused(marked: &str, codes: &[&str]) {
    let text = marked.replace("<<", "").replace(">>", "");
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", &text);
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    let errors: Vec<_> = checked.findings.iter().filter(|finding| finding.is_error()).collect();
    let found: Vec<(&str, &str)> = errors.iter().map(|finding| (finding.code.id, sources.text(finding.span))).collect();
    let marks: Vec<&str> = marked.split("<<").skip(1).map(|rest| rest.split(">>").next().unwrap()).collect();
    let expected: Vec<(&str, &str)> = codes.iter().copied().zip(marks).collect();
    assert_eq!(found, expected, "{shown}");
    assert!(errors.iter().all(|finding| finding.help.is_some()), "no way out:\n{shown}");
}

fn on_rungs(tags: &str, rungs: &str, codes: &[&str]) {
    refused(&project("", tags, rungs, ""), codes);
}

const TAGS: &str = "    A, B : DINT (Class := Safety);\n    V : DINT[4] (Class := Safety);\n    X, Y : BOOL (Class := Safety);\n    T : TIMER (Class := Safety);";

#[test]
fn names_when_unknown_then_each_is_reported_once_with_a_suggestion() {
    on_rungs(
        TAGS,
        "XIC(<<Z_Tag>>)OTE(Y)\nXIC(T.<<DM>>)OTE(Y)\nJSR(<<Nowhere>>,0)\nXIC(X)JMP(<<Nolabel>>)",
        &["E0201", "E0202", "E0204", "E0205"],
    );
}

#[test]
fn operands_when_of_another_type_then_reported() {
    on_rungs(TAGS, "XIC(<<A>>)OTE(X)", &["E0302"]);
    on_rungs(TAGS, "MOV(<<X>>,A)", &["E0302"]);
    on_rungs(TAGS, "MOV(<<V>>,A)", &["E0302"]);
    on_rungs(TAGS, "TON(<<A>>,500,0)", &["E0302"]);
    on_rungs(TAGS, "MOV(A[<<0>>],B)".replace("[<<0>>]", "<<[0]>>").as_str(), &["E0302"]);
}

#[test]
fn operands_when_too_few_too_many_or_missing_then_reported() {
    on_rungs(TAGS, "<<MOV(A)>>", &["E0301"]);
    on_rungs(TAGS, "<<CLR(A,B)>>", &["E0301"]);
    on_rungs(TAGS, "ADD(A,<<?>>,B)", &["E0303"]);
}

#[test]
fn subscripts_and_bits_when_out_of_range_then_reported() {
    on_rungs(TAGS, "MOV(V[<<4>>],A)", &["E0306"]);
    on_rungs(TAGS, "MOV(V[<<-1>>],A)", &["E0306"]);
    on_rungs(TAGS, "XIC(A.<<32>>)OTE(X)", &["E0306"]);
}

#[test]
fn literals_when_beyond_their_range_then_reported() {
    on_rungs(TAGS, "MOV(<<2147483648>>,A)", &["E0305"]);
    on_rungs(TAGS, "MOV(<<16#1_0000_0000>>,A)", &["E0305"]);
    on_rungs(TAGS, "XIC(X)TON(T,<<-1>>,0)", &["E0305"]);
}

#[test]
fn declarations_when_faulty_then_uses_of_them_are_not_reported_again() {
    let tags = "    S : <<Nothing_T>> (Class := Safety);\n    X : BOOL (Class := Safety);\n    <<X>> : DINT (Class := Safety);\n    L OF <<Nobody>> (Class := Safety);";
    on_rungs(tags, "XIC(S.Member)XIC(L)OTE(X)\nMOV(S.Word,S.Other)", &["E0203", "E0206", "E0201"]);
}

#[test]
fn names_when_not_admitted_then_reported() {
    on_rungs("    <<A__B>> : BOOL (Class := Safety);\n    X : BOOL (Class := Safety);", "OTE(X)", &["E0207"]);
    on_rungs("    L OF <<M>>;\n    M OF L;\n    X : BOOL (Class := Safety);", "OTE(X)", &["E0210"]);
}

#[test]
fn aliases_when_in_a_circle_then_reported_once_and_uses_are_not() {
    on_rungs("    L OF <<M>>;\n    M OF L;\n    X : BOOL (Class := Safety);", "XIC(L)OTE(X)", &["E0210"]);
}

#[test]
fn words_when_not_in_the_list_then_the_list_is_shown() {
    let tags = "    E : DCI_STOP (Class := Safety);\n    A, B, S, R : BOOL (Class := Safety);";
    on_rungs(tags, "DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,<<SOMETIMES>>,MANUAL,A,B,S,R)", &["E0304"]);
}

#[test]
fn rungs_when_empty_then_reported() {
    refused(&project("", TAGS, "OTE(X)", "").replace("N: OTE(X);", "N: OTE(X);\n      N: <<;>>"), &["E0406"]);
}

#[test]
fn values_when_they_do_not_fit_then_reported() {
    on_rungs("    W : SINT (Class := Safety) := <<300>>;\n    X : BOOL (Class := Safety);", "OTE(X)", &["E0309"]);
}

#[test]
fn controller_when_unknown_then_only_that_is_reported() {
    let text = project("", TAGS, "XIC(X)OTE(Y)", "").replace("\"1756-L73S\"", "<<\"1756-L75S\">>");
    refused(&text.replace("<<\"1756-L75S\">>", "\"<<1756-L75S>>\""), &["E0402"]);
}

#[test]
fn findings_when_many_then_listed_in_the_order_of_the_text() {
    let rungs: String = (0..1500).map(|at| format!("XIC(Missing_{at})OTE(X)\n")).collect();
    let text = project("", TAGS, rungs.trim_end(), "");
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", &text);
    let checked = check(&reading, &Completion::default());
    assert_eq!(checked.findings.len(), 1001);
    assert!(checked.findings.windows(2).all(|pair| pair[0].span.start <= pair[1].span.start));
}

#[test]
fn master_control_when_in_an_add_on_instruction_then_each_is_refused() {
    let definition = "  ADD_ON_INSTRUCTION_DEFINITION Zoned (Class := Safety)\n    PARAMETERS\n      Run : BOOL (Usage := Input);\n    END_PARAMETERS\n    \
         ROUTINE Logic\n      N: XIC(Run)<<MCR()>>;\n      N: <<MCR()>>;\n    END_ROUTINE\n  END_ADD_ON_INSTRUCTION_DEFINITION\n";
    let tags = format!("{TAGS}\n    Zone : Zoned (Class := Safety);");
    refused(&project(definition, &tags, "Zoned(Zone,X)", ""), &["S0607", "S0607"]);
}
