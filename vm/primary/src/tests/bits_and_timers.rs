//! Bit instructions, timers and counters. general-instructions.md A.1 to A.3.

use twinrung_bytecode::channel::ScanEnd;

use super::rig::Rig;

#[test]
fn on_delay_when_first_true_then_adds_no_time() {
    let mut rig = Rig::new("a BOOL; t TIMER", &["XIC(a)TON(t,?,?)"]);
    rig.set("t.PRE", 20);
    rig.prescan();
    rig.scan();
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [1, 1, 0, 0]);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [1, 1, 0, 10]);
    rig.now_ms += 5;
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [1, 0, 1, 25]);
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [0, 0, 0, 0]);
}

#[test]
fn on_delay_when_preset_is_zero_then_done_at_second_true_scan() {
    let mut rig = Rig::new("t TIMER", &["TON(t,?,?)"]);
    rig.prescan();
    rig.scan();
    assert_eq!(rig.all("t.TT t.DN"), [1, 0]);
    rig.scan();
    assert_eq!(rig.all("t.TT t.DN"), [0, 1]);
}

#[test]
fn on_delay_when_done_is_set_and_cleared_by_logic_then_the_pause_is_not_counted() {
    let mut rig = Rig::new("t TIMER", &["TON(t,?,?)"]);
    rig.set("t.PRE", 100);
    rig.prescan();
    rig.scan();
    rig.scan();
    rig.set("t.DN", 1);
    rig.scan();
    rig.scan();
    rig.set("t.DN", 0);
    rig.scan();
    assert_eq!(rig.all("t.TT t.DN t.ACC"), [1, 0, 20]);
}

#[test]
fn off_delay_when_rung_falls_then_times_and_drops() {
    let mut rig = Rig::new("a BOOL; t TIMER", &["XIC(a)TOF(t,?,?)"]);
    rig.set("t.PRE", 10);
    rig.prescan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [0, 0, 0, 10]);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [0, 0, 0, 10]);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [1, 0, 1, 0]);
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [0, 1, 1, 0]);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [0, 0, 0, 10]);
}

#[test]
fn retentive_timer_when_rung_falls_then_keeps_time_and_done() {
    let mut rig = Rig::new("a BOOL; t TIMER", &["XIC(a)RTO(t,?,?)"]);
    rig.set("t.PRE", 20);
    rig.prescan();
    rig.set("a", 1);
    rig.scan();
    rig.scan();
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [0, 0, 0, 10]);
    rig.set("a", 1);
    rig.scan();
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [1, 0, 1, 20]);
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("t.EN t.TT t.DN t.ACC"), [0, 0, 1, 20]);
}

#[test]
fn timer_when_time_runs_over_then_is_done_at_the_end_of_its_range() {
    let mut rig = Rig::new("t TIMER", &["TON(t,?,?)"]);
    rig.set("t.PRE", i32::MAX);
    rig.prescan();
    rig.scan();
    rig.now_ms += 1 << 40;
    rig.scan();
    assert_eq!(rig.all("t.TT t.DN t.ACC"), [0, 1, i32::MAX]);
}

#[test]
fn timer_when_preset_is_negative_then_faults_only_while_it_times() {
    let mut rig = Rig::new("a b BOOL; t u TIMER", &["XIC(a)TON(t,?,?)OTE(b)", "XIC(a)TOF(u,?,?)"]);
    rig.prescan();
    rig.set("t.PRE", -1);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    rig.set("a", 1);
    let ScanEnd::MajorFault(fault) = rig.scan() else { panic!("no fault") };
    assert_eq!((fault.code, fault.place.rung, fault.place.element), (34, 0, 1));
    assert_eq!(rig.all("t.EN t.ACC b"), [0, 0, 0]);
    rig.set("t.PRE", 0);
    rig.set("u.PRE", -5);
    assert_eq!(rig.scan(), ScanEnd::Completed);
    rig.set("a", 0);
    assert!(matches!(rig.scan(), ScanEnd::MajorFault(_)));
}

#[test]
fn one_shots_when_rung_rises_and_falls_then_pulse_once() {
    let mut rig = Rig::new("a s s1 s2 o r f BOOL", &["XIC(a)ONS(s)OTE(o)", "XIC(a)OSR(s1,r)", "XIC(a)OSF(s2,f)"]);
    rig.set("a", 1);
    rig.prescan();
    assert_eq!(rig.all("s s1 s2"), [1, 1, 0]);
    rig.scan();
    assert_eq!(rig.all("o r f"), [0, 0, 0]);
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("o r f"), [0, 0, 1]);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("o r f"), [1, 1, 0]);
    rig.scan();
    assert_eq!(rig.all("o r f"), [0, 0, 0]);
}

#[test]
fn prescan_when_rungs_are_true_then_clears_coils_and_keeps_latches() {
    let mut rig = Rig::new("a b c BOOL", &["OTE(a)OTL(b)OTU(c)"]);
    for name in ["a", "b", "c"] {
        rig.set(name, 1);
    }
    rig.prescan();
    assert_eq!(rig.all("a b c"), [0, 1, 1]);
    rig.scan();
    assert_eq!(rig.all("a b c"), [1, 1, 0]);
}

#[test]
fn branch_when_a_leg_is_empty_then_passes() {
    let mut rig = Rig::new("a b c d BOOL", &["[XIC(a) , ]OTE(b)", "[XIC(a)OTE(c) ,XIO(a)OTE(d) ]"]);
    rig.prescan();
    rig.scan();
    assert_eq!(rig.all("b c d"), [1, 0, 1]);
}

#[test]
fn contact_when_its_bit_is_written_on_the_rung_before_then_sees_it_at_once() {
    let mut rig = Rig::new("a b c BOOL", &["XIC(a)[OTE(a) ,XIO(b)OTL(b) ,XIC(b)OTE(c) ]", "XIO(c)OTE(a)"]);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("a b c"), [0, 1, 1]);
}

#[test]
fn bit_of_sint_when_sign_bit_is_set_then_value_is_negative() {
    let mut rig = Rig::new("p SINT; o BOOL", &["OTL(p.7)", "XIC(p.7)OTE(o)"]);
    rig.scan();
    assert_eq!(rig.all("p o"), [-128, 1]);
}

#[test]
fn counter_when_rung_rises_then_counts_once_and_shows_done() {
    let mut rig = Rig::new("a BOOL; c COUNTER", &["XIC(a)CTU(c,?,?)"]);
    rig.set("c.PRE", 2);
    rig.set("a", 1);
    rig.prescan();
    rig.scan();
    assert_eq!(rig.all("c.CU c.DN c.ACC"), [1, 0, 0]);
    for _ in 0..2 {
        rig.set("a", 0);
        rig.scan();
        rig.set("a", 1);
        rig.scan();
        rig.scan();
    }
    assert_eq!(rig.all("c.CU c.DN c.ACC"), [1, 1, 2]);
    rig.set("c.PRE", 3);
    rig.set("a", 0);
    rig.scan();
    assert_eq!(rig.all("c.CU c.DN c.ACC"), [0, 0, 2]);
}

#[test]
fn counter_when_it_wraps_up_and_back_then_overflow_is_set_and_cleared() {
    let mut rig = Rig::new("a b BOOL; c COUNTER", &["XIC(a)CTU(c,?,?)", "XIC(b)CTD(c,?,?)"]);
    rig.set("c.PRE", 5);
    rig.set("c.ACC", i32::MAX);
    rig.set("a", 1);
    rig.scan();
    assert_eq!(rig.all("c.ACC c.OV c.UN c.DN"), [i32::MIN, 1, 0, 0]);
    rig.set("b", 1);
    rig.scan();
    assert_eq!(rig.all("c.ACC c.OV c.UN c.DN"), [i32::MAX, 0, 0, 1]);
}

#[test]
fn reset_when_true_then_clears_values_and_bits_but_not_presets() {
    let mut rig = Rig::new("t TIMER; c COUNTER; k CONTROL", &["RES(t)RES(c)RES(k)"]);
    for name in ["t.PRE", "t.ACC", "t.EN", "t.TT", "t.DN", "c.PRE", "c.ACC", "c.OV", "c.UN", "k.LEN", "k.POS", "k.FD"] {
        rig.set(name, 1);
    }
    rig.scan();
    assert_eq!(rig.all("t.PRE t.ACC t.EN t.TT t.DN"), [1, 0, 0, 0, 0]);
    assert_eq!(rig.all("c.PRE c.ACC c.OV c.UN k.LEN k.POS k.FD"), [1, 0, 0, 0, 1, 0, 0]);
}
