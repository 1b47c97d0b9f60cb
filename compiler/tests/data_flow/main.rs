//! Standard data on its way through every door: where it alone reaches a safety output it is refused, where safety data
//! stands in series it is not.

#[path = "../support/mod.rs"]
mod support;

mod cases;
mod initial_values;
mod instructions;
mod limits;
mod programs;
mod random;
mod reports;
mod sound;
mod three_valued;

use support::read;
use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::Sources;

const MODULES: &str = r#"  MODULE Rack (CatalogNumber := "1734-AENT", Parent := "Local", IPAddress := "192.168.1.10") END_MODULE
  MODULE In (CatalogNumber := "1734-IB8S", Parent := "Rack", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE
  MODULE Out (CatalogNumber := "1734-OB8S", Parent := "Rack", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE
"#;

const TAGS: &str = r#"    P, P2, P3 : BOOL;
    PN, PN2 : DINT;
    Std : BOOL (Class := Safety, MappedFrom := P);
    Std2 : BOOL (Class := Safety, MappedFrom := P2);
    Ack : BOOL (Class := Safety, MappedFrom := P3);
    Num : DINT (Class := Safety, MappedFrom := PN);
    Num2 : DINT (Class := Safety, MappedFrom := PN2);
    A, B, C, D, Edge : BOOL (Class := Safety);
    W, V, X, Y : DINT (Class := Safety);
    Words, More : DINT[8] (Class := Safety);
    Bits : BOOL[32] (Class := Safety);
    T : TIMER (Class := Safety);
    N : COUNTER (Class := Safety);
    K : CONTROL (Class := Safety);
    E : DCI_STOP (Class := Safety);
    R : CONFIGURABLE_ROUT (Class := Safety);
    Safe OF In:I.Pt00Data;
    Safe2 OF In:I.Pt01Data;
    Motor OF Out:O.Pt00Data;
    Lamp OF Out:O.Pt01Data;"#;

fn text(declarations: &str, tags: &str, rungs: &str, routines: &str) -> String {
    support::project(&format!("{declarations}{MODULES}"), &format!("{TAGS}\n{tags}"), rungs, routines)
}

/// The codes of the data flow, each with what it points at, and every other error.
fn findings(text: &str) -> Vec<String> {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", text);
    let checked = check(&reading, &Completion::default());
    let errors = checked.findings.iter().filter(|finding| finding.is_error());
    errors.map(|finding| format!("{} {}", finding.code.id, sources.text(finding.span))).collect()
}

/// The messages of all errors.
fn messages(text: &str) -> Vec<String> {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", text);
    let checked = check(&reading, &Completion::default());
    checked.findings.iter().filter(|finding| finding.is_error()).map(|finding| finding.message.to_string()).collect()
}

fn on_rungs(rungs: &str) -> Vec<String> {
    findings(&text("", "", rungs, ""))
}

fn refused(rungs: &str, expected: &[&str]) {
    assert_eq!(on_rungs(rungs), expected, "{rungs}");
}

fn accepted(rungs: &str) {
    refused(rungs, &[]);
}
