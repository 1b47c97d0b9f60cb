//! The conformance tables of the base instructions: every row on primary, partner and judge; every instruction of the
//! catalog with every kind of row; every requirement with a table that shows it; admission on each controller.
//!
//! `TWINRUNG_TABLES=ton,tof cargo test -p twinrung-conformance` runs the named tables only.

use std::collections::BTreeSet;

use twinrung_conformance::admission;
use twinrung_conformance::run::failures;
use twinrung_conformance::table::{Case, Show, Table};
use twinrung_conformance::{chosen_tables, tables};

/// Each requirement and a table with a case that shows it.
const REQUIREMENTS: &[(&str, &str)] = &[
    ("REQ-EXEC-001", "ote"),
    ("REQ-EXEC-002", "mov"),
    ("REQ-EXEC-003", "mov"),
    ("REQ-EXEC-004", "xic"),
    ("REQ-EXEC-005", "ons"),
    ("REQ-EXEC-006", "cop"),
    ("REQ-EXEC-010", "mov"),
    ("REQ-EXEC-011", "mov"),
    ("REQ-EXEC-012", "subscripts"),
    ("REQ-EXEC-013", "add"),
    ("REQ-EXEC-014", "jmp"),
    ("REQ-EXEC-015", "jmp"),
    ("REQ-EXEC-016", "jmp"),
    ("REQ-EXEC-017", "div"),
    ("REQ-EXEC-018", "sqr"),
    ("REQ-EXEC-019", "gsv"),
    ("REQ-EXEC-020", "xic"),
    ("REQ-EXEC-021", "mcr"),
    ("REQ-EXEC-022", "tnd"),
    ("REQ-EXEC-023", "jsr"),
    ("REQ-EXEC-024", "jsr"),
    ("REQ-EXEC-030", "add-on-instruction"),
    ("REQ-EXEC-031", "add-on-instruction"),
    ("REQ-EXEC-032", "add-on-instruction"),
    ("REQ-EXEC-033", "add-on-instruction"),
    ("REQ-EXEC-034", "add-on-instruction"),
    ("REQ-EXEC-040", "ton"),
    ("REQ-EXEC-041", "ton"),
    ("REQ-EXEC-050", "fault-routine"),
    ("REQ-EXEC-051", "fault-routine"),
    ("REQ-EXEC-052", "fault-routine"),
    ("REQ-EXEC-053", "jsr"),
    ("REQ-EXEC-054", "fault-routine"),
    ("REQ-EXEC-060", "safety-application"),
    ("REQ-EXEC-061", "safety-application"),
    ("REQ-EXEC-062", "safety-application"),
    ("REQ-EXEC-070", "fal"),
    ("REQ-EXEC-071", "fal"),
    ("REQ-EXEC-072", "fsc"),
];

#[test]
fn tables_when_run_on_primary_partner_and_judge_then_every_row_holds() {
    let (tables, unreadable) = chosen_tables();
    let mut failed = unreadable;
    failed.extend(tables.iter().flat_map(|table| table.cases.iter().flat_map(|case| failures(table, case))));
    let cases: usize = tables.iter().map(|table| table.cases.len()).sum();
    let rows: usize = tables.iter().flat_map(|table| &table.cases).map(|case| case.rows.len()).sum();
    println!("{} tables, {cases} cases, {rows} rows", tables.len());
    assert!(failed.is_empty(), "{} of the expectations fail:\n{}", failed.len(), failed.join("\n"));
}

#[test]
fn base_instructions_when_listed_then_each_has_true_false_prescan_fault_and_limit_rows() {
    let (tables, unreadable) = tables();
    assert!(unreadable.is_empty(), "{}", unreadable.join("\n"));
    println!("{:<6} {:>5} {:>6} {:>7} {:>6} {:>6} {:>6}", "", "true", "false", "prescan", "fault", "limit", "rows");
    let missing: Vec<String> = admission::base_instructions()
        .flat_map(|instruction| {
            let table = tables.iter().find(|table| table.instruction.as_deref() == Some(instruction.mnemonic));
            println!("{}", table.map_or_else(|| format!("{:<6} no table", instruction.mnemonic), line_of_report));
            Show::ALL
                .into_iter()
                .filter(move |show| !table.is_some_and(|table| has(table, *show)))
                .map(|show| format!("{} has no case that shows {}", instruction.mnemonic, show.word()))
        })
        .collect();
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

#[test]
fn tables_when_their_file_names_are_compared_then_each_is_named_after_its_instruction() {
    let (tables, _) = tables();
    let named = |table: &&Table| {
        table.instruction.as_ref().is_none_or(|name| table.file == format!("{}.table", name.to_ascii_lowercase()))
    };
    let wrong: Vec<&str> = tables.iter().filter(|table| !named(table)).map(|table| table.file.as_str()).collect();
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn base_instructions_when_compiled_for_each_controller_then_admitted_as_the_catalog_declares() {
    let wrong = admission::failures();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn requirements_when_looked_up_then_the_named_table_has_a_case_that_shows_each() {
    let (tables, _) = tables();
    let shows = |name: &str, requirement: &str| {
        let cases = tables.iter().filter(|table| table.file == format!("{name}.table")).flat_map(|table| &table.cases);
        cases.flat_map(|case: &Case| &case.requirements).any(|shown| shown == requirement)
    };
    let wrong: Vec<_> = REQUIREMENTS.iter().filter(|(requirement, name)| !shows(name, requirement)).collect();
    assert!(wrong.is_empty(), "no case shows {wrong:?}");
    let listed: BTreeSet<&str> = REQUIREMENTS.iter().map(|(requirement, _)| *requirement).collect();
    let shown = tables.iter().flat_map(|table| &table.cases).flat_map(|case| &case.requirements);
    let unlisted: BTreeSet<&String> = shown.filter(|shown| !listed.contains(shown.as_str())).collect();
    assert!(unlisted.is_empty(), "cases show what is not listed here: {unlisted:?}");
}

fn has(table: &Table, show: Show) -> bool {
    table.without.iter().any(|(without, _)| *without == show) || cases_that_show(table, show) > 0
}

fn cases_that_show(table: &Table, show: Show) -> usize {
    table.cases.iter().filter(|case| case.shows.contains(&show)).count()
}

fn line_of_report(table: &Table) -> String {
    let [yes, no, prescan, fault, limit] = Show::ALL.map(|show| cases_that_show(table, show));
    let rows: usize = table.cases.iter().map(|case| case.rows.len()).sum();
    let name = table.instruction.as_deref().unwrap_or_default();
    format!("{name:<6} {yes:>5} {no:>6} {prescan:>7} {fault:>6} {limit:>6} {rows:>6}")
}
