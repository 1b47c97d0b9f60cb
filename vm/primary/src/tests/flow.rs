//! Program control, subroutines, Add-On Instructions, faults, system values. general-instructions.md A.8, A.10, B.7.

use alloc::string::ToString;

use twinrung_bytecode::channel::{Channel, ScanEnd};
use twinrung_bytecode::image::{SystemValueRecord, Usage};
use twinrung_bytecode::index::{EventTaskIndex, ProgramIndex};

use super::assembler::Assembler;
use super::rig::Rig;

fn assembler(tags: &str) -> Assembler {
    let mut assembler = Assembler::new();
    assembler.tags(tags);
    assembler
}

pub(super) fn code(end: ScanEnd) -> u16 {
    match end {
        ScanEnd::MajorFault(fault) => fault.code,
        ScanEnd::Completed | ScanEnd::BudgetExceeded => 0,
    }
}

pub(super) fn with_record(assembler: &mut Assembler) {
    assembler.tags("zero DINT[11]; record DINT[11]");
    assembler.image.system_values.push(SystemValueRecord { attribute: 9, instance: 0, first: 0, program: None });
}

#[test]
fn jump_when_taken_then_skips_what_lies_between() {
    let mut rig = Rig::new("a b c d BOOL", &["XIC(a)JMP(on)", "OTE(b)", "XIC(d)OTE(c)", "LBL(on)XIC(b)OTE(d)"]);
    rig.scan();
    assert_eq!(rig.all("b d"), [1, 1]);
    rig.set("a", 1);
    rig.set("c", 1);
    rig.scan();
    assert_eq!(rig.all("b c d"), [1, 1, 1]);
    assert_eq!(rig.status().executed, 8 + 5);
}

#[test]
fn backward_jump_when_it_never_ends_then_faults_after_a_thousand() {
    let mut rig = Rig::new("i DINT", &["LBL(top)ADD(i,1,i)", "JMP(top)"]);
    assert_eq!(code(rig.scan()), 94);
    assert_eq!(rig.get("i"), 1001);
    rig.budget = 100;
    rig.set("i", 0);
    assert_eq!(rig.scan(), ScanEnd::BudgetExceeded);
    assert_eq!(rig.get("i"), 34);
}

#[test]
fn master_control_reset_when_zone_is_off_then_rungs_are_false() {
    let mut rig = Rig::new("a b c d BOOL; i DINT", &["XIC(a)MCR()", "OTE(b)OTL(c)ADD(i,1,i)", "MCR()", "OTE(d)"]);
    rig.set("b", 1);
    rig.scan();
    assert_eq!(rig.all("b c d i"), [0, 0, 1, 0]);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("b c d i"), [1, 1, 1, 1]);
}

#[test]
fn always_false_when_on_a_rung_then_switches_off() {
    let mut rig = Rig::new("a b BOOL", &["AFI()OTE(a)", "NOP()OTE(b)"]);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("a b"), [0, 1]);
}

#[test]
fn temporary_end_when_true_then_ends_the_routine() {
    let mut assembler = assembler("a b c d BOOL");
    assembler.routine("Sub", &["XIC(a)TND()OTE(b)", "OTE(c)"]);
    assembler.main(&["JSR(Sub,0)OTE(d)"]);
    let mut rig = Rig::of(assembler);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("b c d"), [0, 0, 1]);
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("b c d"), [0, 1, 1]);
}

#[test]
fn subroutine_when_called_then_copies_in_and_returns_by_value() {
    let mut assembler = assembler("go b BOOL; x y p q DINT; t u TIMER; f g BOOL");
    assembler.routine("Sub", &["SBR(p,u,f)ADD(p,1,q)", "XIO(go)RET(q,u,f)"]);
    assembler.main(&["JSR(Sub,3,x,t,b,y,t,g)"]);
    let mut rig = Rig::of(assembler);
    rig.set("x", 41);
    rig.set("t.PRE", 9);
    rig.set("b", 1);
    rig.scan();
    assert_eq!(rig.all("y p u.PRE g"), [42, 41, 9, 1]);
    rig.set("go", 1);
    rig.set("x", 1);
    rig.scan();
    assert_eq!(rig.all("y q"), [42, 2]);
}

#[test]
fn prescan_when_a_routine_is_called_twice_then_visits_it_once() {
    let mut assembler = assembler("a b BOOL");
    assembler.routine("Sub", &["OTE(a)"]);
    assembler.main(&["XIC(b)JSR(Sub,0)JSR(Sub,0)"]);
    let mut rig = Rig::of(assembler);
    rig.set("a", 1);
    rig.prescan();
    assert_eq!(rig.get("a"), 0);
    assert_eq!(rig.status().executed, 4);
}

#[test]
fn first_scan_bit_when_after_prescan_then_set_for_one_scan() {
    let mut rig = Rig::new("a BOOL; i DINT", &["XIC(S:FS)ADD(i,1,i)OTE(a)"]);
    rig.prescan();
    rig.scan();
    assert_eq!(rig.all("a i"), [1, 1]);
    rig.scan();
    assert_eq!(rig.all("a i"), [0, 1]);
}

#[test]
fn fault_when_the_routine_clears_it_then_the_rest_of_the_rung_is_false() {
    let mut assembler = assembler("a b c d e f BOOL; i n DINT; arr DINT[2]");
    with_record(&mut assembler);
    assembler.fault(&["GSV(PROGRAM,THIS,0,record[0])ADD(n,1,n)", "XIO(f)SSV(PROGRAM,THIS,0,zero[0])"]);
    assembler.main(&["XIC(a)[OTE(b)MOV(1,arr[i])OTE(c) ,OTE(d) ]OTE(e)", "OTE(a)"]);
    let mut rig = Rig::of(assembler);
    for name in ["a", "c", "d", "e"] {
        rig.set(name, 1);
    }
    rig.set("i", 5);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    assert_eq!(rig.all("b c d e a n"), [1, 0, 0, 0, 1, 1]);
    assert_eq!(rig.all("record[2] record[3] record[5] record[6]"), [4 | (20 << 16), 0, 0, 2]);
    assert_eq!(rig.status().cleared_faults, 1);
    assert_eq!(rig.silent.fault_record(ProgramIndex(0)), Some([0; 11]));
    rig.set("f", 1);
    assert_eq!(code(rig.scan()), 20);
}

#[test]
fn fault_when_it_is_the_second_of_a_scan_then_ends_it() {
    let mut assembler = assembler("i n DINT; arr DINT[2]");
    with_record(&mut assembler);
    assembler.fault(&["ADD(n,1,n)SSV(PROGRAM,THIS,0,zero[0])"]);
    assembler.main(&["MOV(1,arr[i])", "MOV(2,arr[i])", "ADD(n,100,n)"]);
    let mut rig = Rig::of(assembler);
    rig.set("i", 5);
    let ScanEnd::MajorFault(fault) = rig.scan() else { panic!("no fault") };
    assert_eq!((fault.code, fault.place.rung), (20, 1));
    assert_eq!(rig.get("n"), 1);
}

#[test]
fn prescan_when_an_instruction_faults_then_it_ends_without_the_fault_routine() {
    let mut assembler = assembler("i n DINT; flags BOOL[32]; a BOOL");
    with_record(&mut assembler);
    assembler.fault(&["ADD(n,1,n)SSV(PROGRAM,THIS,0,zero[0])"]);
    assembler.main(&["OTE(flags[i])OTE(a)"]);
    let mut rig = Rig::of(assembler);
    rig.set("i", 32);
    rig.set("a", 1);
    assert_eq!(code(rig.prescan()), 20);
    assert_eq!(rig.all("n a"), [0, 1]);
    assert_eq!((rig.status().executed, rig.status().cleared_faults), (1, 0));
    assert_eq!(code(rig.scan()), 0, "a scan runs it again");
    assert_eq!((rig.get("n"), rig.status().cleared_faults), (1, 1));
}

#[test]
fn prescan_when_a_record_is_filled_then_clears_it() {
    let mut assembler = assembler("i n DINT; arr DINT[2]");
    assembler.main(&["MOV(1,arr[i])"]);
    let mut rig = Rig::of(assembler);
    rig.set("i", 2);
    assert_eq!(code(rig.scan()), 20);
    assert_ne!(rig.silent.fault_record(ProgramIndex(0)), Some([0; 11]));
    assert_eq!(rig.prescan(), ScanEnd::Completed);
    assert_eq!(rig.silent.fault_record(ProgramIndex(0)), Some([0; 11]));
}

#[test]
fn user_fault_when_number_is_in_range_then_is_raised() {
    let mut assembler = assembler("i DINT; a BOOL");
    assembler.fault(&["SBR(i)OTE(a)"]);
    assembler.main(&["JSR(Fault,1,992)"]);
    let mut rig = Rig::of(assembler);
    assert_eq!(code(rig.scan()), 992);
    assert_eq!(rig.get("a"), 1);
}

#[test]
fn event_when_true_then_is_counted_for_the_scan() {
    let mut assembler = assembler("a BOOL");
    assembler.image.event_tasks.push("E".to_string());
    assembler.main(&["EVENT(0)XIC(a)EVENT(0)"]);
    let mut rig = Rig::of(assembler);
    rig.scan();
    assert_eq!(rig.silent.events(EventTaskIndex(0)), 1);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.silent.events(EventTaskIndex(0)), 2);
}

#[test]
fn system_value_when_destination_is_of_another_width_then_its_bytes_are_written_low_first() {
    let mut assembler = assembler("i DINT; p SINT[5]; n INT");
    for (attribute, first) in [(13, 0), (5, 1), (6, 2)] {
        let value = SystemValueRecord { attribute, instance: 0, first, program: None };
        assembler.image.system_values.push(value);
    }
    assembler.main(&["GSV(SAFETY,,0,i)GSV(TASK,T,1,n)GSV(TASK,T,2,p[0])"]);
    let mut rig = Rig::of(assembler);
    rig.system_values = alloc::vec![1, 7, 0x0102_8081];
    rig.set("i", 0x0102_0304);
    rig.set("p[4]", 9);
    rig.scan();
    assert_eq!(rig.all("i n p[0] p[1] p[2] p[3] p[4]"), [0x0102_0301, 7, -127, -128, 2, 1, 9]);
    assert_eq!((rig.status().overflow, rig.status().minor_faults), (false, 0));
}

#[test]
fn system_value_when_destination_is_a_structure_then_covers_its_bits_and_leaves_what_lies_beyond() {
    let mut assembler = assembler("first DINT; k CONTROL; after DINT");
    assembler.image.system_values.push(SystemValueRecord { attribute: 2, instance: 0, first: 0, program: None });
    assembler.main(&["MOV(5,k.POS)MOV(6,k.LEN)GSV(TASK,T,0,k)MOV(k.LEN,after)"]);
    let mut rig = Rig::of(assembler);
    rig.system_values = alloc::vec![0x2100_0000, 12];
    rig.set("k.EN", 1);
    rig.scan();
    assert_eq!(rig.all("k.EN k.DN k.FD k.LEN k.POS after"), [0, 1, 1, 12, 5, 12]);
}

#[test]
fn system_value_when_a_subscript_leaves_too_little_room_then_faults() {
    let mut assembler = assembler("arr DINT[3]; i DINT");
    assembler.image.system_values.push(SystemValueRecord { attribute: 2, instance: 0, first: 0, program: None });
    assembler.main(&["GSV(TASK,T,0,arr[i])"]);
    let mut rig = Rig::of(assembler);
    rig.system_values = alloc::vec![5, 6];
    rig.set("i", 1);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("arr[1] arr[2]"), [5, 6]);
    rig.set("i", 2);
    assert_eq!(code(rig.scan()), 20);
}

fn scaled(with_false: &[&str]) -> Rig {
    let mut assembler = Assembler::new();
    assembler.add_on(
        "Scale",
        &[
            ("Go", "BOOL", Usage::Input),
            ("In", "INT", Usage::Input),
            ("Out", "DINT", Usage::Output),
            ("Total", "DINT", Usage::InOut),
        ],
        &[("Seen", "BOOL"), ("T", "TIMER")],
        [
            &["MUL(In,2,Out)ADD(Total,Out,Total)", "XIC(Go)OTE(Seen)", "XIC(Go)TON(T,?,?)", "XIO(Go)OTU(EnableOut)"],
            &["OTL(Seen)MOV(77,Out)"],
            with_false,
        ],
    );
    assembler.tags("a b c BOOL; x y z DINT; s1 s2 Scale");
    assembler.main(&["XIC(a)Scale(s1,b,x,y,z)OTE(c)", "Scale(s2,a,3,y,z)"]);
    Rig::of(assembler)
}

#[test]
fn add_on_when_true_then_copies_converts_and_passes_enable_out() {
    let mut rig = scaled(&[]);
    rig.set("a", 1);
    rig.set("b", 1);
    rig.set("x", 65536 + 5);
    rig.scan();
    assert_eq!(rig.all("s1.In s1.Out s1.Seen s1.EnableIn s1.EnableOut c z y"), [5, 10, 1, 1, 1, 1, 16, 6]);
    assert_eq!(rig.status().minor_faults, 1);
    rig.set("b", 0);
    rig.scan();
    assert_eq!(rig.all("s1.EnableIn s1.EnableOut c"), [1, 0, 0]);
}

#[test]
fn add_on_when_false_then_only_its_enables_fall() {
    let mut rig = scaled(&[]);
    rig.set("s1.EnableIn", 1);
    rig.set("s1.EnableOut", 1);
    rig.set("c", 1);
    rig.scan();
    assert_eq!(rig.all("s1.EnableIn s1.EnableOut s1.Out c"), [0, 0, 0, 0]);
    let mut rig = scaled(&["MOV(9,Out)OTE(EnableOut)"]);
    rig.set("x", 4);
    rig.scan();
    assert_eq!(rig.all("s1.EnableIn s1.EnableOut s1.In s1.Out c"), [0, 1, 4, 9, 1]);
}

#[test]
fn add_on_when_prescanned_then_runs_its_prescan_routine_with_true_rungs() {
    let mut rig = scaled(&[]);
    rig.set("x", 4);
    rig.set("s1.T.DN", 1);
    rig.prescan();
    assert_eq!(rig.all("s1.In s1.Out s1.Seen s1.T.DN y"), [4, 77, 1, 0, 77]);
    assert_eq!(rig.status().executed, 4 + 2 * (8 + 2));
}

#[test]
fn observer_when_active_then_hears_rungs_results_and_writes() {
    let mut rig = Rig::new("a b BOOL; i DINT", &["XIC(a)OTE(b)", "XIO(b)MOV(3,i)"]);
    rig.scan();
    assert_eq!(rig.recorder.rungs, [0, 1]);
    assert_eq!(
        rig.recorder.results,
        [(0, 0, true, false), (0, 1, false, false), (1, 0, true, true), (1, 1, true, true)]
    );
    assert_eq!(rig.recorder.bits, [(1, false)]);
    assert_eq!(rig.recorder.words, [(0, 3)]);
    assert_eq!(rig.recorder.retired, 4);
}

#[test]
fn reset_when_called_then_all_is_as_loaded() {
    let mut rig = Rig::new("a BOOL; t TIMER", &["TON(t,?,?)OTE(a)"]);
    rig.prescan();
    rig.scan();
    rig.scan();
    rig.silent.reset();
    assert_eq!(rig.all("a t.EN t.ACC"), [0, 0, 0]);
    assert_eq!(rig.status().executed, 0);
}
