//! Backward jumps, counted for each execution of a routine. REQ-EXEC-016.

use twinrung_bytecode::channel::ScanEnd;
use twinrung_bytecode::image::Usage;

use super::assembler::Assembler;
use super::flow::{code, with_record};
use super::rig::Rig;

/// A routine that goes through its first rung `times` times, jumping backward once less.
const LOOP: [&str; 3] = ["MOV(0,i)", "LBL(top)ADD(i,1,i)ADD(n,1,n)", "LES(i,times)JMP(top)"];

fn subroutine(main: &[&str]) -> Rig {
    let mut assembler = Assembler::new();
    assembler.tags("i j n times DINT; arr DINT[2]");
    assembler.routine("Sub", &LOOP);
    assembler.main(main);
    Rig::of(assembler)
}

#[test]
fn backward_jump_when_taken_a_thousand_times_then_the_next_time_faults() {
    let mut rig = Rig::new("i n times DINT", &LOOP);
    rig.set("times", 1001);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    assert_eq!(rig.scan(), ScanEnd::Completed, "the next scan executes the main routine anew");
    rig.set("times", 1002);
    assert_eq!(code(rig.scan()), 94);
    assert_eq!(rig.get("i"), 1001);
    rig.set("times", 1001);
    assert_eq!(rig.scan(), ScanEnd::Completed, "a scan that a fault has ended leaves nothing behind");
}

#[test]
fn backward_jump_when_a_routine_is_called_again_then_is_counted_anew() {
    let mut rig = subroutine(&["JSR(Sub,0)JSR(Sub,0)", "JSR(Sub,0)"]);
    rig.set("times", 1001);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    assert_eq!(rig.get("n"), 3 * 1001);
    rig.set("times", 1002);
    assert_eq!(code(rig.scan()), 94);
}

#[test]
fn backward_jump_when_the_routine_calls_another_that_loops_then_keeps_its_own_count() {
    let mut rig = subroutine(&["LBL(again)JSR(Sub,0)ADD(j,1,j)", "JMP(again)"]);
    rig.set("times", 5);
    assert_eq!(code(rig.scan()), 94);
    assert_eq!(rig.all("j n"), [1001, 5 * 1001]);
}

#[test]
fn backward_jump_when_routines_called_anew_loop_for_long_then_the_budget_ends_the_scan() {
    let mut rig = subroutine(&["LBL(again)JSR(Sub,0)ADD(j,1,j)", "LES(j,100)JMP(again)"]);
    rig.set("times", 900);
    rig.budget = 100_000;
    assert_eq!(rig.scan(), ScanEnd::BudgetExceeded);
}

#[test]
fn backward_jump_when_an_add_on_is_called_again_then_is_counted_anew() {
    let mut assembler = Assembler::new();
    let parameters = [("times", "DINT", Usage::Input), ("n", "DINT", Usage::Output)];
    assembler.add_on("Looping", &parameters, &[("i", "DINT")], [&LOOP, &[], &LOOP]);
    assembler.tags("a BOOL; j x y DINT; s1 s2 Looping");
    assembler.main(&["LBL(again)ADD(j,1,j)XIO(a)[Looping(s1,1001,x) ,Looping(s2,1001,y) ]", "LES(j,3)JMP(again)"]);
    let mut rig = Rig::of(assembler);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    assert_eq!(rig.all("x y"), [3 * 1001; 2]);
    rig.set("a", 1);
    rig.set("j", 0);
    assert_eq!(rig.scan(), ScanEnd::Completed, "EnableInFalse counts for itself");
    assert_eq!(rig.all("x y"), [6 * 1001; 2]);
}

#[test]
fn backward_jump_when_the_fault_routine_executes_the_halted_routine_then_each_execution_counts_for_itself() {
    let mut assembler = Assembler::new();
    assembler.tags("i k again DINT; arr DINT[2]");
    with_record(&mut assembler);
    assembler.routine("Sub", &["LBL(top)ADD(i,1,i)", "EQU(i,500)MOV(1,arr[k])", "LES(i,1100)JMP(top)"]);
    assembler.fault(&["JSR(Sub,0)MOV(again,i)SSV(PROGRAM,THIS,0,zero[0])"]);
    assembler.main(&["JSR(Sub,0)"]);
    let mut rig = Rig::of(assembler);
    rig.set("k", 2);
    // 499 jumps before the fault, 599 in the fault routine, 501 after it.
    rig.set("again", 599);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    assert_eq!(rig.get("i"), 1100);
    rig.set("i", 0);
    rig.set("again", 598);
    assert_eq!(code(rig.scan()), 94);
    assert_eq!(rig.get("i"), 1099);
}

#[test]
fn forward_jump_when_taken_more_than_a_thousand_times_then_is_not_counted() {
    let mut assembler = Assembler::new();
    assembler.tags("i j DINT");
    assembler.main(&[
        "LBL(outer)ADD(j,1,j)MOV(0,i)",
        "LBL(top)ADD(i,1,i)JMP(on)",
        "NOP()",
        "LBL(on)LES(i,900)JMP(top)",
        "LES(j,1)JMP(outer)",
    ]);
    let mut rig = Rig::of(assembler);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    rig.set("j", -1);
    assert_eq!(code(rig.scan()), 94, "but a backward one within the same execution is");
    assert_eq!(rig.all("j i"), [1, 102]);
}
