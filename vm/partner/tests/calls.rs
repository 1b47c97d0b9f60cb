//! Subscripts of operands: when calls look at them, and in which order expressions do. REQ-EXEC-004, 023, 030, 053.

mod support;

use support::{Rig, fault_code, project, rungs, tags};

const DOUBLE: &str = "ADD_ON_INSTRUCTION_DEFINITION Double (Class := Safety, Revision := \"1.0\")
PARAMETERS
Given : DINT (Usage := Input, Required := Yes, Visible := Yes);
Sum : DINT (Usage := Output, Required := Yes, Visible := Yes);
Next : DINT (Usage := InOut, Required := Yes, Visible := Yes);
END_PARAMETERS
ROUTINE Logic
N: ADD(Given,Given,Sum)ADD(Next,1,Next);
END_ROUTINE
END_ADD_ON_INSTRUCTION_DEFINITION";

const TAGS: &[&str] = &["I : Double", "A : DINT[3] := [5,6,7]", "B : DINT[3]", "At : DINT", "To : DINT", "K : DINT"];

/// A call of the Add-On Instruction, both walked and in regions; its scan has this fault, if any, and leaves these values.
fn called(call: &str, at: i32, to: i32, fault: Option<u16>, names: &[&str], expected: &[i32]) {
    for watched in [false, true] {
        let program = format!(")\nROUTINE Main\nN: {call};\nEND_ROUTINE");
        let mut rig = Rig { watched, ..Rig::new(&project(DOUBLE, &tags(TAGS), &program)) };
        rig.prescan(0);
        rig.set("I.Given", 99);
        rig.set("I.Sum", 99);
        rig.set("K", to);
        rig.set("At", at);
        rig.set("To", to);
        assert_eq!(fault_code(rig.scan(0)), fault, "{call}");
        assert_eq!(rig.row(names), expected, "{call}");
    }
}

#[test]
fn add_on_call_when_a_subscript_of_an_argument_is_out_of_range_then_nothing_of_it_is_written() {
    let names = ["I.EnableIn", "I.EnableOut", "I.Given", "I.Sum", "K", "B[0]", "B[1]", "B[2]"];
    called("Double(I,A[At],B[0],K)", 3, 1, Some(20), &names, &[0, 0, 99, 99, 1, 0, 0, 0]);
    called("Double(I,A[0],B[At],K)", -1, 1, Some(20), &names, &[0, 0, 99, 99, 1, 0, 0, 0]);
    called("Double(I,A[At],B[To],K)", 2, 1, None, &names, &[1, 1, 7, 14, 2, 0, 14, 0]);
}

#[test]
fn add_on_call_when_a_subscript_overflows_then_it_is_out_of_range_and_one_minor_fault_is_logged() {
    for watched in [false, true] {
        for (call, minor_faults) in [
            ("Double(I,A[At + At],B[0],K)", 1),
            ("Double(I,A[0],B[At + At],K)", 1),
            // The first that is out of range ends the look.
            ("Double(I,A[At],B[At + At],K)", 0),
        ] {
            let program = format!(")\nROUTINE Main\nN: {call};\nEND_ROUTINE");
            let mut rig = Rig { watched, ..Rig::new(&project(DOUBLE, &tags(TAGS), &program)) };
            rig.prescan(0);
            rig.set("At", i32::MAX);
            assert_eq!(fault_code(rig.scan(0)), Some(20), "{call}");
            assert_eq!(rig.status().minor_faults, minor_faults, "{call}");
        }
    }
}

#[test]
fn add_on_call_when_logic_changes_a_subscript_then_the_output_goes_to_where_it_leads_when_it_is_copied_out() {
    let names = ["I.EnableIn", "I.Sum", "K", "B[1]", "B[2]"];
    called("Double(I,A[2],B[K],K)", 0, 1, None, &names, &[1, 14, 2, 0, 14]);
    called("Double(I,A[2],B[K],K)", 0, 2, Some(20), &names, &[1, 14, 3, 0, 0]);
}

const PASSING: &str = ")
ROUTINE Main
N: JSR(Sub,1,A[At],B[To]);
END_ROUTINE
ROUTINE Sub
N: SBR(Given)ADD(To,1,To)ADD(Given,10,Given)RET(Given);
END_ROUTINE";

const PASSING_TAGS: &[&str] = &["A : DINT[3] := [5,6,7]", "B : DINT[3]", "At : DINT", "To : DINT", "Given : DINT"];

fn passing(at: i32, to: i32) -> Rig {
    let mut rig = Rig::new(&project("", &tags(PASSING_TAGS), PASSING));
    rig.prescan(0);
    rig.set("At", at);
    rig.set("To", to);
    rig
}

#[test]
fn jsr_when_the_routine_changes_a_subscript_then_the_value_goes_to_the_element_selected_before_it_began() {
    let mut rig = passing(1, 0);
    assert_eq!(fault_code(rig.scan(0)), None);
    assert_eq!(rig.row(&["To", "B[0]", "B[1]"]), [1, 16, 0]);
    // A subscript that the routine leads out of range does no harm.
    let mut rig = passing(1, 2);
    assert_eq!(fault_code(rig.scan(0)), None);
    assert_eq!(rig.row(&["To", "B[2]"]), [3, 16]);
}

#[test]
fn jsr_when_a_subscript_of_an_input_or_a_return_operand_is_out_of_range_then_the_routine_does_not_begin() {
    for (at, to) in [(3, 0), (0, 3), (-1, 0)] {
        let mut rig = passing(at, to);
        let before = rig.status().executed;
        assert_eq!(fault_code(rig.scan(0)), Some(20));
        assert_eq!(rig.status().executed - before, 1);
        assert_eq!(rig.row(&["To", "Given", "B[0]"]), [to, 0, 0]);
    }
}

const RECEIVING: &str = ")
ROUTINE Main
N: JSR(Sub,2,A[1],A[2]);
END_ROUTINE
ROUTINE Sub
N: SBR(At,B[At])NOP();
END_ROUTINE";

fn receiving(at: i32) -> (Rig, Option<u16>) {
    let mut rig = Rig::new(&project("", &tags(&["A : DINT[3] := [5,2,7]", "B : DINT[3]", "At : DINT"]), RECEIVING));
    rig.prescan(0);
    rig.set("At", at);
    let fault = fault_code(rig.scan(0));
    (rig, fault)
}

#[test]
fn sbr_when_its_first_operand_is_the_subscript_of_its_second_then_the_subscript_is_looked_at_before_it_is_written() {
    let (rig, fault) = receiving(1);
    assert_eq!(fault, None);
    assert_eq!(rig.row(&["At", "B[0]", "B[1]", "B[2]"]), [2, 0, 7, 0]);
}

#[test]
fn sbr_when_a_subscript_of_a_later_operand_is_out_of_range_then_none_is_written_and_the_routine_does_not_begin() {
    for at in [3, -1] {
        let (rig, fault) = receiving(at);
        assert_eq!(fault, Some(20));
        assert_eq!(rig.row(&["At", "B[0]", "B[1]", "B[2]"]), [at, 0, 0, 0]);
    }
}

#[test]
fn ret_when_no_jsr_waits_for_it_then_its_operands_are_evaluated_all_the_same() {
    for (at, fault) in [(2, None), (3, Some(20)), (-1, Some(20))] {
        let mut rig = rungs(&["A : DINT[3]", "At : DINT"], &["RET(A[At])"]);
        rig.prescan(0);
        rig.set("At", at);
        assert_eq!(fault_code(rig.scan(0)), fault, "{at}");
    }
}

/// A JSR to the fault routine, which takes its operands, has this fault.
fn user_fault(call: &str, receives: &str, at: i32, number: i32) -> Option<u16> {
    let program = format!(
        ", FAULT := \"Handler\")\nROUTINE Main\nN: {call};\nEND_ROUTINE\n\
         ROUTINE Handler\nN: {receives}RET(N);\nEND_ROUTINE"
    );
    let mut rig = Rig::new(&project("", &tags(&["A : DINT[3]", "B : DINT[3]", "At : DINT", "N : DINT"]), &program));
    rig.prescan(0);
    rig.set("At", at);
    rig.set("N", number);
    fault_code(rig.scan(0))
}

#[test]
fn jsr_when_it_raises_a_user_fault_then_its_return_operands_are_looked_at_before_and_those_of_the_sbr_never() {
    assert_eq!(user_fault("JSR(Handler,1,N,B[At])", "SBR(A[0])", 2, 995), Some(995));
    assert_eq!(user_fault("JSR(Handler,1,N,B[At])", "SBR(A[0])", 3, 995), Some(20));
    assert_eq!(user_fault("JSR(Handler,1,N,B[0])", "SBR(A[At])", 3, 995), Some(995));
    assert_eq!(user_fault("JSR(Handler,1,N,B[0])", "SBR(A[At])", 3, 989), Some(20));
    assert_eq!(user_fault("JSR(Handler,1,N,B[0])", "SBR(A[At])", 2, 989), None);
    assert_eq!(user_fault("JSR(Handler,1,999)", "SBR(A[At],B[At])", 3, 0), Some(999));
}

#[test]
fn expression_when_the_left_of_bitwise_logic_does_not_fit_then_it_overflows_before_the_right_is_evaluated() {
    let tag_list = ["R : REAL := 2147483648.0", "A : DINT[2]", "At : DINT := 2", "N : DINT", "K : CONTROL := [0,4,0]"];
    let rows = [
        ("CMP((R + 0.0) OR A[At])NOP()", 1),
        ("CMP(A[At] OR (R + 0.0))NOP()", 0),
        ("FSC(K,?,?,3,((N) + (R)) AND (A[At] >= 0))", 1),
        ("CPT(N,((R) XOR 1) OR A[At])", 1),
    ];
    for (rung, minor_faults) in rows {
        let mut rig = rungs(&tag_list, &[rung]);
        rig.prescan(0);
        assert_eq!(fault_code(rig.scan(0)), Some(20), "{rung}");
        let status = rig.status();
        assert_eq!((status.minor_faults, status.overflow), (minor_faults, minor_faults == 1), "{rung}");
    }
}
