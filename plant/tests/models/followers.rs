//! Auxiliary contacts that follow an output. REQ-PLANT-054

use twinrung_plant::{
    AuxiliaryContact, Command, Fault, ModuleSettings, Plant, Reading, Series, Signal, Station, Stimulus,
};

use super::support::{at, contact};

/// Inputs, and two outputs that are switched alone.
fn plant() -> Plant {
    let inputs = ModuleSettings::new("1734-IB8S").point(at("I0"), &[("Mode", "SAFETY")]);
    let single = [("Mode", "SAFETY"), ("Channel", "SINGLE")];
    let outputs = ModuleSettings::new("1734-OB8S").point(at("O0"), &single).point(at("O1"), &single);
    let commands = vec![Command::Output(0), Command::Output(1)];
    Plant::new(vec![
        Station::new(&inputs, vec![Reading::Data(0)], Vec::new()).unwrap(),
        Station::new(&outputs, Vec::new(), commands).unwrap(),
    ])
}

/// A mirror contact that takes 20 ms.
fn mirror(output: &str) -> AuxiliaryContact {
    AuxiliaryContact { module: 1, output: at(output), inverted: true, delay_ms: 20 }
}

fn follows(contacts: &[AuxiliaryContact]) -> Stimulus {
    Stimulus::Signal(at("I0"), Signal::Follows(Series::new(contacts).unwrap()))
}

/// The times up to `until_ms` at which the input gets another level. Every 20 ms the outputs are commanded.
fn changes(plant: &mut Plant, (from_ms, until_ms): (u64, u64), command: [bool; 2]) -> Vec<(u64, bool)> {
    let mut list: Vec<(u64, bool)> = Vec::new();
    for now_ms in from_ms..until_ms {
        plant.through(now_ms);
        let high = plant.stations()[0].is_high(at("I0")).unwrap();
        list.extend((list.last().map(|(_, last)| *last) != Some(high)).then_some((now_ms, high)));
        (now_ms % 20 == 0).then(|| plant.receive(1, command.into_iter()));
    }
    list
}

#[test]
fn contact_when_its_output_changes_then_it_moves_after_its_time_either_way() {
    let mut plant = plant();
    plant.apply(0, &follows(&[mirror("O0")]), 0);
    assert_eq!(changes(&mut plant, (0, 100), [false, false]), [(0, true)]);
    // Commanded at 100 ms.
    assert_eq!(changes(&mut plant, (100, 200), [true, false]), [(100, true), (120, false)]);
    assert_eq!(changes(&mut plant, (200, 300), [false, false]), [(200, false), (220, true)]);
}

/// A contactor that is pulsed for less than it takes does not move.
#[test]
fn contact_when_its_output_changes_back_in_time_then_it_does_not_move() {
    let mut plant = plant();
    plant.apply(0, &follows(&[AuxiliaryContact { delay_ms: 21, ..mirror("O0") }]), 0);
    plant.through(20);
    assert_eq!(changes(&mut plant, (20, 40), [true, false]), [(20, true)]);
    assert_eq!(changes(&mut plant, (40, 60), [false, false]), [(40, true)]);
    assert_eq!(changes(&mut plant, (60, 80), [true, false]), [(60, true)]);
    assert_eq!(changes(&mut plant, (80, 200), [false, false]), [(80, true)]);
}

#[test]
fn contact_when_it_is_closed_with_its_output_then_it_follows_at_once_where_it_takes_no_time() {
    let mut plant = plant();
    plant.apply(0, &follows(&[AuxiliaryContact { inverted: false, delay_ms: 0, ..mirror("O0") }]), 0);
    assert_eq!(changes(&mut plant, (0, 100), [true, false]), [(0, false), (1, true)]);
}

#[test]
fn contacts_when_they_are_in_series_then_one_that_is_open_opens_them_all() {
    let mut plant = plant();
    plant.apply(0, &follows(&[mirror("O0"), mirror("O1")]), 0);
    assert_eq!(changes(&mut plant, (0, 100), [false, true]), [(0, true), (20, false)]);
    assert_eq!(changes(&mut plant, (100, 200), [false, false]), [(100, false), (120, true)]);
}

/// What a contactor gets counts, and not what is commanded.
#[test]
fn contact_when_the_wire_of_its_contactor_breaks_then_it_moves() {
    let mut plant = plant();
    plant.apply(0, &follows(&[mirror("O0")]), 0);
    assert_eq!(changes(&mut plant, (0, 100), [true, true]), [(0, true), (20, false)]);
    plant.apply(1, &Stimulus::Fault(at("O0"), Fault::Open), 105);
    assert_eq!(changes(&mut plant, (105, 200), [true, true]), [(105, false), (125, true)]);
}

#[test]
fn contact_when_it_is_moved_by_name_then_it_is_welded_until_it_is_said_to_follow_again() {
    let mut plant = plant();
    plant.apply(0, &follows(&[mirror("O0")]), 0);
    assert_eq!(changes(&mut plant, (0, 100), [true, true]), [(0, true), (20, false)]);
    plant.apply(0, &contact("I0", false), 100);
    assert_eq!(changes(&mut plant, (100, 200), [false, false]), [(100, false)]);
    plant.apply(0, &follows(&[mirror("O0")]), 200);
    assert_eq!(changes(&mut plant, (200, 300), [false, false]), [(200, true)]);
}

#[test]
fn series_when_it_has_more_contacts_than_it_may_then_it_is_none() {
    assert_eq!(Series::new(&[mirror("O0"); 5]), None);
}
