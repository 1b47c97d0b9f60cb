//! `dual-channel-inputs.md` 12; the numbers are those of its list.

use crate::play::{Row, Scans, always, implies, plays};
use proptest::prelude::*;
use twinrung_catalog::Opcode;

const MANUAL: i32 = 0;
const AUTOMATIC: i32 = 1;

fn channel(row: &Row, name: &str, active: bool) -> bool {
    row.on(name) == active
}

/// Both channels are in their active state, by Input Type.
fn active(row: &Row) -> bool {
    match row.get("InputType") {
        0 => channel(row, "ChannelA", true) && channel(row, "ChannelB", true),
        1 => channel(row, "ChannelA", false) && channel(row, "ChannelB", false),
        _ => channel(row, "ChannelA", true) && channel(row, "ChannelB", false),
    }
}

/// Both channels are in their safe state, by Input Type.
fn safe(row: &Row) -> bool {
    match row.get("InputType") {
        0 => channel(row, "ChannelA", false) && channel(row, "ChannelB", false),
        1 => channel(row, "ChannelA", true) && channel(row, "ChannelB", true),
        _ => channel(row, "ChannelA", false) && channel(row, "ChannelB", true),
    }
}

/// 1, 3, 4: O1 needs a true rung, Input Status and no fault; a fault turns every command off and falls by a Reset edge only.
fn latches(scans: &Scans) -> bool {
    let now = scans.now;
    let commands = ["O1", "TC", "ML", "SS", "SRCA", "SRCB", "BR", "SB"];
    implies(now.on("O1"), now.rung && now.on("InputStatus") && !now.on("FP"))
        && implies(now.on("FP"), !commands.iter().any(|command| now.shows(command)))
        && now.on("FP") == (now.get("FaultCode") != 0)
        && implies(scans.falls("FP"), !now.rung || (scans.edge("Reset") && now.on("InputStatus")))
}

always! {
    dcs_when_played_then_latches, Dcs []: |scans| latches(scans);
    dcst_when_played_then_latches, Dcst []: |scans| latches(scans);
    dcstl_when_played_then_latches, Dcstl []: |scans| latches(scans);
    dcstm_when_played_then_latches, Dcstm []: |scans| latches(scans);
    dcm_when_played_then_latches, Dcm []: |scans| latches(scans);
    dcsrt_when_played_then_latches, Dcsrt []: |scans| latches(scans);
    smat_when_played_then_latches, Smat []: |scans| latches(scans);
    thrse_when_played_then_latches, Thrse []: |scans| latches(scans);

    /// 2
    dcs_when_o1_is_on_then_both_channels_are_active, Dcs []: |scans| implies(scans.now.on("O1"), active(scans.now));
    /// 2
    dcst_when_o1_is_on_then_both_channels_are_active, Dcst []: |scans| implies(scans.now.on("O1"), active(scans.now));
    /// 2 and 9
    dcstl_when_o1_is_on_then_channels_are_active_and_locked, Dcstl []: |scans| implies(
        scans.now.on("O1"),
        active(scans.now) && scans.now.on("LockFeedback") && !scans.now.on("UnlockRequest")
    );
    /// 9
    dcstl_when_unlock_is_commanded_then_hazard_has_stopped_and_o1_is_off, Dcstl []: |scans| implies(
        scans.now.on("ULC"),
        scans.now.on("UnlockRequest")
            && scans.now.on("HazardStopped")
            && scans.now.on("InputStatus")
            && !scans.now.on("O1")
    );
    /// 2 and 10
    dcstm_when_o1_is_on_then_channels_are_active_or_muted, Dcstm []: |scans| implies(
        scans.now.on("O1"),
        (active(scans.now) || scans.now.on("ML")) && scans.now.on("MutingLampStatus")
    );
    /// 10
    dcstm_when_muted_then_mute_and_o1_are_on, Dcstm []: |scans| implies(
        scans.now.on("ML"),
        scans.now.on("Mute") && scans.now.on("O1")
    );
    /// D27
    dcstm_when_field_is_shown_clear_then_both_channels_are_active, Dcstm []: |scans| implies(
        scans.now.on("SS"),
        active(scans.now) && scans.now.on("InputStatus")
    );

    /// 6
    dcs_when_manual_then_o1_rises_with_a_reset_edge,
    Dcs [("RestartType", MANUAL), ("ColdStartType", MANUAL)]:
    |scans| implies(scans.rises("O1"), scans.edge("Reset"));
    /// 6
    dcstm_when_manual_then_o1_rises_with_a_reset_edge,
    Dcstm [("RestartType", MANUAL), ("ColdStartType", MANUAL)]:
    |scans| implies(scans.rises("O1"), scans.edge("Reset"));
    /// 7: nor by a cold start that is not the first scan with Input Status
    dcs_when_cold_start_is_automatic_then_o1_rises_with_a_reset_edge_or_input_status,
    Dcs [("RestartType", MANUAL), ("ColdStartType", AUTOMATIC)]:
    |scans| implies(
        scans.rises("O1"),
        scans.edge("Reset") || !scans.before.rung || !scans.before.on("InputStatus")
    );

    /// 11
    dcm_when_played_then_o1_is_the_active_pair, Dcm []: |scans| {
        let healthy = scans.now.rung && scans.now.on("InputStatus") && !scans.now.on("FP");
        scans.now.on("O1") == (healthy && active(scans.now)) && scans.now.on("IS") == healthy
    };
    /// 12
    dcsrt_when_o1_rises_then_the_pair_was_not_active_before, Dcsrt []: |scans| implies(
        scans.rises("O1"),
        scans.now.on("Enable") && active(scans.now) && !active(scans.before)
    );
    /// 13
    thrse_when_played_then_o1_br_and_sb_exclude_each_other, Thrse []: |scans| {
        ["O1", "BR", "SB"].iter().filter(|output| scans.now.on(output)).count() <= 1
    };
    /// 14
    smat_when_played_then_one_source_is_on_at_most, Smat []: |scans| !(scans.now.on("SRCA") && scans.now.on("SRCB"));
}

/// Whether between two rising edges of `output` there is always a scan in which `seen` holds.
fn always_between(rows: &[Row], output: &str, seen: impl Fn(&Row) -> bool) -> bool {
    let mut owed = false;
    rows.iter().zip(rows.iter().skip(1)).all(|(before, now)| {
        let rises = !before.on(output) && now.on(output);
        let fine = !(rises && owed);
        owed = (owed || rises) && !seen(now);
        fine
    })
}

proptest! {
    /// 12
    #[test]
    fn dcsrt_when_o1_rises_again_then_both_channels_were_released_while_enabled(play in plays(Opcode::Dcsrt, &[])) {
        let rows = play.run();
        prop_assert!(always_between(&rows, "O1", |row| safe(row) && row.on("Enable") && row.rung));
    }

    /// 13
    #[test]
    fn thrse_when_o1_rises_again_then_both_buttons_were_released(play in plays(Opcode::Thrse, &[])) {
        let rows = play.run();
        prop_assert!(always_between(&rows, "O1", |row| row.on("BR")));
    }

    /// 8, where no cold start can turn O1 on at once
    #[test]
    fn dcs_when_restart_is_automatic_then_o1_rises_50_ms_after_the_pair(
        play in plays(Opcode::Dcs, &[("RestartType", AUTOMATIC), ("ColdStartType", MANUAL)])
    ) {
        let rows = play.run();
        let violation = too_early(&rows);
        prop_assert!(violation.is_none(), "{violation:?}");
    }
}

/// The first scan in which O1 rises less than 50 ms after the pair became active.
fn too_early(rows: &[Row]) -> Option<&Row> {
    let mut since_ms = i64::MAX;
    let mut pairs = rows.iter().zip(rows.iter().skip(1));
    pairs.find_map(|(before, now)| {
        let began = active(now) && !(active(before) && before.rung);
        since_ms = if began { now.now_ms } else { since_ms };
        let rises = !before.on("O1") && now.on("O1");
        (rises && now.now_ms.saturating_sub(since_ms) < 50).then_some(now)
    })
}
