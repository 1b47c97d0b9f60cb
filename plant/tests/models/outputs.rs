//! 1734-OB8S: Figures 18 to 20 of 1734-UM013, recovery, wiring faults. REQ-PLANT-030 to REQ-PLANT-033

use twinrung_plant::Reading::{CombinedStatus, Power, Readback, Status};
use twinrung_plant::digital_output::{DigitalOutput, OutputFault, PULSE_OFFSET_MS, PULSE_PERIOD_MS};
use twinrung_plant::{Command, Device, Fault, ModuleSettings, Stimulus};

use super::support::{Bench, at};

const O0: Command = Command::Output(0);
const O1: Command = Command::Output(1);
const BOTH_ON: [(Command, bool); 2] = [(O0, true), (O1, true)];
const BOTH_OFF: [(Command, bool); 2] = [(O0, false), (O1, false)];

fn module(mode: &str, channel: &str) -> Bench<DigitalOutput> {
    let settings = [("Mode", mode), ("Channel", channel)];
    let module = ModuleSettings::new("1734-OB8S").point(at("O0"), &settings).point(at("O1"), &settings);
    Bench::new(DigitalOutput::new(&module))
}

/// Figure 19, normal operation. REQ-PLANT-030
#[test]
fn dual_outputs_when_both_are_commanded_then_both_switch_and_are_normal() {
    let mut bench = module("SAFETY_PULSE_TEST", "DUAL");
    bench.command(100, &BOTH_ON);
    assert_eq!(bench.read(100, &[Readback(0), Readback(1), Status(0), Status(1)]), [1, 1, 1, 1]);
    bench.command(500, &BOTH_OFF);
    assert_eq!(bench.read(500, &[Readback(0), Readback(1), CombinedStatus]), [0, 0, 1]);
}

/// Figure 18: test pulses of a healthy output find nothing. REQ-PLANT-030
#[test]
fn output_when_healthy_then_test_pulses_never_show() {
    let mut bench = module("SAFETY_PULSE_TEST", "SINGLE");
    bench.command(100, &BOTH_ON);
    assert_eq!(bench.changes(10 * PULSE_PERIOD_MS, CombinedStatus), [(100, 1)]);
}

/// A pair that is not commanded alike: the module declares a channel fault. REQ-PLANT-030
#[test]
fn dual_outputs_when_commanded_differently_then_both_are_off_and_faulted_until_both_are_off() {
    let mut bench = module("SAFETY", "DUAL");
    bench.command(100, &[(O0, true), (O1, false)]);
    assert_eq!(bench.read(100, &[Readback(0), Readback(1), Status(0), Status(1)]), [0, 0, 0, 0]);
    assert_eq!(bench.device.fault(0), OutputFault::DualChannelViolation);
    bench.command(200, &BOTH_ON);
    assert_eq!(bench.read(3000, &[Readback(0), Status(0)]), [0, 0]);
    bench.command(3100, &BOTH_OFF);
    assert_eq!(bench.read(3100, &[Status(0), Status(1)]), [1, 1]);
}

/// Figure 20 and Figure 19, fault detection: a short to 0 V takes the channel, and its partner. REQ-PLANT-031
#[test]
fn output_when_its_wire_touches_0_v_then_it_is_off_and_its_pair_too() {
    let mut single = module("SAFETY", "SINGLE");
    single.command(100, &BOTH_ON).at(200, Stimulus::Fault(at("O0"), Fault::ToCommon));
    assert_eq!(single.read(200, &[Readback(0), Readback(1), Status(0), Status(1)]), [0, 1, 0, 1]);
    let mut dual = module("SAFETY", "DUAL");
    dual.command(100, &BOTH_ON).at(200, Stimulus::Fault(at("O0"), Fault::ToCommon));
    assert_eq!(dual.read(200, &[Readback(0), Readback(1), Status(0), Status(1)]), [0, 0, 0, 0]);
    assert_eq!(dual.device.fault(0), OutputFault::OverCurrent);
    assert_eq!(dual.device.fault(1), OutputFault::Partner);
}

/// Safety Output Fault Recovery: cause gone, commanded off, error latch time. REQ-PLANT-032
#[test]
fn output_when_repaired_then_it_returns_after_off_was_commanded_and_the_latch_time() {
    let mut bench = module("SAFETY", "DUAL");
    bench.command(100, &BOTH_ON).at(200, Stimulus::Fault(at("O0"), Fault::ToCommon));
    bench.at(300, Stimulus::Repaired(at("O0")));
    assert_eq!(bench.read(5000, &[Readback(0), Status(0)]), [0, 0]);
    bench.command(5001, &BOTH_OFF);
    assert_eq!(bench.read(5001, &[Status(0), Status(1)]), [1, 1]);
    bench.command(5100, &BOTH_ON);
    assert_eq!(bench.read(5100, &[Readback(0), Readback(1)]), [1, 1]);
}

/// The time that the point sets, and not the default, counts. REQ-PLANT-032
#[test]
fn output_when_its_latch_time_is_set_then_its_status_returns_with_that_time() {
    for (text, latch_ms) in [("500", 500), ("5000", 5000)] {
        let settings = [("Mode", "SAFETY"), ("Channel", "SINGLE"), ("ErrorLatchTime", text)];
        let mut bench = Bench::new(DigitalOutput::new(&ModuleSettings::new("1734-OB8S").point(at("O0"), &settings)));
        bench.command(100, &[(O0, true)]).at(200, Stimulus::Fault(at("O0"), Fault::ToCommon));
        bench.at(300, Stimulus::Repaired(at("O0"))).command(300, &[(O0, false)]);
        // An output that is off shows no short to 0 V: the last look that finds it is that at 200 ms.
        assert_eq!(bench.changes(10_000, Status(0)), [(300, 0), (200 + latch_ms, 1)], "{text}");
    }
}

/// A short to 24 V while the output is on: the next test pulse finds it. Stuck high ends with the power of the module alone.
/// REQ-PLANT-031, REQ-PLANT-032
#[test]
fn output_when_shorted_to_24_v_then_its_pulse_finds_it_and_only_power_clears_it() {
    let mut bench = module("SAFETY_PULSE_TEST", "DUAL");
    bench.command(100, &BOTH_ON).at(200, Stimulus::Fault(at("O1"), Fault::ToSupply));
    let pulse = PULSE_PERIOD_MS + PULSE_OFFSET_MS;
    assert_eq!(bench.read(pulse - 1, &[Status(0), Status(1)]), [1, 1]);
    assert_eq!(bench.read(pulse, &[Status(0), Status(1), Readback(0)]), [0, 0, 0]);
    // Nothing can take the 24 V away from the wire: the read-back shows it.
    assert_eq!(bench.read(1000, &[Readback(1)]), [1]);
    bench.at(1100, Stimulus::Repaired(at("O1"))).command(1100, &BOTH_OFF);
    assert_eq!(bench.read(60_000, &[Status(0), Status(1)]), [0, 0]);
    bench.device.power_up(60_001);
    assert_eq!(bench.read(60_001, &[Status(0), Status(1)]), [1, 1]);
}

/// Without test pulses a short to 24 V hides as long as the output is on. REQ-PLANT-031
#[test]
fn output_when_shorted_to_24_v_without_test_pulses_then_it_is_found_when_commanded_off() {
    let mut bench = module("SAFETY", "SINGLE");
    bench.command(100, &BOTH_ON).at(200, Stimulus::Fault(at("O0"), Fault::ToSupply));
    assert_eq!(bench.read(5000, &[Status(0)]), [1]);
    bench.command(5001, &BOTH_OFF);
    assert_eq!(bench.read(5001, &[Status(0), Status(1), Readback(0)]), [0, 1, 1]);
    assert_eq!(bench.device.fault(0), OutputFault::OutputOn);
}

/// REQ-PLANT-031
#[test]
fn outputs_when_their_wires_touch_then_the_test_pulse_of_either_finds_it() {
    let mut bench = module("SAFETY_PULSE_TEST", "DUAL");
    bench.command(100, &BOTH_ON).at(200, Stimulus::Fault(at("O0"), Fault::To(at("O1"))));
    assert_eq!(bench.read(PULSE_PERIOD_MS, &[Status(0), Status(1), Readback(0)]), [0, 0, 0]);
    bench.at(600, Stimulus::Repaired(at("O1"))).command(600, &BOTH_OFF);
    assert_eq!(bench.read(1700, &[Status(0), Status(1)]), [1, 1]);
}

/// The module sees its terminal, not the actuator. REQ-PLANT-031
#[test]
fn output_when_its_wire_is_broken_then_the_actuator_is_off_and_the_module_normal() {
    let mut bench = module("SAFETY_PULSE_TEST", "SINGLE");
    bench.command(100, &BOTH_ON).at(200, Stimulus::Fault(at("O0"), Fault::Open));
    assert_eq!(bench.read(2000, &[Readback(0), Status(0)]), [1, 1]);
    assert_eq!(bench.device.is_high(at("O0")), Some(false));
    assert_eq!(bench.device.is_high(at("O1")), Some(true));
}

/// REQ-PLANT-033
#[test]
fn outputs_when_the_field_power_or_the_connection_is_lost_then_they_are_off() {
    let mut bench = module("SAFETY", "DUAL");
    bench.command(100, &BOTH_ON).at(200, Stimulus::FieldPower(false));
    assert_eq!(bench.read(200, &[Readback(0), Status(0), CombinedStatus, Power]), [0, 0, 0, 1]);
    bench.at(300, Stimulus::FieldPower(true));
    assert_eq!(bench.read(300, &[Readback(0), Status(0), Power]), [1, 1, 0]);
    bench.device.output_connection_lost(301);
    assert_eq!(bench.read(301, &[Readback(0), Readback(1), Status(0)]), [0, 0, 1]);
}

/// Single outputs whose wires touch: the one that is off finds the 24 V of the other, and is well again when the wires are parted.
/// Only what the field power itself holds high is stuck. REQ-PLANT-032
#[test]
fn single_outputs_when_their_wires_touched_then_the_one_that_was_off_is_not_stuck_for_good() {
    let mut bench = module("SAFETY", "SINGLE");
    bench.at(100, Stimulus::Fault(at("O0"), Fault::To(at("O1")))).command(200, &[(O0, false), (O1, true)]);
    assert_eq!(bench.read(200, &[Status(0), Readback(0)]), [0, 1]);
    assert_eq!(bench.device.fault(0), OutputFault::OutputOn);
    bench.at(300, Stimulus::Repaired(at("O0")));
    assert_eq!(bench.read(5000, &[Status(0), Status(1), Readback(0)]), [1, 1, 0]);
}

/// REQ-PLANT-033
#[test]
fn outputs_when_the_field_power_is_back_then_they_follow_their_command_again() {
    let mut bench = module("SAFETY", "DUAL");
    bench.command(100, &BOTH_ON).at(200, Stimulus::FieldPower(false)).command(300, &BOTH_OFF);
    bench.at(400, Stimulus::FieldPower(true));
    assert_eq!(bench.read(400, &[Readback(0), Readback(1), Status(0)]), [0, 0, 1]);
    bench.command(500, &BOTH_ON).at(600, Stimulus::FieldPower(false)).at(700, Stimulus::FieldPower(true));
    assert_eq!(bench.read(700, &[Readback(0), Readback(1), Status(0)]), [1, 1, 1]);
}
