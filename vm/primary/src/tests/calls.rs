//! Subscripts in the arguments of JSR and of Add-On calls, and calls on a rung on which a fault was cleared. REQ-EXEC-004,
//! 023, 030, 032, 051.

use twinrung_bytecode::image::Usage;

use super::assembler::Assembler;
use super::flow::{code, with_record};
use super::rig::Rig;

fn subroutine(rungs: &[&str], main: &str) -> Rig {
    let mut assembler = Assembler::new();
    assembler.tags("x p i ran DINT; out kept DINT[3]");
    assembler.routine("Deep", &["MOV(1,i)RET(50)"]);
    assembler.routine("Sub", rungs);
    assembler.main(&[main]);
    Rig::of(assembler)
}

#[test]
fn subroutine_when_a_return_subscript_is_out_of_range_then_faults_before_it_begins() {
    let mut rig = subroutine(&["SBR(p)ADD(ran,1,ran)", "RET(p)"], "JSR(Sub,1,x,out[i])");
    rig.set("x", 7);
    rig.set("i", 3);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.all("p ran"), [0, 0]);
    assert_eq!(rig.status().executed, 1);
    rig.set("i", 2);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("p ran out[2]"), [7, 1, 7]);
}

#[test]
fn subroutine_when_no_ret_is_reached_then_its_return_subscripts_are_looked_at_all_the_same() {
    let mut rig = subroutine(&["ADD(ran,1,ran)", "AFI()RET(x)"], "JSR(Sub,0,out[i])");
    rig.set("i", -1);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.get("ran"), 0);
}

#[test]
fn subroutine_when_it_changes_its_return_subscript_then_returns_to_what_was_selected_before() {
    let mut rig = subroutine(&["SBR(p)MOV(9,i)RET(p)"], "JSR(Sub,1,x,out[i])");
    rig.set("x", 7);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("out[0] out[1] out[2] i"), [7, 0, 0, 9]);
}

#[test]
fn subroutine_when_it_calls_another_then_each_returns_to_its_own_selection() {
    let mut rig = subroutine(&["SBR(p)MOV(2,i)JSR(Deep,0,kept[i])", "RET(p)"], "JSR(Sub,1,x,out[i])");
    rig.set("x", 7);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("out[0] out[1] out[2] kept[0] kept[1] kept[2]"), [7, 0, 0, 0, 0, 50]);
}

#[test]
fn user_fault_when_a_return_subscript_is_out_of_range_then_the_subscript_faults_first() {
    let mut assembler = Assembler::new();
    assembler.tags("i DINT; out DINT[3]");
    assembler.fault(&["RET(5)"]);
    assembler.main(&["JSR(Fault,1,992,out[i])"]);
    let mut rig = Rig::of(assembler);
    assert_eq!(code(rig.scan()), 992);
    rig.set("i", 3);
    assert_eq!(code(rig.scan()), 20);
}

fn placed(false_rungs: &[&str]) -> Rig {
    let mut assembler = Assembler::new();
    let parameters = [("Out", "DINT", Usage::Output), ("In", "DINT", Usage::Input), ("Where", "DINT", Usage::InOut)];
    assembler.add_on(
        "Place",
        &parameters,
        &[("Ran", "BOOL")],
        [&["OTL(Ran)MOV(In,Out)NEQ(In,0)MOV(In,Where)"], &[], false_rungs],
    );
    assembler.tags("a BOOL; i k other DINT; out DINT[5]; from DINT[5]; s Place");
    assembler.main(&["XIC(a)Place(s,out[i],from[k+1],i)"]);
    Rig::of(assembler)
}

#[test]
fn add_on_when_an_argument_is_out_of_range_then_faults_before_enable_in_is_set() {
    let mut rig = placed(&[]);
    rig.set("a", 1);
    rig.set("i", 5);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.all("s.EnableIn s.EnableOut s.Ran"), [0, 0, 0]);
    assert_eq!(rig.status().executed, 2);
    rig.set("i", 0);
    rig.set("k", 4);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.all("s.EnableIn s.EnableOut s.Ran"), [0, 0, 0]);
}

#[test]
fn add_on_when_two_arguments_are_out_of_range_then_the_first_of_the_call_faults() {
    let mut rig = placed(&[]);
    rig.set("a", 1);
    rig.set("i", 5);
    rig.set("k", i32::MAX);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.status().minor_faults, 0, "the subscript of In was not computed");
    rig.set("i", 0);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.status().minor_faults, 1);
}

#[test]
fn add_on_when_logic_changes_the_subscript_of_an_output_then_it_is_evaluated_again() {
    let mut rig = placed(&[]);
    rig.set("a", 1);
    rig.set("from[1]", 4);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("out[0] out[4] i"), [0, 4, 4]);
    rig.set("from[1]", 5);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.all("out[0] out[4] i s.Out s.EnableOut"), [0, 4, 5, 5, 1]);
}

#[test]
fn add_on_when_false_then_looks_at_its_arguments_only_for_a_routine() {
    let mut rig = placed(&[]);
    rig.set("i", 5);
    rig.set("s.EnableIn", 1);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.get("s.EnableIn"), 0);
    let mut rig = placed(&["NOP()"]);
    rig.set("i", 5);
    rig.set("s.EnableIn", 1);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.get("s.EnableIn"), 1);
}

#[test]
fn add_on_when_prescanned_with_an_output_out_of_range_then_faults_before_its_enables_fall() {
    let mut rig = placed(&[]);
    rig.set("i", 5);
    rig.set("s.EnableIn", 1);
    assert_eq!(code(rig.prescan()), 20);
    assert_eq!(rig.get("s.EnableIn"), 1);
}

#[test]
fn subroutine_when_a_later_sbr_subscript_is_out_of_range_then_writes_no_parameter() {
    let mut rig = subroutine(&["SBR(p,out[i])ADD(ran,1,ran)"], "JSR(Sub,2,x,x)");
    rig.set("x", 7);
    rig.set("i", 3);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.all("p ran"), [0, 0]);
    rig.set("i", 2);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("p ran out[2]"), [7, 1, 7]);
}

#[test]
fn subroutine_when_an_sbr_operand_is_the_subscript_of_another_then_that_is_evaluated_before_it_is_written() {
    let mut rig = subroutine(&["SBR(i,out[i])ADD(ran,1,ran)"], "JSR(Sub,2,x,x)");
    rig.set("x", 2);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("i out[0] out[2]"), [2, 2, 0]);
    rig.set("x", 9);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("i out[2] ran"), [9, 9, 2]);
}

fn split() -> Rig {
    let mut assembler = Assembler::new();
    let parameters = [("Low", "DINT", Usage::Output), ("High", "DINT", Usage::Output), ("In", "DINT", Usage::Input)];
    assembler.add_on(
        "Split",
        &parameters,
        &[],
        [&["MOV(In,Low)ADD(In,100,High)"], &["MOV(In,Low)ADD(In,200,High)"], &[]],
    );
    assembler.tags("i from DINT; out DINT[4]; s Split");
    assembler.main(&["Split(s,i,out[i],from)"]);
    Rig::of(assembler)
}

#[test]
fn add_on_when_an_output_is_the_subscript_of_a_later_one_then_that_is_evaluated_after_it_is_written() {
    let mut rig = split();
    rig.set("from", 3);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("i out[0] out[3]"), [3, 0, 103]);
    rig.set("from", 2);
    assert_eq!(code(rig.prescan()), 0);
    assert_eq!(rig.all("i out[2] out[3]"), [2, 202, 103]);
}

#[test]
fn add_on_when_an_output_moves_a_later_subscript_out_of_range_then_faults_and_what_is_written_stays() {
    let mut rig = split();
    rig.set("from", 4);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.all("i out[0] s.High s.EnableOut"), [4, 0, 104, 1]);
}

/// A rung on which a fault is cleared, a call that makes EnableOut true when false, and a rung behind it.
fn cleared(rung: &str) -> Rig {
    let mut assembler = Assembler::new();
    with_record(&mut assembler);
    assembler.add_on("Own", &[("Out", "DINT", Usage::Output)], &[], [&["MOV(1,Out)"], &[], &["OTE(EnableOut)"]]);
    assembler.tags("fault storage after next BOOL; i x DINT; out DINT[2]; s Own");
    assembler.fault(&["SSV(PROGRAM,THIS,0,zero[0])"]);
    assembler.main(&[rung, "AFI()Own(s,x)OTE(next)"]);
    let mut rig = Rig::of(assembler);
    rig.set("i", 2);
    rig
}

#[test]
fn enable_out_when_a_fault_was_cleared_on_its_rung_then_does_not_make_it_true_again() {
    let mut rig = cleared("[MOV(1,out[i]) , ,[Own(s,x)ONS(storage) ,]]OTE(after)");
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.status().cleared_faults, 1);
    assert_eq!(rig.all("storage after next s.EnableIn s.EnableOut"), [0, 0, 1, 0, 1]);
    rig.set("i", 0);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("storage after"), [1, 1]);
}

#[test]
fn enable_out_when_the_fault_was_in_its_own_outputs_then_the_rung_stays_false() {
    let mut rig = cleared("Own(s,out[i])Own(s,x)OTE(after)");
    rig.set("after", 1);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.status().cleared_faults, 1);
    assert_eq!(rig.all("after next s.EnableOut"), [0, 1, 1]);
}
