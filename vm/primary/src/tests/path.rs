//! The signature of the path of control. REQ-SCAN-010. The expected numbers were computed apart from this code.

use twinrung_bytecode::channel::{Channel, ScanEnd};
use twinrung_bytecode::image::Usage;

use super::assembler::Assembler;
use super::flow::{code, with_record};
use super::rig::Rig;

/// A routine begins, with its index.
const BEGINS: u64 = 1;
/// A JMP is taken, with the rung that it goes to.
const JUMPS: u64 = 2;
/// A routine runs out, with its number of rungs.
const RUNS_OUT: u64 = 3;
/// RET or TND, with its rung.
const LEAVES: u64 = 4;
/// A major fault, with its code.
const FAULTS: u64 = 5;

/// The signature of these events, by the words of REQ-SCAN-010, which must be `expected`.
fn went(events: &[(u64, u64)], expected: u32) -> u32 {
    const MODULUS: u64 = 1 << 32;
    let mut signature = 0u64;
    for (event, number) in events {
        let turned = signature * 32 % MODULUS + signature * 32 / MODULUS;
        signature = (turned ^ (event * (1 << 28) + number % (1 << 28))) * 0x9E37_79B1 % MODULUS;
    }
    assert_eq!(signature, u64::from(expected), "of {events:?}");
    expected
}

fn path(rig: &Rig) -> u32 {
    assert_eq!(rig.silent.path_signature(), rig.observed.path_signature());
    rig.silent.path_signature()
}

#[test]
fn path_when_one_routine_runs_then_it_begins_and_runs_out() {
    let mut rig = Rig::new("a b BOOL; i DINT; t TIMER", &["XIC(a)OTE(b)", "ADD(i,1,i)", "XIO(a)TON(t,?,?)"]);
    let expected = went(&[(BEGINS, 0), (RUNS_OUT, 3)], 0xCE37_79B1);
    assert_eq!(path(&rig), 0, "nothing was executed yet");
    rig.scan();
    assert_eq!(path(&rig), expected);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(path(&rig), expected, "data alone changes no path, and a scan begins anew");
    rig.prescan();
    assert_eq!(path(&rig), expected);
    rig.silent.reset();
    assert_eq!(rig.silent.path_signature(), 0);
}

#[test]
fn path_when_a_program_has_no_main_routine_then_is_empty() {
    let mut assembler = Assembler::new();
    assembler.tags("a BOOL");
    let mut rig = Rig::of(assembler);
    rig.scan();
    assert_eq!(path(&rig), 0);
}

#[test]
fn path_when_a_routine_is_called_then_its_begin_and_its_ret_are_in_it() {
    let mut assembler = Assembler::new();
    assembler.tags("call back BOOL; x y DINT");
    assembler.routine("Sub", &["NOP()", "XIC(back)RET(x)", "NOP()"]);
    assembler.main(&["XIC(call)JSR(Sub,0,y)", "NOP()"]);
    let mut rig = Rig::of(assembler);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 1), (RUNS_OUT, 2)], 0x63D5_7B07));
    rig.set("call", 1);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 1), (BEGINS, 0), (RUNS_OUT, 3), (RUNS_OUT, 2)], 0x23C1_CD21));
    rig.set("back", 1);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 1), (BEGINS, 0), (LEAVES, 1), (RUNS_OUT, 2)], 0x1BE3_F3F7));
}

#[test]
fn path_when_a_routine_is_called_twice_then_prescan_goes_through_it_once() {
    let mut assembler = Assembler::new();
    assembler.tags("a BOOL");
    assembler.routine("Sub", &["NOP()"]);
    assembler.main(&["XIC(a)JSR(Sub,0)JSR(Sub,0)", "XIC(a)RET()JMP(on)", "LBL(on)TND()"]);
    let mut rig = Rig::of(assembler);
    rig.set("a", 1);
    rig.prescan();
    assert_eq!(path(&rig), went(&[(BEGINS, 1), (BEGINS, 0), (RUNS_OUT, 1), (RUNS_OUT, 3)], 0xBA1B_6DA8));
    rig.scan();
    let events = [(BEGINS, 1), (BEGINS, 0), (RUNS_OUT, 1), (BEGINS, 0), (RUNS_OUT, 1), (LEAVES, 1)];
    assert_eq!(path(&rig), went(&events, 0x78A8_23B4));
}

#[test]
fn path_when_a_jump_is_taken_then_its_rung_is_in_it() {
    let mut rig = Rig::new("a b BOOL", &["XIC(a)JMP(on)", "OTE(b)", "NOP()", "LBL(on)NOP()"]);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 0), (RUNS_OUT, 4)], 0xE54C_DA26));
    rig.set("a", 1);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 0), (JUMPS, 3), (RUNS_OUT, 4)], 0xEAF7_9443));
}

#[test]
fn path_when_a_loop_runs_then_each_time_round_is_in_it() {
    let mut rig = Rig::new("i times DINT", &["CLR(i)", "LBL(top)ADD(i,1,i)", "LES(i,times)JMP(top)"]);
    rig.set("times", 3);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 0), (JUMPS, 1), (JUMPS, 1), (RUNS_OUT, 3)], 0xFA5B_26A7));
    rig.set("times", 2);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 0), (JUMPS, 1), (RUNS_OUT, 3)], 0x549D_F3BC));
}

/// An Add-On Instruction whose Logic is routine 0, its Prescan 1, its EnableInFalse 2; Main is 3.
fn add_on() -> Rig {
    let mut assembler = Assembler::new();
    let logic = ["XIC(Leave)RET()", "NOP()"];
    let prescan = ["NOP()", "NOP()", "LBL(end)NOP()"];
    assembler.add_on("Own", &[("Leave", "BOOL", Usage::Input)], &[], [&logic, &prescan, &["NOP()", "TND()"]]);
    assembler.tags("call leave BOOL; s t Own");
    assembler.main(&["XIC(call)Own(s,leave)"]);
    Rig::of(assembler)
}

#[test]
fn path_when_an_add_on_runs_then_its_logic_is_in_it() {
    let mut rig = add_on();
    rig.set("call", 1);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 3), (BEGINS, 0), (RUNS_OUT, 2), (RUNS_OUT, 1)], 0x1A72_CC36));
    rig.set("leave", 1);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 3), (BEGINS, 0), (LEAVES, 0), (RUNS_OUT, 1)], 0x37B6_F114));
}

#[test]
fn path_when_an_add_on_is_false_then_its_enable_in_false_routine_is_in_it() {
    let mut rig = add_on();
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 3), (BEGINS, 2), (LEAVES, 1), (RUNS_OUT, 1)], 0x0CA7_C423));
}

#[test]
fn path_when_an_add_on_is_prescanned_then_its_logic_and_its_prescan_are_in_it() {
    let mut rig = add_on();
    rig.prescan();
    let events = [(BEGINS, 3), (BEGINS, 0), (RUNS_OUT, 2), (BEGINS, 1), (RUNS_OUT, 3), (RUNS_OUT, 1)];
    assert_eq!(path(&rig), went(&events, 0x1CEE_96F2));
}

#[test]
fn path_when_a_fault_is_cleared_then_the_fault_and_its_routine_are_in_it() {
    let mut assembler = Assembler::new();
    with_record(&mut assembler);
    assembler.tags("i DINT; arr DINT[2]; keep BOOL");
    assembler.fault(&["NOP()", "XIO(keep)SSV(PROGRAM,THIS,0,zero[0])"]);
    assembler.main(&["NOP()", "MOV(1,arr[i])", "NOP()"]);
    let mut rig = Rig::of(assembler);
    rig.set("i", 2);
    assert_eq!(code(rig.scan()), 0);
    let events = [(BEGINS, 1), (FAULTS, 20), (BEGINS, 0), (RUNS_OUT, 2), (RUNS_OUT, 3)];
    assert_eq!(path(&rig), went(&events, 0x6FFA_16E6));
    rig.set("keep", 1);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(path(&rig), went(&[(BEGINS, 1), (FAULTS, 20), (BEGINS, 0), (RUNS_OUT, 2)], 0x2B59_BBC6));
}

#[test]
fn path_when_a_fault_has_no_routine_then_ends_with_it() {
    let mut rig = Rig::new("i DINT; arr DINT[2]", &["MOV(1,arr[i])", "NOP()"]);
    rig.set("i", 2);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(path(&rig), went(&[(BEGINS, 0), (FAULTS, 20)], 0xE8C4_7536));
}

#[test]
fn path_when_a_return_does_not_fit_then_the_routine_has_ended_before_the_fault() {
    let mut assembler = Assembler::new();
    assembler.tags("x y DINT");
    assembler.routine("Sub", &["RET(x)"]);
    assembler.main(&["JSR(Sub,0,x,y)"]);
    let mut rig = Rig::of(assembler);
    assert_eq!(code(rig.scan()), 31);
    assert_eq!(path(&rig), went(&[(BEGINS, 1), (BEGINS, 0), (LEAVES, 0), (FAULTS, 31)], 0x328E_BBAE));
}

#[test]
fn path_when_the_program_raises_its_own_fault_then_its_number_is_in_it() {
    let mut assembler = Assembler::new();
    assembler.tags("a BOOL");
    assembler.fault(&["OTE(a)"]);
    assembler.main(&["JSR(Fault,1,992)"]);
    let mut rig = Rig::of(assembler);
    assert_eq!(code(rig.scan()), 992);
    assert_eq!(path(&rig), went(&[(BEGINS, 1), (FAULTS, 992), (BEGINS, 0), (RUNS_OUT, 1)], 0xE170_45E3));
}

#[test]
fn path_when_a_tnd_is_true_then_its_routine_ends_on_its_rung() {
    let mut assembler = Assembler::new();
    assembler.tags("a b BOOL");
    assembler.routine("Sub", &["NOP()", "XIC(a)TND()", "NOP()"]);
    assembler.main(&["JSR(Sub,0)", "NOP()", "XIC(b)TND()", "NOP()"]);
    let mut rig = Rig::of(assembler);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 1), (BEGINS, 0), (LEAVES, 1), (RUNS_OUT, 4)], 0x6697_19D1));
    rig.set("b", 1);
    rig.scan();
    assert_eq!(path(&rig), went(&[(BEGINS, 1), (BEGINS, 0), (LEAVES, 1), (LEAVES, 2)], 0x4BE3_F3F7));
}

#[test]
fn path_when_a_scan_ends_early_then_the_next_one_begins_anew() {
    let mut rig = Rig::new("i DINT; arr DINT[2]", &["LBL(top)MOV(1,arr[i])", "JMP(top)"]);
    rig.budget = 10;
    assert_eq!(rig.scan(), ScanEnd::BudgetExceeded);
    rig.set("i", 2);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(path(&rig), went(&[(BEGINS, 0), (FAULTS, 20)], 0xE8C4_7536));
}
