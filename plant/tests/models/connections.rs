//! What modules do when their connections are lost, and when they are idle. REQ-PLANT-003 to REQ-PLANT-005

use twinrung_plant::{Command, ModuleSettings, Plant, Reading, Station, Stimulus};

use super::support::{at, contact};

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
    plant.receive(0, [true].into_iter());
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
    plant.receive(0, [true, true].into_iter());
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
        plant.receive(0, [true].into_iter());
        plant.stations()[0].is_high(at("O0"))
    };
    assert_eq!(told(&mut plant, 20), Some(true));
    plant.apply(0, &Stimulus::Running(false), 30);
    assert_eq!(told(&mut plant, 40), Some(false));
    plant.apply(0, &Stimulus::Running(true), 50);
    assert_eq!(told(&mut plant, 60), Some(true));
}
