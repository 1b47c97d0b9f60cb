//! COP, FLL, SIZE, FAL, FSC and subscripts. general-instructions.md 2.6 and A.6.

use super::flow::code;
use super::rig::Rig;

#[test]
fn copy_when_onto_a_timer_then_shows_the_bits_of_its_first_word() {
    let mut rig = Rig::new("raw DINT[3]; t TIMER; back SINT[12]", &["COP(raw[0],t,1)", "COP(t,back[0],12)"]);
    rig.set("raw[0]", 0xC018_B1F3u32 as i32);
    rig.set("raw[1]", 5000);
    rig.set("raw[2]", 500);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.PRE t.ACC"), [1, 1, 0, 5000, 500]);
    assert_eq!(rig.all("back[0] back[3] back[4] back[5]"), [0, -64, -120, 19]);
}

#[test]
fn copy_when_ranges_overlap_then_reads_before_it_writes() {
    let mut rig = Rig::new("arr DINT[4]", &["COP(arr[0],arr[1],3)"]);
    for index in 0..4 {
        rig.set(["arr[0]", "arr[1]", "arr[2]", "arr[3]"][index], index as i32 + 1);
    }
    rig.scan();
    assert_eq!(rig.all("arr[0] arr[1] arr[2] arr[3]"), [1, 1, 2, 3]);
}

#[test]
fn copy_when_a_subscript_leaves_too_few_elements_then_faults() {
    let mut rig = Rig::new("arr out DINT[4]; i DINT", &["COP(arr[i],out[0],2)"]);
    rig.set("arr[3]", 9);
    rig.set("i", 2);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.get("out[1]"), 9);
    rig.set("i", 3);
    assert_eq!(code(rig.scan()), 20);
}

#[test]
fn fill_when_value_does_not_fit_then_low_bits_and_overflow_only() {
    let mut rig = Rig::new("small SINT[4]", &["FLL(300,small[1],2)"]);
    rig.scan();
    assert_eq!(rig.all("small[0] small[1] small[2] small[3]"), [0, 44, 44, 0]);
    assert_eq!(rig.flags(), [true, false, false, false]);
}

#[test]
fn size_when_executed_then_counts_elements() {
    let mut rig = Rig::new("arr DINT[7]; i DINT", &["SIZE(arr[0],0,i)"]);
    rig.scan();
    assert_eq!(rig.get("i"), 7);
}

#[test]
fn subscript_when_out_of_range_then_faults_unless_the_rung_is_false() {
    let mut rig = Rig::new("arr DINT[4]; i DINT; a b BOOL", &["XIC(a)MOV(1,arr[i])", "XIC(b)MOV(1,arr[i+1])"]);
    rig.set("i", 4);
    assert_eq!(code(rig.scan()), 0);
    rig.set("a", 1);
    assert_eq!(code(rig.scan()), 20);
    rig.set("i", -1);
    assert_eq!(code(rig.scan()), 20);
    rig.set("a", 0);
    rig.set("b", 1);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.get("arr[0]"), 1);
}

#[test]
fn coil_when_rung_is_false_then_still_checks_its_subscript() {
    let mut rig = Rig::new("flags BOOL[32]; i DINT; a BOOL", &["XIC(a)OTE(flags[i])"]);
    rig.set("i", 32);
    assert_eq!(code(rig.scan()), 20);
}

#[test]
fn bit_number_when_beyond_its_word_then_faults() {
    let mut rig = Rig::new("n INT; i DINT; a BOOL", &["XIC(n.[i])OTE(a)"]);
    rig.set("n", -32768);
    rig.set("i", 15);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.get("a"), 1);
    rig.set("i", 16);
    assert_eq!(code(rig.scan()), 20);
}

#[test]
fn file_arithmetic_when_all_then_stores_every_element_once() {
    let mut rig = Rig::new("a BOOL; k CONTROL; arr DINT[4]", &["XIC(a)FAL(k,?,?,ALL,arr[k.POS],k.POS * 10)"]);
    rig.set("k.LEN", 4);
    rig.set("k.POS", 2);
    rig.set("a", 1);
    rig.prescan();
    rig.scan();
    assert_eq!(rig.all("arr[0] arr[1] arr[2] arr[3]"), [0, 10, 20, 30]);
    assert_eq!(rig.all("k.EN k.DN k.POS"), [1, 1, 4]);
    assert_eq!(rig.status().executed, 2 + 2 + 4);
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("k.EN k.DN k.POS"), [0, 0, 0]);
}

#[test]
fn file_arithmetic_when_incremental_then_one_element_for_each_edge() {
    let mut rig = Rig::new("a BOOL; k CONTROL; arr DINT[2]", &["XIC(a)FAL(k,?,?,INC,arr[k.POS],7)"]);
    rig.set("k.LEN", 2);
    rig.set("a", 1);
    rig.scan();
    rig.scan();
    assert_eq!(rig.all("arr[0] arr[1] k.POS k.DN"), [7, 0, 1, 0]);
    rig.set("a", 0);
    rig.scan();
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("arr[0] arr[1] k.POS k.DN"), [7, 7, 2, 1]);
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("k.POS k.DN"), [0, 0]);
}

#[test]
fn file_arithmetic_when_numeric_then_goes_on_with_a_false_rung() {
    let mut rig = Rig::new("a BOOL; k CONTROL; arr DINT[5]", &["XIC(a)FAL(k,?,?,2,arr[k.POS],7)"]);
    rig.set("k.LEN", 5);
    rig.set("a", 1);
    rig.scan();
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("arr[3] arr[4] k.EN k.DN k.POS"), [7, 0, 1, 0, 4]);
    rig.scan();
    assert_eq!(rig.all("arr[4] k.EN k.DN k.POS"), [7, 1, 1, 5]);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("k.EN k.DN k.POS"), [0, 0, 0]);
    rig.scan();
    assert_eq!(rig.all("k.EN k.DN k.POS"), [1, 0, 2]);
}

#[test]
fn file_arithmetic_when_it_overflows_then_stops_on_the_element() {
    let mut rig = Rig::new("k CONTROL; arr SINT[3]", &["FAL(k,?,?,ALL,arr[k.POS],k.POS * 100)"]);
    rig.set("k.LEN", 3);
    rig.scan();
    assert_eq!(rig.all("arr[1] arr[2] k.POS k.ER k.DN k.EN"), [100, -56, 2, 1, 0, 1]);
    assert_eq!(rig.status().minor_faults, 1);
}

#[test]
fn file_search_when_hit_then_inhibits_until_the_program_clears_it() {
    let mut rig = Rig::new("k CONTROL; arr DINT[4]", &["FSC(k,?,?,ALL,arr[k.POS] = 5)"]);
    rig.set("k.LEN", 4);
    rig.set("arr[1]", 5);
    rig.set("arr[3]", 5);
    rig.scan();
    assert_eq!(rig.all("k.POS k.FD k.IN k.DN"), [1, 1, 1, 0]);
    rig.scan();
    assert_eq!(rig.get("k.POS"), 1);
    rig.set("k.IN", 0);
    rig.scan();
    assert_eq!(rig.all("k.POS k.FD k.IN k.DN"), [3, 1, 1, 0]);
    rig.set("k.IN", 0);
    rig.scan();
    assert_eq!(rig.all("k.POS k.IN k.DN"), [4, 0, 1]);
}

#[test]
fn file_when_control_is_negative_or_too_long_then_faults() {
    let mut rig = Rig::new("k CONTROL; arr DINT[2]", &["FAL(k,?,?,ALL,arr[k.POS],7)"]);
    rig.set("k.LEN", -1);
    assert_eq!(code(rig.scan()), 21);
    assert_eq!(rig.get("k.EN"), 1, "what the start changed stays changed");
    rig.set("k.EN", 0);
    rig.set("k.LEN", 3);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.all("arr[0] arr[1] k.POS"), [7, 7, 2]);
    rig.set("k.EN", 0);
    rig.set("k.LEN", 1_048_577);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.get("k.POS"), 0, "a run that is too long processes nothing");
}

#[test]
fn file_arithmetic_when_fd_is_set_then_neither_heeds_nor_clears_it() {
    let mut rig = Rig::new(
        "k m n CONTROL; arr DINT[4]",
        &["FAL(k,?,?,ALL,arr[0],1)FAL(m,?,?,INC,arr[m.POS],7)FAL(n,?,?,2,arr[n.POS],8)"],
    );
    for name in ["k.FD", "m.FD", "n.FD"] {
        rig.set(name, 1);
    }
    for name in ["k.LEN", "m.LEN", "n.LEN"] {
        rig.set(name, 4);
    }
    rig.scan();
    assert_eq!(rig.all("k.FD k.POS m.FD m.POS n.FD n.POS"), [1, 4, 1, 1, 1, 2]);
    rig.scan();
    assert_eq!(rig.all("k.FD k.POS m.FD m.POS n.FD n.POS n.DN"), [1, 4, 1, 1, 1, 4, 1]);
}

#[test]
fn file_when_it_would_never_end_then_faults_after_as_many_elements_as_an_array_can_have() {
    let mut rig = Rig::new("k CONTROL", &["FAL(k,?,?,ALL,k.POS,-1)"]);
    rig.set("k.LEN", 1);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.all("k.EN k.DN k.POS"), [1, 0, 0]);
    assert_eq!(rig.status().executed, 1 + 1_048_576);
}

#[test]
fn file_when_it_ends_with_the_last_element_that_an_array_can_have_then_completes() {
    let mut rig = Rig::new("k CONTROL; n DINT", &["FAL(k,?,?,ALL,n,k.POS)"]);
    rig.set("k.LEN", 1_048_576);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("k.DN k.POS n"), [1, 1_048_576, 1_048_575]);
}

#[test]
fn file_arithmetic_when_pos_is_the_greatest_dint_then_it_wraps() {
    let mut rig = Rig::new("k CONTROL", &["FAL(k,?,?,INC,k.POS,2147483647)"]);
    rig.set("k.LEN", 1);
    assert_eq!(code(rig.scan()), 0);
    assert_eq!(rig.all("k.POS k.DN"), [i32::MIN, 0]);
    let mut rig = Rig::new("k CONTROL", &["FAL(k,?,?,ALL,k.POS,2147483647)"]);
    rig.set("k.LEN", 1);
    assert_eq!(code(rig.scan()), 20);
    assert_eq!(rig.all("k.POS k.DN"), [i32::MIN, 0]);
}

#[test]
fn file_search_when_it_passes_a_hit_at_the_greatest_dint_then_pos_wraps() {
    for (mode, enabled) in [("ALL", 1), ("INC", 0), ("2", 1)] {
        let mut rig = Rig::new("k CONTROL; n DINT", &[&alloc::format!("FSC(k,?,?,{mode},n = 5)")]);
        rig.set("k.LEN", 4);
        rig.set("k.POS", i32::MAX);
        rig.set("k.EN", enabled);
        rig.set("k.FD", 1);
        assert_eq!(code(rig.scan()), 21, "{mode}");
        assert_eq!(rig.all("k.POS k.FD k.EN"), [i32::MIN, 0, 1], "{mode}");
    }
}

/// A FAL in mode 2 and, where `other` is set, one in another mode share a CONTROL. The run in mode 2 was completed on a
/// false rung, and then the other FAL was executed on one.
fn completed_on_false(mode: &str) -> Rig {
    let mut rig = Rig::new(
        "a b other BOOL; k CONTROL; arr DINT[3]",
        &[
            "XIC(other)JMP(on)",
            "XIC(a)FAL(k,?,?,2,arr[k.POS],7)",
            "TND()",
            &alloc::format!("LBL(on)XIC(b)FAL(k,?,?,{mode},arr[k.POS],8)"),
        ],
    );
    rig.set("k.LEN", 3);
    rig.set("a", 1);
    rig.scan();
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("k.EN k.DN k.POS"), [1, 1, 3]);
    rig.set("other", 1);
    rig.scan();
    rig
}

#[test]
fn file_arithmetic_when_a_run_in_another_mode_is_completed_on_a_true_rung_then_the_false_one_is_forgotten() {
    for mode in ["ALL", "INC"] {
        let mut rig = completed_on_false(mode);
        assert_eq!(rig.all("k.EN k.DN k.POS"), [0, 0, 0], "{mode}");
        rig.set("k.LEN", 1);
        rig.set("b", 1);
        rig.scan();
        assert_eq!(rig.all("k.EN k.DN k.POS arr[0]"), [1, 1, 1, 8], "{mode}");
        rig.set("other", 0);
        rig.set("a", 1);
        rig.scan();
        assert_eq!(rig.all("k.EN k.DN k.POS"), [1, 1, 1], "{mode}");
        rig.set("a", 0);
        rig.scan();
        assert_eq!(rig.all("k.EN k.DN k.POS"), [0, 0, 0], "{mode}");
    }
}

#[test]
fn file_arithmetic_when_a_run_in_another_mode_is_not_completed_then_the_false_one_is_remembered() {
    let mut rig = completed_on_false("INC");
    rig.set("b", 1);
    rig.scan();
    assert_eq!(rig.all("k.EN k.DN k.POS"), [1, 0, 1]);
    rig.set("other", 0);
    rig.set("a", 1);
    rig.set("k.DN", 1);
    rig.scan();
    assert_eq!(rig.all("k.EN k.DN k.POS"), [0, 0, 0]);
}
