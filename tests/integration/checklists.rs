//! The checklists of the safety reference manual, filled in from a sample: what is answered, and what is left to a person.

use std::fs;

use crate::command::{expect, twinrung};
use crate::support::{project_path, text};

const SAMPLE: &str = "samples/estop-with-contactors/project.rll";

/// Answers of the lists with a title: `number answer`.
fn answers(json: &str, title: &str) -> Vec<String> {
    let json: serde_json::Value = serde_json::from_str(json).unwrap();
    let lists = json["checklists"].as_array().unwrap().iter().filter(|list| list["title"] == title);
    let lines = lists.flat_map(|list| list["lines"].as_array().unwrap());
    lines.map(|line| format!("{} {}", line["number"], line["answer"].as_str().unwrap())).collect()
}

/// A variant of a sample with one thing changed.
fn variant(sample: &str, from: &str, to: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("project.rll");
    let sample = text(&project_path(sample));
    assert!(sample.contains(from));
    fs::write(&path, sample.replace(from, to)).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

#[test]
fn checklists_when_filled_in_from_a_sample_then_as_reviewed_in_every_form() {
    let said = twinrung(&["checklist", SAMPLE]);
    assert_eq!(said.code, Some(0));
    expect("checklist.txt", &said.out);
    expect("checklist.md", &twinrung(&["checklist", SAMPLE, "--format", "markdown"]).out);
    expect("checklist.json", &twinrung(&["checklist", SAMPLE, "--format", "json"]).out);
}

/// REQ-CHECK-009
#[test]
fn checklists_when_a_standard_tag_is_read_then_its_lines_say_no_and_the_others_are_left_to_a_person() {
    let (_folder, path) = variant(SAMPLE, "XIC(Start)", "XIC(Panel)XIC(Start)");
    let said = twinrung(&["checklist", &path, "--format", "json"]);
    assert_eq!(
        answers(&said.out, "safety application program")[3..8],
        ["4 person", "5 person", "6 person", "7 person", "8 person"]
    );
    let tags = "  TAG\n    Panel : BOOL;\n";
    let with_tag = text(std::path::Path::new(&path)).replacen("  TAG\n", tags, 1);
    fs::write(&path, with_tag).unwrap();
    let said = twinrung(&["checklist", &path, "--format", "json"]);
    assert_eq!(said.code, Some(1));
    assert_eq!(
        answers(&said.out, "safety application program")[3..8],
        ["4 person", "5 person", "6 no", "7 no", "8 person"]
    );
}

#[test]
fn checklists_when_an_uncertified_instruction_is_used_then_line_4_says_no() {
    let (_folder, path) = variant(SAMPLE, "XIC(Start)", "SIN(Start,Start)XIC(Start)");
    let said = twinrung(&["checklist", &path, "--format", "json"]);
    assert_eq!(answers(&said.out, "safety application program")[3], "4 no");
}

/// REQ-CHECK-009
#[test]
fn checklists_when_of_a_part_of_a_project_then_nothing_is_ticked_that_needs_the_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("routine.rll");
    fs::write(&path, "ROUTINE Main\n  N: NOP();\nEND_ROUTINE\n").unwrap();
    let arguments = ["--controller", "1756-L73S/20", "--period", "20", "--watchdog", "10", "--format", "json"];
    let said = twinrung(&[&["checklist", path.to_str().unwrap()], &arguments[..]].concat());
    let found = answers(&said.out, "safety application program");
    assert!(found.iter().all(|line| line.ends_with("person")), "{found:?}");
}

#[test]
fn checklists_when_an_export_names_software_and_signature_then_these_lines_are_answered() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("project.L5X");
    let export = text(&project_path("samples/estop-with-contactors/project.L5X"));
    fs::write(&path, export.replace("SafetyLocked=", "SafetySignature=\"16#11b2_536b\" SafetyLocked=")).unwrap();
    let said = twinrung(&["checklist", path.to_str().unwrap(), "--format", "json"]);
    assert_eq!(answers(&said.out, "safety application program")[0], "1 yes");
    assert_eq!(answers(&said.out, "controller system")[9], "10 yes");
}

#[test]
fn checklists_when_nobody_watches_a_connection_then_line_3_of_its_inputs_says_no() {
    let sample = "samples/qualified-standard-data/project.rll";
    let (_folder, path) = variant(sample, "XIO(Node31:I.ConnectionFaulted)", "");
    let count = |path: &str| {
        let said = twinrung(&["checklist", path, "--format", "json"]);
        answers(&said.out, "safety input channel").iter().filter(|line| *line == "3 no").count()
    };
    assert_eq!((count(sample), count(&path)), (0, 1));
}

/// What stands beside a line of the lists for one channel.
fn evidence(json: &str, channel: &str, number: u64) -> Vec<String> {
    let json: serde_json::Value = serde_json::from_str(json).unwrap();
    let lists = json["checklists"].as_array().unwrap();
    let list = lists.iter().find(|list| list["subject"].as_str().unwrap().ends_with(channel)).unwrap();
    let line = list["lines"].as_array().unwrap().iter().find(|line| line["number"] == number).unwrap();
    line["evidence"].as_array().unwrap().iter().map(|text| text.as_str().unwrap().to_owned()).collect()
}

/// A project with two output modules; what stands on its rungs, and what is declared before its tags.
fn two_outputs(add_on: &str, tags: &str, rungs: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("project.rll");
    let module = |name: &str, catalog: &str, slot: u32| {
        format!(
            "MODULE {name} (CatalogNumber := \"{catalog}\", Parent := \"Rack\", Slot := {slot}, \
             SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n"
        )
    };
    let text = format!(
        "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n\
         MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n\
         {}{}{}{add_on}TAG\nA : BOOL (Class := Safety);\n{tags}END_TAG\nPROGRAM P (Class := Safety, MAIN := \"Main\")\n\
         ROUTINE Main\n{rungs}\nEND_ROUTINE\nEND_PROGRAM\n\
         TASK T (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\nP;\nEND_TASK\nEND_CONTROLLER\n",
        module("In", "1734-IB8S", 1),
        module("Out", "1734-OB8S", 2),
        module("Idle", "1734-OB8S", 3),
    );
    fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

const COPY: &str = "ADD_ON_INSTRUCTION_DEFINITION Copy (Class := Safety)\nPARAMETERS\n\
     From : BOOL (Usage := Input, Required := Yes, Visible := Yes);\n\
     To : BOOL (Usage := Output, Required := Yes, Visible := Yes);\nEND_PARAMETERS\nLOCAL_TAGS\nEND_LOCAL_TAGS\n\
     ROUTINE Logic\nN: XIC(From)OTE(To);\nEND_ROUTINE\nEND_ADD_ON_INSTRUCTION_DEFINITION\n";

#[test]
fn checklists_when_an_add_on_instruction_writes_a_channel_then_it_is_written_and_not_read() {
    let rungs = "N: Copy(C,In:I.Pt00Data,Out:O.Pt00Data);\nN: XIC(Out:O.Pt00Data)OTE(A);";
    let (_folder, path) = two_outputs(COPY, "C : Copy (Class := Safety);\n", rungs);
    let said = twinrung(&["checklist", &path, "--format", "json"]);
    assert_eq!(evidence(&said.out, "Out:O.Pt00Data", 4), ["the logic writes the channel: P/Main rung 0"]);
    assert_eq!(evidence(&said.out, "In:I.Pt00Data", 3)[0], "the logic uses the channel: P/Main rung 0");
}

#[test]
fn checklists_when_another_module_is_not_written_then_that_is_no_evidence_for_this_one() {
    let (_folder, path) = two_outputs("", "", "N: XIC(In:I.Pt00Data)OTE(Out:O.Pt00Data);");
    let said = twinrung(&["checklist", &path, "--format", "json"]);
    assert_eq!(evidence(&said.out, "Out:O.Pt01Data", 4), ["the logic writes the channel: nowhere"]);
    assert_eq!(evidence(&said.out, "Out:O.Pt00Data", 4), ["the logic writes the channel: P/Main rung 0"]);
}
