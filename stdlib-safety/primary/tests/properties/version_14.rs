//! `v14-and-metal-form.md` 12, the version-14 set; the numbers are those of its list.

use crate::play::{Row, Scans, always, implies, plays};
use proptest::prelude::*;
use twinrung_catalog::Opcode;

/// Reset Type: manual is 1 in this set.
const MANUAL: i32 = 1;

fn both_active(row: &Row) -> bool {
    row.on("ChannelA") && row.on("ChannelB")
}

/// 1: O1 needs both channels in this scan.
fn circuit(scans: &Scans, active: bool) -> bool {
    implies(scans.now.on("O1"), active && !scans.now.on("CI")) && scans.now.on("FP") == scans.now.on("II")
}

fn selects(row: &Row, positions: &[&str]) -> bool {
    let on = positions.iter().filter(|position| row.on(&format!("O{position}")));
    on.clone().count() <= 1 && on.clone().all(|position| row.on(&format!("Input{position}")))
}

always! {
    /// 1
    din_when_o1_is_on_then_both_channels_are_active, Din []: |scans| {
        circuit(scans, scans.now.on("ChannelA") && !scans.now.on("ChannelB"))
    };
    /// 1
    rin_when_o1_is_on_then_both_channels_are_active, Rin []: |scans| circuit(scans, both_active(scans.now));
    /// 1
    enpend_when_o1_is_on_then_both_channels_are_active, Enpend []: |scans| circuit(scans, both_active(scans.now));
    /// 1
    estop_when_o1_is_on_then_both_channels_are_active, Estop []: |scans| circuit(scans, both_active(scans.now));
    /// 1: LCB is 0 when both filtered channels are 1.
    lc_when_o1_is_on_then_curtain_is_clear_or_muted, Lc []: |scans| {
        implies(scans.now.on("O1"), !scans.now.on("LCB") || scans.now.on("LCM"))
            && implies(scans.rises("O1"), !scans.now.on("LCB"))
    };
    /// 2
    din_when_manual_then_o1_rises_with_a_circuit_reset_edge, Din [("ResetType", MANUAL)]:
    |scans| implies(scans.rises("O1"), scans.edge("CircuitReset"));
    /// 2
    estop_when_manual_then_o1_rises_with_a_circuit_reset_edge, Estop [("ResetType", MANUAL)]:
    |scans| implies(scans.rises("O1"), scans.edge("CircuitReset"));
    /// 2
    lc_when_manual_then_o1_rises_with_a_circuit_reset_edge, Lc [("ResetType", MANUAL)]:
    |scans| implies(scans.rises("O1"), scans.edge("CircuitReset"));
    estop_when_fault_clears_then_by_a_fault_reset_edge, Estop []: |scans| implies(
        scans.falls("FP"),
        !scans.now.rung || scans.edge("FaultReset")
    );
    thrs_when_fault_clears_then_by_a_fault_reset_edge, Thrs []: |scans| implies(
        scans.falls("FP"),
        !scans.now.rung || scans.edge("FaultReset")
    );
    /// 4
    fpms_when_an_output_is_on_then_it_is_the_only_one_and_its_input_is_on, Fpms []: |scans| {
        selects(scans.now, &["1", "2", "3", "4", "5"])
            && scans.now.on("FP") == (scans.now.on("NM") || scans.now.on("MMS"))
    };
    thrs_when_buttons_are_shown_pressed_then_both_are, Thrs []: |scans| implies(
        scans.now.on("BP"),
        scans.now.on("RightButtonNormallyOpen")
            && scans.now.on("LeftButtonNormallyOpen")
            && !scans.now.on("RightButtonNormallyClosed")
            && !scans.now.on("LeftButtonNormallyClosed")
    );
}

fn released(row: &Row) -> bool {
    row.rung
        && !row.on("RightButtonNormallyOpen")
        && !row.on("LeftButtonNormallyOpen")
        && row.on("RightButtonNormallyClosed")
        && row.on("LeftButtonNormallyClosed")
}

proptest! {
    /// 5
    #[test]
    fn thrs_when_bp_rises_then_both_buttons_were_released_since_the_last_time(play in plays(Opcode::Thrs, &[])) {
        let rows = play.run();
        let mut free = false;
        for (before, now) in rows.iter().zip(rows.iter().skip(1)) {
            let rises = !before.on("BP") && now.on("BP");
            prop_assert!(implies(rises, free), "{now:?}");
            free = (free && !rises) || released(now);
        }
    }

    /// 10
    #[test]
    fn thrs_when_inputs_are_constant_then_bp_never_comes(play in plays(Opcode::Thrs, &[])) {
        prop_assert!(play.run_with_constant_inputs().iter().all(|row| !row.on("BP")));
    }

    /// 10
    #[test]
    fn estop_when_manual_and_inputs_are_constant_then_o1_never_comes(
        play in plays(Opcode::Estop, &[("ResetType", MANUAL)])
    ) {
        prop_assert!(play.run_with_constant_inputs().iter().all(|row| !row.on("O1")));
    }
}
