//! Figures 5 to 11 of 1734-UM013 replayed: terminals in, data and status out. Times of our traces; the figures have no scale.

use twinrung_plant::Reading::{CombinedStatus, Data, Status};
use twinrung_plant::digital_input::{DigitalInput, InputFault, PULSE_PERIOD_MS};
use twinrung_plant::{Fault, ModuleSettings, Stimulus};

use super::support::{Bench, at, contact, pair};

fn tested() -> ModuleSettings {
    let input = |source| [("Mode", "SAFETY_PULSE_TEST"), ("TestSource", source)];
    ModuleSettings::new("1734-IB8S").point(at("I0"), &input("T0")).point(at("I1"), &input("T1"))
}

/// Figure 5. REQ-PLANT-012
#[test]
fn input_when_healthy_then_test_pulses_never_show_in_its_data() {
    let mut bench = Bench::new(DigitalInput::new(&tested()));
    bench.at(10, contact("I0", true));
    assert_eq!(bench.changes(10 * PULSE_PERIOD_MS, Data(0)), [(10, 1)]);
    assert_eq!(bench.changes(20 * PULSE_PERIOD_MS, Status(0)), [(1441, 1)]);
}

/// Figure 7, normal operation. REQ-PLANT-012
#[test]
fn single_input_when_its_contact_moves_then_its_data_follows_and_its_status_stays() {
    let mut bench = Bench::new(DigitalInput::new(&tested()));
    bench.at(100, contact("I0", true));
    assert_eq!(bench.read(100, &[Data(0), Status(0)]), [1, 1]);
    bench.at(500, contact("I0", false));
    assert_eq!(bench.read(500, &[Data(0), Status(0)]), [0, 1]);
}

/// Figure 7, fault detection and recovery: a short to 24 V is found by the next test pulse; data stays off until the cause is gone,
/// the input is off, and the error latch time has run out. REQ-PLANT-013
#[test]
fn single_input_when_shorted_to_24_v_then_it_is_off_until_repaired_opened_and_latched() {
    let mut bench = Bench::new(DigitalInput::new(&tested()));
    bench.at(10, contact("I0", true)).at(200, Stimulus::Fault(at("I0"), Fault::ToSupply));
    assert_eq!(bench.read(287, &[Data(0), Status(0)]), [1, 1]);
    // T0 pulses at 0, 144, 288 ms.
    assert_eq!(bench.read(288, &[Data(0), Status(0), CombinedStatus]), [0, 0, 0]);
    assert_eq!(bench.device.input_fault(0), InputFault::TestSignal);
    // The cause is gone for the module with the pulse at 576 ms; the input is still closed.
    bench.at(500, Stimulus::Repaired(at("I0")));
    assert_eq!(bench.read(3000, &[Data(0), Status(0)]), [0, 0]);
    bench.at(3001, contact("I0", false));
    assert_eq!(bench.read(3001, &[Data(0), Status(0)]), [0, 1]);
    bench.at(3100, contact("I0", true));
    assert_eq!(bench.read(3100, &[Data(0), Status(0)]), [1, 1]);
}

/// Figure 7, the error latch time: 1000 ms after the last pulse that failed. REQ-PLANT-013
#[test]
fn single_input_when_repaired_and_open_then_its_status_returns_with_the_latch_time() {
    let mut bench = Bench::new(DigitalInput::new(&tested()));
    bench.at(10, contact("I0", true)).at(200, Stimulus::Fault(at("I0"), Fault::ToSupply));
    bench.at(300, contact("I0", false)).at(300, Stimulus::Repaired(at("I0")));
    // The failure of 288 ms counts until the pulse of 432 ms passes.
    assert_eq!(bench.changes(2000, Status(0)), [(300, 0), (431 + 1000, 1)]);
}

/// The time that the point sets, and not the default, counts. REQ-PLANT-013
#[test]
fn single_input_when_its_latch_time_is_set_then_its_status_returns_with_that_time() {
    for (text, latch_ms) in [("50", 50), ("5000", 5000), ("65530", 65_530)] {
        let settings = [("Mode", "SAFETY_PULSE_TEST"), ("TestSource", "T0"), ("ErrorLatchTime", text)];
        let mut bench = Bench::new(DigitalInput::new(&ModuleSettings::new("1734-IB8S").point(at("I0"), &settings)));
        bench.at(10, contact("I0", true)).at(200, Stimulus::Fault(at("I0"), Fault::ToSupply));
        bench.at(300, contact("I0", false)).at(300, Stimulus::Repaired(at("I0")));
        assert_eq!(bench.changes(70_000, Status(0)), [(300, 0), (431 + latch_ms, 1)], "{text}");
    }
}

/// Figure 8, normal operation: data is on when both are on, and off with the first that is off. REQ-PLANT-014
#[test]
fn equivalent_pair_when_both_follow_within_the_time_then_data_is_on_while_both_are() {
    let mut bench = Bench::new(DigitalInput::new(&pair("EQUIVALENT", "100")));
    bench.at(100, contact("I0", true));
    assert_eq!(bench.read(149, &[Data(0), Data(1), Status(0)]), [0, 0, 1]);
    bench.at(150, contact("I1", true));
    assert_eq!(bench.read(150, &[Data(0), Data(1)]), [1, 1]);
    bench.at(400, contact("I1", false));
    assert_eq!(bench.read(400, &[Data(0), Data(1), Status(0), Status(1)]), [0, 0, 1, 1]);
    bench.at(450, contact("I0", false));
    assert_eq!(bench.changes(2000, Status(0)), [(450, 1)]);
}

/// Figure 8, fault detection: a fault after the discrepancy time; normal when both are off and the latch time has run out.
/// REQ-PLANT-014
#[test]
fn equivalent_pair_when_one_does_not_follow_then_both_fault_after_the_discrepancy_time() {
    let mut bench = Bench::new(DigitalInput::new(&pair("EQUIVALENT", "100")));
    bench.at(100, contact("I0", true));
    assert_eq!(bench.changes(500, Status(1)), [(100, 1), (201, 0)]);
    assert_eq!(bench.device.input_fault(0), InputFault::Discrepancy);
    bench.at(600, contact("I1", true));
    // Both are on now: no discrepancy, but not the safe state.
    assert_eq!(bench.read(3000, &[Data(0), Data(1), Status(0), Status(1)]), [0, 0, 0, 0]);
    bench.at(3100, contact("I0", false)).at(3100, contact("I1", false));
    assert_eq!(bench.read(3100, &[Status(0), Status(1)]), [1, 1]);
}

/// Figure 9, normal operation and fault detection. REQ-PLANT-014
#[test]
fn complementary_pair_when_one_does_not_follow_then_data_goes_off_on_and_both_fault() {
    let mut bench = Bench::new(DigitalInput::new(&pair("COMPLEMENTARY", "100")));
    bench.at(0, contact("I1", true));
    bench.at(100, contact("I0", true)).at(150, contact("I1", false));
    assert_eq!(bench.read(150, &[Data(0), Data(1), Status(0)]), [1, 0, 1]);
    bench.at(400, contact("I0", false));
    assert_eq!(bench.read(400, &[Data(0), Data(1), Status(0)]), [0, 1, 1]);
    assert_eq!(bench.read(500, &[Status(0), Status(1)]), [1, 1]);
    assert_eq!(bench.read(501, &[Data(0), Data(1), Status(0), Status(1)]), [0, 1, 0, 0]);
    bench.at(600, contact("I1", true));
    assert_eq!(bench.changes(3000, Status(0)), [(600, 0), (599 + 1000, 1)]);
}

/// `Cycle inputs`: one channel leaves the active state and returns alone. No fault, and data stays off until both were off.
/// REQ-PLANT-015
#[test]
fn equivalent_pair_when_one_channel_leaves_and_returns_alone_then_the_inputs_must_be_cycled() {
    let mut bench = Bench::new(DigitalInput::new(&pair("EQUIVALENT", "0")));
    bench.at(100, contact("I0", true)).at(100, contact("I1", true));
    bench.at(200, contact("I0", false)).at(5000, contact("I0", true));
    assert_eq!(bench.read(6000, &[Data(0), Data(1), Status(0), Status(1)]), [0, 0, 1, 1]);
    bench.at(6100, contact("I0", false)).at(6200, contact("I1", false));
    bench.at(6300, contact("I0", true)).at(6300, contact("I1", true));
    assert_eq!(bench.read(6300, &[Data(0), Data(1)]), [1, 1]);
}

/// A discrepancy time of 0 is without end. REQ-PLANT-015
#[test]
fn equivalent_pair_when_its_discrepancy_time_is_0_then_it_never_faults() {
    let mut bench = Bench::new(DigitalInput::new(&pair("EQUIVALENT", "0")));
    bench.at(100, contact("I0", true));
    assert_eq!(bench.read(100_000, &[Data(0), Status(0), Status(1)]), [0, 1, 1]);
}

fn delayed(key: &str) -> ModuleSettings {
    ModuleSettings::new("1734-IB8S").point(at("I0"), &[("Mode", "SAFETY"), (key, "24")])
}

/// Figure 10: a pulse shorter than the on-delay is not seen; a contact that stays is seen after it. REQ-PLANT-016
#[test]
fn input_when_it_has_an_on_delay_then_only_what_lasts_turns_it_on() {
    let mut bench = Bench::new(DigitalInput::new(&delayed("OffOn")));
    bench.at(100, contact("I0", true)).at(123, contact("I0", false)).at(200, contact("I0", true));
    assert_eq!(bench.changes(400, Data(0)), [(200, 0), (224, 1)]);
    bench.at(500, contact("I0", false));
    assert_eq!(bench.read(500, &[Data(0)]), [0]);
}

/// Figure 11: a gap shorter than the off-delay is not seen; a contact that stays open is seen after it. REQ-PLANT-016
#[test]
fn input_when_it_has_an_off_delay_then_only_what_lasts_turns_it_off() {
    let mut bench = Bench::new(DigitalInput::new(&delayed("OnOff")));
    bench.at(100, contact("I0", true));
    assert_eq!(bench.read(100, &[Data(0)]), [1]);
    bench.at(200, contact("I0", false)).at(223, contact("I0", true));
    assert_eq!(bench.read(299, &[Data(0)]), [1]);
    bench.at(300, contact("I0", false));
    assert_eq!(bench.changes(400, Data(0)), [(300, 1), (324, 0)]);
}
