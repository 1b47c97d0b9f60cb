//! What an instruction or an Add-On Instruction takes in a place, and what it does not.

mod support;

use support::{admitted, lines, on_rungs, project, read, refused};
use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::Sources;

const TAGS: &str = "    A, B : DINT (Class := Safety);\n    V : DINT[4] (Class := Safety);\n    X, Y : BOOL (Class := Safety);\n    Bits : BOOL[32] (Class := Safety);\n    Locked : SINT (Class := Safety);";

const TABLES: &str = "  ADD_ON_INSTRUCTION_DEFINITION Tables (Class := Safety)
    PARAMETERS
      Table : DINT[2,3] (Usage := InOut);
      One : DINT (Usage := InOut);
      Flag : BOOL (Usage := InOut);
    END_PARAMETERS
    ROUTINE Logic
      N: XIC(Flag)MOV(Table[1,2],One);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
";

/// A call with these arguments: its text.
fn call(arguments: &str) -> String {
    let tags = "    I : Tables (Class := Safety);\n    Fits : DINT[2,3] (Class := Safety);\n    Longer : DINT[3,3] (Class := Safety);\n    Shorter : DINT[1,3] (Class := Safety);\n    Wider : DINT[2,4] (Class := Safety);\n    Deeper : DINT[2,3,2] (Class := Safety);\n    Ratio : REAL[2,3] (Class := Safety);\n    Real : REAL (Class := Safety);";
    project(TABLES, &format!("{TAGS}\n{tags}"), &format!("Tables(I,{arguments})"), "")
}

#[test]
fn array_argument_when_longer_in_its_first_dimension_then_admitted() {
    admitted(&call("Fits,A,X"));
    admitted(&call("Longer,V[2],Bits[3]"));
}

#[test]
fn array_argument_when_shorter_or_of_other_dimensions_or_type_then_refused() {
    for argument in ["<<Shorter>>", "<<Wider>>", "<<Deeper>>", "<<V>>", "<<A>>", "<<Ratio>>"] {
        refused(&call(&format!("{argument},A,X")), &["E0302"]);
    }
}

#[test]
fn scalar_argument_when_an_array_a_bit_of_a_number_or_another_type_then_refused() {
    for arguments in ["<<V>>,X", "<<Real>>,X", "A,<<B.3>>", "A,<<Bits>>", "A,<<A>>"] {
        refused(&call(&format!("Fits,{arguments}")), &["E0302"]);
    }
}

#[test]
fn fill_destination_when_bits_then_refused() {
    on_rungs(TAGS, "FLL(0,<<Bits>>,1)\nFLL(0,<<A.3>>,1)", &["E0302", "E0302"]);
    admitted(&project("", TAGS, "FLL(0,V[0],4)\nFLL(0,A,1)", ""));
}

#[test]
fn dimension_when_beyond_those_of_any_array_then_refused() {
    on_rungs(TAGS, "SIZE(V,<<3>>,A)\nSIZE(V,<<-1>>,A)", &["E0305", "E0305"]);
}

#[test]
fn number_of_inputs_when_more_than_a_subroutine_takes_then_refused() {
    let part = "    ROUTINE Part\n      N: NOP();\n    END_ROUTINE\n";
    refused(&project("", TAGS, "JSR(Part,<<41>>)", part), &["E0305"]);
}

#[test]
fn operands_when_several_are_unknown_then_each_is_reported_unless_it_depends_on_another() {
    on_rungs(TAGS, "MOV(<<Nope>>,<<Neither>>)", &["E0201", "E0201"]);
    on_rungs(TAGS, "GSV(<<CLOCK>>,THIS,Nothing,A)", &["S0107"]);
}

#[test]
fn label_when_not_first_on_its_rung_then_that_is_reported_and_not_the_label() {
    on_rungs(TAGS, "XIC(X)<<LBL(There)>>NOP()", &["E0404"]);
}

#[test]
fn attribute_when_only_some_controllers_have_it_then_refused_on_the_others() {
    let text = project("", TAGS, "GSV(SAFETY,,<<SafetyLocked>>,Locked)", "");
    admitted(&text.replace("<<", "").replace(">>", ""));
    refused(&text.replace("1756-L73S", "1756-L63S"), &["S0107"]);
    let both = project("", TAGS, "GSV(SAFETY,,SafetySignatureExists,Locked)", "");
    admitted(&both);
    admitted(&both.replace("1756-L73S", "1756-L63S"));
}

#[test]
fn expression_when_it_has_256_operations_then_admitted_and_with_one_more_refused() {
    // 128 values and 127 sums; each ABS is one more.
    let values = "+B".repeat(127);
    admitted(&project("", TAGS, &format!("CPT(A,ABS(B){values})"), ""));
    on_rungs(TAGS, &format!("CPT(A,<<ABS(ABS(B)){values}>>)"), &["E0108"]);
}

/// The ways out of all errors.
fn helps(rungs: &str) -> Vec<String> {
    let mut sources = Sources::new();
    let tags = format!("{TAGS}\n    E : DCI_STOP (Class := Safety);");
    let reading = read(&mut sources, "sample.rll", &project("", &tags, rungs, ""));
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    let errors = checked.findings.into_iter().filter(|finding| finding.is_error());
    errors.map(|finding| finding.help.unwrap_or_else(|| panic!("{shown}"))).collect()
}

#[test]
fn word_when_nearly_one_of_the_list_then_that_one_is_meant() {
    let dcs = |word: &str| helps(&format!("DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,{word},MANUAL,X,Y,X,Y)"));
    assert_eq!(dcs("MANUEL"), ["did you mean `MANUAL`?"]);
    assert_eq!(dcs("'MANUEL'"), ["did you mean `MANUAL`?"]);
}

#[test]
fn parameter_of_a_subroutine_when_behind_the_number_of_inputs_then_it_takes_no_literal() {
    let part = "    ROUTINE Part\n      N: SBR(A,A,A);\n      N: RET(B);\n    END_ROUTINE\n    ROUTINE Short\n      N: SBR(A)RET(B);\n    END_ROUTINE\n";
    refused(&project("", TAGS, "JSR(Part,3,1,2,3,<<4>>)", part), &["E0105"]);
    refused(&project("", TAGS, "JSR(Part,3,1,2,3,B)\nJSR(Short,1,5,B)", part), &[]);
}

#[test]
fn type_when_another_is_expected_then_the_message_names_the_one_that_was_found() {
    let found = |rung: &str| {
        let mut sources = Sources::new();
        let checked = check(&read(&mut sources, "sample.rll", &project("", TAGS, rung, "")), &Completion::default());
        let message = checked.findings.into_iter().find(|finding| finding.is_error()).unwrap().message;
        message.split("found ").nth(1).unwrap().to_owned()
    };
    assert_eq!(found("XIC(A)OTE(X)"), "DINT");
    assert_eq!(found("MOV(V,A)"), "DINT[4]");
    assert_eq!(found("MOV(X,A)"), "BOOL");
    assert_eq!(found("TON(A.3,1,0)"), "a bit of an integer");
}

#[test]
fn storage_bit_when_something_writes_the_number_that_it_is_a_bit_of_then_a_warning() {
    let warned = |rung: &str| {
        let text = project("", TAGS, &format!("XIC(X)ONS(V[1].0)OTE(Y)\n{rung}"), "");
        let mut sources = Sources::new();
        let checked = check(&read(&mut sources, "sample.rll", &text), &Completion::default());
        let own = checked.findings.iter().filter(|finding| finding.code.id == "W0103");
        own.map(|finding| sources.text(finding.span).to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(warned("MOV(A,V[1])"), ["V[1]"]);
    assert_eq!(warned("XIC(Y)OTL(V[1].0)"), ["V[1].0"]);
    assert_eq!(warned("MOV(A,V[2])"), Vec::<String>::new());
}

#[test]
fn member_when_unknown_then_the_first_twelve_are_shown_and_whether_there_are_more() {
    let shown = |count: usize| {
        let members: String = (0..count).map(|at| format!("    DINT Member{at};\n")).collect();
        let types = format!("  DATATYPE Long_T\n{members}  END_DATATYPE\n");
        let mut sources = Sources::new();
        let text = project(&types, "    L : Long_T (Class := Safety);", "CLR(L.Other)", "");
        let checked = check(&read(&mut sources, "sample.rll", &text), &Completion::default());
        checked.findings.into_iter().find(|finding| finding.is_error()).and_then(|finding| finding.help).unwrap()
    };
    assert!(shown(12).ends_with("Member10, Member11"), "{}", shown(12));
    assert!(shown(13).ends_with("Member10, Member11, ..."), "{}", shown(13));
}
