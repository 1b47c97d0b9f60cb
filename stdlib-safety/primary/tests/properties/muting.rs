//! `muting-and-outputs.md` 2.6, invariants of every scan.

use crate::play::{Row, Scans, always, implies};

const MANUAL: i32 = 0;

fn curtain(row: &Row) -> bool {
    !row.on("LightCurtain")
}

/// The invariants of 2.6. A muted scan is one with the lamp on and no override request.
fn holds(scans: &Scans) -> bool {
    let now = scans.now;
    let muted = now.on("ML") && !now.on("Override");
    implies(now.on("ML"), now.on("O1"))
        && implies(now.on("O1") && now.on("FP"), now.on("ML") && now.on("Override"))
        && implies(now.on("O1") && curtain(now), now.on("ML"))
        && implies(muted, now.on("EnableMute") && now.on("MutingLampStatus") && !now.on("FP"))
        && implies(now.on("O1"), now.rung && now.on("InputStatus"))
        && now.on("FP") == (now.get("FaultCode") != 0)
        && implies(scans.falls("FP"), !now.rung || (scans.edge("Reset") && now.on("InputStatus") && !curtain(now)))
}

/// Without an override: how O1 came on with manual restart.
fn starts_by_reset_or_override(scans: &Scans) -> bool {
    implies(scans.rises("O1"), scans.edge("Reset") || scans.edge("Override"))
}

fn both_sensors_blocked(row: &Row) -> bool {
    !row.on("Sensor1") && !row.on("Sensor2")
}

always! {
    tsam_when_played_then_invariants_hold, Tsam []: |scans| holds(scans);
    tssm_when_played_then_invariants_hold, Tssm []: |scans| holds(scans);
    fsbm_when_played_then_invariants_hold, Fsbm []: |scans| holds(scans);

    tsam_when_muted_then_both_sensors_are_blocked, Tsam []: |scans| implies(
        scans.now.on("ML") && !scans.now.on("Override"),
        both_sensors_blocked(scans.now)
    );
    tssm_when_muted_then_both_sensors_are_blocked, Tssm []: |scans| implies(
        scans.now.on("ML") && !scans.now.on("Override"),
        both_sensors_blocked(scans.now)
    );
    tsam_when_manual_then_o1_rises_by_reset_or_override, Tsam [("RestartType", MANUAL)]:
    |scans| starts_by_reset_or_override(scans);
    tssm_when_manual_then_o1_rises_by_reset_or_override, Tssm [("RestartType", MANUAL)]:
    |scans| starts_by_reset_or_override(scans);
    fsbm_when_manual_then_o1_rises_by_reset_or_override, Fsbm [("RestartType", MANUAL)]:
    |scans| starts_by_reset_or_override(scans);

    tsam_when_override_time_is_0_then_lamp_is_on_only_while_muted, Tsam [("MaximumOverrideTime", 0)]:
    |scans| implies(scans.now.on("ML"), both_sensors_blocked(scans.now) && !scans.now.on("FP"));
}

/// Fault: configuration out of range (2.2).
const CONFIGURATION: i32 = 0xF06F;

/// Whether a configuration that is out of range is the one fault from the first scan on.
fn refuses(scans: &Scans) -> bool {
    implies(scans.now.rung, scans.now.get("FaultCode") == CONFIGURATION) && !scans.now.on("O1")
}

fn accepts(scans: &Scans) -> bool {
    scans.now.get("FaultCode") != CONFIGURATION
}

always! {
    tsam_when_a_pair_time_is_4_then_refuses, Tsam [("S1S2Time", 4)]: |scans| refuses(scans);
    tsam_when_a_pair_time_is_above_180000_then_refuses, Tsam [("S2LCTime", 180_001)]: |scans| refuses(scans);
    tsam_when_mute_time_is_above_3600_then_refuses, Tsam [("MaximumMuteTime", 3601)]: |scans| refuses(scans);
    tsam_when_override_time_is_above_30_then_refuses, Tsam [("MaximumOverrideTime", 31)]: |scans| refuses(scans);
    tsam_when_override_time_is_below_0_then_refuses, Tsam [("MaximumOverrideTime", -1)]: |scans| refuses(scans);
    tsam_when_times_are_greatest_then_accepts,
    Tsam [("S1S2Time", 180_000), ("S2LCTime", 180_000), ("MaximumMuteTime", 3600), ("MaximumOverrideTime", 30)]:
    |scans| accepts(scans);
    tsam_when_times_are_least_then_accepts,
    Tsam [("S1S2Time", 5), ("S2LCTime", 0), ("MaximumMuteTime", 0), ("MaximumOverrideTime", 0)]:
    |scans| accepts(scans);
    tssm_when_discrepancy_time_is_4_then_refuses, Tssm [("S1S2DiscrepancyTime", 4)]: |scans| refuses(scans);
    tssm_when_minimum_is_not_below_maximum_then_refuses,
    Tssm [("S1S2LCMinimumTime", 50), ("S1S2LCMaximumTime", 50)]:
    |scans| refuses(scans);
    tssm_when_minimum_is_below_0_then_refuses, Tssm [("S1S2LCMinimumTime", -1)]: |scans| refuses(scans);
    tssm_when_maximum_is_4_then_refuses, Tssm [("S1S2LCMinimumTime", 0), ("S1S2LCMaximumTime", 4)]:
    |scans| refuses(scans);
    tssm_when_there_is_no_maximum_then_accepts_any_minimum,
    Tssm [("S1S2LCMinimumTime", 180_000), ("S1S2LCMaximumTime", 0)]:
    |scans| accepts(scans);
    fsbm_when_first_pair_time_is_4_then_refuses, Fsbm [("S1S2Time", 4)]: |scans| refuses(scans);
    fsbm_when_second_pair_time_is_4_then_refuses, Fsbm [("S2LCTime", 4)]: |scans| refuses(scans);
    fsbm_when_third_pair_time_is_4_then_refuses, Fsbm [("LCS3Time", 4)]: |scans| refuses(scans);
    fsbm_when_fourth_pair_time_is_4_then_refuses, Fsbm [("S3S4Time", 4)]: |scans| refuses(scans);
}
