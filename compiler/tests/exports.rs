//! L5X exports: forms of data, tags of modules, partial exports with what completes them.

mod support;

use std::path::Path;

use support::{export, lines, read};
use twinrung_compiler::{Completion, check, compile};
use twinrung_grammar::tree::Sources;

fn bytes(name: &str, text: &str) -> Vec<u8> {
    let mut sources = Sources::new();
    let reading = read(&mut sources, name, text);
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    compile(&checked.project.unwrap_or_else(|| panic!("{shown}"))).unwrap().bytes
}

const AXIS: &str = "<Tag Name=\"Axis\" TagType=\"Base\" DataType=\"Axis_T\" Class=\"Safety\" Constant=\"false\" ExternalAccess=\"Read/Write\">";

#[test]
fn data_when_decorated_list_and_raw_agree_then_one_value() {
    let decorated = "<Data Format=\"Decorated\"><Structure DataType=\"Axis_T\"><DataValueMember Name=\"Enabled\" DataType=\"BOOL\" Value=\"0\"/><DataValueMember Name=\"Homed\" DataType=\"BOOL\" Value=\"1\"/><DataValueMember Name=\"Speed\" DataType=\"INT\" Radix=\"Decimal\" Value=\"-3\"/></Structure></Data>";
    let list = "<Data Format=\"L5K\"><![CDATA[[2,-3]]]></Data>";
    let raw = "<Data>02 00 FD FF</Data>";
    let rung = "XIC(Axis.Homed)OTE(Axis.Enabled);";
    let all = bytes("all.L5X", &export(&format!("{AXIS}{raw}{list}{decorated}</Tag>"), rung));
    let first = bytes("list.L5X", &export(&format!("{AXIS}{list}</Tag>"), rung));
    let second = bytes("raw.L5X", &export(&format!("{AXIS}{raw}</Tag>"), rung));
    assert!(all == first && all == second);
}

#[test]
fn data_when_two_forms_disagree_then_refused_at_the_other_form() {
    let tag = format!(
        "{AXIS}<Data Format=\"L5K\"><![CDATA[[2,-4]]]></Data><Data Format=\"Decorated\"><Structure DataType=\"Axis_T\"><DataValueMember Name=\"Enabled\" DataType=\"BOOL\" Value=\"0\"/><DataValueMember Name=\"Homed\" DataType=\"BOOL\" Value=\"1\"/><DataValueMember Name=\"Speed\" DataType=\"INT\" Radix=\"Decimal\" Value=\"-3\"/></Structure></Data></Tag>"
    );
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.L5X", &export(&tag, "XIC(Axis.Homed)OTE(Axis.Enabled);"));
    let checked = check(&reading, &Completion::default());
    let codes: Vec<&str> = checked.findings.iter().map(|finding| finding.code.id).collect();
    assert_eq!(codes, ["E0308"], "{}", lines(&sources, &checked));
}

#[test]
fn project_when_written_as_text_and_as_export_then_the_same_bytes() {
    let text = support::project(
        "  DATATYPE Axis_T\n    BOOL Enabled;\n    BOOL Homed;\n    INT Speed;\n  END_DATATYPE\n",
        "    Axis : Axis_T (Class := Safety) := [2,-3];",
        "XIC(Axis.Homed)[XIC(Axis.Enabled) ,]OTE(Axis.Enabled)",
        "",
    );
    let shown = export(
        &format!("{AXIS}<Data Format=\"L5K\"><![CDATA[[2,-3]]]></Data></Tag>"),
        "XIC(Axis.Homed)[XIC(Axis.Enabled) ,]OTE(Axis.Enabled);",
    );
    assert!(bytes("sample.rll", &text) == bytes("sample.L5X", &shown));
}

#[test]
fn partial_export_when_completed_with_its_rack_then_admitted() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/corpus/acd-l5x-tool-lib");
    let Ok(program) = std::fs::read(folder.join("SafetyProgram_Program.L5X")) else {
        println!("skipped: {} is not there", folder.display());
        return;
    };
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read(&mut sources, "SafetyProgram_Program.L5X", program);
    let rack = twinrung_grammar::read_path(&mut sources, &folder.join("ENET_ECP103_A_0_Module.L5X"));
    let completion = Completion {
        controller: Some("1756-L84ES".to_owned()),
        revision: Some(35),
        period_ms: Some(20),
        watchdog_ms: Some(20),
        contexts: vec![rack.file],
        ..Completion::default()
    };
    let checked = check(&reading, &completion);
    let shown = lines(&sources, &checked);
    let compiled = compile(&checked.project.unwrap_or_else(|| panic!("{shown}"))).unwrap();
    let image = twinrung_bytecode::admit(&compiled.bytes).unwrap();
    let names: Vec<&str> = image.image().tags.iter().map(|tag| tag.name.as_str()).collect();
    assert!(names.contains(&"ENET_ECP103_A_0:1:I") && names.contains(&"ENET_ECP103_A_0:3:O"), "{names:?}");
    assert!(image.image().routines.iter().any(|routine| routine.text.contains("OTE(ENET_ECP103_A_0:3:O.Pt00.Data)")));
}

#[test]
fn partial_export_when_nothing_completes_it_then_says_what_is_missing() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/corpus/acd-l5x-tool-lib");
    let mut sources = Sources::new();
    if !folder.exists() {
        println!("skipped: {} is not there", folder.display());
        return;
    }
    let reading = twinrung_grammar::read_path(&mut sources, &folder.join("SafetyProgram_Program.L5X"));
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    assert!(checked.project.is_none());
    assert!(shown.contains("E0401") && shown.contains("E0403") && shown.contains("ENET_ECP103_A_0:3:O"), "{shown}");
}
