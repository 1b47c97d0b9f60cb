//! 1734-IE4S: Figures 12, 13, 14, 16 and 17 of 1734-UM013, its ranges and its errors. REQ-PLANT-040 to REQ-PLANT-047

use twinrung_plant::Reading::{
    CombinedAlarm, Data, DualLow, FaultReason, High, HighHigh, Low, LowLow, Overfrequency, Power, Status,
    Underfrequency,
};
use twinrung_plant::analog_input::{AnalogInput, OVERCURRENT_MS, SENSOR_TEST_MS};
use twinrung_plant::{Command, Device, Fault, ModuleSettings, Refusal, Stimulus};

use super::support::{Bench, amount, at};

type Settings = Vec<(&'static str, &'static str)>;

fn channel(range: &'static str, more: &[(&'static str, &'static str)]) -> Settings {
    [&[("Mode", "SAFETY"), ("Range", range), ("SensorPower", "EXTERNAL"), ("Filter", "HZ_50")], more].concat()
}

fn module(channels: &[(&str, Settings)]) -> Bench<AnalogInput> {
    let none = ModuleSettings::new("1734-IE4S");
    let settings = channels.iter().fold(none, |module, (name, settings)| module.point(at(name), settings));
    Bench::new(AnalogInput::new(&settings))
}

fn one(range: &'static str, more: &[(&'static str, &'static str)]) -> Bench<AnalogInput> {
    module(&[("C0", channel(range, more))])
}

/// The manual's example of scaling. REQ-PLANT-040
#[test]
fn scaling_when_0_to_10_v_is_0_to_10000_then_a_volt_is_1000() {
    for (millivolts, data) in [(1_000, 1_000), (5_500, 5_500), (10_000, 10_000)] {
        let mut bench = one("V_0_10", &[]);
        bench.at(0, amount("C0", millivolts));
        assert_eq!(bench.read(0, &[Data(0), Status(0)]), [data, 1], "{millivolts} mV");
    }
}

/// Two amounts with what they give.
type Ends = [(i64, i32); 2];

/// Range; an amount within at either end and its data; the next amounts outside. The thresholds of the specifications.
const RANGES: [(&str, Ends, Ends); 6] = [
    ("V_10", [(-10_000, 0), (10_000, 10_000)], [(-10_001, 3), (10_001, 2)]),
    ("V_5", [(-5_000, 0), (5_000, 10_000)], [(-5_001, 3), (5_001, 2)]),
    ("V_0_5", [(250, 500), (5_000, 10_000)], [(249, 3), (5_001, 2)]),
    ("V_0_10", [(500, 500), (10_000, 10_000)], [(499, 3), (10_001, 2)]),
    ("MA_4_20", [(4_000, 0), (20_000, 10_000)], [(3_999, 3), (20_001, 2)]),
    ("MA_0_20", [(500, 250), (20_000, 10_000)], [(499, 3), (20_001, 2)]),
];

/// REQ-PLANT-041
#[test]
fn ranges_when_an_amount_is_at_an_end_then_it_is_valid_and_beyond_it_is_0_with_the_reason() {
    for (range, within, beyond) in RANGES {
        for (given, data) in within {
            let mut bench = one(range, &[]);
            bench.at(0, amount("C0", given));
            assert_eq!(bench.read(0, &[Data(0), Status(0), FaultReason(0)]), [data, 1, 1], "{range} {given}");
        }
        for (given, reason) in beyond {
            let mut bench = one(range, &[]);
            bench.at(0, amount("C0", given));
            assert_eq!(bench.read(0, &[Data(0), Status(0), FaultReason(0)]), [0, 0, reason], "{range} {given}");
        }
    }
}

/// A broken wire is found where 0 is outside the range, and only there. REQ-PLANT-041
#[test]
fn broken_wire_when_the_range_holds_0_then_it_is_not_found() {
    for (range, given, found) in
        [("MA_4_20", 12_000, [0, 0, 3]), ("V_0_10", 5_000, [0, 0, 3]), ("V_10", 5_000, [5000, 1, 1])]
    {
        let mut bench = one(range, &[]);
        bench.at(0, amount("C0", given)).at(100, Stimulus::Fault(at("C0"), Fault::Open));
        assert_eq!(bench.read(2000, &[Data(0), Status(0), FaultReason(0)]), found, "{range}");
    }
}

/// REQ-PLANT-041
#[test]
fn error_when_its_cause_is_gone_then_the_status_returns_after_the_latch_time() {
    let mut bench = one("MA_4_20", &[]);
    bench.at(0, amount("C0", 12_000)).at(1000, Stimulus::Fault(at("C0"), Fault::ToSupply));
    assert_eq!(bench.read(2000, &[Data(0), Status(0), FaultReason(0)]), [0, 0, 2]);
    bench.at(3000, Stimulus::Repaired(at("C0")));
    let changes = bench.changes(6000, Status(0));
    assert_eq!(changes.len(), 2);
    // The filter comes back into the range within some ms, then 1000 ms run.
    assert!((4000..4050).contains(&changes[1].0), "{changes:?}");
}

/// The time that the channel sets, and not the default, counts. REQ-PLANT-041
#[test]
fn error_when_its_latch_time_is_set_then_the_status_returns_after_that_time() {
    for (text, latch_ms) in [("200", 200), ("5000", 5000)] {
        let mut bench = one("MA_4_20", &[("ErrorLatchTime", text)]);
        bench.at(0, amount("C0", 12_000)).at(1000, Stimulus::Fault(at("C0"), Fault::ToSupply));
        bench.at(3000, Stimulus::Repaired(at("C0")));
        let changes = bench.changes(10_000, Status(0));
        assert_eq!(changes.len(), 2, "{changes:?}");
        assert!((3000 + latch_ms..3050 + latch_ms).contains(&changes[1].0), "{changes:?}");
    }
}

/// Figure 12 and the table of step responses: 63 % of a step. REQ-PLANT-042
#[test]
fn filter_when_the_input_steps_then_63_percent_are_there_at_the_time_of_the_manual() {
    for (filter, time_ms) in [("HZ_1", 450), ("HZ_5", 125), ("HZ_10", 72), ("HZ_50", 25)] {
        let settings = vec![("Mode", "SAFETY"), ("Range", "V_10"), ("SensorPower", "EXTERNAL"), ("Filter", filter)];
        let mut bench = module(&[("C0", settings)]);
        bench.at(0, amount("C0", 0)).at(1000, amount("C0", 10_000));
        // 0 V is 5000 and 10 V 10000: 63.2 % of the step are 8160.
        assert!(bench.read(1000 + time_ms - 3, &[Data(0)])[0] < 8160, "{filter}");
        assert!(bench.read(1000 + time_ms + 1, &[Data(0)])[0] >= 8160, "{filter}");
    }
}

/// Figure 13: an alarm comes beyond its level and goes beyond the deadband. REQ-PLANT-043
#[test]
fn alarms_when_the_value_passes_levels_and_deadbands_then_the_figure_is_replayed() {
    let alarms = [
        ("Alarms", "ENABLE"),
        ("HighHighAlarm", "9000"),
        ("HighAlarm", "8000"),
        ("LowAlarm", "3000"),
        ("LowLowAlarm", "2000"),
        ("HighHighLowLowDeadband", "200"),
        ("HighLowDeadband", "100"),
    ];
    let all = [HighHigh(0), High(0), Low(0), LowLow(0), CombinedAlarm(0)];
    let mut bench = one("V_0_10", &alarms);
    let trace: [(i64, [i32; 5]); 10] = [
        (5_000, [1, 1, 1, 1, 1]),
        (8_001, [1, 0, 1, 1, 0]),
        (9_001, [0, 0, 1, 1, 0]),
        (8_801, [0, 0, 1, 1, 0]),
        (8_800, [1, 0, 1, 1, 0]),
        (7_900, [1, 1, 1, 1, 1]),
        (2_999, [1, 1, 0, 1, 0]),
        (1_999, [1, 1, 0, 0, 0]),
        (2_200, [1, 1, 0, 1, 0]),
        (3_100, [1, 1, 1, 1, 1]),
    ];
    for (step, (given, expected)) in (0..).zip(trace) {
        bench.at(step * 1000, amount("C0", given));
        assert_eq!(bench.read(step * 1000 + 999, &all), expected, "{given} mV");
    }
}

/// REQ-PLANT-043
#[test]
fn alarms_when_not_enabled_then_none_comes() {
    let mut bench = one("V_0_10", &[("HighAlarm", "100")]);
    bench.at(0, amount("C0", 9_000));
    assert_eq!(bench.read(100, &[High(0), CombinedAlarm(0)]), [1, 1]);
}

/// Figure 14, A to F. REQ-PLANT-044
#[test]
fn equivalent_channels_when_they_differ_and_agree_then_the_figure_is_replayed() {
    let settings = channel(
        "V_0_10",
        &[("Type", "EQUIVALENT"), ("DiscrepancyTime", "200"), ("DiscrepancyDeadband", "500"), ("ChannelOffset", "100")],
    );
    let mut bench = module(&[("C0", settings.clone()), ("C1", settings)]);
    bench.at(0, amount("C0", 5_000)).at(0, amount("C1", 5_000));
    assert_eq!(bench.read(999, &[Status(0), Status(1)]), [1, 1]);
    // A: they differ by more than the deadband; B: the timer has run out.
    bench.at(1000, amount("C0", 7_000));
    let fault = bench.changes(1500, Status(0));
    assert!(fault.len() == 2 && (1201..1240).contains(&fault[1].0), "{fault:?}");
    // Both go on to report what they measure.
    assert_eq!(bench.read(1600, &[Data(0), Data(1), Status(1), FaultReason(0)]), [7_000, 5_000, 0, 5]);
    // C: they agree again; D: they have agreed for the discrepancy time.
    bench.at(2000, amount("C0", 5_000));
    let cleared = bench.changes(2500, Status(1));
    assert!(cleared.len() == 2 && (2200..2240).contains(&cleared[1].0), "{cleared:?}");
    // A difference shorter than the time is nothing; E and F: a longer one is a fault again.
    bench.at(3000, amount("C0", 7_000)).at(3150, amount("C0", 5_000));
    assert_eq!(bench.read(3900, &[Status(0), Status(1)]), [1, 1]);
    bench.at(4000, amount("C0", 7_000));
    assert_eq!(bench.read(4300, &[Status(0), Status(1)]), [0, 0]);
}

/// The offset is added to the second channel: 5000 and 4400 with 100 differ by 500. REQ-PLANT-044
#[test]
fn equivalent_channels_when_the_offset_brings_them_within_the_deadband_then_they_agree() {
    let settings =
        channel("V_0_10", &[("Type", "EQUIVALENT"), ("DiscrepancyDeadband", "500"), ("ChannelOffset", "100")]);
    let mut bench = module(&[("C0", settings.clone()), ("C1", settings)]);
    bench.at(0, amount("C0", 5_000)).at(0, amount("C1", 4_400));
    assert_eq!(bench.read(5000, &[Status(0), Status(1)]), [1, 1]);
    bench.at(5001, amount("C1", 4_390));
    assert_eq!(bench.read(8000, &[Status(0), Status(1)]), [0, 0]);
}

/// REQ-PLANT-044
#[test]
fn equivalent_channels_when_one_has_an_error_then_the_other_names_it_and_reports_on() {
    let settings = channel("MA_4_20", &[("Type", "EQUIVALENT"), ("DiscrepancyDeadband", "30000")]);
    let mut bench = module(&[("C0", settings.clone()), ("C1", settings)]);
    bench.at(0, amount("C0", 12_000)).at(0, amount("C1", 12_000));
    bench.at(500, Stimulus::Fault(at("C0"), Fault::Open));
    assert_eq!(bench.read(1500, &[Data(0), Status(0), FaultReason(0)]), [0, 0, 3]);
    assert_eq!(bench.read(1500, &[Data(1), Status(1), FaultReason(1)]), [5_000, 0, 6]);
}

/// Figure 16: either edge gives the frequency. REQ-PLANT-045
#[test]
fn tachometer_when_pulses_come_then_it_reports_their_frequency() {
    for trigger in ["FALLING", "RISING"] {
        let mut bench = one("TACHOMETER", &[("TachometerTrigger", trigger)]);
        bench.at(0, amount("C0", 250_000));
        assert_eq!(bench.read(500, &[Data(0), Status(0), Overfrequency(0), Underfrequency(0)]), [250, 1, 1, 1]);
    }
}

/// REQ-PLANT-045
#[test]
fn tachometer_when_slower_than_1_hz_then_it_reports_0_and_underfrequency() {
    let mut bench = one("TACHOMETER", &[]);
    assert_eq!(bench.read(100, &[Data(0), Underfrequency(0)]), [0, 0]);
    bench.at(100, amount("C0", 1_000));
    assert_eq!(bench.read(4000, &[Data(0), Underfrequency(0)]), [1, 1]);
    bench.at(4000, amount("C0", 980));
    assert_eq!(bench.read(8000, &[Data(0), Underfrequency(0)]), [0, 0]);
}

/// Figure 17, A to C and the reset. REQ-PLANT-046
#[test]
fn tachometer_when_faster_than_1_khz_then_it_is_latched_until_the_reset() {
    const RESET: Command = Command::ResetTachometer(0);
    let all = [Data(0), Overfrequency(0)];
    let mut bench = one("TACHOMETER", &[]);
    // At A the frequency is below 1 Hz: none is seen yet, and nothing is too fast.
    bench.at(0, amount("C0", 500));
    assert_eq!(bench.read(2500, &[Data(0), Overfrequency(0), Underfrequency(0)]), [0, 1, 0]);
    bench.at(2600, amount("C0", 900_000));
    assert_eq!(bench.read(3200, &all), [900, 1]);
    bench.at(4000, amount("C0", 1_200_000));
    assert_eq!(bench.read(4003, &all), [1000, 0]);
    // A reset while it is too fast: within range for a moment, then not again.
    bench.command(4100, &[(RESET, true)]);
    assert_eq!(bench.read(4100, &[Overfrequency(0)]), [1]);
    assert_eq!(bench.read(4103, &all), [1000, 0]);
    // Slow again, and still latched: the reset counts its edge alone.
    bench.at(5000, amount("C0", 500_000));
    assert_eq!(bench.read(6000, &all), [1000, 0]);
    bench.command(6001, &[(RESET, false)]).command(6100, &[(RESET, true)]);
    assert_eq!(bench.read(6500, &all), [500, 1]);
}

fn two_tachometers() -> Bench<AnalogInput> {
    let settings = channel("TACHOMETER", &[("TachometerDualLow", "ON")]);
    module(&[("C0", settings.clone()), ("C1", settings)])
}

/// Figure 15. REQ-PLANT-047
#[test]
fn tachometers_when_their_pulses_alternate_then_both_are_normal_and_a_cross_short_is_dual_low() {
    let mut bench = two_tachometers();
    bench.at(0, amount("C0", 100_000)).at(0, amount("C1", 100_000));
    assert_eq!(bench.read(2000, &[Status(0), Status(1), DualLow(0), DualLow(1)]), [1, 1, 1, 1]);
    bench.at(2001, Stimulus::Fault(at("C0"), Fault::To(at("C1"))));
    assert_eq!(bench.read(2050, &[Status(0), Status(1), DualLow(0), DualLow(1)]), [0, 0, 0, 0]);
    assert_eq!(bench.read(2050, &[Data(0), FaultReason(0), FaultReason(1)]), [0, 109, 109]);
}

/// The sensor supply: tested at power-up, then watched. REQ-PLANT-047
#[test]
fn sensor_supply_when_shorted_or_open_then_its_channel_has_an_error() {
    let settings = vec![("Mode", "SAFETY"), ("Range", "MA_4_20"), ("Filter", "HZ_50")];
    let of = |fault: Fault| {
        let mut bench = module(&[("C0", settings.clone())]);
        bench.at(0, amount("C0", 12_000));
        assert_eq!(bench.read(SENSOR_TEST_MS - 1, &[Status(0)]), [0]);
        assert_eq!(bench.read(SENSOR_TEST_MS, &[Data(0), Status(0)]), [5_000, 1]);
        bench.at(1000, Stimulus::Fault(at("S0"), fault));
        let found = bench.read(1500, &[Data(0), Status(0), FaultReason(0)]);
        bench.at(2000, Stimulus::Repaired(at("S0")));
        let back = bench.changes(2000 + OVERCURRENT_MS + 2000, Status(0));
        (found, back.last().copied())
    };
    let (found, back) = of(Fault::Open);
    assert_eq!(found, [0, 0, 101]);
    assert!(back.is_some_and(|(time, status)| status == 1 && (3000..3050).contains(&time)), "{back:?}");
    let (found, back) = of(Fault::ToCommon);
    assert_eq!(found, [0, 0, 100]);
    let longest = 2000 + 1000 + OVERCURRENT_MS;
    assert!(back.is_some_and(|(time, status)| status == 1 && time >= longest - 2), "{back:?}");
}

/// REQ-PLANT-047
#[test]
fn field_power_when_lost_then_every_channel_is_0_with_its_reason() {
    let mut bench = one("MA_4_20", &[]);
    bench.at(0, amount("C0", 12_000)).at(100, Stimulus::FieldPower(false));
    assert_eq!(bench.read(100, &[Data(0), Status(0), FaultReason(0), Power]), [0, 0, 125, 0]);
}

/// The supply of a sensor at the input of another channel is 24 V there. REQ-PLANT-047
#[test]
fn sensor_supply_when_it_touches_another_input_then_both_channels_have_an_error() {
    let supplied = vec![("Mode", "SAFETY"), ("Range", "MA_4_20"), ("Filter", "HZ_50")];
    let mut bench = module(&[("C0", supplied), ("C1", channel("MA_4_20", &[]))]);
    bench.at(0, amount("C0", 12_000)).at(0, amount("C1", 12_000));
    assert_eq!(bench.read(900, &[Status(0), Status(1)]), [1, 1]);
    bench.at(1000, Stimulus::Fault(at("S0"), Fault::To(at("C1"))));
    assert_eq!(bench.read(2000, &[Status(0), FaultReason(0), Status(1), FaultReason(1)]), [0, 127, 0, 2]);
    bench.at(2000, Stimulus::FaultGone(at("C1"), Fault::To(at("S0"))));
    assert_eq!(bench.read(4000, &[Status(0), Status(1)]), [1, 1]);
}

/// Nobody knows what a voltage and a current give together: the model does not make a number up. REQ-PLANT-048
#[test]
fn channels_when_they_measure_different_quantities_then_their_short_is_refused() {
    let mut bench =
        module(&[("C0", channel("MA_4_20", &[])), ("C1", channel("V_10", &[])), ("C2", channel("MA_0_20", &[]))]);
    let short = |other| Stimulus::Fault(at("C0"), Fault::To(at(other)));
    assert_eq!(bench.device.accepts(&short("C1")), Err(Refusal::OtherQuantity(at("C1"))));
    bench.at(0, amount("C0", 12_000)).at(0, amount("C2", 8_000)).at(0, short("C2"));
    assert_eq!(bench.read(100, &[Data(0), Data(2)]), [3_750, 5_000]);
}

/// A wire of a sensor supply that touches two inputs joins them; where that supply is broken, each input measures its own sensor.
/// REQ-PLANT-048
#[test]
fn channels_when_a_dead_supply_joins_them_then_another_quantity_does_not_count() {
    let supplied = vec![("Mode", "SAFETY"), ("Range", "MA_4_20")];
    let mut bench = module(&[("C0", channel("MA_4_20", &[])), ("C1", channel("V_10", &[])), ("C2", supplied)]);
    bench.at(0, amount("C0", 12_000)).at(0, amount("C1", 5_000)).at(0, Stimulus::Fault(at("S2"), Fault::Open));
    bench.at(0, Stimulus::Fault(at("S2"), Fault::To(at("C0")))).at(0, Stimulus::Fault(at("S2"), Fault::To(at("C1"))));
    assert_eq!(bench.read(100, &[Data(0), Status(0), Data(1), Status(1)]), [5_000, 1, 7_500, 1]);
}

/// REQ-PLANT-007
#[test]
fn channel_when_its_circuit_in_the_module_fails_then_it_is_0_with_its_reason() {
    let mut bench = module(&[("C0", channel("MA_4_20", &[]))]);
    bench.at(0, amount("C0", 12_000)).at(100, Stimulus::Fault(at("C0"), Fault::Inside));
    assert_eq!(bench.read(100, &[Data(0), Status(0), FaultReason(0)]), [0, 0, 108]);
    bench.at(200, Stimulus::Repaired(at("C0")));
    assert_eq!(bench.read(1198, &[Status(0)]), [0]);
    assert_eq!(bench.read(2000, &[Data(0), Status(0), FaultReason(0)]), [5_000, 1, 1]);
}

/// At a channel stands a number, and at the supply of a sensor that the module supplies 24 V.
#[test]
fn terminals_when_looked_at_then_only_a_supply_of_the_module_is_on() {
    let supplied = vec![("Mode", "SAFETY"), ("Range", "MA_4_20")];
    let mut bench = module(&[("C0", supplied)]);
    bench.at(0, amount("C0", 12_000));
    assert_eq!((bench.device.is_high(at("C0")), bench.device.is_high(at("S0"))), (None, Some(true)));
    bench.at(10, Stimulus::Fault(at("S0"), Fault::Open));
    assert_eq!(bench.device.is_high(at("S0")), Some(false));
}

/// REQ-PLANT-006
#[test]
fn settings_when_an_image_holds_extremes_that_no_table_allows_then_nothing_overflows() {
    let extremes = [
        ("Type", "EQUIVALENT"),
        ("ChannelOffset", "2147483647"),
        ("DiscrepancyDeadband", "-2147483648"),
        ("Alarms", "ENABLE"),
        ("LowAlarm", "-2147483648"),
        ("HighLowDeadband", "-2147483648"),
    ];
    let mut bench = module(&[("C0", channel("V_10", &extremes)), ("C1", channel("V_10", &extremes))]);
    bench.at(0, amount("C0", 5_000)).at(0, amount("C1", 5_000));
    assert_eq!(bench.read(1000, &[Data(0), Status(0), Low(0)]), [7_500, 1, 1]);
}
