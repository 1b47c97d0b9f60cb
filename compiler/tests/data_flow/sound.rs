//! Ways by which standard data alone switches an output without standing on a rung of its own.

use crate::{accepted, findings, messages, on_rungs, refused, text};

#[test]
fn jump_when_standard_data_skips_what_would_reset_then_refused() {
    refused("OTE(A)\nXIC(Std)JMP(Past)\nAFI()OTE(A)\nLBL(Past)XIC(A)OTE(Motor)", &["S0701 Std"]);
    refused("OTL(A)\nXIC(Std)JMP(Past)\nOTU(A)\nLBL(Past)XIC(A)OTE(Motor)", &["S0701 Std"]);
    accepted("OTL(A)\nXIC(Std)JMP(Past)\nOTU(A)\nLBL(Past)XIC(A)XIC(Safe)OTE(Motor)");
}

#[test]
fn jump_when_safety_data_decides_it_then_it_does_not_qualify_what_it_skips() {
    refused("XIC(Safe)JMP(Past)\nXIC(Std)OTE(Motor)\nLBL(Past)NOP()", &["S0701 Std"]);
    refused("XIC(Safe)TND()\nXIC(Std)OTE(Motor)", &["S0701 Std"]);
}

#[test]
fn jump_when_unconditional_then_what_its_label_leads_to_is_still_judged() {
    refused("JMP(Past)\nLBL(Past)XIC(Std)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Std)JMP(One)\nJMP(Two)\nLBL(One)OTL(A)\nLBL(Two)XIC(A)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Std)JMP(past)\nXIC(Safe)TND()\nLBL(Past)OTL(A)\nXIC(A)OTE(Motor)", &["S0701 Std"]);
}

#[test]
fn jump_when_within_a_branch_then_it_decides_the_rest_of_its_rung() {
    refused("[XIC(Std)JMP(Past) ,OTL(Motor) ]\nLBL(Past)NOP()", &["S0701 Std"]);
}

#[test]
fn loop_when_standard_data_decides_how_often_it_runs_then_what_it_writes_is_unqualified() {
    refused("LBL(Again)XIO(B)OTE(A)\nOTL(B)\nXIC(Std)XIO(C)JMP(Again)\nXIC(A)OTE(Motor)", &["S0701 Std"]);
    accepted("LBL(Again)XIC(Safe)OTE(A)\nXIC(Std)XIO(C)JMP(Again)\nXIC(A)OTE(Motor)");
}

#[test]
fn zone_when_a_jump_leads_past_its_begin_then_its_condition_does_not_qualify() {
    let entered = "XIC(Std2)JMP(Into)\nXIC(Safe)MCR()\nLBL(Into)XIC(Std)OTE(Motor)\nMCR()";
    refused(entered, &["S0701 Std"]);
    accepted("XIC(Safe)MCR()\nXIC(Std)OTE(Motor)\nMCR()");
}

#[test]
fn return_when_standard_data_decides_whether_it_hands_a_value_back_then_refused() {
    let part = "    ROUTINE Part\n      N: SBR(V)OTE(A);\n      N: XIC(Std)RET(A);\n    END_ROUTINE\n";
    assert_eq!(findings(&text("", "", "JSR(Part,1,X,B)\nXIC(B)OTE(Motor)", part)), ["S0701 Std"]);
    let part = part.replace("XIC(Std)RET", "XIC(Std)XIC(Safe)RET");
    assert_eq!(findings(&text("", "", "JSR(Part,1,X,B)\nXIC(B)OTE(Motor)", &part)), Vec::<String>::new());
}

#[test]
fn return_when_several_write_one_operand_then_every_one_counts() {
    let part = "    ROUTINE Part\n      N: SBR(V)XIC(Safe)OTE(A);\n      N: XIC(Safe)RET(A);\n      N: XIC(Std)OTE(C);\n      N: RET(C);\n    END_ROUTINE\n";
    assert_eq!(findings(&text("", "", "JSR(Part,1,X,B)\nXIC(B)OTE(Motor)", part)), ["S0701 Std"]);
}

#[test]
fn subroutine_when_standard_data_keeps_it_from_running_then_what_it_resets_is_unqualified() {
    let part = "    ROUTINE Part\n      N: OTU(A);\n    END_ROUTINE\n";
    assert_eq!(findings(&text("", "", "OTL(A)\nXIO(Std)JSR(Part,0)\nXIC(A)OTE(Motor)", part)), ["S0701 Std"]);
}

#[test]
fn latch_when_only_standard_data_resets_what_nothing_safe_sets_then_refused() {
    refused("OTL(A)\nXIC(Std)OTU(A)\nXIC(A)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Safe)OTL(A)\nOTL(A)\nXIC(Std)OTU(A)\nXIC(A)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Safe)OTL(A)\nXIC(Std)OTU(A)\nXIC(A)OTE(Motor)");
}

#[test]
fn initial_value_when_only_standard_data_resets_it_then_refused() {
    let with = |value: &str| {
        let tags = format!("    Q : BOOL (Class := Safety) := {value};");
        findings(&text("", &tags, "XIC(Safe)OTL(Q)\nXIC(Std)OTU(Q)\nXIC(Q)OTE(Motor)", ""))
    };
    assert_eq!(with("1"), ["S0701 Std"]);
    assert_eq!(with("0"), Vec::<String>::new());
}

#[test]
fn initial_value_when_it_is_read_before_the_coil_then_it_qualifies_nothing() {
    refused("XIO(A)XIC(Std)OTL(Motor)\nXIC(Safe)OTE(A)", &["S0701 Std"]);
    accepted("XIC(Safe)OTE(A)\nXIO(A)XIC(Std)OTL(Motor)");
    accepted("XIO(Safe)OTL(A)\nXIC(Safe2)OTU(A)\nXIO(A)XIC(Std)OTE(Motor)");
}

#[test]
fn timer_when_it_runs_always_then_its_done_bit_is_0_without_safety_data() {
    refused("TON(T,100,0)\nXIO(T.DN)XIC(Std)OTE(Motor)", &["S0701 Std"]);
}

#[test]
fn one_shot_when_only_standard_data_ends_its_condition_then_refused() {
    refused("OTL(A)\nXIC(Std)OTU(A)\nXIC(A)ONS(Edge)OTL(Motor)", &["S0701 Std"]);
}

#[test]
fn parameter_when_a_standard_subscript_selects_the_bit_that_is_passed_then_refused() {
    let part = "    ROUTINE Part\n      N: SBR(A)XIC(A)OTE(Motor);\n    END_ROUTINE\n";
    let given = "XIC(Safe)OTE(Bits[1])\nXIC(Safe2)OTE(Bits[2])\nJSR(Part,1,Bits[Num])";
    assert_eq!(findings(&text("", "", given, part)), ["S0704 Bits[Num]"]);
    let part = "    ROUTINE Part\n      N: SBR(V)XIC(Safe)OTE(Bits[1]);\n      N: RET(Bits[Num]);\n    END_ROUTINE\n";
    assert_eq!(findings(&text("", "", "JSR(Part,1,X,A)\nXIC(A)OTE(Motor)", part)), ["S0704 Bits[Num]"]);
}

#[test]
fn element_when_a_standard_subscript_decides_whether_it_is_reset_then_refused() {
    refused("OTE(Bits[3])\nAFI()OTE(Bits[Num])\nXIC(Bits[3])OTE(Motor)", &["S0704 Bits[Num]"]);
}

const DCS: &str = "DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Safe,Safe2";

#[test]
fn safety_instruction_when_its_status_is_standard_data_then_its_output_inverted_is_unqualified() {
    refused(&format!("{DCS},Std,In:I.Pt06Data)\nXIO(E.O1)OTE(Motor)"), &["S0701 Std"]);
    accepted(&format!("{DCS},In:I.CombinedInputStatus,Std)\nXIO(E.O1)OTE(Motor)"));
    accepted(&format!("{DCS},In:I.CombinedInputStatus,In:I.Pt06Data)\nXIO(E.O1)XIC(Std)OTE(Motor)"));
}

#[test]
fn safety_instruction_when_its_fault_or_code_is_examined_then_it_qualifies_nothing() {
    let call = format!("{DCS},In:I.CombinedInputStatus,In:I.Pt06Data)");
    refused(&format!("{call}\nXIC(Std)XIO(E.FP)OTE(Motor)"), &["S0701 Std"]);
    refused(&format!("{call}\nXIC(Std)EQU(E.FaultCode,0)OTE(Motor)"), &["S0701 Std"]);
    accepted(&format!("{call}\nXIC(Std)XIO(E.FP)XIC(E.O1)OTE(Motor)"));
}

const PARAMETER: &str = "LES(W,V)OTE(Motor)\nXIC(Safe)ADD(W,1,W)";

#[test]
fn parameter_when_a_latch_stands_for_a_step_of_the_sequence_then_refused() {
    let with = |rungs: &str| on_rungs(&format!("{rungs}\n{PARAMETER}"));
    let latched = "XIC(Ack)ONS(Edge)EQU(Num,Num2)LIM(1,Num,100)OTL(A)\nXIC(A)MOV(Num,V)";
    assert_eq!(with(latched), ["S0704 Num"]);
    let once_equal = "EQU(Num,Num2)OTL(A)\nXIC(Ack)ONS(Edge)XIC(A)LIM(1,Num,100)MOV(Num,V)";
    assert_eq!(with(once_equal), ["S0704 Num"]);
    let also_filled =
        "EQU(Num,Num2)OTE(Bits[0])\nFLL(1,Words[0],1)\nXIC(Ack)ONS(Edge)XIC(Bits[0])LIM(1,Num,100)MOV(Num,V)";
    assert_eq!(with(also_filled), Vec::<String>::new());
    let also_set = "EQU(Num,Num2)OTE(A)\nJSR(Part,1,X,A)\nXIC(Ack)ONS(Edge)XIC(A)LIM(1,Num,100)MOV(Num,V)";
    let part = "    ROUTINE Part\n      N: SBR(Y)OTE(B);\n      N: RET(B);\n    END_ROUTINE\n";
    assert_eq!(findings(&text("", "", &format!("{also_set}\n{PARAMETER}"), part)), ["S0704 Num"]);
}

#[test]
fn parameter_when_the_one_shot_is_not_that_of_the_acknowledgement_then_refused() {
    let with = |rungs: &str| on_rungs(&format!("{rungs}\n{PARAMETER}"));
    assert_eq!(with("XIC(Ack)XIC(Safe2)ONS(Edge)EQU(Num,Num2)LIM(1,Num,100)MOV(Num,V)"), Vec::<String>::new());
    assert_eq!(with("XIC(B)ONS(Edge)XIC(Ack)EQU(Num,Num2)LIM(1,Num,100)MOV(Num,V)"), ["S0704 Num"]);
}

#[test]
fn mode_operands_when_a_press_instruction_has_several_then_they_are_no_channels() {
    let tags = "    Press OF Out:O.Pt02Data (SIL := 3);\n    Five : FIVE_POS_MODE_SELECTOR (Class := Safety);";
    let rungs = "FPMS(Five,In:I.Pt02Data,In:I.Pt03Data,In:I.Pt04Data,In:I.Pt05Data,In:I.Pt06Data,In:I.Pt07Data)\nXIC(Five.O1)OTE(Press)";
    let found = findings(&text("", tags, rungs, ""));
    assert!(!found.is_empty() && found.iter().all(|line| line.starts_with("S0703")), "{found:?}");
}

const ALWAYS: &str = r#"  ADD_ON_INSTRUCTION_DEFINITION Always (Class := Safety)
    PARAMETERS
      Go : BOOL (Usage := Input, Required := Yes);
    END_PARAMETERS
    ROUTINE Logic
      N: XIC(Go)OTE(EnableOut);
    END_ROUTINE
    ROUTINE EnableInFalse
      N: XIC(Go)OTE(EnableOut);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
"#;

#[test]
fn enable_out_when_logic_sets_it_while_the_rung_is_false_then_it_does_not_stand_in_series() {
    let tags = "    I1 : Always (Class := Safety);";
    assert_eq!(findings(&text(ALWAYS, tags, "AFI()Always(I1,Std)OTE(Motor)", "")), ["S0701 Std"]);
    assert_eq!(findings(&text(ALWAYS, tags, "[AFI()Always(I1,Std) ,XIC(Safe2) ]OTE(Motor)", "")), ["S0701 Std"]);
    assert_eq!(findings(&text(ALWAYS, tags, "XIC(Safe)Always(I1,Std)XIC(Safe2)OTE(Motor)", "")), Vec::<String>::new());
}

#[test]
fn integrity_when_an_array_is_judged_as_one_cell_then_sil_3_within_it_is_still_seen() {
    let tags = "    Large : DINT[20000] (Class := Safety);\n    Third OF Large[3] (SIL := 3);\n    Known OF In:I.Pt05Data (SIL := 3);";
    let found = findings(&text("", tags, "XIC(In:I.Pt04Data)MOV(1,Large[W])\nXIC(Known)MOV(2,Large[7])", ""));
    assert_eq!(found, ["S0703 In:I.Pt04Data"]);
}

#[test]
fn instances_when_more_than_are_followed_then_what_goes_in_still_reaches_what_comes_out() {
    let types = "  DATATYPE Two_T\n    BOOL First;\n    BOOL Second;\n  END_DATATYPE\n";
    let gate = "  ADD_ON_INSTRUCTION_DEFINITION Gate (Class := Safety)\n    PARAMETERS\n      Go : BOOL (Usage := Input, \
                Required := Yes);\n      Two : Two_T (Usage := InOut);\n      Done : BOOL (Usage := Output, Required := Yes);\n    \
                END_PARAMETERS\n    ROUTINE Logic\n      N: XIC(Go)OTE(Done);\n    END_ROUTINE\n  \
                END_ADD_ON_INSTRUCTION_DEFINITION\n";
    let tags = "    Gates : Gate[20001] (Class := Safety);\n    Two : Two_T (Class := Safety);";
    let given = |at: usize| if at == 20_000 { "Std" } else { "Safe" };
    let calls: String = (0..20_001).map(|at| format!("Gate(Gates[{at}],{},Two,A)\n", given(at))).collect();
    let text = text(&format!("{types}{gate}"), tags, &format!("{calls}XIC(A)OTE(Motor)"), "");
    assert_eq!(findings(&text), ["S0701 Std"]);
}

#[test]
fn findings_when_there_are_more_than_are_looked_for_then_the_last_says_so() {
    let modules: String = (0..40)
        .map(|at| format!("    P{at} : BOOL;\n    M{at} : BOOL (Class := Safety, MappedFrom := P{at});\n"))
        .collect();
    let tags = modules.replace("    P2 : BOOL;\n", "").replace("    P3 : BOOL;\n", "");
    let legs: Vec<String> = (0..40).map(|at| format!("XIC(M{at})")).collect();
    let shown = messages(&text("", &tags, &format!("[{} ]OTE(Motor)", legs.join(" ,")), ""));
    assert_eq!(shown.len(), 32);
    let further = shown.iter().filter(|message| message.contains("there may be further paths")).count();
    assert_eq!(further, 1);
}

#[test]
fn parameter_when_its_range_is_the_wrong_way_round_then_refused() {
    let with = |range: &str| on_rungs(&format!("XIC(Ack)ONS(Edge)EQU(Num,Num2){range}MOV(Num,V)\n{PARAMETER}"));
    assert_eq!(with("LIM(1,Num,100)"), Vec::<String>::new());
    assert_eq!(with("LIM(100,Num,1)"), ["S0704 Num"]);
}
