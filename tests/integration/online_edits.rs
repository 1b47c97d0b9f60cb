//! Online edits of safety routines: what may be changed, how an edit goes on, and what a scan boundary keeps.

use std::fs;

use crate::cell::Cell;
use crate::support::project_path;

const DECLARATIONS: &str = "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE
  MODULE Doors (CatalogNumber := \"1734-IB8S/B\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE
  MODULE Drives (CatalogNumber := \"1734-OB8S/B\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE
  TAG
    Scans : DINT (Class := Safety);
    Wait : TIMER (Class := Safety) := [0,10000,0];
    Latched : BOOL (Class := Safety);
    Levels : DINT[2] (Class := Safety);
    Level : DINT (Class := Safety);
    Exists : SINT (Class := Safety);
  END_TAG
";

/// A project with a counter of scans, a timer, a latch, and this rung.
fn project(rung: &str) -> String {
    format!(
        "CONTROLLER Cell (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0003)
{DECLARATIONS}  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")
    ROUTINE Main
      N: ADD(Scans,1,Scans);
      N: XIO(Doors:I.ConnectionFaulted)TON(Wait,?,?);
      N: XIC(Doors:I.Pt00Data)OTL(Latched);
      N: {rung};
    END_ROUTINE
  END_PROGRAM
  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5)
    Safety_Main;
  END_TASK
END_CONTROLLER
"
    )
}

const BEFORE: &str = "XIC(Doors:I.Pt00Data)OTE(Drives:O.Pt00Data)";
const AFTER: &str = "XIC(Doors:I.Pt00Data)XIC(Doors:I.Pt01Data)OTE(Drives:O.Pt00Data)";

/// With the project downloaded, and the changed one beside it.
fn with_project() -> Cell {
    let cell = Cell::with_project(&project(BEFORE));
    cell.write("changed.rll", &project(AFTER));
    cell
}

/// The words that begin an edit to a text.
fn begin(cell: &Cell, text: &str) -> String {
    cell.write("edit.rll", text);
    format!("edit begin {}", cell.path("edit.rll").display())
}

fn stage(cell: &Cell) -> serde_json::Value {
    cell.status()["online_edit"].clone()
}

/// REQ-EDIT-001. From a changed rung to the program.
#[test]
fn edit_when_each_step_is_taken_then_the_program_is_the_changed_one() {
    let cell = with_project();
    let changed = cell.path("changed.rll").display().to_string();
    assert!(cell.done(&format!("edit begin {changed}")).contains("changes Safety_Main/Main"));
    cell.refused("edit test", "P54");
    cell.refused("lock", "P33");
    cell.done("edit accept");
    cell.refused(&format!("edit begin {changed}"), "P58");
    cell.refused("generate", "P24");
    assert!(cell.done("edit test").contains("allow 2 ms more on the watchdog of 10.000 ms"));
    cell.done("edit untest");
    cell.done("edit test");
    cell.done("edit assemble");
    assert_eq!(stage(&cell), serde_json::Value::Null);
    assert!(cell.done(&format!("compare {changed}")).contains("they are the same application"));
}

/// REQ-EDIT-001.
#[test]
fn edit_when_it_is_cancelled_then_the_program_is_what_it_was() {
    let cell = with_project();
    cell.done(&format!("edit begin {}", cell.path("changed.rll").display()));
    cell.done("edit accept");
    cell.done("edit cancel");
    cell.refused("edit cancel", "P57");
    let own = cell.path("project.rll").display().to_string();
    assert!(cell.done(&format!("compare {own}")).contains("they are the same application"));
}

/// REQ-EDIT-001. 1756-RM093 Online Editing: they may exist when the application is locked, and are neither assembled nor cancelled.
#[test]
fn edit_when_the_controller_is_locked_or_signed_then_it_stays_as_it_is() {
    let cell = with_project();
    let begin = format!("edit begin {}", cell.path("changed.rll").display());
    cell.done(&begin);
    cell.done("edit accept");
    cell.done("lock");
    cell.refused("edit assemble", "P51");
    cell.refused("edit cancel", "P51");
    cell.done("unlock");
    cell.done("edit cancel");
    cell.done("generate --clock 2026-11-22T18:00:00Z");
    cell.refused(&begin, "P52");
}

/// REQ-EDIT-002.
#[test]
fn edit_when_something_else_than_rungs_changes_then_it_is_refused_with_what_it_is() {
    let cell = with_project();
    let before = project(BEFORE);
    let others = [
        (before.replace("Latched : BOOL", "Latched, More : BOOL"), "tags"),
        (before.replace("Rate := 10, Watchdog := 10", "Rate := 20, Watchdog := 10"), "task"),
        (before.replace("RPI := 10", "RPI := 20"), "module"),
        (before.clone(), "no rung of a safety routine differs"),
    ];
    for (text, words) in others {
        cell.refused(&begin(&cell, &text), words);
    }
    assert_eq!(stage(&cell), serde_json::Value::Null);
}

/// REQ-EDIT-003. The switch would be that tag, and the changed rungs would never execute.
#[test]
fn edit_when_a_program_tag_has_the_name_of_the_switch_then_it_is_refused() {
    let with_tag = |rung: &str| {
        let tag = "MAIN := \"Main\")\n    TAG\n      online_edit_tested : BOOL;\n    END_TAG\n";
        project(rung).replacen("MAIN := \"Main\")\n", tag, 1)
    };
    let cell = Cell::with_project(&with_tag(BEFORE));
    cell.refused(&begin(&cell, &with_tag(AFTER)), "a tag is called Online_Edit_Tested");
}

/// REQ-EDIT-003. Jumps in a zone that is off do not jump: rungs of both versions would execute.
#[test]
fn edit_when_it_changes_a_rung_in_a_zone_then_it_is_refused_and_behind_the_zone_it_is_not() {
    let zone = |inside: &str, behind: &str| {
        project(&format!("XIC(Doors:I.Pt01Data)MCR();\n      N: {inside};\n      N: MCR();\n      N: {behind}"))
    };
    let cell = Cell::with_project(&zone("OTE(Drives:O.Pt01Data)", BEFORE));
    let inside = zone("XIC(Latched)OTE(Drives:O.Pt01Data)", BEFORE);
    cell.refused(&begin(&cell, &inside), "stand in an MCR zone");
    let behind = zone("OTE(Drives:O.Pt01Data)", AFTER);
    cell.done(&begin(&cell, &behind));
}

/// REQ-EDIT-002. What GSV names is part of the rung.
#[test]
fn edit_when_a_changed_rung_reads_an_attribute_of_the_controller_then_it_executes() {
    let cell = Cell::with_project(&project(BEFORE));
    cell.done("mode run");
    cell.done(&begin(&cell, &project("GSV(SAFETY,,SafetySignatureExists,Exists)")));
    cell.done("edit accept");
    cell.done("run --test-edits 20 --until 40 --quiet");
    cell.done("edit assemble");
    cell.done("run --until 40 --quiet");
}

/// REQ-EDIT-002. The name of an Add-On Instruction or of a tag is no jump.
#[test]
fn edit_when_a_rung_names_what_only_looks_like_a_jump_then_it_is_not_refused() {
    let with_type = |rung: &str| {
        let definition = "  ADD_ON_INSTRUCTION_DEFINITION My_JMP (Class := Safety)\n    PARAMETERS\n      From : BOOL (Usage := Input, Required := Yes);\n    END_PARAMETERS\n    ROUTINE Logic\n      N: NOP();\n    END_ROUTINE\n  END_ADD_ON_INSTRUCTION_DEFINITION\n";
        let text = project(rung).replacen("  MODULE Rack", &format!("{definition}  MODULE Rack"), 1);
        text.replacen("  TAG\n", "  TAG\n    One : My_JMP (Class := Safety);\n", 1)
    };
    let cell = Cell::with_project(&with_type(BEFORE));
    let said = cell.ask(&begin(&cell, &with_type("My_JMP(One,Latched)")));
    assert_eq!(said.code, Some(0), "{}", said.out);
}

/// REQ-EDIT-002. dual-channel-inputs.md 1.2: configuration takes effect with a change from Program to Run.
#[test]
fn edit_when_it_changes_a_safety_application_instruction_then_it_is_refused() {
    let sample = fs::read_to_string(project_path("samples/estop-with-contactors/project.rll")).unwrap();
    let cell = Cell::new();
    cell.write("sample.rll", &sample);
    cell.done(&format!("download {}", cell.path("sample.rll").display()));
    let changed = sample.replace(",500,", ",600,");
    assert_ne!(changed, sample);
    cell.refused(&begin(&cell, &changed), "changes no safety application instruction");
}

/// REQ-EDIT-003. Before, while and after it is tested.
#[test]
fn run_when_an_edit_is_accepted_tested_and_untested_then_the_rungs_of_its_stage_execute() {
    let cell = with_project();
    cell.done("mode run");
    cell.write("stimulus.csv", "time_ms,Doors:I.Pt00Data\n0,1\n");
    cell.done(&format!("edit begin {}", cell.path("changed.rll").display()));
    let outputs = ["accept", "test", "untest"].map(|step| {
        cell.done(&format!("edit {step}"));
        let (stimulus, out) = (cell.path("stimulus.csv"), cell.path("out.csv"));
        let (stimulus, out) = (stimulus.display(), out.display());
        cell.done(&format!(
            "run --stimulus {stimulus} --record Scans,Published:Drives:O.Pt00Data --out {out} --until 20 --quiet"
        ));
        fs::read_to_string(cell.path("out.csv")).unwrap()
    });
    let original = "time_ms,Scans,Published:Drives:O.Pt00Data\n0,1,1\n10,2,1\n20,3,1\n";
    let changed = original.replace(",1\n", ",0\n");
    assert_eq!(outputs, [original, changed.as_str(), original]);
}

/// REQ-EDIT-003. Values, timers and latches go on; the changed rung executes from the scan boundary on, and back again.
#[test]
fn tags_when_an_edit_is_tested_and_untested_in_a_run_then_they_go_on_and_only_the_rung_changes() {
    let cell = with_project();
    cell.done("mode run");
    cell.write("stimulus.csv", "time_ms,Doors:I.Pt00Data\n0,1\n");
    cell.done(&format!("edit begin {}", cell.path("changed.rll").display()));
    cell.done("edit accept");
    let (stimulus, out) = (cell.path("stimulus.csv"), cell.path("out.csv"));
    let run = format!(
        "run --stimulus {} --record Scans,Wait.ACC,Latched,Published:Drives:O.Pt00Data --out {} --until 90 --quiet",
        stimulus.display(),
        out.display()
    );
    cell.refused(&format!("{run} --untest-edits 45"), "P56");
    cell.done(&format!("{run} --test-edits 45 --untest-edits 75"));
    let expected = "time_ms,Scans,Wait.ACC,Latched,Published:Drives:O.Pt00Data
0,1,0,1,1
10,2,10,1,1
20,3,20,1,1
30,4,30,1,1
40,5,40,1,1
50,6,50,1,0
60,7,60,1,0
70,8,70,1,0
80,9,80,1,1
90,10,90,1,1
";
    assert_eq!(fs::read_to_string(&out).unwrap(), expected);
    assert_eq!(stage(&cell), "accepted: the original rungs execute");
    cell.done(&format!("{run} --test-edits 45"));
    assert_eq!(stage(&cell), "tested: the changed rungs execute");
}

/// REQ-EDIT-003. A moment that the scans did not come to.
#[test]
fn edit_when_the_run_ends_before_it_is_tested_then_it_stays_accepted() {
    let cell = with_project();
    cell.done("mode run");
    cell.done(&format!("edit begin {}", cell.path("changed.rll").display()));
    cell.done("edit accept");
    cell.done("run --test-edits 25 --until 24 --quiet");
    assert_eq!(stage(&cell), "accepted: the original rungs execute");
    cell.done("run --test-edits 25 --until 29 --quiet");
    assert_eq!(stage(&cell), "accepted: the original rungs execute");
    cell.done("run --test-edits 25 --until 30 --quiet");
    assert_eq!(stage(&cell), "tested: the changed rungs execute");
}

/// REQ-EDIT-003, REQ-EDIT-004. What would come after the task stopped does not happen.
#[test]
fn edit_when_a_changed_rung_faults_then_the_rung_is_named_and_the_edit_stays_tested() {
    let cell = with_project();
    cell.done("mode run");
    cell.done(&begin(&cell, &project("XIC(Doors:I.Pt00Data)MOV(Levels[Scans],Level)")));
    cell.done("edit accept");
    cell.write("stimulus.csv", "time_ms,Doors:I.Pt00Data\n0,1\n");
    let stimulus = cell.path("stimulus.csv");
    let said =
        cell.ask(&format!("run --stimulus {} --test-edits 0 --untest-edits 30 --until 50 --quiet", stimulus.display()));
    assert_eq!(said.code, Some(4), "{}{}", said.out, said.err);
    let place = "major fault 4/20 at Safety_Main/Main, rung 3 of the changed rungs, instruction 1";
    assert!(said.out.contains(place), "{}", said.out);
    assert!(cell.status()["fault"]["what"].as_str().unwrap().contains(place));
    assert_eq!(stage(&cell), "tested: the changed rungs execute");
}

/// REQ-EDIT-003. A sample with safety application instructions: while the changed rungs do the same as the original ones, the
/// recording with a change in its middle is the one without.
#[test]
fn sample_when_an_edit_that_changes_nothing_is_tested_then_its_recording_is_the_same() {
    let folder = project_path("samples/two-hand-press");
    let sample = fs::read_to_string(folder.join("project.rll")).unwrap();
    let rung = sample.lines().find(|line| line.trim_start().starts_with("N: XIC(") && line.contains("OTE(")).unwrap();
    let same = rung.replacen("N: XIC(", "N: XIO(Always_Off_Here)XIC(", 1);
    let declared = |text: &str| text.replacen("  TAG\n", "  TAG\n    Always_Off_Here : BOOL (Class := Safety);\n", 1);
    let (before, changed) = (declared(&sample), declared(&sample).replacen(rung, &same, 1));
    let cell = Cell::new();
    cell.write("sample.rll", &before);
    cell.done(&format!("download {}", cell.path("sample.rll").display()));
    cell.done("mode run");
    let names = fs::read_to_string(folder.join("record.txt")).unwrap();
    let names: Vec<&str> = names.lines().filter(|line| !line.is_empty() && !line.starts_with('#')).collect();
    let record = |more: &str| {
        let out = cell.path("out.csv");
        let (stimulus, names) = (folder.join("stimulus.csv"), names.join(","));
        cell.done(&format!(
            "run --stimulus {} --record {names} --out {} --quiet{more}",
            stimulus.display(),
            out.display()
        ));
        fs::read_to_string(out).unwrap()
    };
    let plain = record("");
    cell.done(&begin(&cell, &changed));
    cell.done("edit accept");
    assert_eq!(record(" --test-edits 2000 --untest-edits 4000"), plain);
}
