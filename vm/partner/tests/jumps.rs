//! Backward jumps are counted for each execution of a routine. REQ-EXEC-016.

mod support;

use support::{Rig, fault_code, project, rungs, tags};
use twinrung_bytecode::channel::ScanEnd;
use twinrung_bytecode::limits::BACKWARD_JUMPS;

const MOST: i32 = BACKWARD_JUMPS as i32;

/// Jumps `Rounds` times backward and adds up its jumps.
const LOOP: &str = "N: MOV(0,K);\nN: LBL(Again)NOP();\nN: LES(K,Rounds)ADD(K,1,K)ADD(Sum,1,Sum)JMP(Again);";

const TAGS: &[&str] = &["K : DINT", "Rounds : DINT", "Sum : DINT", "A : DINT[1]", "At : DINT", "Zero : DINT[11]"];

fn rig(declarations: &str, more_tags: &[&str], program: &str, rounds: i32) -> Rig {
    let mut rig = Rig::new(&project(declarations, &tags(&[TAGS, more_tags].concat()), program));
    rig.prescan(0);
    rig.set("Rounds", rounds);
    rig
}

#[test]
fn jmp_when_taken_backward_most_often_then_once_more_is_a_fault_and_the_next_scan_counts_anew() {
    let body = ["LBL(Again)ADD(K,1,K)", "LEQ(K,Rounds)JMP(Again)"];
    let mut rig = rungs(&["K : DINT", "Rounds : DINT"], &body);
    rig.prescan(0);
    rig.set("Rounds", MOST);
    for _ in 0..3 {
        rig.set("K", 0);
        assert_eq!(rig.scan(0), ScanEnd::Completed);
    }
    rig.set("K", 0);
    rig.set("Rounds", MOST + 1);
    assert_eq!(fault_code(rig.scan(0)), Some(94));
    assert_eq!(rig.get("K"), MOST + 1);
}

#[test]
fn jsr_when_its_routine_is_executed_again_in_the_scan_then_its_jumps_count_anew() {
    let program = format!(
        ")\nROUTINE Main\nN: JSR(Sub,0)JSR(Sub,0);\nN: JSR(Sub,0);\nEND_ROUTINE\nROUTINE Sub\n{LOOP}\nEND_ROUTINE"
    );
    for watched in [false, true] {
        let mut fits = Rig { watched, ..rig("", &[], &program, MOST) };
        assert_eq!(fits.scan(0), ScanEnd::Completed);
        assert_eq!(fits.get("Sum"), 3 * MOST);
        let mut one_too_many = Rig { watched, ..rig("", &[], &program, MOST + 1) };
        assert_eq!(fault_code(one_too_many.scan(0)), Some(94));
    }
}

#[test]
fn jmp_when_its_routine_goes_on_behind_a_jsr_then_it_counts_on() {
    let sub = LOOP.replace("Rounds", "3").replace("(K,", "(Inner,").replace(",K)", ",Inner)");
    let main = "N: LBL(Back)JSR(Sub,0);\nN: ADD(K,1,K)LEQ(K,Rounds)JMP(Back);";
    let program = format!(")\nROUTINE Main\n{main}\nEND_ROUTINE\nROUTINE Sub\n{sub}\nEND_ROUTINE");
    let mut fits = rig("", &["Inner : DINT"], &program, MOST);
    assert_eq!(fits.scan(0), ScanEnd::Completed);
    assert_eq!(fits.row(&["K", "Sum"]), [MOST + 1, 3 * (MOST + 1)]);
    let mut one_too_many = rig("", &["Inner : DINT"], &program, MOST + 1);
    assert_eq!(fault_code(one_too_many.scan(0)), Some(94));
}

#[test]
fn add_on_call_when_it_is_reached_again_then_its_jumps_count_anew_also_on_the_same_instance() {
    let logic = LOOP.replace("(Sum,1,Sum)", "(Total,1,Total)");
    let definition = format!(
        "ADD_ON_INSTRUCTION_DEFINITION Looping (Class := Safety, Revision := \"1.0\")\nPARAMETERS\n\
         Rounds : DINT (Usage := Input, Required := Yes, Visible := Yes);\n\
         Total : DINT (Usage := InOut, Required := Yes, Visible := Yes);\nEND_PARAMETERS\n\
         LOCAL_TAGS\nK : DINT;\nEND_LOCAL_TAGS\nROUTINE Logic\n{logic}\nEND_ROUTINE\n\
         END_ADD_ON_INSTRUCTION_DEFINITION"
    );
    let call = "Looping(I,Rounds,Sum)";
    let program =
        format!(")\nROUTINE Main\nN: LBL(Twice){call};\nN: {call};\nN: ADD(At,1,At)LES(At,2)JMP(Twice);\nEND_ROUTINE");
    let mut fits = rig(&definition, &["I : Looping"], &program, MOST);
    assert_eq!(fits.scan(0), ScanEnd::Completed);
    assert_eq!(fits.get("Sum"), 4 * MOST);
    let mut one_too_many = rig(&definition, &["I : Looping"], &program, MOST + 1);
    assert_eq!(fault_code(one_too_many.scan(0)), Some(94));
}

/// The fault routine executes the routine that it interrupted, whose own count goes on behind it.
#[test]
fn jmp_when_the_fault_routine_executes_its_routine_in_between_then_the_interrupted_execution_counts_on() {
    let sub = "N: LBL(Again)NOP();\nN: ADD(Sum,1,Sum)EQU(Sum,At)MOV(A[At],Zero[0]);\n\
               N: LES(Sum,Rounds)JMP(Again);";
    let program = |last: i32| {
        format!(
            ", FAULT := \"Handler\")\nROUTINE Main\nN: JSR(Sub,0);\nEND_ROUTINE\nROUTINE Sub\n{sub}\nEND_ROUTINE\n\
             ROUTINE Handler\nN: MOV(0,Sum)MOV(-1,At)MOV(900,Rounds)JSR(Sub,0);\n\
             N: MOV(0,Sum)MOV({last},Rounds);\nN: SSV(PROGRAM,THIS,MajorFaultRecord,Zero[0]);\nEND_ROUTINE"
        )
    };
    // 599 jumps before the fault; behind it one at `Sum` 0, and one for each further round.
    for (last, expected) in [(401, None), (402, Some(94))] {
        let mut rig = rig("", &[], &program(last), 5000);
        rig.set("At", 600);
        assert_eq!(fault_code(rig.scan(0)), expected, "{last}");
        assert_eq!(rig.status().cleared_faults, 1);
    }
}
