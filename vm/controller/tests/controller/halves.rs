//! Each bit of what both channels share turned round, at each moment of a scan: no output is on that should be off.

use twinrung_bytecode::injection::Flip;
use twinrung_bytecode::observer::Silent;
use twinrung_controller::{Mode, Moment, Part, SafetyFault, ScanClock, Shared, SharedMemory, Side, StopReason};

use crate::fake::*;

const MOMENTS: [Moment; 6] = [
    Moment::Begun,
    Moment::After(Part::Freeze),
    Moment::After(Part::Primary),
    Moment::After(Part::Partner),
    Moment::After(Part::Compare),
    Moment::After(Part::Publish),
];

/// Turns one bit round at one moment.
struct Once {
    moment: Moment,
    side: Side,
    memory: SharedMemory,
    bit: u64,
    flip: Option<Flip>,
}

impl ScanClock for Once {
    fn begin(&mut self) {}

    fn ended(&mut self, _part: Part) {}

    fn expired(&mut self) -> bool {
        false
    }

    fn disturb(&mut self, moment: Moment, shared: &mut Shared<'_>) {
        if moment == self.moment && self.flip.is_none() {
            self.flip = Some(shared.flip(self.side, self.memory, self.bit));
        }
    }
}

/// Inputs off in the third scan, in which the bit turns round: the output must be off from then on. Answers with why the task
/// stopped, if it did.
fn disturbed(mut once: Once) -> Option<StopReason> {
    let mut controller = running(FAITHFUL);
    controller.scan(0);
    controller.scan(10);
    assert_eq!(controller.published_bit(OUTPUT), Some(true));
    controller.drive_bit(INPUT, false);
    for now_ms in [20, 30, 40] {
        controller.scan_observed(now_ms, &mut once, &mut Silent, &mut Silent);
        assert_eq!(
            controller.published_bit(OUTPUT),
            Some(false),
            "{:?} {:?} {:?} bit {}",
            once.moment,
            once.side,
            once.memory,
            once.bit
        );
    }
    assert_eq!(once.flip, Some(Flip::Done));
    controller.stopped()
}

fn all_stop(moments: &[Moment], memory: SharedMemory) -> Vec<Option<StopReason>> {
    let mut stops = Vec::new();
    for (moment, side) in moments.iter().flat_map(|moment| [(*moment, Side::Primary), (*moment, Side::Partner)]) {
        let bits = running(FAITHFUL).shared().bits(side, memory);
        stops.extend((0..bits).map(|bit| disturbed(Once { moment, side, memory, bit, flip: None })));
    }
    stops
}

/// REQ-SCAN-011
#[test]
fn inputs_when_any_bit_flips_then_no_output_is_on_that_should_be_off() {
    let stops = all_stop(&MOMENTS, SharedMemory::Inputs);
    assert!(stops.iter().flatten().count() > 0);
}

/// REQ-SCAN-011, REQ-SCAN-016
#[test]
fn outputs_when_any_bit_flips_then_no_output_is_on_that_should_be_off() {
    let stops = all_stop(&MOMENTS, SharedMemory::Outputs);
    let corrupted = Some(StopReason::Safety(SafetyFault::ControllerCorrupted));
    // One byte of output in each half stays as it is until the next scan after the last of the moments.
    assert_eq!(stops.iter().filter(|stop| **stop == corrupted).count(), 2 * 8);
}

/// REQ-SCAN-011
#[test]
fn configuration_when_any_bit_flips_then_no_output_is_on_that_should_be_off() {
    all_stop(&MOMENTS, SharedMemory::Configuration);
}

/// REQ-SCAN-011, REQ-SCAN-015
#[test]
fn time_and_budget_when_any_bit_flips_then_no_output_is_on_that_should_be_off() {
    all_stop(&MOMENTS, SharedMemory::Time);
    all_stop(&MOMENTS, SharedMemory::Budget);
}

/// REQ-SCAN-012
#[test]
fn verdict_when_any_bit_flips_before_it_is_used_then_the_task_stops_in_that_scan() {
    let incomplete = Some(StopReason::Safety(SafetyFault::VerdictIncomplete));
    let stops = all_stop(&[Moment::After(Part::Compare)], SharedMemory::Verdict);
    assert_eq!(stops.iter().filter(|stop| **stop == incomplete).count(), 2 * 128, "number and challenge of each half");
}

/// REQ-SCAN-017
#[test]
fn permit_when_any_bit_flips_then_the_task_stops() {
    let corrupted = Some(StopReason::Safety(SafetyFault::ControllerCorrupted));
    assert!(all_stop(&[Moment::After(Part::Publish)], SharedMemory::Permit).iter().all(|stop| *stop == corrupted));
}

/// REQ-SCAN-017
#[test]
fn task_when_its_stop_is_forgotten_then_it_does_not_execute_again() {
    let mut controller = running(DIFFERS_IN_A_BIT);
    for now_ms in [0, 10, 20] {
        controller.scan(now_ms);
    }
    assert!(controller.stopped().is_some());
    assert_eq!(controller.shared().flip(Side::Primary, SharedMemory::Mode, 1), Flip::Done);
    assert_eq!(controller.stopped(), None);
    controller.scan(30);
    assert_eq!(controller.stopped(), Some(StopReason::Safety(SafetyFault::ControllerCorrupted)));
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
}

/// REQ-SCAN-017. Each half has taken back its permission when the mode became Program.
#[test]
fn mode_when_it_turns_from_program_to_run_by_itself_then_nothing_executes() {
    let mut controller = running(FAITHFUL);
    controller.scan(0);
    controller.request_mode(Mode::Program);
    assert_eq!([10, 20].map(|now_ms| controller.scan(now_ms).executed), [true, false]);
    assert_eq!(controller.shared().flip(Side::Primary, SharedMemory::Mode, 0), Flip::Done);
    assert_eq!(controller.mode(), Mode::Run);
    controller.scan(30);
    assert_eq!(controller.stopped(), Some(StopReason::Safety(SafetyFault::ControllerCorrupted)));
    assert_eq!(controller.status().executed, 2);
}
