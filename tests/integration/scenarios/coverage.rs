//! What counts as covered.

use super::support::{heater, missing, project, refused, report};
use crate::support::{project_path, text};

/// The emergency stop sample.
fn sample() -> String {
    text(&project_path("samples/estop-with-contactors/project.rll"))
}

/// Names of missing items that begin so.
fn missing_of(project: &str, scenarios: &str, kind: &str) -> Vec<String> {
    let found = report(project, scenarios);
    missing(&found).into_iter().filter(|name| name.starts_with(kind)).map(str::to_owned).collect()
}

/// REQ-TEST-020
#[test]
fn inputs_when_they_change_each_way_between_scans_then_shown_under_the_name_that_logic_uses() {
    let text = "scenario \"x\"\ngiven Start is on, K1_Feedback is on\nthen K1 stays off for 40 ms\nat 60 ms\nwhen Start is off, Reset is on\nthen K1 is off\nend\n";
    let missing = missing_of(&sample(), text, "input");
    // Start was on from the first scan on: it went off, and never on. Pt07Data and RunMode occur on no rung.
    assert!(missing.contains(&"input Start to on".to_owned()) && !missing.contains(&"input Start to off".to_owned()));
    assert!(missing.contains(&"input Reset to off".to_owned()) && !missing.contains(&"input Reset to on".to_owned()));
    assert!(missing.contains(&"input Field_In:I.Pt00Data to on".to_owned()), "{missing:?}");
    assert!(missing.iter().all(|name| !name.contains("Pt07Data") && !name.contains("RunMode")), "{missing:?}");
    assert_eq!(report(&sample(), text).coverage.kinds[0].1.total, 20);
}

/// REQ-TEST-020
#[test]
fn outputs_when_no_scenario_switches_them_then_each_direction_is_missing() {
    let text = "scenario \"x\"\nthen K1 is off\nend\n";
    assert_eq!(
        missing_of(&sample(), text, "output"),
        ["output K1 to on", "output K1 to off", "output K2 to on", "output K2 to off"]
    );
}

/// REQ-TEST-021
#[test]
fn rungs_when_without_conditions_then_they_are_only_true() {
    let text = "scenario \"x\"\nthen K1 is off\nend\n";
    let missing = missing_of(&sample(), text, "rung");
    assert_eq!(
        missing,
        ["rung Safety_Main/Main 1 true", "rung Safety_Main/Main 3 true", "rung Safety_Main/Main 4 true"]
    );
}

/// REQ-TEST-012
#[test]
fn contacts_when_masked_by_others_then_they_are_not_shown() {
    let project = project("A, B, X : BOOL (Class := Safety);", "N: XIC(A)XIC(B)OTE(X);");
    let contacts = |lines: &str| missing_of(&project, &format!("scenario \"x\"\n{lines}\nend\n"), "contact").join(", ");
    // Both open: neither decides. Both closed: each does.
    assert_eq!(
        contacts("then X is off\nat 20 ms\nwhen A is on, B is on\nthen X is on"),
        "contact P/Main 0 XIC(A) open, contact P/Main 0 XIC(B) open"
    );
    // Each opened alone.
    assert_eq!(
        contacts(
            "given A is on\nthen X is off\nat 20 ms\nwhen B is on\nthen X is on\nat 40 ms\nwhen A is off\nthen X is off"
        ),
        ""
    );
}

/// REQ-TEST-012
#[test]
fn contacts_when_left_of_comparisons_one_shots_and_in_add_ons_then_they_can_be_shown() {
    let project = project(
        "A, B, X, S, Y : BOOL (Class := Safety);\nN1 : DINT (Class := Safety);",
        "N: XIC(A)GRT(N1,5)LIM(0,N1,9)OTE(X);\nN: XIC(B)ONS(S)OTE(Y);",
    );
    let text = "scenario \"x\"\ngiven N1 is 7\nthen X stays off, Y stays off for 40 ms\nat 40 ms\nwhen A is on, B is on\nthen X is on, Y is on\n\
                at 60 ms\nwhen N1 is 3\nthen X is off, Y is off\nat 80 ms\nwhen N1 is 12\nthen X is off\nend\n";
    assert_eq!(missing_of(&project, text, "contact"), [] as [String; 0]);
    let add_on = text_of_add_on();
    let text = "scenario \"x\"\nthen Out is off\nat 20 ms\nwhen In is on, Also is on\nthen Out is on\nat 40 ms\nwhen Also is off\nthen Out is off\nat 60 ms\nwhen Also is on, In is off\nthen Out is off\nend\n";
    assert_eq!(missing_of(&add_on, text, "contact"), [] as [String; 0]);
}

/// A program that calls an Add-On Instruction with two contacts in series.
fn text_of_add_on() -> String {
    project("Both_1 : Both (Class := Safety);\nIn, Also, Out : BOOL (Class := Safety);", "N: Both(Both_1,In,Also,Out);").replacen(
        "TAG\n",
        "ADD_ON_INSTRUCTION_DEFINITION Both (Class := Safety)\nPARAMETERS\n\
         First : BOOL (Usage := Input, Required := Yes, Visible := Yes);\nSecond : BOOL (Usage := Input, Required := Yes, Visible := Yes);\n\
         Result : BOOL (Usage := Output, Required := Yes, Visible := Yes);\nEND_PARAMETERS\nLOCAL_TAGS\nEND_LOCAL_TAGS\n\
         ROUTINE Logic\nN: XIC(First)XIC(Second)OTE(Result);\nEND_ROUTINE\nEND_ADD_ON_INSTRUCTION_DEFINITION\nTAG\n",
        1,
    )
}

/// REQ-TEST-022
#[test]
fn codes_when_a_scan_ends_with_one_then_that_one_is_shown() {
    let text = "scenario \"x\"\ngiven Field_In:I.CombinedInputStatus is on\nat 40 ms\nwhen Field_In:I.CombinedInputStatus is off\nthen EStop.FaultCode is 16#20\nend\n";
    let missing = missing_of(&sample(), text, "code EStop");
    let codes = ["16#4000", "16#4001", "16#4002", "16#4003"].map(|code| format!("code EStop.FaultCode {code}"));
    assert_eq!(missing, codes);
}

/// REQ-TEST-023
#[test]
fn contact_when_missing_then_the_way_is_given_and_going_it_shows_the_contact() {
    let found = report(&heater(), "scenario \"x\"\nthen Run is off\nend\n");
    let way = |name: &str| {
        let item = found.coverage.missing.iter().find(|item| item.name == name);
        item.map(|item| item.way.clone()).unwrap_or_default()
    };
    assert_eq!(way("contact Safety_Main/Main 0 XIO(Stop) open"), "Stop is on, Start is on, Run is off");
    let gone = "scenario \"x\"\ngiven Stop is on, Start is on\nthen Run is off\nend\n";
    assert!(!missing(&report(&heater(), gone)).contains(&"contact Safety_Main/Main 0 XIO(Stop) open"));
}

/// REQ-TEST-023
#[test]
fn contact_when_no_position_of_the_others_lets_it_decide_then_it_is_called_redundant() {
    let project = project("A, B, X : BOOL (Class := Safety);", "N: [XIC(A) ,XIC(A)XIC(B) ]OTE(X);");
    let found = report(&project, "scenario \"x\"\nthen X is off\nend\n");
    let redundant = found.coverage.missing.iter().filter(|item| item.way.contains("redundant"));
    let names: Vec<&str> = redundant.map(|item| item.name.as_str()).collect();
    // With A off and B on the second contact of A would switch X on if it alone closed: open, it decides.
    assert_eq!(
        names,
        ["contact P/Main 0 XIC(A) #2 closed", "contact P/Main 0 XIC(B) closed", "contact P/Main 0 XIC(B) open"]
    );
}

/// REQ-TEST-024
#[test]
fn exclusion_when_it_names_an_item_then_its_reason_is_reported_and_else_it_is_refused() {
    let with =
        |item: &str| format!("exclude \"{item}\" because \"it is not built\"\nscenario \"x\"\nthen Run is off\nend\n");
    let found = report(&heater(), &with("rung Safety_Main/Main 4 true")).coverage;
    assert_eq!(
        (found.excluded[0].item.as_str(), found.excluded[0].reason.as_str()),
        ("rung Safety_Main/Main 4 true", "it is not built")
    );
    let found = report(&heater(), &with("rung Safety_Main/Main 4 false")).coverage;
    assert_eq!((found.excluded.len(), found.needless), (0, vec!["rung Safety_Main/Main 4 false".to_owned()]));
    assert_eq!(
        refused(&heater(), &with("rung Safety_Main/Main 9 true")),
        [
            "E0506 1: there is nothing to cover that is called `rung Safety_Main/Main 9 true`; did you mean `rung Safety_Main/Main 4 false`?"
        ]
    );
}

/// REQ-TEST-025
#[test]
fn observer_when_random_inputs_move_every_sample_then_it_tells_every_write_and_every_evaluation() {
    let mut doubts = Vec::new();
    for sample in super::samples::all() {
        let project = text(&project_path("samples").join(&sample).join("project.rll"));
        let found = super::samples::moved_at_random(&project);
        doubts.extend((found != (0, 0)).then_some((sample, found)));
    }
    assert!(doubts.is_empty(), "(sample, (writes not told, evaluations that do not agree)): {doubts:?}");
}
