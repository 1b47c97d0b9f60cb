//! What a controller and an observer see of the partner.

mod support;

use support::{Rig, Watching, fault_code, project, rungs, tags};
use twinrung_bytecode::channel::{Channel, MajorFault, Place, Representation, ScanEnd, ScanInputs};
use twinrung_bytecode::index::{BitCell, ProgramIndex, RoutineIndex, WordCell};
use twinrung_bytecode::observer::Observer;
use twinrung_partner::Partner;

/// Writes down everything that it is told.
#[derive(Default)]
struct Log {
    lines: Vec<String>,
    retired: u64,
}

impl Observer for Log {
    fn rung_entered(&mut self, place: Place) {
        self.lines.push(format!("rung {}", place.rung));
    }

    fn element_result(&mut self, place: Place, condition_in: bool, condition_out: bool) {
        self.lines.push(format!(
            "{}.{} {}{}",
            place.rung,
            place.element,
            u8::from(condition_in),
            u8::from(condition_out)
        ));
    }

    fn bit_written(&mut self, cell: BitCell, value: bool) {
        self.lines.push(format!("bit {}={}", cell.0, u8::from(value)));
    }

    fn word_written(&mut self, cell: WordCell, value: i32) {
        self.lines.push(format!("word {}={value}", cell.0));
    }

    fn instructions_retired(&mut self, count: u64) {
        self.retired += count;
    }
}

fn inputs(now_ms: i64) -> ScanInputs<'static> {
    ScanInputs { now_ms, budget: u64::MAX, system_values: &[] }
}

#[test]
fn observer_when_active_then_every_rung_result_write_and_count_is_reported() {
    let mut rig = rungs(&["A : BOOL", "B : BOOL", "N : DINT"], &["XIC(A)[OTE(B) ,MOV(5,N) ]", "XIO(B)OTL(A)"]);
    rig.prescan(0);
    rig.set("A", 1);
    let before = rig.status().executed;
    let mut log = Log::default();
    rig.partner.scan(inputs(0), &mut log);
    let expected = ["rung 0", "0.0 11", "bit 1=1", "0.1 11", "word 0=5", "0.2 11", "rung 1", "1.0 10", "1.1 00"];
    assert_eq!(log.lines, expected);
    assert_eq!(log.retired, rig.status().executed - before);
}

#[test]
fn bits_and_words_when_read_then_every_cell_is_complemented_and_private_cells_are_not_shown() {
    assert_eq!(Partner::REPRESENTATION, Representation::Complemented);
    let rig = rungs(&["A : BOOL := 1", "B : BOOL", "N : DINT := 7"], &["XIC(A)OTE(B)"]);
    assert_eq!(rig.partner.bits(), [0xFE, 0xFF]);
    assert_eq!(rig.partner.words(), [!7u32]);
}

#[test]
fn set_when_the_cell_is_beyond_the_image_then_nothing_changes() {
    let mut rig = rungs(&["A : BOOL"], &["XIC(A)OTE(A)"]);
    let before = rig.partner.bits().to_vec();
    for cell in [1, 5, u32::MAX] {
        rig.partner.set_bit(BitCell(cell), true);
        rig.partner.set_word(WordCell(cell), -1);
    }
    rig.prescan(0);
    rig.scan(0);
    assert_eq!(rig.partner.bits(), before);
}

#[test]
fn set_when_the_cell_is_the_first_beyond_the_image_then_the_next_scan_is_as_without_it() {
    let mut rig = rungs(&["A : BOOL", "First : BOOL", "N : DINT"], &["XIC(A)MOV(5,N)", "XIC(S:FS)OTE(First)"]);
    rig.prescan(0);
    rig.scan(0);
    rig.set("A", 1);
    rig.partner.set_bit(BitCell(2), true);
    rig.partner.set_word(WordCell(1), 9);
    rig.scan(10);
    assert_eq!(rig.row(&["N", "First"]), [5, 0]);
}

#[test]
fn cells_when_there_are_more_than_65536_then_the_last_behave_as_the_first() {
    let tag_list = ["Low : DINT[65600]", "High : DINT", "Sum : DINT := 7"];
    let mut rig = rungs(&tag_list, &["MOV(5,High)", "ADD(High,Low[65599],Sum)"]);
    assert_eq!(rig.row(&["High", "Sum"]), [0, 7]);
    rig.prescan(0);
    rig.set("Low[65599]", 30);
    rig.scan(0);
    assert_eq!(rig.row(&["High", "Low[65599]", "Sum"]), [5, 30, 35]);
}

#[test]
fn reset_when_called_then_the_channel_runs_as_after_loading() {
    let text = ["XIC(In)TON(T,?,?)", "XIC(In)ONS(S)ADD(N,1,N)", "XIC(In)CTU(C,?,?)", "XIC(T.DN)OTL(Out)"];
    let tag_list =
        ["In : BOOL", "S : BOOL", "Out : BOOL", "N : DINT := 3", "T : TIMER := [0,20,0]", "C : COUNTER := [0,2,0]"];
    let run = |rig: &mut Rig| {
        let mut rows = vec![];
        rig.prescan(0);
        for scan in 0..8 {
            rig.set("In", i32::from(scan % 5 != 3));
            rig.scan(scan * 10);
            rows.push((rig.partner.bits().to_vec(), rig.partner.words().to_vec(), rig.status()));
        }
        rows
    };
    let mut rig = rungs(&tag_list, &text);
    let first = run(&mut rig);
    rig.partner.reset();
    assert_eq!(rig.status(), Default::default());
    assert_eq!(run(&mut rig), first);
}

#[test]
fn first_scan_when_a_prescan_went_before_then_set_for_one_scan() {
    let mut rig = rungs(&["A : BOOL", "N : DINT"], &["XIC(S:FS)ADD(N,1,N)", "XIC(S:FS)OTE(A)"]);
    rig.prescan(0);
    assert!(!rig.status().first_scan);
    rig.scan(0);
    assert_eq!((rig.status().first_scan, rig.row(&["A", "N"])), (true, vec![1, 1]));
    rig.scan(10);
    assert_eq!((rig.status().first_scan, rig.row(&["A", "N"])), (false, vec![0, 1]));
}

#[test]
fn timer_when_its_preset_is_negative_then_the_fault_names_the_place_and_later_rungs_do_not_run() {
    let tag_list = ["A : BOOL", "B : BOOL", "C : BOOL", "T : TIMER"];
    let mut rig = rungs(&tag_list, &["XIC(A)OTE(B)", "XIC(A)TON(T,?,?)", "OTE(C)"]);
    rig.prescan(0);
    rig.set("A", 1);
    rig.set("T.PRE", -1);
    let place = Place { program: ProgramIndex(0), routine: RoutineIndex(0), rung: 1, element: 1 };
    assert_eq!(rig.scan(5), ScanEnd::MajorFault(MajorFault { code: 34, place }));
    assert_eq!(rig.row(&["B", "C", "T.EN"]), [1, 0, 0]);
    assert_eq!(rig.record(), [5, 0, (34 << 16) | 4, 0, 0, 1, 1, 0, 0, 0, 0]);
    rig.set("A", 0);
    assert_eq!(rig.scan(10), ScanEnd::Completed);
    assert_eq!(rig.row(&["B", "C"]), [0, 1]);
}

#[test]
fn budget_when_exceeded_then_a_backward_jump_and_the_end_of_the_scan_notice() {
    let mut rig = rungs(&["N : DINT"], &["LBL(Again)ADD(N,1,N)", "LES(N,500)JMP(Again)"]);
    rig.budget = 100;
    rig.prescan(0);
    assert_eq!(rig.scan(0), ScanEnd::BudgetExceeded);
    assert_eq!(rig.get("N"), 26);
    let mut rig = rungs(&["N : DINT"], &["NOP()NOP()NOP()"]);
    rig.budget = 3;
    rig.prescan(0);
    assert_eq!(rig.scan(0), ScanEnd::Completed);
    rig.budget = 2;
    assert_eq!(rig.scan(0), ScanEnd::BudgetExceeded);
}

#[test]
fn safety_application_instruction_when_run_then_the_ladder_counts_as_one_and_touches_no_flag() {
    let text = "DCS(Stop,E-STOP,EQUIVALENT - ACTIVE HIGH,100,AUTOMATIC,AUTOMATIC,A,B,Valid,Reset)";
    let tag_list = ["A : BOOL", "B : BOOL", "Valid : BOOL", "Reset : BOOL", "X : DINT", "Stop : DCI_STOP"];
    let mut rig = rungs(&tag_list, &[&format!("SUB(0,1,X){text}")]);
    rig.prescan(0);
    for tag in ["A", "B", "Valid"] {
        rig.set(tag, 1);
    }
    let before = rig.status().executed;
    for scan in 0..20 {
        assert_eq!(rig.scan(scan * 10), ScanEnd::Completed);
    }
    let status = rig.status();
    assert_eq!(status.executed - before, 40);
    assert!(status.negative && status.carry && !status.zero && !status.overflow);
    assert_eq!(rig.row(&["Stop.O1", "Stop.FP", "Stop.EnableIn", "Stop.ChannelA"]), [1, 0, 1, 1]);
    rig.set("B", 0);
    rig.scan(210);
    assert_eq!(rig.row(&["Stop.O1", "Stop.ChannelB"]), [0, 0]);
}

#[test]
fn calls_when_the_same_definition_is_called_twice_then_each_has_its_own_body() {
    let definition = "ADD_ON_INSTRUCTION_DEFINITION Count_Up (Class := Safety, Revision := \"1.0\")\n\
        PARAMETERS\nStep : DINT (Usage := Input, Required := Yes, Visible := Yes);\n\
        Sum : DINT (Usage := InOut, Required := Yes, Visible := Yes);\nEND_PARAMETERS\n\
        LOCAL_TAGS\nCalls : DINT;\nEND_LOCAL_TAGS\n\
        ROUTINE Logic\nN: ADD(Calls,1,Calls);\nN: ADD(Sum,Step,Sum);\nEND_ROUTINE\nEND_ADD_ON_INSTRUCTION_DEFINITION";
    let program = ")\nROUTINE Main\nN: Count_Up(I,2,P);\nN: XIC(Go)Count_Up(J,30,Q);\nEND_ROUTINE";
    let tag_list = tags(&["Go : BOOL", "I : Count_Up", "J : Count_Up", "P : DINT", "Q : DINT"]);
    let mut rig = Rig::new(&project(definition, &tag_list, program));
    rig.prescan(0);
    for scan in 0..4 {
        rig.set("Go", scan % 2);
        rig.scan(i64::from(scan) * 10);
    }
    assert_eq!(rig.row(&["P", "Q", "I.Calls", "J.Calls"]), [8, 60, 4, 2]);
    let mut watched = Rig::new(&project(definition, &tag_list, program));
    watched.partner.prescan(inputs(0), &mut Watching);
    watched.partner.scan(inputs(0), &mut Watching);
    assert_eq!(watched.row(&["P", "Q"]), [2, 0]);
}

/// A program whose second rung faults while `At` is out of range, and whose fault routine clears what it finds.
const HANDLED: &str = ", FAULT := \"Handler\")
ROUTINE Main
N: OSR(Storage,List[At].0);
N: ADD(Runs,1,Runs);
END_ROUTINE
ROUTINE Handler
N: ADD(Handled,1,Handled)SSV(PROGRAM,THIS,MajorFaultRecord,Zero[0]);
END_ROUTINE";

const HANDLED_TAGS: &[&str] =
    &["Storage : BOOL := 1", "List : DINT[2]", "At : DINT", "Runs : DINT", "Handled : DINT", "Zero : DINT[11]"];

/// REQ-EXEC-051.
#[test]
fn prescan_when_an_instruction_faults_then_it_ends_there_and_no_fault_routine_runs() {
    let mut rig = Rig::new(&project("", &tags(HANDLED_TAGS), HANDLED));
    rig.set("At", 2);
    assert_eq!(fault_code(rig.prescan(7)), Some(20));
    assert_eq!(rig.row(&["Handled", "Runs"]), [0, 0]);
    assert_eq!((rig.status().executed, rig.status().cleared_faults), (1, 0));
    assert_eq!(rig.record()[..3], [7, 0, (20 << 16) | 4]);
    // The same fault in a scan is handled.
    assert_eq!(rig.scan(17), ScanEnd::Completed);
    assert_eq!((rig.row(&["Handled", "Runs"]), rig.status().cleared_faults), (vec![1, 1], 1));
}

/// REQ-EXEC-024.
#[test]
fn prescan_when_programs_have_fault_records_then_it_clears_them_at_its_start() {
    let mut rig = rungs(&["List : DINT[2]", "At : DINT := 2", "N : DINT"], &["MOV(List[At],N)"]);
    rig.prescan(0);
    assert_eq!(fault_code(rig.scan(0)), Some(20));
    assert_ne!(rig.record(), [0; 11]);
    assert_eq!(rig.prescan(10), ScanEnd::Completed);
    assert_eq!(rig.record(), [0; 11]);
}
