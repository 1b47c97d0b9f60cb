//! What is driven, held and published, and what the channels are told.

use twinrung_bytecode::image::SystemValueRecord;
use twinrung_bytecode::index::{BitCell, EventTaskIndex, TagIndex, WordCell};
use twinrung_bytecode::{admit, limits};
use twinrung_catalog::instructions::system::ATTRIBUTES;
use twinrung_controller::{CellRange, Controller, ScanReport};

use crate::fake::*;

fn word(cell: WordCell) -> CellRange {
    CellRange { tag: TagIndex(0), bit_cell: 0, bit_cells: 0, word_cell: cell.0, word_cells: 1 }
}

/// REQ-SCAN-001
#[test]
fn values_when_driven_then_they_are_read_back_as_driven() {
    let mut controller = running(FAITHFUL);
    assert_eq!(controller.driven_bit(INPUT), Some(true));
    controller.drive_bit(INPUT, false);
    assert_eq!(controller.driven_bit(INPUT), Some(false));
    assert_eq!(controller.driven_bit(BitCell(2)), None, "past the last cell");
    for value in [1, 0, -7, i32::MIN] {
        controller.drive_word(COUNT, value);
        assert_eq!(controller.driven_word(COUNT), Some(value));
    }
    assert_eq!(controller.driven_word(WordCell(2)), None, "past the last cell");
}

/// REQ-SCAN-001
#[test]
fn cells_when_no_input_holds_them_then_they_are_frozen_only_where_that_is_asked_for() {
    let mut controller = running(FAITHFUL);
    controller.drive_word(BEHAVIOUR, -77);
    controller.scan(0);
    assert_eq!(controller.word(BEHAVIOUR), Some(FAITHFUL));
    controller.freeze_also(word(BEHAVIOUR));
    let report = controller.scan(10);
    assert_eq!((controller.word(BEHAVIOUR), report.stopped), (Some(-77), None));
}

/// REQ-SCAN-008, REQ-SCAN-016
#[test]
fn cells_when_no_output_holds_them_then_they_are_published_only_where_that_is_asked_for() {
    let mut controller = running(FAITHFUL);
    controller.scan(0);
    controller.scan(10);
    assert_eq!(controller.published_word(COUNT), Some(0));
    controller.publish_also(word(COUNT));
    let report = controller.scan(20);
    assert_eq!((controller.published_word(COUNT), report.stopped), (Some(3), None));
    assert_eq!(controller.published_word(WordCell(2)), None, "past the last cell");
    assert_eq!(controller.published_bit(BitCell(2)), None, "past the last cell");
}

#[test]
fn cells_when_read_then_they_are_what_both_channels_hold() {
    let mut controller = running(FAITHFUL);
    controller.scan(0);
    assert_eq!((controller.bit(INPUT), controller.bit(OUTPUT)), (Some(true), Some(true)));
    controller.drive_bit(INPUT, false);
    controller.scan(10);
    assert_eq!((controller.bit(INPUT), controller.bit(OUTPUT)), (Some(false), Some(false)));
    assert_eq!((controller.word(COUNT), controller.word(BEHAVIOUR)), (Some(2), Some(FAITHFUL)));
    assert_eq!((controller.bit(BitCell(2)), controller.word(WordCell(2))), (None, None), "past the last cell");
}

/// REQ-SCAN-001, REQ-SCAN-008. Which of the two holds its cells complemented is all the same.
#[test]
fn cells_when_the_primary_is_the_complemented_channel_then_they_are_read_and_published_as_they_are() {
    let bytes = sealed(FAITHFUL);
    let mut controller: Controller<Fake<true>, Fake<false>> = Controller::load(admit(&bytes).unwrap(), &bytes).unwrap();
    controller.power_up_in_run();
    controller.publish_also(word(COUNT));
    for (input, scans) in [(true, 1), (false, 2), (true, 3)] {
        controller.drive_bit(INPUT, input);
        assert_eq!(controller.scan(i64::from(scans) * 10).stopped, None);
        assert_eq!((controller.bit(OUTPUT), controller.published_bit(OUTPUT)), (Some(input), Some(input)));
        assert_eq!((controller.word(COUNT), controller.published_word(COUNT)), (Some(scans), Some(scans)));
    }
}

#[test]
fn status_and_events_when_asked_for_then_they_are_those_of_the_last_scan() {
    let mut controller = running(FAITHFUL);
    for scans in 1..=3_u32 {
        let report = controller.scan(i64::from(scans) * 10);
        assert_eq!(report, ScanReport { executed: true, stopped: None, instructions: 1 });
        assert_eq!(controller.status().executed, u64::from(scans));
        assert_eq!(controller.events(EventTaskIndex(0)), scans);
    }
    assert_eq!(controller.image().image().controller.name, "Fake");
}

/// REQ-SCAN-001, REQ-SCAN-004. 10 ms of watchdog.
#[test]
fn channels_when_a_scan_begins_then_both_are_told_the_same_time_and_budget() {
    let mut controller = running(FAITHFUL);
    controller.scan(0);
    controller.scan(1234);
    let told = (1234, 10_000 * limits::BUDGET_PER_MICROSECOND);
    let (primary, partner) = controller.channels_mut();
    assert_eq!([primary.told, partner.told], [told; 2]);
}

/// REQ-SCAN-001
#[test]
fn system_values_when_set_then_both_channels_are_told_them() {
    let attribute = ATTRIBUTES.iter().find(|attribute| attribute.class == "TASK" && attribute.length == 1).unwrap();
    let record = SystemValueRecord { attribute: attribute.number, instance: 0, first: 0, program: None };
    let mut controller =
        running_image(&twinrung_bytecode::image::Image { system_values: vec![record], ..image(FAITHFUL) });
    controller.set_system_value(0, 41);
    controller.set_system_value(1, 42);
    controller.scan(0);
    let (primary, partner) = controller.channels_mut();
    assert_eq!([&primary.system_values, &partner.system_values], [&vec![41]; 2], "there is one value");
}
