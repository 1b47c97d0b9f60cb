//! Time that is not plausible.

use twinrung_bytecode::observer::Silent;
use twinrung_controller::{SafetyFault, Simulated, StopReason, TimeFault};

use crate::fake::*;

/// Scans at 0 and 10 ms, the period, and then at this time.
fn third_scan_at(now_ms: i64) -> (Option<StopReason>, Option<bool>) {
    let mut controller = running(FAITHFUL);
    let mut clock = Simulated::new(10);
    controller.scan_observed(0, &mut clock, &mut Silent, &mut Silent);
    controller.scan_observed(10, &mut clock, &mut Silent, &mut Silent);
    assert_eq!(controller.published_bit(OUTPUT), Some(true));
    let stopped = controller.scan_observed(now_ms, &mut clock, &mut Silent, &mut Silent).stopped;
    (stopped, controller.published_bit(OUTPUT))
}

fn stopped_by(fault: TimeFault) -> (Option<StopReason>, Option<bool>) {
    (Some(StopReason::Safety(SafetyFault::Time(fault))), Some(false))
}

/// REQ-SCAN-015
#[test]
fn scan_when_simulated_time_is_not_the_count_of_periods_then_outputs_are_off_in_that_scan() {
    assert_eq!(third_scan_at(20), (None, Some(true)));
    assert_eq!(third_scan_at(21), stopped_by(TimeFault::Fast));
    assert_eq!(third_scan_at(19), stopped_by(TimeFault::Slow));
    assert_eq!(third_scan_at(10), stopped_by(TimeFault::Slow));
    assert_eq!(third_scan_at(9), stopped_by(TimeFault::Backwards));
    assert_eq!(third_scan_at(20 | 1 << 62), stopped_by(TimeFault::Fast));
}

/// REQ-SCAN-015
#[test]
fn scan_when_no_second_source_is_there_then_only_backwards_is_refused() {
    let mut controller = running(FAITHFUL);
    assert_eq!([0, 10, 500, 500].map(|now_ms| controller.scan(now_ms).stopped), [None; 4]);
    let stopped = controller.scan(499).stopped;
    assert_eq!(stopped, Some(StopReason::Safety(SafetyFault::Time(TimeFault::Backwards))));
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
}
