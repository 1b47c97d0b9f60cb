//! The static bound: what it counts, and that no scan and no prescan of any random program executes more.

use twinrung_bytecode::bound::{self, Work};
use twinrung_trio::{Subject, Trio};
use twinrung_workbench::generate::{self, Size};

/// A program with the given tags, routines (the first is the main routine) and, before it, other declarations.
fn subject_of(declarations: &str, tags: &str, routines: &str, fault: &str) -> Subject {
    let text = format!(
        "CONTROLLER Bounds (ProcessorType := \"1756-L73S\", Major := 20)\n{declarations}\nTAG\n{tags}\nEND_TAG\n\
         PROGRAM P (Class := Safety, MAIN := \"Main\"{fault})\n{routines}\nEND_PROGRAM\n\
         TASK Safety (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 1, Priority := 5)\nP;\nEND_TASK\n\
         END_CONTROLLER\n"
    );
    Subject::from_text(&text).unwrap_or_else(|errors| panic!("{errors:#?}\n{text}"))
}

fn subject(tags: &str, rungs: &str) -> Subject {
    subject_of("", tags, &format!("ROUTINE Main\n{rungs}\nEND_ROUTINE"), "")
}

fn instructions(subject: &Subject) -> u64 {
    bound::instructions(&subject.image).total
}

/// Most rungs that a scan, and a prescan, can enter.
fn rungs(subject: &Subject) -> (u64, u64) {
    let bound = bound::bound(&subject.image, &|work| u64::from(work == Work::Rung));
    (bound.total, bound.prescan)
}

/// Instructions of the prescan, and rungs that it enters.
fn prescanned(subject: &Subject) -> (u64, u64) {
    let mut trio = Trio::new(subject);
    trio.count_executions();
    trio.prescan(0).unwrap();
    (trio.executed(), trio.executions().rungs)
}

/// Most instructions in one of `scans` scans.
fn executed(subject: &Subject, scans: i64) -> u64 {
    let mut trio = Trio::new(subject);
    trio.prescan(0).unwrap();
    let mut most = 0;
    for scan in 0..scans {
        let before = trio.executed();
        trio.scan(scan * 10).unwrap();
        most = most.max(trio.executed() - before);
    }
    most
}

const BITS: &str = "A : BOOL (Class := Safety);\nB : BOOL (Class := Safety);\n";

/// REQ-BOUND-002
#[test]
fn bound_when_a_rung_has_branches_then_all_legs_count() {
    let subject = subject(BITS, "N: XIC(A)[XIC(A) ,XIO(B) XIC(A) , ]OTE(B);\nN: NOP();");
    assert_eq!((instructions(&subject), executed(&subject, 3)), (6, 6));
}

/// REQ-BOUND-003
#[test]
fn bound_when_a_jump_leads_back_then_its_loop_counts_a_thousand_times() {
    let text = "N: LBL(again)NOP();\nN: XIO(A)JMP(again);\nN: NOP();";
    let subject = subject(BITS, text);
    assert_eq!(instructions(&subject), 5 + 1000 * 4);
    assert_eq!(executed(&subject, 3), 4 * 1001);
    assert_eq!(rungs(&subject), (3 + 1000 * 2, 3));
}

/// REQ-BOUND-003
#[test]
fn bound_when_a_jump_leads_forward_then_nothing_is_added() {
    let subject = subject(BITS, "N: XIC(A)JMP(on);\nN: NOP();\nN: LBL(on)NOP();");
    assert_eq!(instructions(&subject), 5);
}

/// REQ-BOUND-003, REQ-BOUND-004
#[test]
fn bound_when_a_subroutine_with_a_loop_is_called_in_a_loop_then_its_loop_begins_anew_each_time() {
    let routines = "ROUTINE Main\nN: LBL(outer)JSR(Inner,0);\nN: XIC(A)JMP(outer);\nEND_ROUTINE\n\
                    ROUTINE Inner\nN: LBL(inner)XIC(B)JMP(inner);\nEND_ROUTINE";
    let subject = subject_of("", BITS, routines, "");
    assert_eq!(instructions(&subject), 1001 * 4 + 1001 * (1001 * 3));
}

/// REQ-BOUND-004
#[test]
fn bound_when_routines_are_called_twice_and_a_fault_routine_is_there_then_each_run_counts() {
    let routines = "ROUTINE Main\nN: JSR(Twice,0)JSR(Twice,0);\nN: XIC(A)JSR(Fault,1,990);\nEND_ROUTINE\n\
                    ROUTINE Twice\nN: NOP()NOP();\nEND_ROUTINE\n\
                    ROUTINE Fault\nN: NOP()JSR(Twice,0);\nEND_ROUTINE\n\
                    ROUTINE Never\nN: NOP()JSR(Twice,0);\nEND_ROUTINE";
    let subject = subject_of("", BITS, routines, ", FAULT := \"Fault\"");
    assert_eq!(instructions(&subject), 4 + 3 * 2 + 2);
    let routines = bound::instructions(&subject.image).routines;
    assert_eq!(routines.iter().map(|routine| routine.runs).sum::<u64>(), 1 + 3 + 1);
}

/// REQ-BOUND-004
#[test]
fn bound_when_a_program_is_disabled_then_nothing_of_it_counts() {
    let text = |disabled: &str| {
        format!(
            "CONTROLLER Bounds (ProcessorType := \"1756-L73S\", Major := 20)\n\
             PROGRAM P (Class := Safety, MAIN := \"Main\")\nROUTINE Main\nN: NOP();\nEND_ROUTINE\nEND_PROGRAM\n\
             PROGRAM Q (Class := Safety, MAIN := \"Main\"{disabled})\nROUTINE Main\nN: NOP()NOP();\nEND_ROUTINE\nEND_PROGRAM\n\
             TASK Safety (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 1, Priority := 5)\nP;\nQ;\nEND_TASK\n\
             END_CONTROLLER\n"
        )
    };
    let bound = |disabled| {
        let subject = Subject::from_text(&text(disabled)).unwrap();
        let bound = bound::instructions(&subject.image);
        assert_eq!(executed(&subject, 2), bound.total);
        (bound.total, bound.prescan, bound.programs)
    };
    assert_eq!(bound(""), (3, 3, vec![1, 2]));
    assert_eq!(bound(", DISABLED := Yes"), (1, 1, vec![1, 0]));
}

/// REQ-BOUND-004
#[test]
fn bound_when_a_fault_routine_jumps_back_then_its_loop_counts_once_however_often_it_is_named() {
    let routines = "ROUTINE Main\nN: XIC(A)JSR(Fault,1,990);\nN: XIC(A)JSR(Fault,1,991);\nEND_ROUTINE\n\
                    ROUTINE Fault\nN: LBL(again)XIC(B)JMP(again);\nEND_ROUTINE";
    let subject = subject_of("", BITS, routines, ", FAULT := \"Fault\"");
    assert_eq!(instructions(&subject), 4 + 3 * 1001);
    assert_eq!(bound::instructions(&subject.image).prescan, 4 + 3);
}

/// REQ-BOUND-008
#[test]
fn bound_of_a_prescan_when_subroutines_are_called_in_loops_then_each_is_visited_once() {
    let routines = "ROUTINE Main\nN: LBL(outer)JSR(Inner,0)JSR(Inner,0);\nN: XIC(A)JMP(outer);\nEND_ROUTINE\n\
                    ROUTINE Inner\nN: LBL(inner)XIC(B)JMP(inner);\nEND_ROUTINE\n\
                    ROUTINE Never\nN: NOP();\nEND_ROUTINE";
    let subject = subject_of("", BITS, routines, "");
    assert_eq!(bound::instructions(&subject.image).prescan, 5 + 3);
    assert_eq!(prescanned(&subject), (5 + 3, 3));
    assert_eq!(rungs(&subject).1, 3);
}

/// An Add-On Instruction whose Prescan routine jumps back as long as `Again` is set, and that has a file instruction.
const LOOPS_IN_PRESCAN: &str = "ADD_ON_INSTRUCTION_DEFINITION Loops (Class := Safety, ExecutePrescan := Yes)\nPARAMETERS\n\
     Again : BOOL (Usage := Input, Required := Yes, Visible := Yes);\nEND_PARAMETERS\nLOCAL_TAGS\nHeld : BOOL;\n\
     END_LOCAL_TAGS\nROUTINE Logic\nN: NOP()OTE(Held);\nEND_ROUTINE\nROUTINE Prescan\nN: LBL(back)NOP();\n\
     N: XIC(Again)XIC(Again)JMP(back);\nEND_ROUTINE\nEND_ADD_ON_INSTRUCTION_DEFINITION\n";

/// REQ-BOUND-008
#[test]
fn bound_of_a_prescan_when_a_prescan_routine_loops_then_it_counts_as_it_runs() {
    let tags = format!("{BITS}L : Loops (Class := Safety);\n");
    let subject = subject_of(LOOPS_IN_PRESCAN, &tags, "ROUTINE Main\nN: Loops(L,A);\nEND_ROUTINE", "");
    let bound = bound::instructions(&subject.image);
    assert_eq!((bound.total, bound.prescan), (1 + 2, 1 + 2 + 5 * 1001));
    assert_eq!(prescanned(&subject), (1 + 2 + 5, 1 + 1 + 2));
    assert_eq!(rungs(&subject), (2, 1 + 1 + 2 * 1001));
}

/// REQ-BOUND-007
#[test]
fn bound_when_only_the_prescan_exceeds_the_budget_then_the_check_refuses_the_image() {
    let tags: String = (0..20).map(|at| format!("L{at} : Loops (Class := Safety);\n")).collect();
    let calls: String = (0..20).map(|at| format!("N: Loops(L{at},A);\n")).collect();
    let main = format!("ROUTINE Main\n{calls}END_ROUTINE");
    let subject = subject_of(LOOPS_IN_PRESCAN, &format!("{BITS}{tags}"), &main, "");
    let beyond = bound::check(&subject.image).unwrap_err();
    assert_eq!((beyond.scan, beyond.prescan, beyond.budget), (20 * 3, 20 * (3 + 5005), 100_000));
}

/// REQ-BOUND-005
#[test]
fn bound_when_an_add_on_instruction_is_called_then_the_longer_of_its_routines_counts() {
    let declarations = "ADD_ON_INSTRUCTION_DEFINITION Latch (Class := Safety, ExecuteEnableInFalse := Yes)\nPARAMETERS\n\
         END_PARAMETERS\nLOCAL_TAGS\nHeld : BOOL;\nEND_LOCAL_TAGS\nROUTINE Logic\nN: NOP()NOP()NOP()OTE(Held);\n\
         END_ROUTINE\nROUTINE EnableInFalse\nN: OTU(Held);\nEND_ROUTINE\nEND_ADD_ON_INSTRUCTION_DEFINITION\n";
    let tags = format!("{BITS}L : Latch (Class := Safety);\n");
    let subject = subject_of(declarations, &tags, "ROUTINE Main\nN: XIC(A)Latch(L);\nEND_ROUTINE", "");
    assert_eq!(instructions(&subject), 2 + 4);
    assert_eq!(executed(&subject, 3), 2 + 1);
}

const FILE: &str =
    "C : CONTROL (Class := Safety) := [0,5,0];\nX : DINT[8] (Class := Safety);\nS : DINT (Class := Safety);\n";

/// REQ-BOUND-006
#[test]
fn bound_when_a_file_instruction_has_a_constant_length_then_its_elements_count() {
    let all = subject(FILE, "N: FAL(C,5,0,ALL,X[C.POS],S + 1);");
    assert_eq!((instructions(&all), executed(&all, 1)), (1 + 5, 1 + 5));
    let two = subject(FILE, "N: FAL(C,5,0,2,X[C.POS],S + 1);");
    assert_eq!(instructions(&two), 1 + 2);
    let one = subject(FILE, "N: FSC(C,5,0,INC,S > 1);");
    assert_eq!(instructions(&one), 1 + 1);
}

/// REQ-BOUND-006
#[test]
fn bound_when_the_length_can_change_then_the_greatest_array_counts() {
    let length = subject(FILE, "N: MOV(S,C.LEN);\nN: FAL(C,5,0,ALL,X[C.POS],S + 1);");
    assert_eq!(instructions(&length), 1 + 1 + (1 << 20));
    let itself = subject(FILE, "N: FAL(C,5,0,ALL,C.POS,S + 1);");
    assert_eq!(instructions(&itself), 1 + (1 << 20));
}

/// REQ-BOUND-006
#[test]
fn bound_when_the_mode_takes_more_than_the_length_then_the_length_counts() {
    let some = subject(FILE, "N: FAL(C,5,0,7,X[C.POS],S + 1);");
    assert_eq!((instructions(&some), executed(&some, 1)), (1 + 5, 1 + 5));
}

/// REQ-BOUND-006
#[test]
fn bound_when_only_file_instructions_and_res_write_the_control_then_its_length_is_constant() {
    let subject = subject(FILE, "N: FAL(C,5,0,ALL,X[C.POS],S + 1);\nN: FSC(C,5,0,ALL,X[C.POS] > 1);\nN: RES(C);");
    assert_eq!(instructions(&subject), (1 + 5) + (1 + 5) + 1);
}

/// REQ-BOUND-006
#[test]
fn bound_when_a_variable_subscript_selects_the_control_then_the_greatest_array_counts() {
    let tags = "C : CONTROL[2] (Class := Safety);\nI : DINT (Class := Safety);\nX : DINT[8] (Class := Safety);\n";
    let selected = subject(tags, "N: FSC(C[I],?,?,ALL,X[0] > 1);");
    assert_eq!(instructions(&selected), 1 + (1 << 20));
}

/// REQ-BOUND-006
#[test]
fn bound_when_the_instruction_can_store_into_its_own_control_then_the_greatest_array_counts() {
    let tags = "A : Both_T (Class := Safety);\nS : DINT (Class := Safety);\n";
    let declarations = "DATATYPE Both_T\nDINT X[2];\nCONTROL C;\nEND_DATATYPE\n";
    let routine = |destination: &str| format!("ROUTINE Main\nN: FAL(A.C,5,0,ALL,{destination},S + 1);\nEND_ROUTINE");
    let subject_with = |destination| subject_of(declarations, tags, &routine(destination), "");
    assert_eq!(instructions(&subject_with("A.C.LEN")), 1 + (1 << 20));
    assert_eq!(instructions(&subject_with("A.X[S]")), 1 + 5);
}

/// REQ-BOUND-007
#[test]
fn bound_when_it_exceeds_the_budget_then_the_check_refuses_the_image() {
    let within = subject(FILE, "N: FAL(C,5,0,ALL,X[C.POS],S + 1);");
    assert_eq!(bound::check(&within.image), Ok(()));
    let beyond = subject(FILE, "N: MOV(S,C.LEN);\nN: FAL(C,5,0,ALL,X[C.POS],S + 1);");
    assert_eq!(bound::budget(&beyond.image), Some(100_000));
    assert_eq!(bound::check(&beyond.image).unwrap_err().scan, 2 + (1 << 20));
}

/// Programs that the property looks at, and scans of each.
const PROGRAMS: u64 = 150;
const SCANS: usize = 40;

/// The greatest share of its bound that a scan of a random program executed; `None` where the compiler refuses it.
fn greatest_share(seed: u64) -> Option<f64> {
    let generated = generate::program(seed, Size::SMALL);
    let stimulus = generate::stimulus(seed, &generated, SCANS);
    let subject = Subject::from_text(&generated.text).ok()?;
    let bound = bound::instructions(&subject.image);
    let rungs = rungs(&subject);
    let mut trio = Trio::new(&subject);
    trio.count_executions();
    trio.budget = stimulus.budget;
    let mut most = 0;
    for step in &stimulus.steps {
        step.values.iter().for_each(|(name, value)| trio.set(name, *value));
        let before = (trio.executed(), trio.executions().rungs);
        let ended = if step.prescan { trio.prescan(step.now_ms) } else { trio.scan(step.now_ms) };
        let done = (trio.executed() - before.0, trio.executions().rungs - before.1);
        let at_most = if step.prescan { (bound.prescan, rungs.1) } else { (bound.total, rungs.0) };
        assert!(
            done.0 <= at_most.0 && done.1 <= at_most.1,
            "seed {seed}, prescan {}: {done:?} instructions and rungs, the bound is {at_most:?}\n{}",
            step.prescan,
            generated.text
        );
        most = most.max(if step.prescan { 0 } else { done.0 });
        // That the evaluators agree other tests show.
        if ended.is_err() {
            break;
        }
    }
    Some(most as f64 / bound.total as f64)
}

/// REQ-BOUND-001
#[test]
fn bound_when_random_programs_run_then_no_scan_and_no_prescan_executes_more() {
    let shares: Vec<f64> = (0..PROGRAMS).filter_map(|seed| greatest_share(20_000 + seed)).collect();
    let reached = shares.iter().filter(|share| **share == 1.0).count();
    println!("{} programs; in {reached} of them a scan executed exactly the bound", shares.len());
    assert!(shares.len() as u64 > PROGRAMS / 2, "the compiler refuses most of the programs");
}
