//! `muting-and-outputs.md` 6.3 and 7.3.

use crate::play::{Row, always, implies};

fn says_on(row: &Row, feedback: &str) -> bool {
    row.on(feedback) == row.on("FeedbackType")
}

fn any_feedback_on(row: &Row) -> bool {
    says_on(row, "Feedback1") || says_on(row, "Feedback2")
}

always! {
    crout_when_played_then_both_outputs_are_equal, Crout []: |scans| scans.now.on("O1") == scans.now.on("O2");
    rout_when_played_then_both_outputs_are_equal, Rout []: |scans| scans.now.on("O1") == scans.now.on("O2");

    crout_when_outputs_are_on_then_actuate_and_both_status_are_on, Crout []: |scans| implies(
        scans.now.on("O1"),
        scans.now.on("Actuate") && scans.now.on("InputStatus") && scans.now.on("OutputStatus")
    );
    rout_when_outputs_are_on_then_enable_is_on, Rout []: |scans| implies(scans.now.on("O1"), scans.now.on("Enable"));

    crout_when_outputs_rise_then_both_feedbacks_say_off, Crout []: |scans| implies(
        scans.rises("O1"),
        !any_feedback_on(scans.now)
    );
    rout_when_outputs_rise_then_both_feedbacks_say_off, Rout []: |scans| implies(
        scans.rises("O1"),
        !any_feedback_on(scans.now)
    );

    crout_when_fault_clears_then_by_reset_with_both_feedbacks_off, Crout []: |scans| implies(
        scans.falls("FP"),
        !scans.now.rung || (scans.edge("Reset") && !any_feedback_on(scans.now) && !scans.now.on("O1"))
    );
    rout_when_fault_clears_then_by_reset_with_both_feedbacks_off, Rout []: |scans| implies(
        scans.falls("FP"),
        !scans.now.rung || (scans.edge("FaultReset") && !any_feedback_on(scans.now) && !scans.now.on("O1"))
    );
    rout_when_played_then_fault_present_is_either_feedback_failure, Rout []: |scans| {
        scans.now.on("FP") == (scans.now.on("O1FF") || scans.now.on("O2FF"))
    };
}
