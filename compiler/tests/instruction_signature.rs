//! The instruction signature covers what a person wrote into an Add-On Instruction and into what it uses, and nothing else.

mod support;

use support::{lines, project, read};
use twinrung_compiler::instruction_signature::{Definitions, ID, Seal, quoted, safety_add_ons, seal, set_seal};
use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::{Sources, Span};

const DEFINITIONS: &str = "  DATATYPE Axis_T
    DINT Speed;
    BOOL Homed;
  END_DATATYPE
  DATATYPE Other_T
    DINT Count;
  END_DATATYPE
  ADD_ON_INSTRUCTION_DEFINITION Inner (Class := Safety)
    PARAMETERS
      Go : BOOL (Usage := Input);
    END_PARAMETERS
    ROUTINE Logic
      N: XIC(Go)NOP();
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
  ADD_ON_INSTRUCTION_DEFINITION Unit (Class := Safety)
    PARAMETERS
      Start : BOOL (Usage := Input);
      Limit : DINT (Usage := Input) := 7;
      Axis : Axis_T (Usage := InOut);
    END_PARAMETERS
    LOCAL_TAGS
      Step : DINT := 3;
      Ratio : REAL;
      Own : Inner;
    END_LOCAL_TAGS
    ROUTINE Logic
      N: XIC(Start)[Inner(Own,Start) ,MOV(Limit,Step) ];
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
";

/// The instruction signature of `Unit`.
fn signature(definitions: &str) -> [u8; 32] {
    let mut sources = Sources::new();
    let reading =
        read(&mut sources, "sample.rll", &project(definitions, "    X : BOOL (Class := Safety);", "OTE(X)", ""));
    let checked = check(&reading, &Completion::default());
    let shown = lines(&sources, &checked);
    let project = checked.project.unwrap_or_else(|| panic!("{shown}"));
    let files = [&reading.file];
    let unit = safety_add_ons(&files).find(|one| one.name.is("Unit")).unwrap();
    Definitions::new(&files, &project).signature(unit)
}

/// The signature with this change.
fn with(from: &str, to: &str) -> [u8; 32] {
    let changed = DEFINITIONS.replacen(from, to, 1);
    assert_ne!(changed, DEFINITIONS, "{from}");
    signature(&changed)
}

#[test]
fn signature_when_the_logic_or_a_declaration_changes_then_another() {
    let first = signature(DEFINITIONS);
    for (from, to) in [
        ("XIC(Start)", "XIO(Start)"),
        ("N: XIC(Start)", "RC: \"Why.\";\n      N: XIC(Start)"),
        ("Limit : DINT (Usage := Input)", "Limit : DINT (Usage := Input, Description := \"mm/s\")"),
        ("Limit : DINT (Usage := Input) := 7", "Limit : DINT (Usage := Input) := 8"),
        ("Limit : DINT (Usage := Input)", "Limit : DINT (Usage := Input, Radix := Hex)"),
        ("Step : DINT := 3", "Step : DINT := 4"),
        ("Step : DINT", "Step : DINT (Radix := Hex)"),
        ("Ratio : REAL", "Ratio : REAL (Radix := Exponential)"),
        ("Unit (Class := Safety)", "Unit (Class := Safety, Description := \"A unit.\")"),
    ] {
        assert_ne!(with(from, to), first, "{from} -> {to}");
    }
}

#[test]
fn signature_when_what_it_uses_changes_then_another() {
    let first = signature(DEFINITIONS);
    assert_ne!(with("    BOOL Homed;\n", "    BOOL Ready;\n"), first);
    assert_ne!(with("XIC(Go)NOP()", "XIO(Go)NOP()"), first);
}

#[test]
fn signature_when_only_something_else_changes_then_the_same() {
    let first = signature(DEFINITIONS);
    assert_eq!(with("    DINT Count;\n", "    DINT Number;\n"), first);
}

#[test]
fn signature_when_the_same_is_said_in_another_way_then_the_same() {
    let first = signature(DEFINITIONS);
    for (from, to) in [
        ("Limit : DINT (Usage := Input)", "Limit : DINT (Usage := Input, Radix := Decimal)"),
        ("Limit : DINT (Usage := Input)", "Limit : DINT (Usage := Input, Constant := No)"),
        ("Step : DINT", "Step : DINT (Radix := Decimal)"),
        ("Ratio : REAL", "Ratio : REAL (Radix := Float)"),
        (
            "      Start : BOOL",
            "      EnableIn : BOOL (Usage := Input, Required := No, Visible := No);\n      EnableOut : BOOL (Usage := Output, Required := No, Visible := No);\n      Start : BOOL",
        ),
        ("Unit (Class := Safety)", "Unit (Class := Safety, ExecutePrescan := No)"),
    ] {
        assert_eq!(with(from, to), first, "{from} -> {to}");
    }
}

#[test]
fn safety_add_ons_when_a_file_holds_standard_ones_too_then_those_are_left_out() {
    let text = DEFINITIONS.replace("Inner (Class := Safety)", "Inner");
    let mut sources = Sources::new();
    let reading = read(&mut sources, "sample.rll", &project(&text, "", "NOP()", ""));
    let names: Vec<&str> = safety_add_ons(&[&reading.file]).map(|one| one.name.as_str()).collect();
    assert_eq!(names, ["Unit"]);
}

#[test]
fn seal_when_set_then_read_and_when_set_again_or_taken_away_then_nothing_else_is_lost() {
    let mut sources = Sources::new();
    let mut reading = read(&mut sources, "sample.rll", &project(DEFINITIONS, "", "NOP()", ""));
    let unit = reading.file.add_on_instructions.last_mut().unwrap();
    assert_eq!(seal(unit), Ok(None));
    unit.attributes.push(quoted("RevisionNote", "First."));
    set_seal(unit, Some(("ab".repeat(32), "2026-11-22 10:00".to_owned())));
    let read = |unit: &_| seal(unit).unwrap().map(|Seal { id, timestamp, .. }| (id, timestamp.to_string()));
    assert_eq!(read(unit), Some(([0xab; 32], "2026-11-22 10:00".to_owned())));
    set_seal(unit, Some(("cd".repeat(32), "2026-11-22 11:00".to_owned())));
    assert_eq!(read(unit), Some(([0xcd; 32], "2026-11-22 11:00".to_owned())));
    assert_eq!(unit.attributes.len(), 3);
    set_seal(unit, None);
    assert_eq!((read(unit), unit.attributes.len()), (None, 1));
}

#[test]
fn seal_when_its_id_is_no_hash_or_it_has_no_time_then_broken() {
    let mut sources = Sources::new();
    let mut reading = read(&mut sources, "sample.rll", &project(DEFINITIONS, "", "NOP()", ""));
    let unit = reading.file.add_on_instructions.last_mut().unwrap();
    set_seal(unit, Some(("ab".repeat(31), "2026-11-22 10:00".to_owned())));
    assert_eq!(seal(unit).unwrap_err().span, Span::default());
    set_seal(unit, None);
    unit.attributes.push(quoted(ID, "ab".repeat(32)));
    assert!(seal(unit).unwrap_err().message.contains("no date and time"));
}
