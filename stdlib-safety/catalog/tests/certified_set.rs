//! The catalog against the reference's lists, where the folder `../shared` is at hand.

use std::collections::BTreeMap;
use std::path::Path;
use twinrung_catalog::{Element, Group, Instruction, Requires, instructions, types};

type Row = BTreeMap<String, String>;

/// The rows of a CSV file of the reference by column name; nothing where the folder is missing.
fn reference_rows(file: &str) -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/reference").join(file);
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| {
        eprintln!("skipped: {file}: {error}");
        String::new()
    });
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let header = lines.next().unwrap_or_default();
    lines.map(|cells| header.iter().cloned().zip(cells).collect()).collect()
}

fn group_of(row: &Row) -> Group {
    match row["group"].as_str() {
        "bit" => Group::Bit,
        "timer" | "counter" => Group::TimerCounter,
        "compare" => Group::Compare,
        "move" => Group::Move,
        "logical" => Group::Logical,
        "math" => Group::Math,
        "array" => Group::Array,
        "program-control" => Group::ProgramControl,
        "io" => Group::InputOutput,
        "safety-application" => Group::SafetyApplication,
        "metal-form" => Group::MetalForm,
        "safety-application-v14" => Group::SafetyApplicationV14,
        other => panic!("unknown group {other}"),
    }
}

fn requirement_of(row: &Row) -> Requires {
    match row["targets"].as_str() {
        "all" => Requires::Any,
        "L7x" => Requires::L7x,
        "real-capable" => Requires::Real,
        other => panic!("unknown targets {other}"),
    }
}

fn table_of(row: &Row) -> String {
    match row["table"].as_str() {
        "App. F" => "1756-RM093 Appendix F".to_owned(),
        number => format!("1756-RM093 Table {number}"),
    }
}

#[test]
fn certified_set_when_compared_with_catalog_then_every_row_is_declared_as_listed() {
    for row in reference_rows("certified-set.csv") {
        let mnemonic = &row["mnemonic"];
        let instruction = Instruction::by_mnemonic(mnemonic).unwrap_or_else(|| panic!("{mnemonic} is not declared"));
        assert_eq!(instruction.mnemonic, mnemonic);
        assert_eq!(instruction.name, row["name"], "{mnemonic}");
        assert_eq!(instruction.group, group_of(&row), "{mnemonic}");
        assert_eq!(instruction.first_version.to_string(), row["min_version"], "{mnemonic}");
        assert_eq!(instruction.requires, requirement_of(&row), "{mnemonic}");
        assert_eq!(instruction.source, table_of(&row), "{mnemonic}");
    }
}

#[test]
fn catalog_when_compared_with_certified_set_then_nothing_else_is_declared() {
    let rows = reference_rows("certified-set.csv");
    let listed: Vec<&str> = rows.iter().map(|row| row["mnemonic"].as_str()).collect();
    let unlisted: Vec<&str> = instructions::ALL
        .iter()
        .map(|instruction| instruction.mnemonic)
        .filter(|mnemonic| !listed.is_empty() && !listed.contains(mnemonic))
        .collect();
    assert_eq!(unlisted, Vec::<&str>::new());
}

#[test]
fn safety_types_when_compared_with_catalog_then_every_type_is_known() {
    let rows = reference_rows("safety-types.csv");
    let unknown: Vec<&str> = rows
        .iter()
        .map(|row| row["type"].as_str())
        .filter(|name| {
            Element::by_name(name).is_none()
                && types::ALL.iter().all(|known| known.name != *name)
                && !types::LISTED_WITHOUT_LAYOUT.contains(name)
        })
        .collect();
    assert_eq!(unknown, Vec::<&str>::new());
}

#[test]
fn predefined_types_when_compared_with_safety_types_then_only_dcaf_input_is_added() {
    let rows = reference_rows("safety-types.csv");
    let listed: Vec<&str> = rows.iter().map(|row| row["type"].as_str()).collect();
    let added: Vec<&str> = types::ALL
        .iter()
        .map(|known| known.name)
        .chain(types::LISTED_WITHOUT_LAYOUT.iter().copied())
        .filter(|name| !listed.is_empty() && !listed.contains(name) && *name != "DCAF_INPUT")
        .collect();
    assert_eq!(added, Vec::<&str>::new());
}
