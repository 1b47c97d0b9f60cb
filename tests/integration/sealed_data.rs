//! What an instruction signature and a safety instruction signature cover beside rungs: initial values, in whatever form a file
//! writes them, and the types and instructions that an instruction uses.

use std::fs;
use std::path::PathBuf;

use crate::cell::Cell;
use crate::command::twinrung;
use crate::support::project_path;

const CLOCK: &str = "2026-11-22T18:00:00Z";

/// `Outer` uses the type `Pair_T`, the instruction `Limit_Check`, and through it the type `Range_T`.
const PROJECT: &str =
    "CONTROLLER Cell (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)
  DATATYPE Range_T
    DINT Low;
    DINT High;
  END_DATATYPE
  DATATYPE Pair_T
    DINT First;
    Limit_Check Within;
  END_DATATYPE
  ADD_ON_INSTRUCTION_DEFINITION Limit_Check (Class := Safety, Revision := \"1.0\")
    PARAMETERS
      Value : DINT (Usage := Input, Required := Yes, Visible := Yes);
      Above : BOOL (Usage := Output, Required := No, Visible := Yes);
    END_PARAMETERS
    LOCAL_TAGS
      Limit : DINT := 500;
      Range : Range_T;
    END_LOCAL_TAGS
    ROUTINE Logic
      N: GRT(Value,Limit)OTE(Above);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
  ADD_ON_INSTRUCTION_DEFINITION Outer (Class := Safety, Revision := \"1.0\")
    PARAMETERS
      Speed : DINT (Usage := Input, Required := Yes, Visible := Yes);
      Stop : BOOL (Usage := Output, Required := No, Visible := Yes);
    END_PARAMETERS
    LOCAL_TAGS
      Inner : Limit_Check;
      Pairs : Pair_T;
    END_LOCAL_TAGS
    ROUTINE Logic
      N: Limit_Check(Inner,Speed);
      N: XIC(Inner.Above)OTE(Stop);
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
  TAG
    Watch : Outer (Class := Safety);
    Speed : DINT (Class := Safety);
  END_TAG
  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")
    ROUTINE Main
      N: Outer(Watch,Speed);
    END_ROUTINE
  END_PROGRAM
  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5)
    Safety_Main;
  END_TASK
END_CONTROLLER
";

fn signature(cell: &Cell, action: &[&str]) -> String {
    let path = cell.path("project.rll").display().to_string();
    let arguments: Vec<&str> = ["signature", &path].into_iter().chain(action.iter().copied()).collect();
    let said = twinrung(&arguments);
    assert_eq!(said.code, Some(0), "{action:?}: {}{}", said.out, said.err);
    said.out
}

/// The project, with `Outer` sealed.
fn sealed() -> Cell {
    let cell = Cell::new();
    cell.write("project.rll", PROJECT);
    signature(&cell, &["generate", "Outer", "--clock", CLOCK]);
    cell
}

fn codes_of(path: PathBuf) -> Vec<String> {
    let said = twinrung(&["check", path.to_str().unwrap(), "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    json["findings"].as_array().unwrap().iter().map(|one| one["code"].as_str().unwrap().to_owned()).collect()
}

fn is_refused(path: PathBuf) -> bool {
    codes_of(path).contains(&"S0801".to_owned())
}

fn change(cell: &Cell, from: &str, to: &str) {
    let text = fs::read_to_string(cell.path("project.rll")).unwrap();
    assert!(text.contains(from), "{from}");
    cell.write("project.rll", &text.replacen(from, to, 1));
}

/// REQ-SIGN-006, REQ-SIGN-007. Zeros are data where the type holds something else, and what is used is content.
#[test]
fn check_when_data_or_what_a_sealed_instruction_uses_was_changed_then_it_is_refused() {
    let changes = [
        ("Inner : Limit_Check;", "Inner : Limit_Check := [0,0,0,0,0,[0,0]];"),
        ("Pairs : Pair_T;", "Pairs : Pair_T := [0,[0,0,0,0,0,[0,0]]];"),
        ("Limit : DINT := 500;", "Limit : DINT := 5000;"),
        ("GRT(Value,Limit)", "GEQ(Value,Limit)"),
        ("DINT Low;", "INT Low;"),
        ("DINT First;", "INT First;"),
    ];
    for (from, to) in changes {
        let cell = sealed();
        assert!(!is_refused(cell.path("project.rll")));
        change(&cell, from, to);
        let codes = codes_of(cell.path("project.rll"));
        assert!(codes.contains(&"S0801".to_owned()), "{to}: {codes:?}");
    }
}

/// REQ-SIGN-006. What only says the same in another way is no other content.
#[test]
fn check_when_data_says_what_the_language_assumes_then_the_seal_holds() {
    for (from, to) in [("Range : Range_T;", "Range : Range_T := [0,0];"), ("DINT := 500;", "DINT := 16#01f4;")] {
        let cell = sealed();
        change(&cell, from, to);
        assert!(!is_refused(cell.path("project.rll")), "{to}");
    }
}

/// REQ-SIGN-007. A reference of the same name stands beside the definition; what is compiled is what is sealed.
#[test]
fn check_when_the_sealed_content_stands_in_a_mere_reference_then_the_compiled_one_is_judged() {
    for (kind, end) in [
        ("ADD_ON_INSTRUCTION_DEFINITION Limit_Check", "END_ADD_ON_INSTRUCTION_DEFINITION\n"),
        ("DATATYPE Pair_T", "END_DATATYPE\n"),
    ] {
        let cell = sealed();
        let text = fs::read_to_string(cell.path("project.rll")).unwrap();
        let at = text.find(kind).unwrap();
        let definition = &text[at..at + text[at..].find(end).unwrap() + end.len()];
        let line = definition.lines().next().unwrap();
        let setting = if line.contains('(') {
            line.replacen('(', "(Use := Reference, ", 1)
        } else {
            format!("{line} (Use := Reference)")
        };
        let reference = definition.replacen(line, &setting, 1);
        let other = definition.replacen("GRT(", "GEQ(", 1).replacen("DINT First", "DINT Other", 1);
        cell.write("project.rll", &text.replacen(definition, &format!("{reference}  {other}"), 1));
        assert!(is_refused(cell.path("project.rll")), "{kind}");
    }
}

/// REQ-SIGN-006, REQ-SIGN-007. An export writes data by member name, as words, and as bytes.
#[test]
fn check_when_data_of_an_export_changes_in_any_of_its_forms_then_the_seal_is_broken() {
    let export = fs::read_to_string(project_path("samples/add-on-instruction/project.L5X")).unwrap();
    let forms = [
        (
            "<DefaultData Format=\"Decorated\"><Structure DataType=\"TIMER\"><DataValueMember Name=\"PRE\" DataType=\"DINT\" Radix=\"Decimal\" Value=\"150\"/></Structure></DefaultData>",
            "\"150\"",
            "\"1500\"",
        ),
        ("<DefaultData>00 00 00 00 96 00 00 00 00 00 00 00</DefaultData>", " 96 00", " 96 01"),
        ("<DefaultData Format=\"L5K\"><![CDATA[[0,150,0]]]></DefaultData>", ",150,", ",1500,"),
    ];
    let cell = Cell::new();
    let ids = forms.map(|(data, from, to)| {
        let with = |data: &str| {
            let tag = export.find("<LocalTag Name=\"Travel\"").unwrap();
            let end = tag + export[tag..].find("/>").unwrap();
            format!("{}>{data}</LocalTag>{}", &export[..end], &export[end + 2..])
        };
        let id_of = |data: &str| {
            let seal = format!(
                "<AddOnInstructionDefinition InstructionSignature=\"{}\" InstructionSignatureTimestamp=\"{CLOCK}\" ",
                "0".repeat(64)
            );
            cell.write("project.L5X", &with(data).replacen("<AddOnInstructionDefinition ", &seal, 1));
            let said = twinrung(&["check", cell.path("project.L5X").to_str().unwrap()]);
            let at = said.out.find("its content is ").unwrap_or_else(|| panic!("{}", said.out));
            said.out[at..].split_whitespace().nth(3).unwrap().to_owned()
        };
        let (before, after) = (id_of(data), id_of(&data.replacen(from, to, 1)));
        assert_ne!(before, after, "{data}");
        before
    });
    assert_eq!(ids[0], ids[1]);
    assert_eq!(ids[0], ids[2]);
}

/// REQ-SIGN-009. What decides what executes is compared: initial values, and the types and instructions that are used.
#[test]
fn compare_when_what_executes_was_changed_then_it_is_named() {
    let changes = [
        ("Limit : DINT := 500;", "Limit : DINT := 5000;"),
        ("GRT(Value,Limit)", "GEQ(Value,Limit)"),
        ("DINT Low;", "INT Low;"),
        ("DINT First;", "INT First;"),
    ];
    for (from, to) in changes {
        let cell = Cell::new();
        cell.write("project.rll", PROJECT);
        let recorded = signature(&cell, &["--format", "json"]);
        cell.write("recorded.json", &recorded);
        change(&cell, from, to);
        let (path, recorded) = (cell.path("project.rll"), cell.path("recorded.json"));
        let said = twinrung(&["signature", path.to_str().unwrap(), "compare", recorded.to_str().unwrap()]);
        assert_eq!(said.code, Some(1), "{to}: {}", said.out);
        assert!(
            said.out.contains("Outer: the safety instruction signature is another: it executes otherwise"),
            "{to}: {}",
            said.out
        );
    }
}

/// REQ-SIGN-006. Layout is no content.
#[test]
fn signature_when_a_sealed_project_is_formatted_then_it_stays() {
    let cell = sealed();
    change(&cell, "      N: XIC(Inner.Above)OTE(Stop);", "   N:    XIC( Inner.Above )  OTE(Stop) ;");
    let before = signature(&cell, &["--format", "json"]);
    let said = twinrung(&["fmt", cell.path("project.rll").to_str().unwrap()]);
    assert_eq!(said.code, Some(0), "{}{}", said.out, said.err);
    assert_eq!(signature(&cell, &["--format", "json"]), before);
}
