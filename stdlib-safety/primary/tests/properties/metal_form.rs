//! `v14-and-metal-form.md` 12, the metal-form set; the numbers are those of its list.

use crate::play::{Row, always, implies, plays};
use proptest::prelude::*;
use twinrung_catalog::Opcode;

const DOWN: i32 = 2;

/// Whether every rise of O1 comes after an edge of `input` since O1 was last on (7).
fn fresh_input(rows: &[Row], input: &str) -> bool {
    let mut fresh = false;
    rows.iter().zip(rows.iter().skip(1)).all(|(before, now)| {
        let edge = before.rung && now.rung && !before.on(input) && now.on(input);
        fresh |= edge;
        let fine = implies(!before.on("O1") && now.on("O1"), fresh);
        fresh &= !now.on("O1");
        fine
    })
}

fn press_stands(row: &Row) -> bool {
    !row.on("O1")
}

always! {
    /// 4
    epms_when_an_output_is_on_then_it_is_the_only_one_and_its_input_is_on, Epms []: |scans| {
        let positions = ["1", "2", "3", "4", "5", "6", "7", "8"];
        let on = positions.iter().filter(|position| scans.now.on(&format!("O{position}")));
        on.clone().count() <= 1 && on.clone().all(|position| scans.now.on(&format!("Input{position}")))
    };
    /// H-EPMS: never a change to another mode while locked.
    epms_when_locked_then_no_output_comes_on, Epms []: |scans| implies(
        scans.now.on("Lock"),
        !["O1", "O2", "O3", "O5", "O8"].iter().any(|output| scans.rises(output))
    );
    /// 6
    cpm_when_played_then_slide_zone_is_the_zone_that_is_on, Cpm []: |scans| {
        let (tz, dz, uz) = (scans.now.get("TZ"), scans.now.get("DZ"), scans.now.get("UZ"));
        tz + dz + uz <= 1 && scans.now.get("SlideZone") == tz + 2 * dz + 4 * uz
    };
    cpm_when_input_status_is_off_then_no_zone_is_shown, Cpm []: |scans| implies(
        !scans.now.on("InputStatus"),
        scans.now.get("SlideZone") == 0
    );
    csm_when_fault_clears_then_nothing_is_requested, Csm []: |scans| implies(
        scans.falls("FP"),
        !scans.now.rung || (scans.edge("Reset") && !scans.now.on("MotionRequest"))
    );
    /// 7
    mvc_when_played_then_both_outputs_are_equal, Mvc []: |scans| scans.now.on("O1") == scans.now.on("O2");
    mvc_when_outputs_are_on_then_actuate_is_on, Mvc []: |scans| implies(
        scans.now.on("O1"),
        scans.now.on("Actuate") && scans.now.on("InputStatus") && scans.now.on("OutputStatus")
    );
    mmvc_when_o1_is_on_then_every_permissive_is, Mmvc []: |scans| implies(
        scans.now.on("O1"),
        ["Enable", "Keyswitch", "Bottom", "FlywheelStopped", "SafetyEnable", "Actuate", "InputStatus", "OutputStatus"]
            .iter()
            .all(|permissive| scans.now.on(permissive))
    );
    mmvc_when_o1_rises_then_actuate_has_an_edge, Mmvc []: |scans| implies(scans.rises("O1"), scans.edge("Actuate"));
    avc_when_o1_is_on_then_both_status_are_good, Avc []: |scans| implies(
        scans.now.on("O1"),
        scans.now.on("InputStatus") && scans.now.on("OutputStatus")
    );
    avc_when_output_follows_and_nothing_delays_then_o1_needs_actuate, Avc [("OutputFollowsActuate", 1), ("DelayTime", 0)]:
    |scans| implies(scans.now.on("O1"), scans.now.on("Actuate"));
    /// 9
    cbim_when_o1_is_on_then_start_is_held_and_safety_enable_is_on, Cbim []: |scans| implies(
        scans.now.on("O1"),
        scans.now.on("Start") && scans.now.on("SafetyEnable") && scans.now.on("Enable")
    );
    /// 8 and 9
    cbssm_when_o1_is_on_in_down_then_start_is_held, Cbssm []: |scans| implies(
        scans.now.on("O1"),
        scans.now.on("SafetyEnable") && implies(scans.now.get("SlideZone") == DOWN, scans.now.on("Start"))
    );
    /// 9
    cbcm_when_o1_is_on_then_safety_enable_is_on, Cbcm []: |scans| implies(
        scans.now.on("O1"),
        scans.now.on("SafetyEnable") && !scans.now.on("MotionMonitorFault") && scans.now.on("StandardEnable")
    );
    cbcm_when_immediate_then_continuous_is_never_armed, Cbcm [("Mode", 0)]: |scans| !scans.now.on("CA");
    cbcm_when_arming_is_needed_then_o1_rises_armed, Cbcm [("Mode", 1)]: |scans| implies(
        scans.rises("O1"),
        scans.before.on("CA") && scans.edge("Start")
    );
}

proptest! {
    /// 7
    #[test]
    fn mvc_when_outputs_rise_then_actuate_was_given_again(play in plays(Opcode::Mvc, &[])) {
        prop_assert!(fresh_input(&play.run(), "Actuate"));
    }

    /// 7 and 8
    #[test]
    fn cbim_when_o1_rises_then_start_was_given_again(play in plays(Opcode::Cbim, &[])) {
        prop_assert!(fresh_input(&play.run(), "Start"));
    }

    /// 7 and 8
    #[test]
    fn cbssm_when_o1_rises_then_start_was_given_again(play in plays(Opcode::Cbssm, &[])) {
        prop_assert!(fresh_input(&play.run(), "Start"));
    }

    /// 7
    #[test]
    fn cbcm_when_o1_rises_then_start_was_given_again(play in plays(Opcode::Cbcm, &[])) {
        prop_assert!(fresh_input(&play.run(), "Start"));
    }

    /// 10
    #[test]
    fn press_when_inputs_are_constant_then_never_starts(
        play in prop::sample::select(vec![Opcode::Mvc, Opcode::Mmvc, Opcode::Cbim, Opcode::Cbssm, Opcode::Cbcm])
            .prop_flat_map(|opcode| plays(opcode, &[]))
    ) {
        prop_assert!(play.run_with_constant_inputs().iter().all(press_stands));
    }
}
