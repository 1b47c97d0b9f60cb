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
