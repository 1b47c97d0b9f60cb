//! `muting-and-outputs.md` 8.3 and 8.4.

use crate::play::{Row, Scans, always, implies};
use proptest::prelude::*;
use twinrung_catalog::Opcode;
use twinrung_safety_primary::State;

const MANUAL: i32 = 0;

fn dint(row: &Row, member: &str) -> i128 {
    i128::from(row.get(member))
}

/// Both channels within the limits and within Tolerance of each other, in exact arithmetic.
fn good(row: &Row) -> bool {
    let (a, b) = (dint(row, "ChannelA"), dint(row, "ChannelB"));
    let (low, high) = (dint(row, "LowLimit"), dint(row, "HighLimit"));
    low <= a && a <= high && low <= b && b <= high && (a - b).abs() <= dint(row, "Tolerance")
}

/// The same for the REAL values of the vocabulary, whose differences an f64 holds exactly.
fn good_real(row: &Row) -> bool {
    let (a, b) = (row.real("ChannelA"), row.real("ChannelB"));
    let (low, high) = (row.real("LowLimit"), row.real("HighLimit"));
    low <= a && a <= high && low <= b && b <= high && (a - b).abs() <= row.real("Tolerance")
}

fn latches(scans: &Scans) -> bool {
    let now = scans.now;
    implies(now.on("O1"), now.rung && now.on("InputStatus") && !now.on("FP"))
        && now.on("FP") == (now.get("FaultCode") != 0)
        && implies(scans.falls("FP"), !now.rung || (scans.edge("Reset") && now.on("InputStatus")))
        && now.get("Revision") == 1
        && implies(now.on("O1"), now.get("O1OnTime") == 50)
        && (0..=50).contains(&now.get("O1OnTime"))
}

always! {
    dca_when_played_then_latches, Dca []: |scans| latches(scans);
    dcaf_when_played_then_latches, Dcaf []: |scans| latches(scans);
    dca_when_o1_is_on_then_channels_are_good, Dca []: |scans| implies(scans.now.on("O1"), good(scans.now));
    dcaf_when_o1_is_on_then_channels_are_good, Dcaf []: |scans| implies(scans.now.on("O1"), good_real(scans.now));
    dca_when_manual_then_o1_rises_with_a_reset_edge, Dca [("RestartType", MANUAL), ("ColdStartType", MANUAL)]:
    |scans| implies(scans.rises("O1"), scans.edge("Reset"));
    dcaf_when_manual_then_o1_rises_with_a_reset_edge, Dcaf [("RestartType", MANUAL), ("ColdStartType", MANUAL)]:
    |scans| implies(scans.rises("O1"), scans.edge("Reset"));
}

/// HTP and LTP tell whether a channel is above or below its limits, on every true rung.
fn trip_points(scans: &Scans, above: bool, below: bool) -> bool {
    implies(scans.now.rung, scans.now.on("HTP") == above && scans.now.on("LTP") == below)
}

always! {
    dca_when_played_then_trip_points_follow_the_channels, Dca []: |scans| {
        let (a, b) = (dint(scans.now, "ChannelA"), dint(scans.now, "ChannelB"));
        let (low, high) = (dint(scans.now, "LowLimit"), dint(scans.now, "HighLimit"));
        trip_points(scans, a > high || b > high, a < low || b < low)
    };
    dcaf_when_played_then_trip_points_follow_the_channels, Dcaf []: |scans| {
        let (a, b) = (scans.now.real("ChannelA"), scans.now.real("ChannelB"));
        let (low, high) = (scans.now.real("LowLimit"), scans.now.real("HighLimit"));
        let finite = a.is_finite() && b.is_finite();
        trip_points(scans, !finite || a > high || b > high, !finite || a < low || b < low)
    };
}

/// `significand * 2^exponent` as the f32 and as the integer that it is.
#[derive(Clone, Copy, Debug)]
struct Exact {
    real: f32,
    whole: i128,
}

fn exact() -> impl Strategy<Value = Exact> {
    let significand = prop_oneof![Just(1), Just(-1), Just(0), -0xFF_FFFFi32..=0xFF_FFFF];
    let exponent = prop_oneof![Just(0), 0u32..=90];
    (significand, exponent).prop_map(|(significand, exponent)| Exact {
        real: significand as f32 * 2f32.powi(exponent.cast_signed()),
        whole: i128::from(significand) << exponent,
    })
}

/// Whether DCAF turns O1 on at once: automatic cold start, no limits that matter.
fn agrees(a: f32, b: f32, tolerance: f32) -> bool {
    let backing = Opcode::Dcaf.instruction().safety.unwrap().backing;
    let mut members = vec![0; backing.members.len()];
    let mut set = |name: &str, value: i32| members[backing.member(name).unwrap().0] = value;
    let bits = |real: f32| real.to_bits().cast_signed();
    set("InputStatus", 1);
    set("ColdStartType", 1);
    set("DiscrepancyTime", 500);
    set("HighLimit", bits(f32::MAX));
    set("LowLimit", bits(f32::MIN));
    set("ChannelA", bits(a));
    set("ChannelB", bits(b));
    set("Tolerance", bits(tolerance));
    let mut state = State::new(Opcode::Dcaf).unwrap();
    state.prescan(&[], &mut members);
    state.scan(true, 0, &[], &mut members);
    members[backing.member("O1").unwrap().0] != 0
}

proptest! {
    /// 8.3: no rounding decides the comparison.
    #[test]
    fn dcaf_when_channels_differ_by_anything_then_tolerance_is_judged_exactly(
        a in exact(), b in exact(), tolerance in exact()
    ) {
        prop_assume!(tolerance.whole >= 0);
        prop_assert_eq!(agrees(a.real, b.real, tolerance.real), (a.whole - b.whole).abs() <= tolerance.whole);
    }

    /// 8.3, where the rounded difference is the tolerance: a greater channel, and one that is lost beside it.
    #[test]
    fn dcaf_when_a_channel_is_lost_in_rounding_then_still_decides(a in exact(), b in -3i32..=3) {
        let small = Exact { real: b as f32, whole: i128::from(b) };
        let tolerance = Exact { real: a.real.abs(), whole: a.whole.abs() };
        let within = (a.whole - small.whole).abs() <= tolerance.whole;
        prop_assert_eq!(agrees(a.real, small.real, tolerance.real), within);
        prop_assert_eq!(agrees(small.real, a.real, tolerance.real), within);
    }
}
