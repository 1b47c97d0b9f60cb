//! The signature of the path of control. REQ-SCAN-010.

mod support;

use support::{Rig, fault_code, project, rungs, tags};
use twinrung_bytecode::channel::{Channel, ScanEnd};

const BEGINS: u32 = 1;
const JUMPS: u32 = 2;
const ENDS: u32 = 3;
const RETURNS: u32 = 4;
const FAULTS: u32 = 5;

/// The signature of events and their numbers, in wide arithmetic.
fn signature(events: &[(u32, u32)]) -> u32 {
    events.iter().fold(0u64, |before, (event, number)| {
        let turned = before * 32 % (1 << 32) + before / (1 << 27);
        let taken = u64::from(*event) * (1 << 28) + u64::from(*number) % (1 << 28);
        (turned ^ taken) * 0x9E37_79B1 % (1 << 32)
    }) as u32
}

/// The index of a routine, of which no other has the name.
fn index(rig: &Rig, name: &str) -> u32 {
    let is = |routine: &twinrung_bytecode::image::RoutineRecord| routine.name.eq_ignore_ascii_case(name);
    rig.admitted.image().routines.iter().position(is).unwrap() as u32
}

/// The path of a scan, the same whether an observer looks on or not.
fn follows(rig: &mut Rig, events: &[(u32, u32)]) -> ScanEnd {
    let before = rig.partner.clone();
    rig.watched = true;
    let watched_end = rig.scan(0);
    assert_eq!(rig.partner.path_signature(), signature(events));
    rig.watched = false;
    rig.partner = before;
    let end = rig.scan(0);
    assert_eq!(rig.partner.path_signature(), signature(events));
    assert_eq!(watched_end, end);
    end
}

fn prescan_follows(rig: &mut Rig, events: &[(u32, u32)]) -> ScanEnd {
    let end = rig.prescan(0);
    assert_eq!(rig.partner.path_signature(), signature(events));
    end
}

#[test]
fn path_when_a_program_is_one_routine_then_it_begins_and_ends_behind_its_last_rung() {
    let mut rig = rungs(&["A : BOOL", "B : BOOL"], &["XIC(A)OTE(B)", "XIC(B)OTE(A)"]);
    assert_eq!(rig.partner.path_signature(), 0);
    prescan_follows(&mut rig, &[(BEGINS, 0), (ENDS, 2)]);
    follows(&mut rig, &[(BEGINS, 0), (ENDS, 2)]);
    // 1000_0000 x 9E37_79B1 = 1000_0000; turned by 5 to 2, xor 3000_0002 gives 3000_0000, and that times the factor 3000_0000.
    assert_eq!(rig.partner.path_signature(), 0x3000_0000);
    rig.partner.reset();
    assert_eq!(rig.partner.path_signature(), 0);
}

/// A program whose main routine calls `Sub`, which returns from its second rung while `Early` is set.
const CALLING: &str = ")
ROUTINE Main
N: XIC(Call)JSR(Sub,0);
N: OTE(Ran);
END_ROUTINE
ROUTINE Sub
N: NOP();
N: XIC(Early)RET();
N: NOP();
END_ROUTINE";

#[test]
fn path_when_jsr_calls_then_the_routine_begins_and_ends_within_the_path_of_its_caller() {
    let mut rig = Rig::new(&project("", &tags(&["Call : BOOL", "Early : BOOL", "Ran : BOOL"]), CALLING));
    let (main, sub) = (index(&rig, "Main"), index(&rig, "Sub"));
    // Prescan visits what JSR names; nothing returns.
    prescan_follows(&mut rig, &[(BEGINS, main), (BEGINS, sub), (ENDS, 3), (ENDS, 2)]);
    follows(&mut rig, &[(BEGINS, main), (ENDS, 2)]);
    rig.set("Call", 1);
    follows(&mut rig, &[(BEGINS, main), (BEGINS, sub), (ENDS, 3), (ENDS, 2)]);
    rig.set("Early", 1);
    follows(&mut rig, &[(BEGINS, main), (BEGINS, sub), (RETURNS, 1), (ENDS, 2)]);
}

#[test]
fn path_when_tnd_is_true_then_the_routine_ends_on_its_rung() {
    let program = ")\nROUTINE Main\nN: JSR(Sub,0);\nN: XIC(Stop)TND();\nN: NOP();\nEND_ROUTINE\n\
                   ROUTINE Sub\nN: XIC(Stop)TND();\nEND_ROUTINE";
    let mut rig = Rig::new(&project("", &tags(&["Stop : BOOL"]), program));
    let (main, sub) = (index(&rig, "Main"), index(&rig, "Sub"));
    follows(&mut rig, &[(BEGINS, main), (BEGINS, sub), (ENDS, 1), (ENDS, 3)]);
    rig.set("Stop", 1);
    follows(&mut rig, &[(BEGINS, main), (BEGINS, sub), (RETURNS, 0), (RETURNS, 1)]);
    prescan_follows(&mut rig, &[(BEGINS, main), (BEGINS, sub), (ENDS, 1), (ENDS, 3)]);
}

#[test]
fn path_when_a_jmp_is_taken_then_the_rung_of_its_label_is_on_it() {
    let mut rig = rungs(&["Go : BOOL", "A : BOOL"], &["XIC(Go)JMP(Over)", "OTE(A)", "NOP()", "LBL(Over)NOP()"]);
    prescan_follows(&mut rig, &[(BEGINS, 0), (ENDS, 4)]);
    follows(&mut rig, &[(BEGINS, 0), (ENDS, 4)]);
    rig.set("Go", 1);
    follows(&mut rig, &[(BEGINS, 0), (JUMPS, 3), (ENDS, 4)]);
}

#[test]
fn path_when_a_loop_jumps_back_then_each_round_is_on_it() {
    let mut rig = rungs(&["N : DINT"], &["CLR(N)", "LBL(Again)ADD(N,1,N)", "LES(N,4)JMP(Again)"]);
    follows(&mut rig, &[(BEGINS, 0), (JUMPS, 1), (JUMPS, 1), (JUMPS, 1), (ENDS, 3)]);
}

#[test]
fn path_when_a_jmp_may_not_be_taken_again_then_its_fault_is_on_it() {
    let mut rig = rungs(&["A : BOOL"], &["LBL(Again)NOP()", "JMP(Again)"]);
    let mut events = vec![(BEGINS, 0)];
    events.extend([(JUMPS, 0); 1000]);
    events.push((FAULTS, 94));
    assert_eq!(fault_code(follows(&mut rig, &events)), Some(94));
}

/// An Add-On Instruction with a routine of each kind.
const THREE: &str =
    "ADD_ON_INSTRUCTION_DEFINITION Three (Class := Safety, Revision := \"1.0\", ExecutePrescan := Yes, ExecuteEnableInFalse := Yes)
PARAMETERS
Given : DINT (Usage := Input, Required := Yes, Visible := Yes);
END_PARAMETERS
LOCAL_TAGS
Sum : DINT;
END_LOCAL_TAGS
ROUTINE Logic
N: GRT(Given,9)RET();
N: ADD(Sum,Given,Sum);
END_ROUTINE
ROUTINE Prescan
N: CLR(Sum);
N: GRT(Given,9)TND();
N: NOP();
END_ROUTINE
ROUTINE EnableInFalse
N: NOP();
END_ROUTINE
END_ADD_ON_INSTRUCTION_DEFINITION";

#[test]
fn path_when_an_add_on_instruction_of_the_user_is_called_then_each_of_its_routines_is_on_it() {
    let program = ")\nROUTINE Main\nN: XIC(Go)Three(I,Given);\nEND_ROUTINE";
    let mut rig = Rig::new(&project(THREE, &tags(&["I : Three", "Go : BOOL", "Given : DINT"]), program));
    let [main, logic, prescan, false_in] = ["Main", "Logic", "Prescan", "EnableInFalse"].map(|name| index(&rig, name));
    // Logic is prescanned, then Prescan runs.
    let visited = [(BEGINS, main), (BEGINS, logic), (ENDS, 2), (BEGINS, prescan)];
    prescan_follows(&mut rig, &[visited.as_slice(), &[(ENDS, 3), (ENDS, 1)]].concat());
    follows(&mut rig, &[(BEGINS, main), (BEGINS, false_in), (ENDS, 1), (ENDS, 1)]);
    rig.set("Go", 1);
    follows(&mut rig, &[(BEGINS, main), (BEGINS, logic), (ENDS, 2), (ENDS, 1)]);
    rig.set("Given", 10);
    follows(&mut rig, &[(BEGINS, main), (BEGINS, logic), (RETURNS, 0), (ENDS, 1)]);
    prescan_follows(&mut rig, &[visited.as_slice(), &[(RETURNS, 1), (ENDS, 1)]].concat());
}

#[test]
fn path_when_an_add_on_instruction_has_logic_alone_then_a_false_call_is_not_on_it() {
    let plain = THREE.replace(", ExecutePrescan := Yes, ExecuteEnableInFalse := Yes", "");
    let plain = format!("{}END_ADD_ON_INSTRUCTION_DEFINITION", &plain[..plain.find("ROUTINE Prescan").unwrap()]);
    let program = ")\nROUTINE Main\nN: XIC(Go)Three(I,Given);\nEND_ROUTINE";
    let mut rig = Rig::new(&project(&plain, &tags(&["I : Three", "Go : BOOL", "Given : DINT"]), program));
    let (main, logic) = (index(&rig, "Main"), index(&rig, "Logic"));
    prescan_follows(&mut rig, &[(BEGINS, main), (BEGINS, logic), (ENDS, 2), (ENDS, 1)]);
    follows(&mut rig, &[(BEGINS, main), (ENDS, 1)]);
}

#[test]
fn path_when_a_safety_application_instruction_runs_then_its_ladder_is_not_on_it() {
    let text = "DCS(Stop,E-STOP,EQUIVALENT - ACTIVE HIGH,100,AUTOMATIC,AUTOMATIC,A,B,Valid,Reset)";
    let mut rig =
        rungs(&["A : BOOL", "B : BOOL", "Valid : BOOL", "Reset : BOOL", "Stop : DCI_STOP"], &["XIC(A)NOP()", text]);
    prescan_follows(&mut rig, &[(BEGINS, 0), (ENDS, 2)]);
    follows(&mut rig, &[(BEGINS, 0), (ENDS, 2)]);
}

/// A program that faults while `At` is out of range; its fault routine clears the record unless `Keep` is set.
const FAULTING: &str = ", FAULT := \"Handler\")
ROUTINE Main
N: NOP();
N: MOV(List[At],N)JSR(Sub,0);
N: JSR(Sub,0);
END_ROUTINE
ROUTINE Sub
N: NOP();
END_ROUTINE
ROUTINE Handler
N: XIC(Keep)RET();
N: SSV(PROGRAM,THIS,MajorFaultRecord,Zero[0]);
END_ROUTINE";

#[test]
fn path_when_a_major_fault_is_raised_then_its_code_and_the_fault_routine_are_on_it() {
    let tag_list = tags(&["List : DINT[2]", "At : DINT", "N : DINT", "Keep : BOOL", "Zero : DINT[11]"]);
    let mut rig = Rig::new(&project("", &tag_list, FAULTING));
    let (main, sub, handler) = (index(&rig, "Main"), index(&rig, "Sub"), index(&rig, "Handler"));
    let (called, whole) = ([(BEGINS, sub), (ENDS, 1)], [(BEGINS, main), (BEGINS, sub), (ENDS, 1), (ENDS, 3)]);
    prescan_follows(&mut rig, &[whole.as_slice(), &[(BEGINS, handler), (ENDS, 2)]].concat());
    follows(&mut rig, &[[(BEGINS, main)].as_slice(), &called, &called, &[(ENDS, 3)]].concat());
    rig.set("At", 2);
    let raised = [(BEGINS, main), (FAULTS, 20), (BEGINS, handler)];
    assert_eq!(
        follows(&mut rig, &[raised.as_slice(), &[(ENDS, 2)], &called, &[(ENDS, 3)]].concat()),
        ScanEnd::Completed
    );
    rig.set("Keep", 1);
    assert_eq!(fault_code(follows(&mut rig, &[raised.as_slice(), &[(RETURNS, 0)]].concat())), Some(20));
}

#[test]
fn path_when_a_fault_ends_the_scan_then_no_routine_ends_on_it() {
    let mut rig = rungs(&["List : DINT[2]", "At : DINT := 2", "N : DINT"], &["NOP()", "MOV(List[At],N)"]);
    assert_eq!(fault_code(follows(&mut rig, &[(BEGINS, 0), (FAULTS, 20)])), Some(20));
}

#[test]
fn path_when_programs_follow_each_other_then_it_leads_through_all() {
    let text = project("", &tags(&["A : BOOL"]), ")\nROUTINE Main\nN: OTE(A);\nEND_ROUTINE")
        .replace("TASK Safety_Task", "PROGRAM Second (Class := Safety, MAIN := \"Other\")\nROUTINE Other\nN: NOP();\nN: NOP();\nEND_ROUTINE\nEND_PROGRAM\nTASK Safety_Task")
        .replace("Main_Program;\n", "Main_Program;\nSecond;\n");
    let mut rig = Rig::new(&text);
    let (main, other) = (index(&rig, "Main"), index(&rig, "Other"));
    let both = [(BEGINS, main), (ENDS, 1), (BEGINS, other), (ENDS, 2)];
    prescan_follows(&mut rig, &both);
    follows(&mut rig, &both);
}
