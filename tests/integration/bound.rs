//! The static bound: what it counts, and that no scan of any random program executes more.

use twinrung_bytecode::bound;
use twinrung_trio::generate::{self, Size};
use twinrung_trio::{Subject, Trio};

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
    let rungs = "N: LBL(again)NOP();\nN: XIO(A)JMP(again);\nN: NOP();";
    let subject = subject(BITS, rungs);
    assert_eq!(instructions(&subject), 5 + 1000 * 4);
    assert_eq!(executed(&subject, 3), 4 * 1001);
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

/// REQ-BOUND-007
#[test]
fn bound_when_it_exceeds_the_budget_then_the_check_refuses_the_image() {
    let within = subject(FILE, "N: FAL(C,5,0,ALL,X[C.POS],S + 1);");
    assert_eq!(bound::check(&within.image), Ok(6));
    let beyond = subject(FILE, "N: MOV(S,C.LEN);\nN: FAL(C,5,0,ALL,X[C.POS],S + 1);");
    assert_eq!(bound::budget(&beyond.image), Some(100_000));
    assert_eq!(bound::check(&beyond.image).unwrap_err().bound, 2 + (1 << 20));
}

/// Programs that the property looks at, and scans of each.
const PROGRAMS: u64 = 150;
const SCANS: usize = 40;

/// The greatest share of its bound that a scan of a random program executed; `None` where the compiler refuses it.
fn greatest_share(seed: u64) -> Option<f64> {
    let generated = generate::program(seed, Size::SMALL);
    let stimulus = generate::stimulus(seed, &generated, SCANS);
    let subject = Subject::from_text(&generated.text).ok()?;
    let bound = instructions(&subject);
    let mut trio = Trio::new(&subject);
    trio.budget = stimulus.budget;
    let mut most = 0;
    for step in &stimulus.steps {
        step.values.iter().for_each(|(name, value)| trio.set(name, *value));
        let before = trio.executed();
        let ended = if step.prescan { trio.prescan(step.now_ms) } else { trio.scan(step.now_ms) };
        most = most.max(if step.prescan { 0 } else { trio.executed() - before });
        // That the evaluators agree other tests show.
        if ended.is_err() {
            break;
        }
    }
    assert!(
        most <= bound,
        "seed {seed}: a scan executed {most} instructions, the bound is {bound}\n{}",
        generated.text
    );
    Some(most as f64 / bound as f64)
}

/// REQ-BOUND-001
#[test]
fn bound_when_random_programs_run_then_no_scan_executes_more() {
    let shares: Vec<f64> = (0..PROGRAMS).filter_map(|seed| greatest_share(20_000 + seed)).collect();
    let reached = shares.iter().filter(|share| **share == 1.0).count();
    println!("{} programs; in {reached} of them a scan executed exactly the bound", shares.len());
    assert!(shares.len() as u64 > PROGRAMS / 2, "the compiler refuses most of the programs");
}
