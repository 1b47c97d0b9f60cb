//! Scenarios at the terminals of modules: `docs/spec/plant.md`.

use super::samples::with as samples_with;
use super::support::{failures, refused, report};
use crate::support::{project_path, text};

fn estop() -> String {
    text(&project_path("samples/estop-with-contactors/project.rll"))
}

fn wiring() -> String {
    text(&project_path("samples/estop-with-contactors/wiring.scenario"))
}

/// REQ-PLANT-050, REQ-PLANT-052
#[test]
fn sample_when_its_wires_go_wrong_then_the_motor_is_off_as_its_scenarios_say() {
    assert_eq!(failures(&report(&estop(), &wiring())), [] as [String; 0]);
}

/// REQ-PLANT-050
#[test]
fn samples_when_their_wires_go_wrong_then_it_is_as_their_scenarios_say() {
    let samples = samples_with("wiring.scenario");
    assert!(samples.len() >= 2, "{samples:?}");
    for sample in samples {
        let folder = project_path("samples").join(&sample);
        let found = report(&text(&folder.join("project.rll")), &text(&folder.join("wiring.scenario")));
        assert_eq!(failures(&found), [] as [String; 0], "{sample}");
    }
}

/// One test source for both channels: a cross short is then not found, and a channel that touches 0 V takes the source of both, so
/// that no discrepancy shows.
#[test]
fn sample_when_both_channels_share_a_test_source_then_the_scenarios_of_their_shorts_fail() {
    let shared = estop().replace("TestSource := T1", "TestSource := T0");
    let found = report(&shared, &wiring());
    let failed: Vec<&str> = found.scenarios.iter().filter(|one| !one.passed).map(|one| one.name.as_str()).collect();
    assert_eq!(failed, ["the channels of the button touch", "a channel of the button touches 0 V"]);
}

/// Without test pulses a short to 24 V shows when the output is switched off, which is too late.
#[test]
fn sample_when_an_output_is_not_pulse_tested_then_the_scenario_of_its_short_fails() {
    let untested = estop().replace("SAFETY_PULSE_TEST, Channel", "SAFETY, Channel");
    let found = report(&untested, &wiring());
    let failed: Vec<&str> = found.scenarios.iter().filter(|one| !one.passed).map(|one| one.name.as_str()).collect();
    assert_eq!(failed, ["the wire of a contactor touches 24 V"]);
}

/// What cannot be said of the sample's terminals, and why not.
const REFUSED: &[(&str, &str)] = &[
    ("given Field_In terminal 9 is on", "E0507 2: the module has no terminal `9`"),
    ("given Field_In terminal X0 is on", "E0507 2: the module has no terminal `X0`"),
    (
        "given Field_In terminal 6 is on",
        "E0507 2: the project does not use the terminal I6; set its mode in the module: `POINT I06 (Mode := SAFETY);`",
    ),
    ("given Field_In terminal 0 is 12.5", "E0507 2: the device at I0 is on or off; write `is on` or `is off`"),
    ("given Field_Out terminal 0 is on", "E0507 2: the module switches O0, no device does"),
    (
        "given Field_In terminal 0 shorted to 12 V",
        "E0507 2: a wire is not shorted to 12 V; write `shorted to 24 V`, `shorted to 0 V` or `shorted to terminal 1`",
    ),
    ("given Field_In terminal 0 shorted to terminal 0", "E0507 2: the wire at I0 cannot touch itself"),
    (
        "then Field_In terminal 6 is off",
        "E0507 2: the project does not use the terminal I6; set its mode in the module: `POINT I06 (Mode := SAFETY);`",
    ),
    ("then Field_Out terminal 0 is off +- 1", "E0503 2: `Field_Out terminal 0` is on or off, which has no tolerance"),
    (
        "hold Field_In terminal 0 repaired for 1 s",
        "E0507 2: `repaired` is not held: it ends what went wrong before; write `when ... repaired`",
    ),
    (
        "hold Field_In power restored for 1 s",
        "E0507 2: `restored` is not held: it ends what went wrong before; write `when ... restored`",
    ),
    (
        "hold Field_In running for 1 s",
        "E0507 2: `running` is not held: it ends what went wrong before; write `when ... running`",
    ),
    (
        "given Field_In terminal 0 is 9223372036854775.999",
        "E0503 2: `9223372036854775.999` is no value of a terminal; on, off, or a number with three decimals at most",
    ),
    (
        "given Field_In terminal 4 follows Field_In terminal 5",
        "E0507 2: I5 is no output; a contact follows a safety output or a test output",
    ),
    (
        "given Field_In terminal 4 follows Field_Out terminal 5",
        "E0507 2: the project does not use the terminal O5; set its mode in the module: `POINT O05 (Mode := SAFETY);`",
    ),
    ("given Field_Out terminal 0 follows Field_Out terminal 1", "E0507 2: the module switches O0, no device does"),
    (
        "given Field_In terminal 4 follows Field_Out terminal 0 and Field_Out terminal 0 and Field_Out terminal 0 \
         and Field_Out terminal 1 and Field_Out terminal 1",
        "E0507 2: 5 contacts are in series, and 4 are the most",
    ),
    (
        "given Field_Out terminal 0 fails",
        "E0507 2: no source tells what the module shows when its own circuit at O0 fails; an input of a 1734-IB8S and a \
         channel of a 1734-IE4S can fail",
    ),
    (
        "given Rack terminal 0 is on",
        "E0502 2: `Rack` is no module with terminals; modules with terminals here: Field_In, Field_Out",
    ),
];

/// REQ-PLANT-051
#[test]
fn terminals_when_they_cannot_do_what_is_said_then_it_is_refused_with_a_way_out() {
    for (line, expected) in REFUSED {
        let scenario = format!("scenario \"x\"\n{line}\nthen K1 is off\nend\n");
        assert_eq!(refused(&estop(), &scenario), [*expected], "{line}");
    }
}

/// REQ-PLANT-050
#[test]
fn tags_when_the_scenario_acts_at_terminals_too_then_driving_them_is_refused() {
    let scenario = "scenario \"x\"\ngiven Field_In terminal 0 is on\nwhen Reset is on\nthen K1 is off\nend\n";
    let expected = "E0507 3: `Reset` follows the terminals of Field_In, which this scenario acts on; say what happens at the \
                    terminal: `when Field_In terminal 0 is on`";
    assert_eq!(refused(&estop(), scenario), [expected]);
}

/// A tank with a level sensor, a muting lamp and a lamp button.
fn tank() -> String {
    "CONTROLLER T (ProcessorType := \"1756-L73S\", Major := 20)\n\
     MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n\
     MODULE Tank (CatalogNumber := \"1734-IE4S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10)\n\
     POINT C0 (Mode := SAFETY, Range := MA_4_20, SensorPower := EXTERNAL, Filter := HZ_50);\nEND_MODULE\n\
     MODULE Panel (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002, \
     RPI := 10, OutputData := \"TEST\")\n\
     POINT I00 (Mode := SAFETY);\nTEST T1 (Mode := MUTING_LAMP);\nEND_MODULE\n\
     TAG\nFull : BOOL (Class := Safety);\nEND_TAG\n\
     PROGRAM P (Class := Safety, MAIN := \"Main\")\nROUTINE Main\n\
     N: XIC(Tank:I.Ch0InputStatus)GRT(Tank:I.Ch0Data,5000)OTE(Full);\n\
     N: XIC(Panel:I.Pt00Data)OTE(Panel:O.Test01Data);\n\
     END_ROUTINE\nEND_PROGRAM\n\
     TASK S (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 10, Priority := 5)\nP;\nEND_TASK\nEND_CONTROLLER\n"
        .to_owned()
}

#[test]
fn sensor_and_lamp_when_they_break_then_the_tags_of_their_modules_follow() {
    let scenario = "scenario \"x\"\n\
        given Tank terminal 0 is 12.0, Panel terminal 0 is on\n\
        then Tank:I.Ch0Data is 5000, Full is off, Panel terminal T1 is on\n\
        at 1 s\nwhen Tank terminal 0 is 16.0\nthen Full is on within 100 ms\n\
        at 2 s\nwhen Tank terminal 0 open, Panel terminal T1 open\n\
        then Tank:I.Ch0InputStatus is off, Full is off within 100 ms\n\
        then Panel:I.Muting01Status is off not before 2 s within 7020 ms\n\
        at 10 s\nwhen Panel terminal T1 repaired\nthen Panel:I.Muting01Status is on within 3020 ms\nend\n";
    assert_eq!(failures(&report(&tank(), scenario)), [] as [String; 0]);
}

/// At a channel stands a number. REQ-PLANT-051
#[test]
fn channel_when_looked_at_as_on_or_off_then_it_is_refused() {
    let scenario = "scenario \"x\"\nthen Tank terminal 0 is on\nend\n";
    assert_eq!(refused(&tank(), scenario), ["E0507 2: C0 has a number, not on or off; look at the data in its tag"]);
}

/// A bit of an analog value follows the terminals as the value does. REQ-PLANT-050
#[test]
fn bit_when_its_number_follows_a_terminal_then_driving_it_is_refused() {
    let scenario =
        "scenario \"x\"\ngiven Tank terminal 0 is 12.0\nwhen Tank:I.Ch0Data.3 is on\nthen Full is off\nend\n";
    let expected = "E0507 3: `Tank:I.Ch0Data.3` follows the terminals of Tank, which this scenario acts on; say what happens at \
                    the terminal: `when Tank terminal 0 is on`";
    assert_eq!(refused(&tank(), scenario), [expected]);
}

/// What is never judged is refused. REQ-TEST-005
#[test]
fn never_when_it_looks_at_a_terminal_and_no_scenario_is_played_there_then_it_is_refused() {
    let never = "never Field_Out terminal 0 is on and K1 is off\n";
    let on_tags = "scenario \"x\"\nthen K1 is off\nend\n";
    let expected = "E0507 1: no scenario of the file is played at terminals, so that this is never looked at; act at a terminal in \
                    a scenario of the file, or look at the tag";
    assert_eq!(refused(&estop(), &format!("{never}{on_tags}")), [expected]);
    let at_terminals = "scenario \"y\"\ngiven Field_In terminal 0 is on\nthen K1 is off\nend\n";
    assert_eq!(failures(&report(&estop(), &format!("{never}{on_tags}{at_terminals}"))), [] as [String; 0]);
    // It is looked up where it stands, whatever the scenarios are.
    let unused = format!("never Field_In terminal 6 is on\n{on_tags}");
    assert!(refused(&estop(), &unused)[0].starts_with("E0507 1: the project does not use the terminal I6"));
}

/// What a hold ends is what it began: not a fault that was there before, nor one that came later. REQ-TEST-007
#[test]
fn hold_when_it_ends_at_a_terminal_then_what_was_before_or_came_later_stays() {
    let on = |lines: &str| {
        failures(&report(&estop(), &format!("scenario \"x\"\ngiven Field_In terminal 2 is on\n{lines}\nend\n")))
    };
    let reset = "Field_In:I.Pt02Data";
    let cases = [
        // A broken wire that was there before is not mended by the end of a short.
        format!("given Field_In terminal 2 open\nat 100 ms\nhold Field_In terminal 2 shorted to 0 V for 100 ms\nat 400 ms\nthen {reset} is off"),
        // The same fault twice: it was there before.
        format!("given Field_In terminal 2 open\nat 100 ms\nhold Field_In terminal 2 open for 100 ms\nat 400 ms\nthen {reset} is off"),
        // What comes later stays.
        format!("hold Field_In terminal 2 open for 100 ms\nat 60 ms\nwhen Field_In terminal 2 open\nat 400 ms\nthen {reset} is off"),
        "hold Field_In lost for 100 ms\nat 60 ms\nwhen Field_In lost\nat 400 ms\nthen Field_In:I.ConnectionFaulted is on".to_owned(),
        "given Field_In idle\nat 100 ms\nhold Field_In idle for 100 ms\nat 400 ms\nthen Field_In:I.RunMode is off".to_owned(),
        // And a hold alone ends.
        format!("hold Field_In terminal 2 open for 100 ms\nat 60 ms\nthen {reset} is off\nat 400 ms\nthen {reset} is on"),
        "hold Field_In idle for 100 ms\nat 60 ms\nthen Field_In:I.RunMode is off\nat 400 ms\nthen Field_In:I.RunMode is on".to_owned(),
    ];
    let found: Vec<Vec<String>> = cases.iter().map(|lines| on(lines)).collect();
    assert_eq!(found, vec![Vec::<String>::new(); cases.len()]);
}

/// REQ-PLANT-054, REQ-TEST-007
#[test]
fn contact_when_it_follows_an_output_then_a_hold_of_it_ends_and_it_follows_again() {
    let held = "with \"running\"\nat 0 ms\nthen K1_Feedback is off\nhold Field_In terminal 4 is off for 60 ms\n\
                at 200 ms\nthen K1_Feedback is off\nat 300 ms\nwhen Field_In terminal 0 is off, Field_In terminal 1 is off\n\
                then Field_Out terminal 0 is off\nthen K1_Feedback is on within 60 ms";
    let running =
        wiring().split_inclusive("\nend\n").next().unwrap_or_default().replace("project \"project.rll\"\n", "");
    let scenarios = format!("{running}scenario \"x\"\n{held}\nend\n");
    assert_eq!(failures(&report(&estop(), &scenarios)), [] as [String; 0]);
}

/// REQ-PLANT-052. A scenario that acts at a terminal that is none still is one at terminals.
#[test]
fn never_when_the_only_act_at_a_terminal_is_refused_then_that_alone_is_said() {
    let scenarios = "never Field_Out terminal 0 is on and K1_Feedback is on and K2_Feedback is on\n\
                     scenario \"x\"\ngiven Field_In terminal 9 is on\nthen K1_Feedback is off\nend\n";
    let found = refused(&estop(), scenarios);
    assert_eq!(found, ["E0507 3: the module has no terminal `9`"]);
}

/// REQ-PLANT-007
#[test]
fn input_when_the_module_fails_there_then_its_status_says_so() {
    let lines = "given Field_In terminal 2 is on\nat 100 ms\nwhen Field_In terminal 2 fails\n\
                 then Field_In:I.CombinedInputStatus is off, Field_In:I.Pt02Data is off";
    assert_eq!(failures(&report(&estop(), &format!("scenario \"x\"\n{lines}\nend\n"))), [] as [String; 0]);
}

/// A module that looks at its pulses each µs counts for a thousand. REQ-PLANT-053
#[test]
fn scenario_when_its_modules_take_too_long_to_simulate_then_it_is_refused_with_what_they_may_have() {
    let scenario = "scenario \"x\"\ngiven Tank terminal 0 is 12.0\nat 15 min\nthen Full is off\nend\n";
    let found = refused(&tank().replace("MA_4_20", "TACHOMETER"), scenario);
    let expected =
        "E0504 1: a scenario at these terminals lasts at most 863136 ms, since each ms of each module is simulated";
    assert_eq!(found, [expected]);
}
