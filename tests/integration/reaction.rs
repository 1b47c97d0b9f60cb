//! Reaction times and probabilities of failure of chains, as the command adds them up.

use std::fs;

use crate::command::twinrung;

const RACK: &str =
    "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n";

/// Two input points with filters, one output point.
const INPUTS: &str = "  MODULE Doors (CatalogNumber := \"1734-IB8S/B\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10)
    POINT I00 (Mode := SAFETY, OffOn := 0, OnOff := 6);
    POINT I01 (Mode := SAFETY, OffOn := 12, OnOff := 0);
  END_MODULE
";
const OUTPUTS: &str = "  MODULE Drives (CatalogNumber := \"1734-OB8S/B\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002)
    POINT O00 (Mode := SAFETY_PULSE_TEST, Channel := DUAL);
  END_MODULE
";
const LINE_TYPE: &str = "  DATATYPE Line_T\n    CONNECTION_STATUS Status;\n    BOOL Stop;\n  END_DATATYPE\n";

/// A controller with these types, modules, tags and routines; period and watchdog in ms.
fn controller(name: &str, declarations: &str, tags: &str, routines: &str, times: (u32, u32)) -> String {
    let (period, watchdog) = times;
    format!(
        "CONTROLLER {name} (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0003)
{declarations}  TAG\n{tags}  END_TAG\n  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n{routines}  END_PROGRAM
  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := {period}, Watchdog := {watchdog}, Priority := 5)
    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
    )
}

fn main_routine(rungs: &[&str]) -> String {
    let rungs: String = rungs.iter().map(|rung| format!("      N: {rung};\n")).collect();
    format!("    ROUTINE Main\n{rungs}    END_ROUTINE\n")
}

/// What the command says of these projects, the first of them the one that is asked about.
fn reaction(projects: &[&str], options: &[&str]) -> (Option<i32>, serde_json::Value) {
    let folder = tempfile::tempdir().unwrap();
    let paths: Vec<String> = projects
        .iter()
        .enumerate()
        .map(|(number, text)| {
            let path = folder.path().join(format!("{number}.rll"));
            fs::write(&path, text).unwrap();
            path.to_str().unwrap().to_owned()
        })
        .collect();
    let mut arguments = vec!["reaction", &paths[0], "--format", "json"];
    for producer in &paths[1..] {
        arguments.extend(["--producer", producer]);
    }
    arguments.extend(options);
    let said = twinrung(&arguments);
    (said.code, serde_json::from_str(&said.out).unwrap_or_else(|error| panic!("{error}: {}{}", said.out, said.err)))
}

fn one_controller(rungs: &[&str]) -> String {
    let run = "    Run : BOOL (Class := Safety);\n    Gate : BOOL (Class := Safety);\n";
    controller("Cell", &format!("{RACK}{INPUTS}{OUTPUTS}"), run, &main_routine(rungs), (20, 10))
}

fn times(chain: &serde_json::Value) -> Vec<u64> {
    chain["components"].as_array().unwrap().iter().map(|part| part["us"].as_u64().unwrap()).collect()
}

/// REQ-REACT-001, REQ-REACT-002. 1756-RM093 Figure 20; 1734-UM013, Configure Safety Connections: 40.1 and 60.0 ms.
#[test]
fn chain_when_input_reaches_output_then_the_five_parts_of_the_manual_add_up() {
    let project = one_controller(&["XIC(Doors:I.Pt00Data)OTE(Run)", "XIC(Run)OTE(Drives:O.Pt00Data)"]);
    let (code, json) = reaction(&[&project], &["--sensor", "15", "--actuator", "45"]);
    let chain = &json["chains"][0];
    assert_eq!(times(chain), [15_000, 16_200, 6_000, 40_064, 30_000, 60_032, 6_200, 45_000]);
    assert_eq!(chain["logix_us"], 158_496);
    assert_eq!(chain["system_us"], 218_496);
    assert_eq!((code, json["chains"].as_array().unwrap().len()), (Some(0), 1));
}

/// REQ-REACT-003. A demand may be either edge.
#[test]
fn filter_when_the_rising_edge_is_the_slower_then_that_counts() {
    let project = one_controller(&["XIC(Doors:I.Pt01Data)OTE(Drives:O.Pt00Data)"]);
    assert_eq!(times(&reaction(&[&project], &[]).1["chains"][0])[2], 12_000);
}

/// REQ-REACT-004
#[test]
fn chain_when_an_input_only_steers_control_then_it_is_listed() {
    let jump = one_controller(&["XIC(Doors:I.Pt00Data)JMP(Past)", "XIC(Gate)OTE(Drives:O.Pt00Data)", "LBL(Past)NOP()"]);
    assert_eq!(reaction(&[&jump], &[]).1["chains"][0]["inputs"][0], "Doors:I.Pt00Data");
    let call = "    ROUTINE Main\n      N: XIC(Doors:I.Pt00Data)JSR(Stop,0);\n    END_ROUTINE\n    ROUTINE Stop\n      N: XIC(Gate)OTE(Drives:O.Pt00Data);\n    END_ROUTINE\n";
    let gate = "    Gate : BOOL (Class := Safety);\n";
    let call = controller("Cell", &format!("{RACK}{INPUTS}{OUTPUTS}"), gate, call, (20, 10));
    assert_eq!(reaction(&[&call], &[]).1["chains"][0]["inputs"][0], "Doors:I.Pt00Data");
}

/// REQ-REACT-004
#[test]
fn chain_when_no_input_reaches_the_output_then_there_is_none() {
    let project = one_controller(&["XIC(Doors:I.Pt00Data)OTE(Run)", "XIC(Gate)OTE(Drives:O.Pt00Data)"]);
    assert_eq!(reaction(&[&project], &[]).1["chains"].as_array().unwrap().len(), 0);
}

/// REQ-REACT-005. 1756-RM093 Figure 21: seven parts, two controllers.
#[test]
fn chain_when_a_tag_is_consumed_then_it_is_followed_into_its_producer() {
    let produced = "    Line : Line_T (Class := Safety, Produced := 1, RPI := 20);\n";
    let producer = controller(
        "Cell_A",
        &format!("{LINE_TYPE}{RACK}{INPUTS}"),
        produced,
        &main_routine(&["XIC(Doors:I.Pt00Data)OTE(Line.Stop)"]),
        (10, 5),
    );
    let peer = "  MODULE Cell_A (CatalogNumber := \"1756-L73S\", Parent := \"Local\", Slot := 3, SafetyNetwork := 16#0000_0000_0001_0004) END_MODULE\n";
    let consumed = "    Stop_A : Line_T (Class := Safety, Producer := Cell_A, RemoteTag := \"Line\", RPI := 20);\n";
    let consumer = controller(
        "Cell_B",
        &format!("{LINE_TYPE}{peer}{RACK}{OUTPUTS}"),
        consumed,
        &main_routine(&["XIC(Stop_A.Stop)XIO(Stop_A.Status.ConnectionFaulted)OTE(Drives:O.Pt00Data)"]),
        (20, 10),
    );
    let (_, json) = reaction(&[&consumer, &producer], &[]);
    let chain = &json["chains"][0];
    assert_eq!(chain["inputs"][0], "Cell_A: Doors:I.Pt00Data");
    assert_eq!(times(chain), [0, 16_200, 6_000, 40_064, 15_000, 80_000, 30_000, 60_032, 6_200, 0]);
    assert_eq!(chain["failure"]["elements"].as_array().unwrap().len(), 4);

    let (code, alone) = reaction(&[&consumer], &["--limit", "1000"]);
    assert_eq!((code, &alone["chains"][0]["system_us"]), (Some(1), &serde_json::Value::Null));
}

/// REQ-REACT-006
#[test]
fn module_when_no_source_has_its_time_then_the_chain_is_not_known_until_it_is_given() {
    let rungs = ["XIC(Doors:I.Pt00Data)OTE(Drives:O.Pt00Data)"];
    let project = one_controller(&rungs).replace("1734-IB8S/B", "1791ES-IB8XOBV4").replace(", Slot := 1", "");
    let project = project.replace(
        "Parent := \"Rack\", SafetyNetwork",
        "Parent := \"Local\", IPAddress := \"192.168.1.11\", SafetyNetwork",
    );
    let (code, json) = reaction(&[&project], &["--limit", "1000"]);
    assert_eq!((code, &json["chains"][0]["system_us"]), (Some(1), &serde_json::Value::Null));
    assert_eq!(json["chains"][0]["failure"]["per_hour"], serde_json::Value::Null);
    let (code, json) = reaction(&[&project], &["--limit", "1000", "--module", "1791ES-IB8XOBV4=16.2"]);
    assert_eq!((code, &json["chains"][0]["components"][1]["us"]), (Some(0), &serde_json::json!(16_200)));
}

/// REQ-REACT-007. 1756-RM093 Table 4: the sum over the loop. 1734-UM013: IB8S series B single 5.61E-10, OB8S series B dual
/// 1.20E-10; 1756-RM093 Table 15: L7xS 1.2E-09.
#[test]
fn failure_when_every_element_has_a_figure_then_the_loop_has_their_sum() {
    let project = one_controller(&["XIC(Doors:I.Pt00Data)OTE(Drives:O.Pt00Data)"]);
    let failure = reaction(&[&project], &["--proof-test", "10"]).1["chains"][0]["failure"].clone();
    let nearly = |value: &serde_json::Value, expected: f64| (value.as_f64().unwrap() / expected - 1.0).abs() < 1e-9;
    assert!(nearly(&failure["per_hour"], 5.61e-10 + 1.2e-9 + 1.20e-10));
    assert!(nearly(&failure["on_demand"], 2.43e-5 + 3.5e-5 + 5.00e-6));
}
