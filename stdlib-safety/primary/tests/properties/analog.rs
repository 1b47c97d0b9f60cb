//! `muting-and-outputs.md` 8.3 and 8.4.

use crate::play::{Row, Scans, always, implies};

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
