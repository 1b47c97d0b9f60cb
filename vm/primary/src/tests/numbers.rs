//! Compare, move, logic and arithmetic. general-instructions.md 2.2, 2.3, A.4, A.5, A.7, A.9.

use super::rig::Rig;

#[test]
fn limit_test_when_low_is_above_high_then_passes_outside_the_gap() {
    let mut rig = Rig::new("i DINT; a b c BOOL", &["LIM(2,i,4)OTE(a)", "LIM(4,i,2)OTE(b)", "LIM(3,i,3)OTE(c)"]);
    for (value, expected) in [(1, [0, 1, 0]), (2, [1, 1, 0]), (3, [1, 0, 1]), (4, [1, 1, 0])] {
        rig.set("i", value);
        rig.scan();
        assert_eq!(rig.all("a b c"), expected);
    }
}

#[test]
fn comparison_with_nan_when_executed_then_only_unequal_passes() {
    let mut rig = Rig::new(
        "q REAL; a b c d e BOOL",
        &["EQU(q,q)OTE(a)", "NEQ(q,q)OTE(b)", "GEQ(q,1)OTE(c)", "LES(q,1)OTE(d)", "LIM(q,1,0)OTE(e)"],
    );
    rig.set_real("q", f32::NAN);
    rig.scan();
    assert_eq!(rig.all("a b c d e"), [0, 1, 0, 0, 0]);
}

#[test]
fn masked_equal_when_int_is_negative_then_is_zero_filled() {
    let mut rig = Rig::new("n INT; i DINT; a b BOOL", &["MEQ(n,-1,i)OTE(a)", "EQU(n,i)OTE(b)"]);
    rig.set("n", -1);
    rig.set("i", 65535);
    rig.scan();
    assert_eq!(rig.all("a b"), [1, 0]);
}

#[test]
fn move_when_value_does_not_fit_then_keeps_low_bits_and_overflows() {
    let mut rig = Rig::new("n INT; p SINT; i DINT", &["MOV(i,n)", "MOV(i,p)"]);
    rig.set("i", 65665);
    rig.scan();
    assert_eq!(rig.all("n p"), [129, -127]);
    assert_eq!(rig.flags(), [true, false, true, false]);
    assert_eq!(rig.status().minor_faults, 2);
}

#[test]
fn move_from_real_when_stored_then_rounds_half_to_even() {
    let mut rig = Rig::new("q REAL; i DINT; n INT", &["MOV(q,i)MOV(q,n)"]);
    for (value, expected) in [(2.5, 2), (3.5, 4), (-2.5, -2), (-3.5, -4), (1.5, 2), (0.5, 0)] {
        rig.set_real("q", value);
        rig.scan();
        assert_eq!(rig.all("i n"), [expected, expected]);
        assert!(!rig.flags()[0]);
    }
    for (value, dint, int) in [
        (f32::NAN, i32::MIN, 0),
        (f32::INFINITY, i32::MIN, 0),
        (4_294_967_296.0 + 1024.0, 1024, 1024),
        (1.0e20, i32::MIN, 0),
    ] {
        rig.set_real("q", value);
        rig.scan();
        assert_eq!(rig.all("i n"), [dint, int]);
        assert!(rig.flags()[0]);
    }
}

#[test]
fn masked_move_and_logic_when_int_is_negative_then_zero_fill_without_overflow() {
    let mut rig = Rig::new("p SINT; n INT; i j DINT", &["AND(p,-1,i)", "MVM(p,240,n)", "NOT(n,j)", "NOT(n,n)"]);
    rig.set("p", -1);
    rig.set("n", 5);
    rig.scan();
    assert_eq!(rig.all("i j n"), [255, !0xF5, !0xF5]);
    assert!(!rig.flags()[0]);
    assert_eq!(rig.status().minor_faults, 0);
}

#[test]
fn addition_when_it_wraps_then_overflow_and_carry_are_set() {
    let mut rig = Rig::new("i j DINT", &["ADD(i,j,j)"]);
    rig.set("i", i32::MAX);
    rig.set("j", 1);
    rig.scan();
    assert_eq!(rig.get("j"), i32::MIN);
    assert_eq!(rig.flags(), [true, false, true, false]);
    rig.set("i", -1);
    rig.set("j", 1);
    rig.scan();
    assert_eq!(rig.flags(), [false, true, false, true]);
}

#[test]
fn subtraction_when_it_borrows_then_carry_is_set() {
    let mut rig = Rig::new("i DINT", &["SUB(0,1,i)"]);
    rig.scan();
    assert_eq!(rig.flags(), [false, false, true, true]);
}

#[test]
fn division_when_divisor_is_zero_then_dividend_is_kept() {
    let mut rig = Rig::new("i j DINT; q REAL", &["DIV(7,i,i)", "MOD(7,j,j)", "DIV(-7.0,0,q)"]);
    rig.scan();
    assert_eq!(rig.all("i j"), [7, 0]);
    assert_eq!(rig.get_real("q"), f32::NEG_INFINITY);
    assert_eq!(rig.status().minor_faults, 3);
}

#[test]
fn division_when_minimum_by_minus_one_then_wraps() {
    let mut rig = Rig::new("i j k DINT", &["MOD(k,-1,j)", "DIV(k,-1,i)"]);
    rig.set("k", i32::MIN);
    rig.scan();
    assert_eq!(rig.all("i j"), [i32::MIN, 0]);
    assert!(rig.flags()[0]);
    assert_eq!(rig.status().minor_faults, 1);
}

#[test]
fn division_when_destination_is_real_then_is_real() {
    let mut rig = Rig::new("q REAL; i DINT", &["DIV(7,2,q)DIV(7,2,i)"]);
    rig.scan();
    assert_eq!(rig.get_real("q"), 3.5);
    assert_eq!(rig.get("i"), 3);
}

#[test]
fn square_root_when_negative_then_of_the_absolute_value() {
    let mut rig = Rig::new("i DINT; q REAL", &["SQR(-17,i)SQR(-2.25,q)"]);
    rig.scan();
    assert_eq!(rig.get("i"), 4);
    assert_eq!(rig.get_real("q"), 1.5);
}

#[test]
fn nan_when_stored_then_is_canonical() {
    let mut rig = Rig::new("q r REAL; arr REAL[2]; src REAL[2]", &["MOV(q,r)", "COP(src[0],arr[0],2)"]);
    rig.set("q", 0x7F80_0001);
    rig.set("src[1]", -1);
    rig.scan();
    assert_eq!(rig.all("r arr[1]"), [0x7FC0_0000, -1]);
}

#[test]
fn real_arithmetic_when_result_exceeds_the_range_then_overflows() {
    let mut rig = Rig::new("q r REAL", &["MUL(q,q,r)"]);
    rig.set_real("q", 3.0e38);
    rig.scan();
    assert_eq!(rig.get_real("r"), f32::INFINITY);
    assert!(rig.flags()[0]);
    rig.set_real("q", f32::INFINITY);
    rig.scan();
    assert!(!rig.flags()[0]);
}

#[test]
fn expression_when_it_holds_a_real_then_all_arithmetic_is_real_and_logic_is_integer() {
    let mut rig = Rig::new(
        "i j DINT; q REAL; n INT",
        &["CPT(i,7 / 2 + 0 * j)", "CPT(j,7 / 2 * 2.0)", "CPT(q,(2.5 AND 7) + 0.5)", "CPT(n,NOT n + 1)"],
    );
    rig.scan();
    assert_eq!(rig.all("i j"), [3, 7]);
    assert_eq!(rig.get_real("q"), 2.5);
    assert_eq!(rig.get("n"), 0);
}

#[test]
fn compare_expression_when_it_overflows_then_sets_overflow_only() {
    let mut rig = Rig::new("i DINT; a BOOL", &["CMP((i + 1) < 0)OTE(a)", "XIC(S:V)OTL(a)"]);
    rig.set("i", i32::MAX);
    rig.scan();
    assert_eq!(rig.get("a"), 1);
    assert_eq!(rig.flags(), [true, false, false, false]);
    assert_eq!(rig.status().minor_faults, 1);
}

#[test]
fn status_when_several_instructions_affect_it_then_shows_the_last_in_the_text() {
    let mut rig = Rig::new("a BOOL; i j k DINT", &["SUB(0,1,i)", "MOV(5,j)", "XIC(a)ADD(-1,1,k)"]);
    rig.scan();
    assert_eq!(rig.flags(), [false, false, false, false]);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.flags(), [false, true, false, true]);
}

#[test]
fn swap_byte_when_ordered_then_moves_the_bytes() {
    let mut rig =
        Rig::new("i j k l DINT; n m INT", &["SWPB(i,REVERSE,j)SWPB(i,WORD,k)SWPB(i,HIGH/LOW,l)SWPB(n,WORD,m)"]);
    rig.set("i", 0x0102_0304);
    rig.set("n", 0x01F2);
    rig.scan();
    assert_eq!(rig.all("j k l m"), [0x0403_0201, 0x0304_0102, 0x0201_0403, 0xF201u16 as i16 as i32]);
}
