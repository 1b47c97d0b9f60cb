//! Table 3 of 1734-UM013: terminals of a pair, and the data and status that the controller gets. REQ-PLANT-010

use twinrung_plant::Reading::{Data, Status};
use twinrung_plant::digital_input::DigitalInput;

use super::support::{Bench, contact, pair};

/// A row of the table.
type Row = (&'static str, [bool; 2], [i32; 2], [i32; 2]);

/// Mode; IN0, IN1; data 0, data 1; status 0, status 1. Every row of the table.
const TABLE: [Row; 8] = [
    ("EQUIVALENT", [false, false], [0, 0], [1, 1]),
    ("EQUIVALENT", [false, true], [0, 0], [0, 0]),
    ("EQUIVALENT", [true, false], [0, 0], [0, 0]),
    ("EQUIVALENT", [true, true], [1, 1], [1, 1]),
    ("COMPLEMENTARY", [false, false], [0, 1], [0, 0]),
    ("COMPLEMENTARY", [false, true], [0, 1], [1, 1]),
    ("COMPLEMENTARY", [true, false], [1, 0], [1, 1]),
    ("COMPLEMENTARY", [true, true], [0, 1], [0, 0]),
];

/// The terminals stand so from 100 ms on; the discrepancy time of 50 ms has long run out.
#[test]
fn pair_when_its_terminals_stand_then_data_and_status_are_those_of_the_table() {
    for (mode, terminals, data, status) in TABLE {
        let mut bench = Bench::new(DigitalInput::new(&pair(mode, "50")));
        // A complementary pair rests with its odd channel on.
        bench.at(0, contact("I1", mode == "COMPLEMENTARY"));
        bench.at(100, contact("I0", terminals[0])).at(100, contact("I1", terminals[1]));
        let found = bench.read(1000, &[Data(0), Data(1), Status(0), Status(1)]);
        assert_eq!(found, [data, status].concat(), "{mode} {terminals:?}");
    }
}

/// Within the discrepancy time a pair that differs is in the safe state, and no fault.
#[test]
fn pair_when_it_differs_within_the_discrepancy_time_then_data_is_safe_and_status_is_normal() {
    for (mode, terminals, data, _) in TABLE {
        let mut bench = Bench::new(DigitalInput::new(&pair(mode, "50")));
        bench.at(0, contact("I1", mode == "COMPLEMENTARY"));
        bench.at(100, contact("I0", terminals[0])).at(100, contact("I1", terminals[1]));
        let found = bench.read(149, &[Data(0), Data(1), Status(0), Status(1)]);
        assert_eq!(found, [data, [1, 1]].concat(), "{mode} {terminals:?}");
    }
}

/// The same from the active state: first both channels are active, then the terminals stand as the row says.
#[test]
fn pair_when_it_leaves_the_active_state_then_data_and_status_are_those_of_the_table() {
    for (mode, terminals, data, status) in TABLE {
        let mut bench = Bench::new(DigitalInput::new(&pair(mode, "50")));
        bench.at(0, contact("I1", mode == "COMPLEMENTARY"));
        bench.at(100, contact("I0", true)).at(100, contact("I1", mode == "EQUIVALENT"));
        let active = [1, i32::from(mode == "EQUIVALENT"), 1, 1];
        assert_eq!(bench.read(500, &[Data(0), Data(1), Status(0), Status(1)]), active, "{mode}");
        bench.at(600, contact("I0", terminals[0])).at(600, contact("I1", terminals[1]));
        let found = bench.read(1500, &[Data(0), Data(1), Status(0), Status(1)]);
        assert_eq!(found, [data, status].concat(), "{mode} {terminals:?}");
    }
}
