//! FAL and FSC where they differ from each other, and where a run would never end. REQ-EXEC-070 to 072.

mod support;

use support::{Rig, fault_code, rungs};
use twinrung_bytecode::channel::ScanEnd;
use twinrung_bytecode::limits;

/// A FAL in this mode on a CONTROL whose FD is 1.
fn fal_with_found(mode: &str) -> Rig {
    let tag_list = ["K : CONTROL := [0,4,1]", "Go : BOOL", "A : DINT[8]"];
    let mut rig = rungs(&tag_list, &[&format!("XIC(Go)FAL(K,?,?,{mode},A[K.POS],K.POS+1)")]);
    rig.prescan(0);
    rig.set("K.FD", 1);
    rig.set("Go", 1);
    rig
}

#[test]
fn fal_when_found_is_set_then_a_start_neither_looks_at_it_nor_changes_it() {
    let watched = ["K.POS", "K.FD", "K.DN", "A[0]", "A[1]", "A[2]", "A[3]"];
    let rows = [("ALL", [4, 1, 1, 1, 2, 3, 4]), ("INC", [2, 1, 0, 0, 2, 0, 0]), ("3", [3, 1, 0, 1, 2, 3, 0])];
    for (mode, expected) in rows {
        let mut rig = fal_with_found(mode);
        assert_eq!(rig.scan(0), ScanEnd::Completed);
        assert_eq!(rig.row(&watched), expected, "{mode}");
    }
}

#[test]
fn fal_when_found_is_set_in_numeric_mode_then_it_goes_on_from_its_position() {
    let mut rig = fal_with_found("1");
    for scan in 0..4 {
        assert_eq!(rig.scan(scan * 10), ScanEnd::Completed);
    }
    assert_eq!(rig.row(&["K.POS", "K.FD", "K.DN", "A[0]", "A[1]", "A[2]", "A[3]"]), [4, 1, 1, 1, 2, 3, 4]);
}

#[test]
fn fsc_when_found_is_set_then_numeric_mode_goes_on_behind_it_and_a_start_clears_it() {
    let tag_list = ["K : CONTROL := [0,4,0]", "A : DINT[8] := [0,7,0,0,0,0,0,0]"];
    let mut rig = rungs(&tag_list, &["FSC(K,?,?,4,A[K.POS]=7)"]);
    rig.prescan(0);
    rig.set("K.FD", 1);
    rig.scan(0);
    assert_eq!(rig.row(&["K.POS", "K.FD", "K.IN"]), [1, 1, 1]);
    rig.set("K.IN", 0);
    rig.scan(10);
    assert_eq!(rig.row(&["K.POS", "K.FD", "K.DN"]), [4, 0, 1]);
}

/// REQ-EXEC-072.
#[test]
fn fal_when_its_destination_is_its_own_position_then_the_run_ends_with_a_fault_after_the_most_elements() {
    let mut rig = rungs(&["K : CONTROL := [0,2,0]", "N : DINT"], &["FAL(K,?,?,ALL,K.POS,0)", "ADD(N,1,N)"]);
    rig.prescan(0);
    let before = rig.status().executed;
    assert_eq!(fault_code(rig.scan(0)), Some(20));
    assert_eq!(rig.status().executed - before, 1 + u64::from(limits::ARRAY_ELEMENTS));
    assert_eq!(rig.row(&["K.EN", "K.DN", "K.POS", "N"]), [1, 0, 1, 0]);
}

#[test]
fn fal_when_exactly_the_most_elements_are_processed_then_the_run_completes() {
    let tag_list = [format!("K : CONTROL := [0,{},0]", limits::ARRAY_ELEMENTS), "N : DINT".to_owned()];
    let mut rig = rungs(&[&tag_list[0], &tag_list[1]], &["FAL(K,?,?,ALL,N,K.POS)"]);
    rig.prescan(0);
    assert_eq!(rig.scan(0), ScanEnd::Completed);
    assert_eq!(rig.row(&["K.DN", "N"]), [1, limits::ARRAY_ELEMENTS as i32 - 1]);
}

#[test]
fn fal_when_its_own_length_grows_then_the_run_ends_with_a_fault_in_numeric_mode_too() {
    let mut rig = rungs(&["K : CONTROL := [0,2,0]"], &["FAL(K,?,?,2000000,K.LEN,K.POS+2)"]);
    rig.prescan(0);
    assert_eq!(fault_code(rig.scan(0)), Some(20));
    assert_eq!(rig.get("K.POS"), limits::ARRAY_ELEMENTS as i32);
}

#[test]
fn fal_when_its_position_is_at_the_greatest_dint_then_the_next_is_the_least() {
    let mut rig = rungs(&["K : CONTROL := [0,2,0]", "P : DINT := 2147483647"], &["FAL(K,?,?,INC,K.POS,P)"]);
    rig.prescan(0);
    assert_eq!(rig.scan(0), ScanEnd::Completed);
    assert_eq!(rig.row(&["K.POS", "K.DN"]), [i32::MIN, 0]);
}

/// Runs a numeric FAL on K to its end with a false rung, and clears DN; where Other is set another FAL on K runs.
fn completed_on_a_false_rung(mode: &str) -> Rig {
    let tag_list = ["K : CONTROL := [0,2,0]", "Go : BOOL", "Other : BOOL", "A : DINT[8]"];
    let other = format!("FAL(K,?,?,{mode},A[0],1)");
    let body = ["XIC(Go)FAL(K,?,?,1,A[K.POS],1)", "XIO(Other)JMP(End)", &other, "LBL(End)NOP()"];
    let mut rig = rungs(&tag_list, &body);
    rig.prescan(0);
    rig.set("Go", 1);
    rig.scan(0);
    rig.set("Go", 0);
    rig.scan(10);
    assert_eq!(rig.row(&["K.EN", "K.DN", "K.POS"]), [1, 1, 2]);
    rig.set("Go", 1);
    rig.set("K.DN", 0);
    rig
}

/// REQ-EXEC-071.
#[test]
fn fal_when_its_run_is_completed_again_on_a_true_rung_then_it_forgets_the_false_one() {
    let mut rig = completed_on_a_false_rung("ALL");
    for scan in 2..5 {
        rig.scan(scan * 10);
        assert_eq!(rig.row(&["K.EN", "K.DN", "K.POS"]), [1, 1, 2]);
    }
}

#[test]
fn fal_when_all_mode_completes_a_run_on_the_same_control_then_the_false_rung_is_forgotten_too() {
    for mode in ["ALL", "INC"] {
        let mut rig = completed_on_a_false_rung(mode);
        rig.set("Go", 0);
        rig.set("Other", 1);
        rig.set("K.EN", 0);
        rig.set("K.POS", 1);
        rig.scan(20);
        assert_eq!(rig.row(&["K.EN", "K.DN", "K.POS"]), [1, 1, 2], "{mode}");
        rig.set("Go", 1);
        rig.scan(30);
        assert_eq!(rig.row(&["K.EN", "K.DN", "K.POS"]), [1, 1, 2], "{mode}");
    }
}

#[test]
fn fal_when_an_execution_on_a_true_rung_completes_nothing_then_the_false_rung_is_remembered() {
    let mut rig = completed_on_a_false_rung("ALL");
    rig.set("K.POS", 0);
    rig.scan(20);
    assert_eq!(rig.row(&["K.EN", "K.DN", "K.POS"]), [1, 0, 1]);
    rig.set("K.DN", 1);
    rig.scan(30);
    assert_eq!(rig.row(&["K.EN", "K.DN", "K.POS"]), [0, 0, 0]);
}

#[test]
fn fal_when_numeric_mode_clears_or_starts_then_the_false_rung_is_forgotten() {
    for (enabled, after) in [(1, [0, 0, 0]), (0, [1, 0, 1])] {
        let mut rig = completed_on_a_false_rung("ALL");
        rig.set("K.EN", enabled);
        rig.set("K.DN", enabled);
        rig.scan(20);
        assert_eq!(rig.row(&["K.EN", "K.DN", "K.POS"]), after);
        rig.set("K.EN", 1);
        rig.set("K.DN", 1);
        rig.scan(30);
        assert_eq!(rig.row(&["K.EN", "K.DN"]), [1, 1]);
    }
}

#[test]
fn fal_when_another_mode_starts_a_run_and_does_not_complete_it_then_the_false_rung_is_remembered() {
    for (mode, length, fault) in [("INC", 2, None), ("ALL", -1, Some(21))] {
        let mut rig = completed_on_a_false_rung(mode);
        rig.set("Go", 0);
        rig.set("Other", 1);
        rig.set("K.EN", 0);
        rig.set("K.POS", 0);
        rig.set("K.LEN", length);
        assert_eq!(fault_code(rig.scan(20)), fault, "{mode}");
        assert_eq!(rig.row(&["K.EN", "K.DN"]), [1, 0], "{mode}");
        rig.set("Go", 1);
        rig.set("Other", 0);
        rig.set("K.DN", 1);
        rig.scan(30);
        assert_eq!(rig.row(&["K.EN", "K.DN", "K.POS"]), [0, 0, 0], "{mode}");
    }
}
