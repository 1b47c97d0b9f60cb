//! Faults of wires at a 1734-IB8S, of its power, and what the module makes of them. REQ-PLANT-020 to REQ-PLANT-023

use twinrung_plant::Reading::{CombinedStatus, Data, Power, Status, TestStatus};
use twinrung_plant::digital_input::{DigitalInput, InputFault, TestFault};
use twinrung_plant::{Fault, ModuleSettings, Stimulus};

use super::support::{Bench, at, contact, pair};

fn two(sources: [&str; 2]) -> ModuleSettings {
    let input = |source| [("Mode", "SAFETY_PULSE_TEST"), ("TestSource", source)];
    ModuleSettings::new("1734-IB8S").point(at("I0"), &input(sources[0])).point(at("I1"), &input(sources[1]))
}

fn closed(settings: &ModuleSettings) -> Bench<DigitalInput> {
    let mut bench = Bench::new(DigitalInput::new(settings));
    bench.at(10, contact("I0", true)).at(10, contact("I1", true));
    bench
}

/// Figure 6. REQ-PLANT-020
#[test]
fn cross_short_when_the_inputs_have_sources_of_their_own_then_both_are_found() {
    let mut bench = closed(&two(["T0", "T1"]));
    bench.at(300, Stimulus::Fault(at("I0"), Fault::To(at("I1"))));
    assert_eq!(bench.read(600, &[Data(0), Data(1), Status(0), Status(1)]), [0, 0, 0, 0]);
    assert_eq!(bench.device.test_fault(0), TestFault::Cross);
}

/// Why the manual asks for two sources: with one, nothing is found. REQ-PLANT-020
#[test]
fn cross_short_when_the_inputs_share_a_source_then_it_is_not_found() {
    let mut bench = closed(&two(["T0", "T0"]));
    bench.at(300, Stimulus::Fault(at("I0"), Fault::To(at("I1"))));
    assert_eq!(bench.read(5000, &[Data(0), Data(1), Status(0), Status(1)]), [1, 1, 1, 1]);
}

/// An open contact hides a cross short until one closes. REQ-PLANT-020
#[test]
fn cross_short_when_one_contact_is_open_then_the_other_feeds_it_until_the_next_pulse() {
    let mut bench = Bench::new(DigitalInput::new(&two(["T0", "T1"])));
    bench.at(0, Stimulus::Fault(at("I0"), Fault::To(at("I1")))).at(40, contact("I0", true));
    assert_eq!(bench.read(40, &[Data(0), Data(1)]), [1, 1]);
    // The pulse of T1 at 180 ms finds input 1 on.
    assert_eq!(bench.read(179, &[Status(1)]), [1]);
    assert_eq!(bench.read(180, &[Data(1), Status(1)]), [0, 0]);
}

/// A short to 24 V that nobody looks for reads as a closed contact. REQ-PLANT-020
#[test]
fn short_to_24_v_when_the_input_is_not_pulse_tested_then_it_is_on_without_an_error() {
    let settings = ModuleSettings::new("1734-IB8S").point(at("I0"), &[("Mode", "SAFETY")]);
    let mut bench = Bench::new(DigitalInput::new(&settings));
    bench.at(100, Stimulus::Fault(at("I0"), Fault::ToSupply));
    assert_eq!(bench.read(5000, &[Data(0), Status(0)]), [1, 1]);
}

/// REQ-PLANT-021
#[test]
fn short_to_0_v_when_the_contact_is_closed_then_the_input_is_off_and_its_source_overloaded() {
    let mut bench = closed(&two(["T0", "T1"]));
    bench.at(300, Stimulus::Fault(at("I0"), Fault::ToCommon));
    assert_eq!(bench.read(300, &[Data(0), Status(0), TestStatus(0), TestStatus(1)]), [0, 1, 0, 1]);
    assert_eq!(bench.device.test_fault(0), TestFault::Overload);
}

/// An open wire cannot be told from an open contact. REQ-PLANT-021
#[test]
fn open_wire_when_the_contact_is_closed_then_the_input_is_off_without_an_error() {
    let mut bench = closed(&two(["T0", "T1"]));
    bench.at(300, Stimulus::Fault(at("I0"), Fault::Open));
    assert_eq!(bench.read(300, &[Data(0), Status(0), CombinedStatus]), [0, 1, 1]);
    bench.at(400, Stimulus::Repaired(at("I0")));
    assert_eq!(bench.read(400, &[Data(0)]), [1]);
}

/// A wrong test source gives failures of the pulse test. (1734-UM013, Configure the Safety Digital Inputs) REQ-PLANT-021
#[test]
fn pulse_test_when_no_pulse_can_come_then_the_input_has_an_error() {
    let steady = two(["T2", "T1"]).point(at("T2"), &[("Mode", "POWER_SUPPLY")]);
    let mut bench = closed(&steady);
    assert_eq!(bench.read(200, &[Data(0), Status(0)]), [0, 0]);
    let none = ModuleSettings::new("1734-IB8S").point(at("I0"), &[("Mode", "SAFETY_PULSE_TEST")]);
    let mut bench = Bench::new(DigitalInput::new(&none));
    assert_eq!(bench.read(0, &[Status(0)]), [0]);
    assert_eq!(bench.device.input_fault(0), InputFault::Configuration);
}

/// An error of one channel of a pair takes both. REQ-PLANT-013
#[test]
fn pair_when_one_channel_fails_its_pulse_test_then_both_are_safe_and_one_names_the_other() {
    let input = |source| [("Mode", "SAFETY_PULSE_TEST"), ("TestSource", source), ("Type", "EQUIVALENT")];
    let settings = ModuleSettings::new("1734-IB8S").point(at("I0"), &input("T0")).point(at("I1"), &input("T1"));
    let mut bench = closed(&settings);
    bench.at(300, Stimulus::Fault(at("I0"), Fault::ToSupply));
    assert_eq!(bench.read(600, &[Data(0), Data(1), Status(0), Status(1)]), [0, 0, 0, 0]);
    assert_eq!(bench.device.input_fault(0), InputFault::TestSignal);
    assert_eq!(bench.device.input_fault(1), InputFault::Partner);
}

/// REQ-PLANT-022
#[test]
fn field_power_when_lost_then_all_is_safe_and_returns_by_itself_after_the_latch_time() {
    let mut bench = closed(&two(["T0", "T1"]));
    let all = [Data(0), Data(1), Status(0), CombinedStatus, TestStatus(0), Power];
    assert_eq!(bench.read(300, &all), [1, 1, 1, 1, 1, 0]);
    bench.at(400, Stimulus::FieldPower(false));
    assert_eq!(bench.read(400, &all), [0, 0, 0, 0, 0, 1]);
    bench.at(500, Stimulus::FieldPower(true));
    assert_eq!(bench.read(1498, &all), [0, 0, 0, 0, 1, 0]);
    assert_eq!(bench.read(1499, &all), [1, 1, 1, 1, 1, 0]);
}

/// The safe state of a complementary pair is off and on. REQ-PLANT-022
#[test]
fn field_power_when_lost_at_a_complementary_pair_then_its_data_is_off_and_on() {
    let mut bench = Bench::new(DigitalInput::new(&pair("COMPLEMENTARY", "100")));
    bench.at(0, contact("I1", true)).at(100, Stimulus::FieldPower(false));
    assert_eq!(bench.read(5000, &[Data(0), Data(1), Status(0)]), [0, 1, 0]);
}

/// REQ-PLANT-023
#[test]
fn point_when_it_is_not_used_then_its_data_is_off_and_its_status_normal() {
    let mut bench = Bench::new(DigitalInput::new(&ModuleSettings::new("1734-IB8S")));
    assert!(twinrung_plant::Device::accepts(&bench.device, &contact("I0", true)).is_err());
    assert_eq!(bench.read(100, &[Data(0), Status(0), CombinedStatus]), [0, 1, 1]);
}
