//! What single instructions make of the data that goes through them.

use crate::{accepted, findings, on_rungs, refused, text};

#[test]
fn one_shot_when_its_output_is_inverted_then_its_storage_bit_counts() {
    // The output is 0 in nearly every scan, and a prescan sets the storage bit: no safety data is needed for that.
    refused("XIC(Safe)ONS(Edge)OTE(A)\nXIC(Std)XIO(A)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Std)OTL(Edge)\nXIC(Safe)ONS(Edge)OTE(A)\nXIO(A)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Safe)ONS(Edge)OTE(A)\nXIC(Std)XIC(A)OTE(Motor)");
}

/// REQ-CHECK-012: DN is 0 until the time has passed or the count is reached, whatever the rung condition is.
#[test]
fn done_bit_when_it_is_inverted_and_no_safety_data_runs_it_then_it_qualifies_nothing() {
    refused("TON(T,100,0)\nXIC(Std)XIO(T.DN)OTE(Motor)", &["S0701 Std"]);
    refused("RTO(T,100,0)\nXIC(Std)XIO(T.DN)OTE(Motor)", &["S0701 Std"]);
    refused("CTU(N,3,0)\nXIC(Std)XIO(N.DN)OTE(Motor)", &["S0701 Std"]);
    refused("CTD(N,3,0)\nXIC(Std)XIO(N.DN)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Safe)RTO(T,100,0)\nXIC(Std)XIC(T.DN)OTE(Motor)");
    accepted("XIC(Safe)CTU(N,3,0)\nXIC(Std)XIC(N.DN)OTE(Motor)");
}

#[test]
fn overflow_when_it_is_inverted_and_no_safety_data_counts_then_it_qualifies_nothing() {
    refused("CTU(N,3,0)\nXIC(Std)XIO(N.OV)OTE(Motor)", &["S0701 Std"]);
    refused("CTD(N,3,0)\nXIC(Std)XIO(N.UN)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Safe)CTU(N,3,0)\nXIC(Std)XIC(N.OV)OTE(Motor)");
}

#[test]
fn overflow_when_it_begins_set_then_no_count_of_safety_data_stands_for_it() {
    // OV is bit 28 of the first word of a COUNTER; a prescan leaves it as it is.
    let begins = |word: i32| {
        let tags = format!("    Count : COUNTER (Class := Safety) := [{word},3,0];");
        findings(&text("", &tags, "XIC(Safe)CTU(Count,3,0)\nXIC(Std)XIC(Count.OV)OTE(Motor)", ""))
    };
    assert_eq!(begins(1 << 28), ["S0701 Std"]);
    assert_eq!(begins(0), Vec::<String>::new());
}

/// A prescan sets CU and CD, so that a rung that is true in the first scan does not count.
#[test]
fn count_enable_when_examined_before_the_counter_then_the_prescan_has_set_it() {
    refused("XIC(Std)XIC(N.CU)OTE(Motor)\nXIC(Safe)CTU(N,3,0)", &["S0701 Std"]);
    refused("XIC(Std)XIC(N.CD)OTE(Motor)\nXIC(Safe)CTD(N,3,0)", &["S0701 Std"]);
    accepted("XIC(Safe)CTU(N,3,0)\nXIC(Std)XIC(N.CU)OTE(Motor)");
}

#[test]
fn system_value_when_it_fills_several_elements_then_each_is_of_neither_origin() {
    let tags = "    Record : DINT[12] (Class := Safety);";
    let with = |gsv: &str, at: usize| {
        let rungs = format!("XIC(Safe)MOV(1,Record[{at}])\n{gsv}\nXIC(Std)EQU(Record[{at}],1)OTE(Motor)");
        findings(&text("", tags, &rungs, ""))
    };
    let gsv = "GSV(PROGRAM,THIS,MajorFaultRecord,Record[0])";
    assert_eq!(with(gsv, 0), ["S0701 Std"]);
    assert_eq!(with(gsv, 10), ["S0701 Std"]);
    assert_eq!(with(gsv, 11), Vec::<String>::new());
    assert_eq!(with("NOP()", 10), Vec::<String>::new());
}

#[test]
fn zone_when_a_jump_leads_to_its_first_rung_then_it_still_qualifies_and_past_it_no_more() {
    accepted("XIC(Safe2)JMP(In)\nNOP()\nLBL(In)XIC(Safe)MCR()\nXIC(Std)OTE(Motor)\nMCR()");
    refused("XIC(Safe2)JMP(In)\nXIC(Safe)MCR()\nLBL(In)XIC(Std)OTE(Motor)\nMCR()", &["S0701 Std"]);
}

#[test]
fn zone_when_a_jump_leads_into_a_later_one_then_it_still_qualifies() {
    let zone = "XIC(Safe)MCR()\nXIC(Std)OTE(Motor)\nMCR()";
    let later = "XIC(Safe)MCR()\nLBL(In)NOP()\nMCR()";
    accepted(&format!("{zone}\nXIC(Safe2)JMP(In)\n{later}"));
    accepted(&format!("XIC(Safe2)JMP(In)\n{zone}\n{later}"));
}

#[test]
fn inverted_contact_when_what_makes_its_bit_0_is_qualified_then_accepted() {
    let either = "[XIC(Std) ,XIC(Safe) ]OTE(A)";
    refused(&format!("{either}\nXIC(A)OTE(Motor)"), &["S0701 Std"]);
    accepted(&format!("{either}\nXIO(A)OTE(Motor)"));
}

#[test]
fn reset_when_standard_data_alone_does_it_then_what_it_clears_is_unqualified() {
    refused("XIC(Safe)CTU(N,3,0)\nXIC(Std)RES(N)\nXIO(N.DN)OTE(Motor)", &["S0701 Std"]);
    refused("XIC(Safe)RTO(T,3,0)\nXIC(Std)RES(T)\nXIO(T.DN)OTE(Motor)", &["S0701 Std"]);
    accepted("XIC(Safe)CTU(N,3,0)\nXIC(Safe2)RES(N)\nXIO(N.DN)OTE(Motor)");
}

#[test]
fn channels_when_they_are_reported_then_what_follows_from_them_is_not_reported_again() {
    let dcs = "DCS(E,E-STOP,EQUIVALENT - ACTIVE HIGH,500,MANUAL,MANUAL,A,B,In:I.CombinedInputStatus,Safe)";
    let rungs = format!("XIC(Std)OTE(A)\nXIC(Std2)OTE(B)\n{dcs}\nXIC(E.O1)OTE(Motor)");
    refused(&rungs, &["S0702 A", "S0702 B"]);
}

#[test]
fn parameter_when_it_is_compared_with_a_number_that_no_terminal_writes_then_refused() {
    let rest = "LES(W,V)OTE(Motor)\nXIC(Safe)ADD(W,1,W)";
    let found = on_rungs(&format!("XIC(Ack)ONS(Edge)EQU(Num,X)LIM(1,Num,100)MOV(Num,V)\n{rest}"));
    assert_eq!(found, ["S0704 Num"]);
}

#[test]
fn parameter_when_another_number_is_held_to_the_range_then_refused() {
    let rest = "LES(W,V)OTE(Motor)\nXIC(Safe)ADD(W,1,W)";
    let with = |range: &str| on_rungs(&format!("XIC(Ack)ONS(Edge)EQU(Num,Num2){range}MOV(Num,V)\n{rest}"));
    for kept in ["GEQ(Num,1)LEQ(Num,100)", "LEQ(1,Num)GEQ(100,Num2)", "GRT(Num,X)LES(Num,Y)", "LIM(1,Num2,100)"] {
        assert_eq!(with(kept), Vec::<String>::new(), "{kept}");
    }
    for other in [
        "GEQ(X,1)LEQ(Num,100)",
        "GEQ(Num,1)LEQ(X,100)",
        "GEQ(Num,Num2)LEQ(Num,100)",
        "GEQ(Num,1)LEQ(Num,Num2)",
        "GEQ(100,X)LEQ(1,Num)",
        "LEQ(1,X)GEQ(100,Num)",
        "LIM(1,X,100)",
        "LIM(Num2,Num,100)",
    ] {
        assert_eq!(with(other), ["S0704 Num"], "{other}");
    }
}

#[test]
fn parameter_when_a_bit_of_a_number_stands_for_a_step_and_something_writes_the_number_then_refused() {
    let rest = "XIC(Ack)ONS(Edge)XIC(Words[1].0)LIM(1,Num,100)MOV(Num,V)\nLES(W,V)OTE(Motor)\nXIC(Safe)ADD(W,1,W)";
    let with = |other: &str| on_rungs(&format!("EQU(Num,Num2)OTE(Words[1].0)\n{other}\n{rest}"));
    assert_eq!(with("NOP()"), Vec::<String>::new());
    assert_eq!(with("MOV(1,Words[2])"), Vec::<String>::new());
    assert_eq!(with("MOV(1,Words[1])"), ["S0704 Num"]);
    assert_eq!(with("MOV(1,Words[X])"), ["S0704 Num"]);
}

#[test]
fn integrity_when_a_single_point_writes_a_number_or_a_bit_of_it_then_refused() {
    let tags = "    Speed : DINT (Class := Safety, SIL := 3);\n    Known OF In:I.Pt05Data (SIL := 3);";
    let with = |rungs: &str| findings(&text("", tags, rungs, ""));
    assert_eq!(with("XIC(In:I.Pt04Data)MOV(1,Speed)"), ["S0703 In:I.Pt04Data"]);
    assert_eq!(with("XIC(In:I.Pt04Data)OTE(Speed.3)"), ["S0703 In:I.Pt04Data"]);
    assert_eq!(with("XIC(Known)MOV(1,Speed)\nXIC(Known)OTE(Speed.3)"), Vec::<String>::new());
}
