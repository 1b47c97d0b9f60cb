//! What is met, what is not, and what is refused.

use twinrung_bytecode::image::Image;
use twinrung_primary::Primary;
use twinrung_workbench::diagram::Style;
use twinrung_workbench::scenario::report::{junit, page, text};

use super::support::{failures, heater, image, on_heater, refused, report, tried};
use crate::wrong_partner::{Defect, WrongPartner};

const NARROW: Style = Style { columns: 80, colour: false };

/// REQ-TEST-010
#[test]
fn checks_when_joined_by_commas_then_each_is_judged_by_itself() {
    assert_eq!(
        on_heater("when Start is on\nthen Run is off, Warm is off, Step is not 0, Level >= 0.5"),
        ["3: at 0 ms Run was on", "3: at 0 ms Step was 0", "3: at 0 ms Level was 0.0"]
    );
}

/// REQ-TEST-010
#[test]
fn values_when_compared_then_tolerance_and_codes_are_as_written() {
    assert_eq!(on_heater("given Level is 12.0\nthen Level is 12.5 +- 0.5, Level is not 12.6 +- 0.5"), [] as [&str; 0]);
    assert_eq!(on_heater("given Level is 12.0\nthen Level is 12.5 +- 0.4"), ["3: at 0 ms Level was 12.0"]);
    assert_eq!(on_heater("given Index is 16#F052\nthen Index is 61522, Index > -1"), [] as [&str; 0]);
}

/// REQ-TEST-011
#[test]
fn stop_when_no_scenario_expects_it_then_it_is_a_failure_and_else_not() {
    let stop = "given Index is 4\nhold Fetch is on for 20 ms\n";
    assert_eq!(on_heater(&format!("{stop}then fault 4/20")), [] as [&str; 0]);
    assert_eq!(on_heater(&format!("{stop}then fault 14/2 within 100 ms")), [] as [&str; 0]);
    let found = on_heater(&format!("{stop}then Run stays off for 20 ms"));
    assert_eq!(found, ["1: at 0 ms it stopped with fault 14/2: major fault 4/20"]);
    let found = on_heater(&format!("{stop}then fault 14/1 within 20 ms"));
    assert_eq!(found[1], "4: at 20 ms the controller had stopped with fault 14/2");
    assert_eq!(on_heater("then fault 4/20 within 20 ms"), ["2: at 20 ms the controller had not stopped"]);
}

/// Takes the second contact of the first rung away.
struct WithoutAContact;

impl Defect for WithoutAContact {
    fn change(records: &mut Image) {
        super::mutants::take_out(records, (0, 1));
    }
}

/// REQ-TEST-011
#[test]
fn channels_when_they_differ_then_the_scenario_fails_with_the_tag() {
    let text = "scenario \"x\"\nat 40 ms\nthen Warm is off\nend\n";
    let found = tried::<Primary, WrongPartner<WithoutAContact>>(&image(&heater()), text).unwrap();
    let failures = failures(&found);
    assert_eq!(failures.len(), 1, "{failures:?}");
    assert!(failures[0].contains("fault 14/7: the channels differ in"), "{failures:?}");
}

/// REQ-TEST-014
#[test]
fn output_when_the_controller_has_stopped_then_it_is_off_as_the_machine_sees_it() {
    let sample = crate::support::text(&crate::support::project_path("samples/estop-with-contactors/project.rll"));
    let faulty = sample
        .replace("Motor_Run    : BOOL (Class := Safety);", "Motor_Run : BOOL (Class := Safety);\nTable : DINT[4] (Class := Safety);\nIndex, Found : DINT (Class := Safety);")
        .replace("RC: \"Both channels", "N: MOV(Table[Index],Found);\nRC: \"Both channels");
    let text = "scenario \"x\"\n\
        given Field_In:I.CombinedInputStatus is on, Field_Out:I.CombinedOutputStatus is on, K1_Feedback is on, K2_Feedback is on\n\
        at 100 ms\nwhen Field_In:I.Pt00Data is on, Field_In:I.Pt01Data is on\n\
        at 200 ms\nhold Reset is on for 40 ms\nat 300 ms\nhold Start is on for 40 ms\nthen K1 is on, Motor_Run is on\n\
        at 340 ms\nwhen Index is 4\nthen fault 14/2\nthen K1 is off, Published:K1 is off, Motor_Run is on\nend\n";
    assert_eq!(failures(&report(&faulty, text)), [] as [&str; 0]);
}

/// REQ-TEST-013, REQ-TEST-017
#[test]
fn failure_when_reported_then_diagram_and_rung_show_why_in_every_form() {
    let text_of = "scenario \"it never runs\"\nat 40 ms\nwhen Start is on\nthen Run is on\nat 80 ms\nwhen Stop is on\nthen Run is on\nend\n";
    let found = report(&heater(), text_of);
    let shown = text(&found, NARROW);
    let expected = "\
  NOT MET it never runs (2 expectations, 5 scans)

      x.scenario:7: then Run is on
      at 80 ms Run was off

      ms     |0
      Start  ▁▁███
      Stop   ▁▁▁▁█
      Run    ▁▁██▁

      Run was decided by Safety_Main/Main, rung 0; power ended at XIO(Stop)
      │  Stop    Start    Run
      ├──┤/├──┬───┤ ├───┬─( )──┤
      │   △   │   Run   │
      │       └───┤ ├───┘
";
    assert!(shown.contains(expected), "{shown}");
    let html = page(std::slice::from_ref(&found));
    assert!(html.contains("at 80 ms Run was off") && html.contains("power ended at XIO(Stop)"), "{html}");
    let xml = junit(std::slice::from_ref(&found)).unwrap();
    assert!(xml.contains("<testsuite name=\"x\" tests=\"1\" failures=\"1\">"), "{xml}");
    assert!(xml.contains("message=\"then Run is on: at 80 ms Run was off\""), "{xml}");
    let json = serde_json::to_value(&found).unwrap();
    assert_eq!(json["scenarios"][0]["failures"][0]["decision"]["blocked_by"][0], "XIO(Stop)");
}

/// REQ-TEST-015
#[test]
fn names_values_times_and_blocks_when_they_are_none_then_refused_with_a_way_out() {
    let wrong =
        |lines: &str| refused(&heater(), &format!("scenario \"x\"\n{lines}\nthen Run is off\nend\n")).join("\n");
    let cases = [
        ("given Star is on", "E0502 2: there is no tag `Star`; did you mean `Start`?"),
        ("given Run is on", "E0502 2: `Run` is written by logic; a stimulus may drive only what no logic writes"),
        ("given Start is 2", "E0503 2: `2` is not a value of `Start`, which is a BOOL; a BOOL is on or off"),
        (
            "then Step is 2 +- 1",
            "E0503 2: `Step` is a DINT, which has no tolerance; give a range: `NAME >= VALUE, NAME <= VALUE`",
        ),
        (
            "given Index is 16#1_0000_0000",
            "E0503 2: `16#1_0000_0000` is not a value of `Index`, which is a DINT; a DINT is -2147483648 to 2147483647",
        ),
        ("toggle Index every 20 ms for 1 s", "E0503 2: `Index` is no BOOL, and cannot be toggled"),
        ("at 0.5 ms", "E0504 2: `0.5 ms` is no time in whole milliseconds; write 200 ms, 1.5 s, 2 min or 3 scans"),
        ("at 1 s\nat 20 ms", "E0504 3: 20 ms is before the moment above, which is 1000 ms"),
        ("at 100000 min", "E0504 2: a scenario lasts at most 4000000 scans, here 80000000 ms"),
        (
            "then Warm is off within 99999999999 min",
            "E0504 2: a scenario lasts at most 4000000 scans, here 80000000 ms",
        ),
        (
            "then Warm stays off for 99999999999 min",
            "E0504 2: a scenario lasts at most 4000000 scans, here 80000000 ms",
        ),
        ("toggle Start every 20 ms for 30000 s", "E0504 2: a scenario has at most 1000000 changes of inputs"),
        ("then fault 4/20 within 99999999999 min", "E0504 2: a scenario lasts at most 4000000 scans, here 80000000 ms"),
        (
            "then Warm is off not before 18446744073709551615 ms within 5 ms",
            "E0504 2: a scenario lasts at most 4000000 scans, here 80000000 ms",
        ),
        (
            "then Run is off not before 20 ms",
            "E0504 2: `not before` needs the time by which it must be there; write `not before 280 ms within 300 ms`",
        ),
        ("with \"y\"", "E0505 2: there is no setup `y`; the file has no setup"),
        (
            "at 20 ms\ngiven Start is on",
            "E0505 3: `given` stands before the first moment of its block; later on it is `when`",
        ),
    ];
    let found: Vec<String> = cases.iter().map(|(lines, _)| wrong(lines)).collect();
    let expected: Vec<&str> = cases.iter().map(|(_, message)| *message).collect();
    assert_eq!(found, expected);
}

/// REQ-TEST-015
#[test]
fn setups_when_one_begins_with_itself_or_stands_twice_then_refused() {
    let text = "setup \"a\"\nwith \"b\"\nend\nsetup \"b\"\nwith \"a\"\nend\nscenario \"x\"\nwith \"a\"\nthen Run is off\nend\n";
    assert_eq!(refused(&heater(), text), ["E0505 5: the setup `a` begins with itself"]);
    let text = "scenario \"x\"\nthen Run is off\nend\nscenario \"x\"\nthen Run is off\nend\n";
    assert_eq!(refused(&heater(), text), ["E0505 4: `x` stands in the file twice"]);
    let text = "scenario \"x\"\ngiven Start is on\nend\n";
    assert_eq!(
        refused(&heater(), text),
        ["E0505 1: the scenario `x` expects nothing; say what must happen with `then` or `never`"]
    );
}

/// A setup that never ends is refused where it stands, and nothing is counted on from it. REQ-TEST-015
#[test]
fn setup_when_its_times_are_without_end_then_it_is_refused_once() {
    let text = "setup \"a\"\nthen Run is off within 18446744073709551615 ms\nend\n\
                scenario \"x\"\nwith \"a\"\nthen Run is off\nend\n";
    assert_eq!(refused(&heater(), text), ["E0504 2: a scenario lasts at most 4000000 scans, here 80000000 ms"]);
}

/// Setups of setups multiply: fifteen of them with eight `with` each are 8^15 lines. REQ-TEST-015
#[test]
fn setups_when_they_multiply_then_the_scenario_is_refused_before_it_is_laid_out() {
    let with = |setup: usize| format!("with \"{setup}\"\n").repeat(8);
    let setups: String = (1..15).map(|setup| format!("setup \"{setup}\"\n{}end\n", with(setup - 1))).collect();
    let text = format!("setup \"0\"\nthen Run is off\nend\n{setups}scenario \"x\"\n{}end\n", with(14));
    let found = refused(&heater(), &text);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("E0505 ") && found[0].contains("has at most 10000 lines"), "{found:?}");
}
