//! What cannot be resolved is reported once, at its place, with a way out. Marks << >> enclose the place.

mod support;

use support::{lines, on_rungs, project, read, refused};
use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::Sources;

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
    on_rungs(TAGS, "GSV(PROGRAM,THIS,Instance,<<X>>)", &["E0302"]);
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
    on_rungs(TAGS, "GSV(PROGRAM,THIS,MajorFaultRecord,<<V[0]>>)", &["E0306"]);
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
fn controllers_and_tasks_when_named_as_no_component_can_be_then_reported() {
    let text = project("", TAGS, "XIC(X)OTE(Y)", "");
    let heading = "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)";
    let misnamed = format!("<<{}>>", heading.replace("Sample", "Sam__ple"));
    refused(&text.replace(heading, &misnamed), &["E0207"]);
    refused(&text.replace("TASK Safety_Task", "TASK <<Safety_Task_>>"), &["E0207"]);
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
fn rungs_when_their_branches_hold_no_instruction_then_reported_as_empty() {
    for rung in ["<<[];>>", "<<[ ,[]];>>", "<<[,];>>", "<<[[ , ] ,[[]]];>>"] {
        let text = project("", TAGS, "OTE(X)", "").replace("N: OTE(X);", &format!("N: OTE(X);\n      N: {rung}"));
        refused(&text, &["E0406"]);
    }
}

#[test]
fn data_types_when_their_bits_leave_gaps_or_change_hosts_early_then_refused() {
    let refuse = |members: &str| {
        let types = format!("  DATATYPE Flags_T (FamilyType := NoFamily)\n{members}\n  END_DATATYPE\n");
        let tags = "    F : Flags_T (Class := Safety);\n    X : BOOL (Class := Safety);";
        refused(&project(&types, tags, "OTE(X)", ""), &["E0307"]);
    };
    refuse("    SINT Z (Hidden := 1);\n    BIT First Z : 0;\n    BIT Third Z : <<2>>;");
    refuse("    SINT Z (Hidden := 1);\n    BIT First Z : <<1>>;");
    refuse("    SINT Z (Hidden := 1);\n    BIT First Z : 0;\n    SINT <<Y>> (Hidden := 1);\n    BIT Second Y : 0;");
    refuse("    <<INT>> Z (Hidden := 1);\n    BIT First Z : 0;");
    refuse("    SINT Z;\n    BIT First <<Z>> : 0;");
    refuse("    SINT <<Z>> (Hidden := 1);\n    DINT Count;");
}

#[test]
fn data_types_when_faulty_and_used_by_many_tags_then_reported_once() {
    let types = "  DATATYPE Axis_T (FamilyType := NoFamily)\n    <<Nothing_T>> Inner;\n  END_DATATYPE\n";
    let tags =
        "    F, G : Axis_T (Class := Safety);\n    H : Axis_T[3] (Class := Safety);\n    X : BOOL (Class := Safety);";
    refused(&project(types, tags, "XIC(F.Inner)OTE(X)", ""), &["E0203"]);
}

#[test]
fn negations_when_of_a_literal_in_parentheses_then_admitted_and_of_a_bare_bit_pattern_then_refused() {
    support::admitted(&project("", TAGS, "CPT(A,-(2#1010)*B)\nCPT(A,B-(-(16#8000_0000)))\nCPT(A,-(-(5)))", ""));
    on_rungs(TAGS, "CPT(A,<<-2#1010>>*B)", &["E0305"]);
}

#[test]
fn outputs_when_they_name_no_single_safety_value_then_each_is_reported() {
    let tags = format!("{TAGS}\n    Lamp : BOOL;");
    let text = project("", &tags, "XIC(X)OTE(Y)", "");
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", &text);
    let names = ["Y", "A.3", "V[2]", "T.DN", "Yy", "V", "Lamp", "Program:Safety_Man.X", "T.Nothing", "A B"];
    let outputs = names.iter().map(ToString::to_string).collect();
    let checked = check(&reading, &Completion { outputs, ..Completion::default() });
    let errors: Vec<&str> =
        checked.findings.iter().filter(|finding| finding.is_error()).map(|finding| finding.message.as_str()).collect();
    let named: Vec<&str> = errors.iter().filter_map(|message| message.split('`').nth(1)).collect();
    assert_eq!(named, ["A B", "Yy", "T.Nothing", "Program:Safety_Man.X", "V", "Lamp"], "{errors:#?}");
    assert!(checked.findings.iter().all(|finding| !finding.is_error() || finding.help.is_some()));
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

#[test]
fn output_tag_when_the_module_takes_no_data_then_its_output_data_is_the_way_out() {
    let modules = "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n";
    let text = project(modules, TAGS, "XIC(X)OTE(Field:O.Test01Data)", "");
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", &text);
    let checked = check(&reading, &Completion::default());
    let helps: Vec<&str> = checked
        .findings
        .iter()
        .filter(|finding| finding.is_error())
        .filter_map(|finding| finding.help.as_deref())
        .collect();
    assert_eq!(helps, ["`Field` takes no data as it is declared; its OutputData says what it takes"]);
}

#[test]
fn elements_when_reached_by_different_variable_subscripts_then_one_is_not_taken_for_the_other() {
    let tags = "    T : DINT[4] (Class := Safety);\n    A, C, I, J : DINT (Class := Safety);\n    B : BOOL[32] (Class := Safety);\n    G, H : DCI_STOP (Class := Safety);\n    S, R : BOOL (Class := Safety);\n";
    let rungs = "NEQ(T[I],0)DIV(A,T[I],C)\nNEQ(T[I],0)DIV(A,T[J],C)\n\
                 DCS(G,1,0,500,0,0,B[I],B[I],S,R)\nDCS(H,1,0,500,0,0,B[I],B[J],S,R)";
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", &project("", tags, rungs, ""));
    let checked = check(&reading, &Completion::default());
    let wanted = ["W0107", "S0605"];
    let found: Vec<(&str, &str)> = checked
        .findings
        .iter()
        .filter(|finding| wanted.contains(&finding.code.id))
        .map(|finding| (sources.text(finding.span), finding.message.as_str()))
        .collect();
    assert_eq!(
        found,
        [
            ("T[J]", "nothing on the rung keeps `T[...]` from being 0"),
            ("B[I]", "Channel A and Channel B are the same tag"),
            ("B[J]", "Channel A and Channel B may be the same tag"),
        ],
        "{}",
        lines(&sources, &checked)
    );
}

#[test]
fn file_when_empty_or_not_utf_8_then_it_cannot_be_read() {
    let codes = |bytes: Vec<u8>| -> Vec<&str> {
        let mut sources = Sources::new();
        let checked = check(&twinrung_grammar::read(&mut sources, "sample.rll", bytes), &Completion::default());
        checked.findings.iter().map(|finding| finding.code.id).collect()
    };
    assert_eq!(codes([b"(* \xff *)\n", project("", TAGS, "XIC(X)OTE(Y)", "").as_bytes()].concat()), ["E0101"]);
    assert!(codes(Vec::new()).contains(&"E0101"));
}
