//! Times on the grid of the scans, at their boundaries. The heater is warm in the scan 300 ms after the one that starts it.

use super::support::{failures, heater, on_heater, refused, report};

const NOTHING: [&str; 0] = [];

/// REQ-TEST-001
#[test]
fn input_when_set_between_two_scans_then_the_next_one_sees_it() {
    assert_eq!(on_heater("at 81 ms\nwhen Start is on\nthen Run is on"), NOTHING);
    assert_eq!(on_heater("at 80 ms\nthen Run is off\nat 81 ms\nwhen Start is on"), NOTHING);
    assert_eq!(on_heater("at 100 ms\nwhen Start is on\nthen Run is on"), NOTHING);
    assert_eq!(on_heater("at 100 ms\nwhen Start is on\nat 100 ms\nthen Run is off"), ["5: at 100 ms Run was on"]);
}

/// REQ-TEST-002
#[test]
fn within_when_the_last_scan_begins_at_its_very_end_then_that_scan_counts_and_no_later_one() {
    assert_eq!(on_heater("at 100 ms\nwhen Start is on\nthen Warm is on within 300 ms"), NOTHING);
    assert_eq!(on_heater("at 100 ms\nwhen Start is on\nthen Warm is on within 299 ms"), ["4: at 380 ms Warm was off"]);
    assert_eq!(on_heater("at 100 ms\nwhen Start is on\nthen Warm is on within 15 scans"), NOTHING);
    assert_eq!(
        on_heater("at 100 ms\nwhen Start is on\nthen Warm is on within 14 scans"),
        ["4: at 380 ms Warm was off"]
    );
    assert_eq!(on_heater("at 81 ms\nwhen Start is on\nthen Warm is on within 0.319 s"), NOTHING);
    assert_eq!(on_heater("at 81 ms\nwhen Start is on\nthen Warm is on within 318 ms"), ["4: at 380 ms Warm was off"]);
}

/// REQ-TEST-002
#[test]
fn within_when_no_scan_begins_in_it_then_it_is_refused() {
    let wrong = refused(&heater(), "scenario \"x\"\nat 101 ms\nthen Run is off within 5 ms\nend\n");
    assert_eq!(
        wrong,
        ["E0504 3: no scan begins from 101 to 106 ms: the next one begins at 120 ms; \
          give it at least 19 ms; one scan begins every 20 ms"]
    );
    assert_eq!(on_heater("at 101 ms\nthen Run is off within 19 ms"), NOTHING);
}

/// REQ-TEST-003
#[test]
fn not_before_when_it_comes_in_the_scan_at_its_end_then_it_is_met_and_sooner_not() {
    assert_eq!(on_heater("at 100 ms\nwhen Start is on\nthen Warm is on not before 300 ms within 300 ms"), NOTHING);
    assert_eq!(
        on_heater("at 100 ms\nwhen Start is on\nthen Warm is on not before 301 ms within 400 ms"),
        ["4: at 400 ms Warm was on too soon"]
    );
}

/// REQ-TEST-004
#[test]
fn stays_when_it_ends_in_the_scan_at_its_end_then_that_scan_does_not_count() {
    assert_eq!(on_heater("at 100 ms\nwhen Start is on\nthen Warm stays off for 300 ms"), NOTHING);
    assert_eq!(on_heater("at 100 ms\nwhen Start is on\nthen Warm stays off for 301 ms"), ["4: at 400 ms Warm was on"]);
    let none = refused(&heater(), "scenario \"x\"\nat 101 ms\nthen Run stays off for 19 ms\nend\n");
    assert_eq!(none.len(), 1, "{none:?}");
    assert!(none[0].starts_with("E0504 3: no scan begins from 101 to 119 ms"), "{none:?}");
}

/// REQ-TEST-005
#[test]
fn never_when_it_stands_in_a_block_or_in_the_file_then_every_scan_from_there_on_counts() {
    let text = "setup \"s\"\nhold Start is on for 20 ms\nat 40 ms\nwhen Stop is on\nthen Run is off\nend\n\
                scenario \"x\"\nwith \"s\"\nnever Run is on\nthen Run stays off for 100 ms\nend\n";
    assert_eq!(failures(&report(&heater(), text)), [] as [String; 0]);
    let text = format!("never Run is on and Warm is off\n{text}");
    assert_eq!(failures(&report(&heater(), &text)), ["1: at 0 ms Run was on and Warm was off"]);
}

/// REQ-TEST-006
#[test]
fn block_when_it_follows_a_setup_then_it_begins_with_the_scan_after_its_last_check() {
    let text = "setup \"s\"\nhold Start is on for 1 s\nat 30 ms\nthen Run is on within 70 ms\nend\n\
                scenario \"x\"\nwith \"s\"\nat 0 ms\nthen Run is off\nend\n";
    // The moment at 30 ms and 70 ms more: the block begins with the scan after the one at 100 ms.
    assert_eq!(failures(&report(&heater(), text)), ["9: at 120 ms Run was on"]);
}

/// REQ-TEST-007
#[test]
fn hold_when_its_time_is_over_then_the_value_is_the_one_before_and_a_later_setting_ends_it() {
    assert_eq!(
        on_heater(
            "given Level is 13.0\nat 20 ms\nhold Level is 1.0 for 40 ms\nthen Level is 1.0\nat 60 ms\nthen Level is 13.0"
        ),
        NOTHING
    );
    assert_eq!(on_heater("hold Stop is on for 100 ms\nat 40 ms\nwhen Stop is on\nat 200 ms\nthen Stop is on"), NOTHING);
}

/// REQ-TEST-007
#[test]
fn toggle_when_it_runs_then_it_changes_at_once_and_in_its_rhythm_until_another_setting() {
    let begin = "at 20 ms\ntoggle Fetch every 40 ms for 160 ms\nthen Fetch stays on for 40 ms\nat 60 ms\nthen Fetch stays off for 40 ms\n";
    assert_eq!(
        on_heater(&format!(
            "{begin}at 100 ms\nthen Fetch stays on for 40 ms\nat 140 ms\nthen Fetch stays off for 200 ms"
        )),
        NOTHING
    );
    assert_eq!(on_heater(&format!("{begin}at 80 ms\nwhen Fetch is off\nthen Fetch stays off for 200 ms")), NOTHING);
}

#[test]
fn mode_when_turned_then_it_changes_after_more_than_one_period_and_less_than_two() {
    let lines = "power up in program\ngiven Start is on\nthen Run stays off for 100 ms\nat 90 ms\nmode run\nthen Run is on not before 30 ms within 30 ms";
    assert_eq!(on_heater(lines), NOTHING);
}
