//! One place where data goes through at a time.

use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::Sources;

use crate::support::read;
use crate::{accepted, findings, on_rungs, refused, text};

#[test]
fn standard_bit_when_alone_then_refused_and_in_series_with_safety_data_accepted() {
    refused("XIC(Std)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Std)XIC(Safe)OTE(Motor)");
    accepted("XIC(Safe)XIO(Std)OTE(Motor)");
}

#[test]
fn standard_bit_when_in_a_leg_of_its_own_then_refused() {
    refused("[XIC(Std) ,XIC(Safe) ]OTE(Motor)", &["S0701 Std"]);
    accepted("[XIC(Std) ,XIC(Safe) ]XIC(Safe2)OTE(Motor)");
    accepted("[XIC(Std)XIC(Safe2) ,XIC(Safe) ]OTE(Motor)");
    refused("XIC(Safe)[XIC(Std) ,]OTE(A)\n[XIC(A) ,XIC(Std2)[XIC(A) ,] ]OTE(Motor)", &["S0701 Std2"]);
}

#[test]
fn connection_state_when_in_series_then_it_qualifies_nothing() {
    refused("XIC(Std)XIO(In:I.ConnectionFaulted)XIC(In:I.RunMode)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Std)XIC(In:I.CombinedInputStatus)XIC(Out:I.CombinedOutputStatus)OTE(Motor)", &["S0701 Std"]);
}

#[test]
fn constant_when_in_series_then_it_qualifies_nothing() {
    refused("XIC(Std)XIC(D)OTE(Motor)", &["S0701 Std"]);
    refused("OTE(A)\nXIC(Std)XIC(A)OTE(Motor)", &["S0701 Std"]);
}

#[test]
fn member_marked_standard_when_alone_then_refused() {
    refused("XIC(In:I.InputPowerStatus)OTE(Motor)", &["S0701 In:I.InputPowerStatus"]);
    accepted("XIC(Out:I.Pt00Readback)XIC(Safe)OTE(Motor)");
}

#[test]
fn point_with_a_standard_device_when_alone_then_refused() {
    let modules = r#"  MODULE Panel (CatalogNumber := "1734-IB8S", Parent := "Rack", Slot := 3, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10)
    POINT I00 (Mode := STANDARD);
  END_MODULE
"#;
    assert_eq!(findings(&text(modules, "", "XIC(Panel:I.Pt00Data)OTE(Motor)", "")), ["S0701 Panel:I.Pt00Data"]);
    assert_eq!(findings(&text(modules, "", "XIC(Panel:I.Pt01Data)OTE(Motor)", "")), Vec::<String>::new());
}

#[test]
fn standard_data_when_it_goes_through_tags_then_the_source_is_reported_once() {
    refused("XIC(Std)OTE(A)\nXIC(A)OTE(B)\nXIC(B)[OTE(Motor) ,OTE(Lamp) ]", &["S0701 Std"]);
    accepted("XIC(Std)OTE(A)\nXIC(A)OTE(B)\nXIC(B)XIC(Safe)OTE(Motor)");
    accepted("XIC(Std)XIC(Safe)OTE(A)\nXIC(A)OTE(Motor)");
}

#[test]
fn standard_data_when_two_sources_reach_an_output_then_both_are_reported() {
    refused("[XIC(Std) ,XIC(Std2) ]OTE(Motor)", &["S0701 Std", "S0701 Std2"]);
}

#[test]
fn standard_data_when_inverted_behind_a_coil_then_still_refused() {
    refused("XIC(Std)XIC(Safe)OTE(A)\nXIO(A)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Std)XIC(Safe)OTE(A)\nXIO(A)XIC(Safe2)OTE(Motor)");
}

#[test]
fn latch_when_standard_data_alone_sets_it_then_refused_and_when_it_only_resets_accepted() {
    refused("XIC(Std)OTL(A)\nXIC(Safe)OTU(A)\nXIC(A)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Safe)OTL(A)\nXIC(Std)OTU(A)\nXIC(A)OTE(Motor)");
    refused("XIC(Safe)OTL(A)\nXIC(Std)OTU(A)\nXIO(A)OTE(Motor)", &["S0701 Std"]);
    accepted("[XIC(Std) ONS(Edge) ,XIC(A) ]XIC(Safe)OTE(A)\nXIC(A)OTE(Motor)");
    refused("XIO(A)XIC(Std)ONS(Edge)OTL(A)\nXIC(A)XIC(Std2)OTU(A)\nXIC(A)OTE(Motor)", &["S0701 Std"]);
}

#[test]
fn second_writer_when_it_is_unqualified_then_refused() {
    refused("XIC(Safe)OTE(A)\nXIC(Std)OTL(A)\nXIC(A)OTE(Motor)", &["S0701 Std"]);
}

#[test]
fn timer_when_standard_data_alone_runs_it_then_refused() {
    refused("XIC(Std)TON(T,100,0)\nXIC(T.DN)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Std)TOF(T,100,0)\nXIC(T.TT)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Std)TON(T,100,0)\nXIC(T.DN)XIC(Safe)OTE(Motor)");
    accepted("XIC(Safe)TON(T,100,0)\nXIC(T.DN)OTE(Motor)");
}

#[test]
fn timer_when_its_preset_is_standard_data_then_safety_data_must_still_run_it() {
    refused("MOV(Num,T.PRE)\nTON(T,?,?)\nXIC(T.DN)OTE(Motor)", &["S0704 Num"]);
    accepted("MOV(Num,T.PRE)\nXIC(Safe)TON(T,?,?)\nXIC(T.DN)OTE(Motor)");
}

#[test]
fn counter_when_standard_data_alone_counts_then_refused() {
    refused("XIC(Std)CTU(N,3,0)\nXIC(Safe)RES(N)\nXIC(N.DN)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Std)CTU(N,3,0)\nGRT(N.ACC,2)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Safe)CTU(N,3,0)\nXIC(Std)RES(N)\nXIC(N.DN)OTE(Motor)");
}

#[test]
fn moves_when_standard_data_goes_through_them_then_refused() {
    refused("XIC(Std)MOV(5,W)\nEQU(W,5)OTE(Motor)", &["S0701 Std"]);
    refused("MOV(Num,W)\nEQU(W,5)OTE(Motor)", &["S0704 Num"]);
    accepted("XIC(Safe)MOV(Num,W)\nEQU(W,5)OTE(Motor)");
    accepted("MOV(Num,W)\nEQU(W,5)XIC(Safe)OTE(Motor)");
}

#[test]
fn arithmetic_when_standard_data_is_in_it_then_refused_even_with_safety_data_beside() {
    refused("XIC(Safe)ADD(W,1,W)\nADD(W,Num,X)\nGRT(X,5)OTE(Motor)", &["S0704 Num"]);
    refused("XIC(Std)ADD(W,1,W)\nGRT(W,5)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Std)ADD(W,1,V)\nMOV(V,W)\nGRT(W,5)OTE(Motor)", &["S0701 Std"]);
    refused("CPT(X,W+Num*2)\nCMP(X>3)OTE(Motor)", &["S0704 W+Num*2"]);
    refused("GRT(Num,5)OTE(Motor)", &["S0704 Num"]);
    accepted("XIC(Safe)ADD(W,1,W)\nGRT(W,5)XIC(Std)OTE(Motor)");
}

#[test]
fn bits_of_a_number_when_written_apart_then_judged_apart() {
    accepted("XIC(Std)OTE(W.0)\nXIC(Safe)OTE(W.1)\nXIC(W.1)OTE(Motor)");
    refused("XIC(Std)OTE(W.0)\nXIC(Safe)OTE(W.1)\nEQU(W,3)OTE(Motor)", &["S0701 Std"]);
    refused("MOV(Num,W)\nXIC(W.4)OTE(Motor)", &["S0704 Num"]);
    refused("XIC(Num.3)OTE(Motor)", &["S0704 Num.3"]);
}

#[test]
fn arrays_when_a_tag_selects_then_every_element_is_meant() {
    refused("XIC(Std)OTE(Bits[W])\nXIC(Bits[3])OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Std)OTE(Bits[3])\nXIC(Bits[W])OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Safe)OTE(Bits[1])\nXIC(Safe2)OTE(Bits[2])\nXIC(Bits[Num])OTE(Motor)", &["S0704 Bits[Num]"]);
    accepted("XIC(Std)OTE(Bits[3])\nXIC(Safe)OTE(Bits[4])\nXIC(Bits[4])OTE(Motor)");
    refused("MOV(Num,Words[W])\nEQU(Words[2],1)OTE(Motor)", &["S0704 Num"]);
}

#[test]
fn files_when_standard_data_is_copied_then_it_is_followed() {
    refused("MOV(Num,Words[2])\nCOP(Words[0],More[1],4)\nEQU(More[3],1)OTE(Motor)", &["S0704 Num"]);
    accepted("MOV(Num,Words[2])\nXIC(Safe)MOV(1,Words[3])\nCOP(Words[0],More[1],4)\nEQU(More[4],1)OTE(Motor)");
    refused("FLL(Num,Words[0],8)\nEQU(Words[7],1)OTE(Motor)", &["S0704 Num"]);
    refused("MOV(Num,Words[2])\nFAL(K,8,0,ALL,More[K.POS],Words[K.POS]+1)\nEQU(More[0],1)OTE(Motor)", &["S0704 Num"]);
    refused("MOV(Num,Words[2])\nFSC(K,8,0,ALL,Words[K.POS]=4)\nXIC(K.FD)OTE(Motor)", &["S0704 Num"]);
}

#[test]
fn jumps_when_standard_data_decides_what_is_executed_then_it_counts() {
    refused("XIC(Std)JMP(Past)\nOTL(A)\nLBL(Past)XIC(A)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Std)JMP(Past)\nXIC(Safe)OTL(A)\nLBL(Past)XIC(A)OTE(Motor)");
    refused("XIC(Std)TND()\nOTE(Motor)", &["S0701 Std"]);
    refused("XIC(Std)MCR()\nOTE(Motor)\nMCR()", &["S0701 Std"]);
    accepted("XIC(Std)MCR()\nXIC(Safe)OTE(Motor)\nMCR()");
}

#[test]
fn subroutines_when_standard_data_is_passed_then_it_is_followed() {
    let part = "    ROUTINE Part\n      N: SBR(V)GRT(V,3)OTE(A);\n      N: RET(V);\n    END_ROUTINE\n";
    let found = findings(&text("", "", "JSR(Part,1,Num,W)\nXIC(A)OTE(Motor)", part));
    assert_eq!(found, ["S0704 Num"]);
    let found = findings(&text("", "", "JSR(Part,1,Num,W)\nEQU(W,3)OTE(Motor)", part));
    assert_eq!(found, ["S0704 Num"]);
    let found = findings(&text("", "", "JSR(Part,1,Num,W)\nXIC(A)XIC(Safe)OTE(Motor)", part));
    assert_eq!(found, Vec::<String>::new());
}

#[test]
fn subroutine_when_standard_data_alone_calls_it_then_what_it_writes_is_unqualified() {
    let part = "    ROUTINE Part\n      N: OTE(Motor);\n    END_ROUTINE\n";
    assert_eq!(findings(&text("", "", "XIC(Std)JSR(Part,0)", part)), ["S0701 Std"]);
    let part = "    ROUTINE Part\n      N: XIC(Safe)OTE(Motor);\n    END_ROUTINE\n";
    assert_eq!(findings(&text("", "", "XIC(Std)JSR(Part,0)", part)), Vec::<String>::new());
}

const ADD_ON: &str = r#"  ADD_ON_INSTRUCTION_DEFINITION Inner (Class := Safety)
    PARAMETERS
      Value : BOOL (Usage := Input, Required := Yes);
      Result : BOOL (Usage := Output, Required := Yes);
    END_PARAMETERS
    LOCAL_TAGS
      Step : BOOL;
    END_LOCAL_TAGS
    ROUTINE Logic
      N: XIC(Value)OTE(Step);
      N: XIC(Step)OTE(Result);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
  ADD_ON_INSTRUCTION_DEFINITION Outer (Class := Safety)
    PARAMETERS
      Go : BOOL (Usage := Input, Required := Yes);
      Data : DINT (Usage := InOut);
    END_PARAMETERS
    LOCAL_TAGS
      Nested : Inner;
      Done : BOOL;
    END_LOCAL_TAGS
    ROUTINE Logic
      N: Inner(Nested,Go,Done);
      N: XIC(Done)ADD(Data,1,Data);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
"#;

#[test]
fn add_ons_when_standard_data_goes_through_one_instance_then_the_other_stays_qualified() {
    let tags = "    I1, I2 : Inner (Class := Safety);\n    O1, O2 : Outer (Class := Safety);";
    let with = |rungs: &str| findings(&text(ADD_ON, tags, rungs, ""));
    assert_eq!(with("Inner(I1,Std,A)\nInner(I2,Safe,B)\nXIC(B)OTE(Motor)\nXIC(A)OTE(C)"), Vec::<String>::new());
    assert_eq!(with("Inner(I1,Std,A)\nInner(I2,Safe,B)\nXIC(A)OTE(Motor)"), ["S0701 Std"]);
    assert_eq!(with("Inner(I1,Std,A)\nXIC(I1.Result)OTE(Motor)"), ["S0701 Std"]);
    assert_eq!(with("Outer(O1,Std,W)\nOuter(O2,Safe,V)\nGRT(W,3)OTE(Motor)"), ["S0701 Std"]);
    assert_eq!(with("Outer(O1,Std,W)\nOuter(O2,Safe,V)\nGRT(V,3)OTE(Motor)"), Vec::<String>::new());
    assert_eq!(with("XIC(Std)Inner(I1,Safe,Motor)"), Vec::<String>::new());
    assert_eq!(with("XIC(Std)Inner(I1,1,Motor)"), ["S0701 Std"]);
}

#[test]
fn safety_instruction_when_its_reset_is_standard_data_then_accepted() {
    accepted(
        "DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Safe,Safe2,In:I.CombinedInputStatus,Std)\nXIC(E.O1)OTE(Motor)",
    );
}

#[test]
fn safety_instruction_when_a_channel_is_standard_data_then_refused_there_and_only_there() {
    let dcs = "DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Safe,Std,In:I.CombinedInputStatus,Safe)\nXIC(E.O1)OTE(Motor)";
    refused(dcs, &["S0702 Std"]);
}

#[test]
fn safety_instruction_when_its_mirrored_reset_is_used_then_it_is_no_safety_data() {
    let dcs = "DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Safe,Safe2,In:I.CombinedInputStatus,Std)\nXIC(E.Reset)OTE(Motor)";
    refused(dcs, &["S0701 Std"]);
}

#[test]
fn redundant_output_when_standard_data_alone_actuates_it_then_refused() {
    let crout = |actuate: &str| {
        format!(
            "CROUT(R,NEGATIVE,100,{actuate},Safe,Safe2,In:I.CombinedInputStatus,Out:I.CombinedOutputStatus,Std2)\nXIC(R.O1)OTE(Motor)"
        )
    };
    refused(&crout("Std"), &["S0701 Std"]);
    accepted(&format!("XIC(Std)XIC(In:I.Pt04Data)OTE(A)\n{}", crout("A")));
    let feedback = "XIC(In:I.Pt04Data)OTE(A)\nCROUT(R,NEGATIVE,100,A,Std,Safe2,In:I.CombinedInputStatus,Out:I.CombinedOutputStatus,Std2)\nXIC(R.O1)OTE(Motor)";
    refused(feedback, &["S0702 Std"]);
}

#[test]
fn produced_tag_when_standard_data_is_sent_then_refused() {
    let types = "  DATATYPE Link_T\n    CONNECTION_STATUS Status;\n    BOOL Stop;\n  END_DATATYPE\n";
    let tags = "    Link : Link_T (Class := Safety, Produced := 1, RPI := 20);";
    assert_eq!(findings(&text(types, tags, "XIC(Std)OTE(Link.Stop)", "")), ["S0701 Std"]);
    assert_eq!(findings(&text(types, tags, "XIC(Std)XIC(Safe)OTE(Link.Stop)", "")), Vec::<String>::new());
}

#[test]
fn test_output_when_standard_data_switches_it_then_accepted() {
    let modules = r#"  MODULE Lamps (CatalogNumber := "1734-IB8S", Parent := "Rack", Slot := 3, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10, OutputData := TEST) END_MODULE
"#;
    assert_eq!(findings(&text(modules, "", "XIC(Std)OTE(Lamps:O.Test03Data)", "")), Vec::<String>::new());
}

const PARAMETER: &str = "LES(W,V)OTE(Motor)\nXIC(Safe)ADD(W,1,W)";

#[test]
fn parameter_when_the_whole_sequence_is_kept_then_accepted() {
    accepted(&format!("XIC(Ack)ONS(Edge)EQU(Num,Num2)LIM(1,Num,100)MOV(Num,V)\n{PARAMETER}"));
    accepted(&format!(
        "EQU(Num,Num2)OTE(A)\nGEQ(Num,1)LEQ(Num2,100)OTE(B)\nXIC(Ack)OSR(Edge,C)\nXIC(A)XIC(B)XIC(C)MOV(Num,V)\n{PARAMETER}"
    ));
}

#[test]
fn parameter_when_a_step_of_the_sequence_is_missing_then_refused() {
    let without = |rung: &str| on_rungs(&format!("{rung}\n{PARAMETER}"));
    assert_eq!(without("XIC(Ack)ONS(Edge)LIM(1,Num,100)MOV(Num,V)"), ["S0704 Num"]);
    assert_eq!(without("XIC(Ack)ONS(Edge)EQU(Num,Num2)MOV(Num,V)"), ["S0704 Num"]);
    assert_eq!(without("XIC(Ack)ONS(Edge)EQU(Num,Num2)GEQ(Num,1)MOV(Num,V)"), ["S0704 Num"]);
    assert_eq!(without("XIC(Ack)ONS(Edge)EQU(Num,Num2)LIM(1,Num,Num2)MOV(Num,V)"), ["S0704 Num"]);
    assert_eq!(without("EQU(Num,Num2)LIM(1,Num,100)MOV(Num,V)"), ["S0704 Num"]);
    assert_eq!(without("EQU(Num,Num2)LIM(1,Num,100)XIC(Ack)ONS(Edge)MOV(Num,V)"), ["S0704 Num"]);
    assert_eq!(without("EQU(Num,Num2)LIM(1,Num,100)XIC(Ack)MOV(Num,V)"), ["S0704 Num"]);
    assert_eq!(without("XIC(Ack)ONS(Edge)[EQU(Num,Num2) ,]LIM(1,Num,100)MOV(Num,V)"), ["S0704 Num"]);
}

#[test]
fn integrity_when_a_single_point_switches_what_is_declared_sil_3_then_refused() {
    let tags = "    Press OF Out:O.Pt02Data (SIL := 3);\n    Known OF In:I.Pt05Data (SIL := 3);\n    Weak : BOOL (Class := Safety, SIL := 2);";
    let with = |rungs: &str| findings(&text("", tags, rungs, ""));
    assert_eq!(with("XIC(In:I.Pt04Data)OTE(Press)"), ["S0703 In:I.Pt04Data"]);
    assert_eq!(with("XIC(Known)OTE(Press)"), Vec::<String>::new());
    assert_eq!(with("XIC(Known)XIC(In:I.Pt04Data)OTE(Press)"), Vec::<String>::new());
    assert_eq!(with("XIC(Known)OTE(Weak)\nXIC(Weak)OTE(Press)"), ["S0703 Weak"]);
    assert_eq!(with("XIC(In:I.Pt04Data)OTE(Motor)"), Vec::<String>::new());
    let dcs = "DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,Safe,Safe2,In:I.CombinedInputStatus,In:I.Pt06Data)\nXIC(E.O1)OTE(Press)";
    assert_eq!(with(dcs), Vec::<String>::new());
}

/// 1756-RM093 Appendix G: what the standard side reads in two channels is SIL 2, under whatever name.
#[test]
fn integrity_when_mapped_data_is_declared_then_it_is_sil_2_at_most() {
    let with = |sil: &str, alias: &str, rungs: &str| {
        let tags = format!(
            "    Channel_A : BOOL;\n    A_Good : BOOL (Class := Safety, MappedFrom := Channel_A{sil});\n    A_Named OF A_Good{alias};\n    Press OF Out:O.Pt02Data (SIL := 3);\n    Known OF In:I.Pt05Data (SIL := 3);"
        );
        findings(&text("", &tags, rungs, ""))
    };
    let (declared, named) = (", SIL := 2", " (SIL := 3)");
    let alone = "XIC(A_Good)XIC(In:I.Pt04Data)OTE(Press)";
    assert_eq!(with(", SIL := 3", "", alone), ["S0305 Channel_A"]);
    assert_eq!(with(declared, "", alone), ["S0703 A_Good"]);
    assert_eq!(with("", named, "XIC(A_Named)XIC(In:I.Pt04Data)OTE(Press)"), ["S0703 A_Named"]);
    assert_eq!(with(declared, "", "XIC(A_Good)XIC(Known)OTE(Press)"), Vec::<String>::new());
    assert_eq!(with(declared, "", "XIC(A_Good)XIC(In:I.Pt04Data)OTE(Motor)"), Vec::<String>::new());
    assert_eq!(with(declared, "", "XIC(A_Good)OTE(Motor)"), ["S0701 A_Good"]);
}

#[test]
fn rung_when_something_on_it_is_faulty_then_the_data_flow_says_nothing_about_it() {
    refused("XIC(Std)XIC(Missing)OTE(Motor)", &["E0201 Missing"]);
}

#[test]
fn array_when_larger_than_what_is_followed_then_still_sound() {
    let tags = "    Large : DINT[20000] (Class := Safety);";
    assert_eq!(findings(&text("", tags, "MOV(Num,Large[17])\nMOV(Large[W],V)\nEQU(V,1)OTE(Motor)", "")), ["S0704 Num"]);
}

#[test]
fn findings_when_checked_twice_then_the_same() {
    let rungs =
        "[XIC(Std) ,XIC(Std2) ]OTE(A)\nXIC(A)OTE(B)\n[XIC(B) ,XIC(Std) ]OTE(Motor)\nMOV(Num,W)\nEQU(W,1)OTE(Lamp)";
    assert_eq!(on_rungs(rungs), on_rungs(rungs));
}

/// The codes of warnings about the data flow.
fn warnings(rungs: &str) -> Vec<String> {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", &text("", "", rungs, ""));
    let checked = check(&reading, &Completion::default());
    let own = checked.findings.iter().filter(|finding| finding.code.id == "W0117");
    own.map(|finding| sources.text(finding.span).to_owned()).collect()
}

#[test]
fn number_when_safety_data_stands_in_series_then_a_warning_unless_the_sequence_is_kept() {
    assert_eq!(warnings("LES(W,Num)XIC(Safe)OTE(Motor)"), ["Num"]);
    assert_eq!(warnings("XIC(Safe)MOV(Num,T.PRE)\nXIC(Safe)TON(T,?,?)\nXIC(T.DN)OTE(Motor)"), ["Num"]);
    let kept = "XIC(Ack)ONS(Edge)EQU(Num,Num2)LIM(1,Num,100)MOV(Num,V)\nLES(W,V)XIC(Safe)OTE(Motor)";
    assert_eq!(warnings(kept), Vec::<String>::new());
    assert_eq!(warnings("LES(W,Num)OTE(A)\nXIC(Safe)OTE(Motor)"), Vec::<String>::new());
    assert_eq!(warnings("LES(W,Num)OTE(Motor)"), Vec::<String>::new());
}
