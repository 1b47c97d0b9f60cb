//! Table 9 of 1756-RM093 and what a connection does in time. REQ-PLANT-001 to REQ-PLANT-004

use twinrung_plant::{Command, Connection, ConnectionStatus, ModuleSettings, Plant, Reading, Station, Stimulus};

use super::support::{at, contact};

/// RPI and limit of the manual's example, µs.
const RPI_US: u64 = 10_000;
const LIMIT_US: u64 = 40_064;

/// Whether the producer is reached, whether it runs; the two bits, and whether data arrives. Table 9, row by row.
const TABLE: [(bool, bool, (bool, bool), i32); 4] = [
    (true, true, (true, false), 7),
    (true, false, (false, false), 0),
    (false, true, (false, true), 0),
    (false, false, (false, true), 0),
];

/// The fourth row of the table, both bits on, is an invalid state: [`ConnectionStatus`] has no such value.
/// REQ-PLANT-001
#[test]
fn connection_when_its_producer_runs_idles_or_is_lost_then_status_and_data_are_those_of_the_table() {
    for (reached, running, bits, data) in TABLE {
        let mut connection = Connection::new(RPI_US, LIMIT_US);
        connection.pass(0, reached, running, |packet| packet.push(7));
        let status = connection.status(0);
        assert_eq!((status.run_mode(), status.connection_faulted()), bits, "{reached} {running}");
        assert_eq!(connection.value(0, 0), data, "{reached} {running}");
    }
}

/// REQ-PLANT-001
#[test]
fn status_when_all_its_values_are_listed_then_none_has_both_bits() {
    let all = [ConnectionStatus::Running, ConnectionStatus::Idle, ConnectionStatus::Faulted];
    assert!(!all.iter().any(|status| status.run_mode() && status.connection_faulted()));
}

/// REQ-PLANT-002
#[test]
fn connection_when_packets_stay_away_then_it_is_faulted_after_its_limit_and_not_before() {
    let mut connection = Connection::new(RPI_US, LIMIT_US);
    connection.pass(0, true, true, |packet| packet.push(7));
    connection.pass(10_000, false, true, |_| {});
    assert_eq!(connection.status(LIMIT_US), ConnectionStatus::Running);
    assert_eq!(connection.value(LIMIT_US, 0), 7);
    assert_eq!(connection.status(LIMIT_US + 1), ConnectionStatus::Faulted);
    connection.pass(50_000, true, true, |packet| packet.push(8));
    assert_eq!((connection.status(50_000), connection.value(50_000, 0)), (ConnectionStatus::Running, 8));
}

/// A consumed tag shows the last packet, whatever happens between two. REQ-PLANT-002
#[test]
fn connection_when_data_changes_between_packets_then_the_consumer_sees_it_with_the_next() {
    let mut connection = Connection::new(RPI_US, LIMIT_US);
    let seen: Vec<i32> = (0..25)
        .map(|ms: i32| {
            let now_us = u64::from(ms.unsigned_abs()) * 1000;
            connection.pass(now_us, true, true, |packet| packet.push(ms));
            connection.value(now_us, 0)
        })
        .collect();
    assert_eq!((seen[9], seen[10], seen[19], seen[24]), (0, 10, 10, 20));
}

fn inputs() -> Plant {
    let settings = ModuleSettings::new("1734-IB8S").point(at("I0"), &[("Mode", "SAFETY")]);
    let readings = vec![Reading::RunMode, Reading::ConnectionFaulted, Reading::Data(0), Reading::CombinedStatus];
    let mut plant = Plant::new(vec![Station::new(&settings, readings, Vec::new()).unwrap()]);
    plant.apply(0, &contact("I0", true), 0);
    plant
}

fn tags(plant: &mut Plant, time_ms: u64) -> Vec<i32> {
    plant.through(time_ms);
    plant.stations()[0].values().collect()
}

/// REQ-PLANT-003
#[test]
fn module_when_lost_and_back_then_its_tag_is_zero_and_faulted_in_between() {
    let mut plant = inputs();
    assert_eq!(tags(&mut plant, 100), [1, 0, 1, 1]);
    plant.apply(0, &Stimulus::Present(false), 105);
    // The last packet was that of 100 ms; the limit is 40.064 ms.
    assert_eq!(tags(&mut plant, 140), [1, 0, 1, 1]);
    assert_eq!(tags(&mut plant, 141), [0, 1, 0, 0]);
    plant.apply(0, &Stimulus::Present(true), 205);
    assert_eq!(tags(&mut plant, 209), [0, 1, 0, 0]);
    assert_eq!(tags(&mut plant, 210), [1, 0, 1, 1]);
}

/// REQ-PLANT-003
#[test]
fn module_when_idle_then_its_tag_is_zero_and_not_faulted() {
    let mut plant = inputs();
    plant.apply(0, &Stimulus::Running(false), 100);
    assert_eq!(tags(&mut plant, 100), [0, 0, 0, 0]);
    plant.apply(0, &Stimulus::Running(true), 200);
    assert_eq!(tags(&mut plant, 200), [1, 0, 1, 1]);
}

/// REQ-PLANT-004
#[test]
fn outputs_when_no_packet_arrives_for_the_limit_then_they_are_off() {
    let settings = ModuleSettings::new("1734-OB8S").point(at("O0"), &[("Mode", "SAFETY"), ("Channel", "SINGLE")]);
    let mut plant = Plant::new(vec![Station::new(&settings, Vec::new(), vec![Command::Output(0)]).unwrap()]);
    let high = |plant: &Plant| plant.stations()[0].is_high(at("O0"));
    plant.through(20);
    plant.station_mut(0).unwrap().receive([true].into_iter());
    assert_eq!(high(&plant), Some(true));
    // 60.032 ms after 20 ms.
    plant.through(80);
    assert_eq!(high(&plant), Some(true));
    plant.through(81);
    assert_eq!(high(&plant), Some(false));
}

/// REQ-PLANT-004
#[test]
fn test_outputs_when_no_packet_arrives_then_each_does_what_its_fault_action_says() {
    let settings = ModuleSettings::new("1734-IB8S")
        .point(at("T2"), &[("Mode", "STANDARD"), ("FaultAction", "HOLD_LAST")])
        .point(at("T3"), &[("Mode", "STANDARD"), ("FaultAction", "CLEAR_OFF")]);
    let commands = vec![Command::Test(2), Command::Test(3)];
    let mut plant = Plant::new(vec![Station::new(&settings, Vec::new(), commands).unwrap()]);
    plant.through(20);
    plant.station_mut(0).unwrap().receive([true, true].into_iter());
    plant.through(81);
    let high = |name| plant.stations()[0].is_high(at(name));
    assert_eq!((high("T2"), high("T3")), (Some(true), Some(false)));
}

/// REQ-PLANT-005
#[test]
fn outputs_when_the_module_is_idle_then_they_are_in_the_safe_state() {
    let settings = ModuleSettings::new("1734-OB8S").point(at("O0"), &[("Mode", "SAFETY"), ("Channel", "SINGLE")]);
    let mut plant = Plant::new(vec![Station::new(&settings, Vec::new(), vec![Command::Output(0)]).unwrap()]);
    let told = |plant: &mut Plant, time_ms| {
        plant.through(time_ms);
        plant.station_mut(0).unwrap().receive([true].into_iter());
        plant.stations()[0].is_high(at("O0"))
    };
    assert_eq!(told(&mut plant, 20), Some(true));
    plant.apply(0, &Stimulus::Running(false), 30);
    assert_eq!(told(&mut plant, 40), Some(false));
    plant.apply(0, &Stimulus::Running(true), 50);
    assert_eq!(told(&mut plant, 60), Some(true));
}
