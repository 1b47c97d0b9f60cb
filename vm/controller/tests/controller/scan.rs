//! The scan cycle with channels whose behaviour a test chooses.

use twinrung_bytecode::index::ProgramIndex;
use twinrung_bytecode::observer::Silent;
use twinrung_controller::{
    Difference, IMAGE_CHECK_BYTES_PER_SCAN, Mode, NoClock, Part, SafetyFault, ScanClock, StopReason, TimeFault,
};

use crate::fake::*;

fn stopped_in_third_scan(behaviour: i32) -> Option<StopReason> {
    let mut controller = running(behaviour);
    assert_eq!(controller.scan(0).stopped, None);
    assert_eq!(controller.scan(10).stopped, None);
    assert_eq!(controller.published_bit(OUTPUT), Some(true), "on before the fault");
    let report = controller.scan(20);
    assert_eq!(controller.published_bit(OUTPUT), Some(false), "off in the scan of the fault");
    assert_eq!(controller.scan(30).stopped, report.stopped, "and it stays stopped");
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
    report.stopped
}

/// REQ-SCAN-001, REQ-SCAN-008
#[test]
fn scan_when_channels_agree_then_outputs_follow_the_frozen_inputs() {
    let mut controller = running(FAITHFUL);
    let report = controller.scan(0);
    assert!(report.executed);
    assert_eq!(controller.published_bit(OUTPUT), Some(true));
    controller.drive_bit(INPUT, false);
    assert_eq!(controller.published_bit(OUTPUT), Some(true), "nothing moves between scans");
    controller.scan(10);
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
    assert_eq!(controller.word(COUNT), Some(2));
}

/// REQ-SCAN-002, REQ-SCAN-003
#[test]
fn scan_when_a_bit_differs_then_outputs_are_off_in_that_scan() {
    let difference = Difference::Bit(OUTPUT, 1, 0);
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_A_BIT), Some(StopReason::Safety(SafetyFault::Difference(difference))));
}

#[test]
fn scan_when_a_word_differs_then_outputs_are_off_in_that_scan() {
    let difference = Difference::Word(COUNT, 3, -1);
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_A_WORD), Some(StopReason::Safety(SafetyFault::Difference(difference))));
}

#[test]
fn scan_when_a_flag_differs_then_outputs_are_off_in_that_scan() {
    let fault = SafetyFault::Difference(Difference::Status);
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_STATUS), Some(StopReason::Safety(fault)));
}

/// REQ-SCAN-010
#[test]
fn scan_when_control_took_another_path_then_outputs_are_off_in_that_scan() {
    let fault = SafetyFault::Difference(Difference::Path);
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_PATH), Some(StopReason::Safety(fault)));
    let budget = stopped_in_third_scan(EXCEEDS_BUDGET_ON_ANOTHER_PATH);
    assert_eq!(
        budget,
        Some(StopReason::Safety(SafetyFault::BudgetExceeded)),
        "where the path was cut off is not compared"
    );
}

#[test]
fn scan_when_a_fault_record_differs_then_outputs_are_off_in_that_scan() {
    let fault = SafetyFault::Difference(Difference::FaultRecord(ProgramIndex(0)));
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_RECORD), Some(StopReason::Safety(fault)));
}

/// REQ-SCAN-013
#[test]
fn scan_when_both_channels_lose_the_same_cell_then_the_second_comparison_stops_the_task() {
    assert_eq!(stopped_in_third_scan(LOSES_A_CELL), Some(StopReason::Safety(SafetyFault::SecondComparison)));
}

/// REQ-SCAN-014
#[test]
fn scan_when_the_comparisons_have_tried_every_bit_on_themselves_then_the_task_still_runs() {
    let mut controller = running(FAITHFUL);
    assert!((0..100).all(|scan| controller.scan(scan * 10).stopped.is_none()));
    assert_eq!(controller.published_bit(OUTPUT), Some(true));
}

/// REQ-SCAN-018
#[test]
fn scan_when_both_channels_execute_nothing_then_outputs_are_off_in_that_scan() {
    assert_eq!(stopped_in_third_scan(EXECUTES_NOTHING), Some(StopReason::Safety(SafetyFault::NothingExecuted)));
}

/// REQ-SCAN-030
#[test]
fn scan_when_a_channel_has_stopped_then_the_task_stops_with_14_4_and_outputs_are_off() {
    let reason = Some(StopReason::Safety(SafetyFault::ChannelStopped));
    assert_eq!([FIRST_STOPS, SECOND_STOPS].map(stopped_in_third_scan), [reason; 2]);
    assert_eq!(SafetyFault::ChannelStopped.type_and_code(), (14, 4));
}

/// REQ-SCAN-004, REQ-SCAN-030
#[test]
fn scan_when_a_channel_gives_no_answer_until_the_watchdog_expired_then_it_is_the_watchdog() {
    let mut controller = running(SECOND_STOPS);
    let mut clock = Late { expires_in: 3, parts: Vec::new() };
    let reports = [0, 10, 20].map(|at| controller.scan_observed(at, &mut clock, &mut Silent, &mut Silent).stopped);
    assert_eq!(reports, [None, None, Some(StopReason::Safety(SafetyFault::WatchdogExpired))]);
}

/// REQ-SCAN-003, REQ-SCAN-004
#[test]
fn scan_when_channels_differ_and_the_watchdog_expires_then_it_is_the_difference() {
    let mut controller = running(DIFFERS_IN_STATUS);
    let mut clock = Late { expires_in: 3, parts: Vec::new() };
    let reports = [0, 10, 20].map(|at| controller.scan_observed(at, &mut clock, &mut Silent, &mut Silent).stopped);
    assert_eq!(reports, [None, None, Some(StopReason::Safety(SafetyFault::Difference(Difference::Status)))]);
}

/// REQ-SCAN-003, REQ-SCAN-015, REQ-SCAN-017
#[test]
fn faults_when_their_numbers_are_asked_for_then_all_but_watchdog_and_stopped_channel_are_14_7() {
    let others = [
        SafetyFault::Difference(Difference::Size),
        SafetyFault::ImageCorrupted,
        SafetyFault::SecondComparison,
        SafetyFault::NothingExecuted,
        SafetyFault::VerdictIncomplete,
        SafetyFault::OutputsDiffer,
        SafetyFault::ControllerCorrupted,
        SafetyFault::Time(TimeFault::Fast),
    ];
    assert_eq!(others.map(|fault| StopReason::Safety(fault).type_and_code()), [(14, 7); 8]);
    assert_eq!(SafetyFault::WatchdogExpired.type_and_code(), (14, 1));
}

/// REQ-SCAN-005
#[test]
fn scan_when_both_channels_fault_then_the_task_stops_with_14_2() {
    let reason = stopped_in_third_scan(FAULTS).unwrap();
    assert_eq!(reason.type_and_code(), (14, 2));
}

/// REQ-SCAN-002, REQ-SCAN-005, REQ-SCAN-013, REQ-SCAN-030. A prescan is judged as a scan is, and no scan follows one that failed.
#[test]
fn prescan_when_it_fails_then_the_task_stops_before_a_scan_executes() {
    let first_scan = |behaviour| {
        let mut controller = running(behaviour);
        let stopped = controller.scan(0).stopped;
        assert_eq!(controller.status().executed, 0);
        assert_eq!(controller.published_bit(OUTPUT), Some(false));
        assert_eq!(controller.scan(10).stopped, stopped, "and it stays stopped");
        stopped
    };
    let safety = |fault| Some(StopReason::Safety(fault));
    assert_eq!(first_scan(FAULTS_IN_PRESCAN).map(StopReason::type_and_code), Some((14, 2)));
    let differs = first_scan(SECOND_FAULTS_IN_PRESCAN);
    assert!(matches!(differs, Some(StopReason::Safety(SafetyFault::Difference(Difference::End(_, _))))), "{differs:?}");
    assert_eq!(first_scan(LOSES_A_CELL_IN_PRESCAN), safety(SafetyFault::SecondComparison));
    assert_eq!(first_scan(STOPS_IN_PRESCAN), safety(SafetyFault::ChannelStopped));
}

/// REQ-SCAN-004
#[test]
fn scan_when_the_budget_runs_out_then_the_task_stops_with_14_1() {
    let reason = stopped_in_third_scan(EXCEEDS_BUDGET).unwrap();
    assert_eq!(reason, StopReason::Safety(SafetyFault::BudgetExceeded));
    assert_eq!(reason.type_and_code(), (14, 1));
}

/// REQ-SCAN-006
#[test]
fn scan_when_the_image_in_memory_changes_then_it_is_found_within_one_pass() {
    let bytes = sealed(FAITHFUL);
    let mut controller = running(FAITHFUL);
    let scans = bytes.len().div_ceil(IMAGE_CHECK_BYTES_PER_SCAN) as i64;
    let last = controller.checked_bytes_mut().len() - 1;
    controller.checked_bytes_mut()[last] ^= 1;
    let stopped: Vec<_> = (0..scans).map(|scan| controller.scan(scan * 10).stopped).collect();
    assert_eq!(stopped.last(), Some(&Some(StopReason::Safety(SafetyFault::ImageCorrupted))));
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
}

/// REQ-SCAN-007
#[test]
fn mode_when_a_change_is_asked_for_then_it_acts_after_more_than_one_and_less_than_two_periods() {
    let mut controller = running(FAITHFUL);
    controller.scan(0);
    controller.request_mode(Mode::Program);
    assert!(controller.scan(10).executed, "one period has not passed");
    assert!(!controller.scan(20).executed);
    assert_eq!(controller.mode(), Mode::Program);
    assert_eq!(controller.published_bit(OUTPUT), Some(false), "outputs are off in Program");
    controller.request_mode(Mode::Run);
    assert!(!controller.scan(30).executed);
    assert!(controller.scan(40).executed);
    assert_eq!(controller.channels_mut().0.prescans, 2, "each change to Run prescans");
}

/// A clock that says that the watchdog has expired in one scan.
struct Late {
    expires_in: u32,
    parts: Vec<Part>,
}

impl ScanClock for Late {
    fn begin(&mut self) {
        self.parts.clear();
    }

    fn ended(&mut self, part: Part) {
        self.parts.push(part);
    }

    fn expired(&mut self) -> bool {
        self.expires_in -= 1;
        self.expires_in == 0
    }
}

/// REQ-SCAN-004
#[test]
fn scan_when_the_clock_says_that_it_took_too_long_then_nothing_is_published() {
    let mut controller = running(FAITHFUL);
    let mut clock = Late { expires_in: 2, parts: Vec::new() };
    controller.scan_observed(0, &mut clock, &mut Silent, &mut Silent);
    assert_eq!(clock.parts, Part::ALL);
    assert_eq!(controller.published_bit(OUTPUT), Some(true));
    let report = controller.scan_observed(10, &mut clock, &mut Silent, &mut Silent);
    assert_eq!(report.stopped, Some(StopReason::Safety(SafetyFault::WatchdogExpired)));
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
    assert_eq!(controller.scan_observed(20, &mut NoClock, &mut Silent, &mut Silent).stopped, report.stopped);
}
