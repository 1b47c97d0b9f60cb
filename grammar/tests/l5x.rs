//! A partial L5X with every kind of component: everything in it is read, with places in the XML.

use twinrung_grammar::tree::{Data, DataForm, ExternalAccess, RoutineBody, Sources, Tag, TagKind, Usage, Value};
use twinrung_grammar::{Reading, read};

const SAMPLE: &str = include_str!("samples/context.L5X");

fn sample() -> (Sources, Reading) {
    let mut sources = Sources::new();
    let reading = read(&mut sources, "context.L5X", SAMPLE.into());
    (sources, reading)
}

fn tag(reading: &Reading, name: &str) -> Tag {
    reading.file.tags.iter().find(|tag| tag.name.is(name)).unwrap().clone()
}

fn forms(data: &[Data]) -> Vec<DataForm> {
    data.iter().map(|data| data.form).collect()
}

#[test]
fn export_when_read_then_has_no_error() {
    assert_eq!(sample().1.errors, []);
}

/// REQ-LANG-012
#[test]
fn export_when_partial_then_says_what_was_exported() {
    let (_, reading) = sample();
    let export = reading.file.export.unwrap();
    assert!(export.is_partial());
    assert!(export.target_type.unwrap().is("Program") && export.target_class.unwrap().is("Safety"));
    assert_eq!(reading.file.controller.unwrap().usage, Usage::Context);
    assert_eq!(reading.file.data_types[0].usage, Usage::Context);
    assert_eq!(reading.file.programs[0].usage, Usage::Target);
    assert_eq!(reading.file.programs[0].routines[0].usage, Usage::Target);
}

#[test]
fn safety_tag_map_when_an_element_then_is_read_with_places() {
    let (sources, reading) = sample();
    let safety = reading.file.controller.unwrap().safety.unwrap();
    let pairs: Vec<_> = safety
        .tag_map
        .iter()
        .map(|entry| (sources.text(entry.standard.span), sources.text(entry.safety.span)))
        .collect();
    assert_eq!(pairs, [("Panel_Reset", "Reset"), ("Panel_Mode", "Mode")]);
    assert_eq!(safety.level.unwrap().text, "SIL3/PLe");
}

#[test]
fn member_when_a_bit_then_has_its_host() {
    let (_, reading) = sample();
    let members = &reading.file.data_types[0].members;
    assert!(members[0].hidden);
    assert_eq!(members[1].bit.as_ref().unwrap().number.value, 3);
    assert_eq!(members[1].external_access.unwrap().value, ExternalAccess::ReadOnly);
}

/// REQ-LANG-010, REQ-LANG-014
#[test]
fn module_when_read_then_has_its_place_and_connections() {
    let (_, reading) = sample();
    let module = &reading.file.modules[0];
    assert_eq!(module.slot.map(|slot| slot.value), Some(3));
    assert!(module.electronic_key.as_ref().unwrap().is("CompatibleModule"));
    assert_eq!(module.configuration.as_ref().unwrap().data_type.as_ref().unwrap().as_str(), "AB:1734_IB8S:C:0");
    assert!(module.opaque[0].kind.is("SafetyScript"));
    assert!(matches!(&module.opaque[0].value, Value::List { items, .. } if items.len() == 4));
    let connection = &module.connections[0];
    assert_eq!(connection.rpi_us.map(|time| time.value), Some(10_000));
    assert_eq!(connection.reaction_time_limit_us.map(|time| time.value), Some(40_064));
    assert_eq!(connection.input.as_ref().unwrap().suffix, "SI");
}

/// REQ-LANG-011
#[test]
fn tag_when_its_data_have_several_forms_then_all_are_kept() {
    let (_, reading) = sample();
    let delay = tag(&reading, "Delay");
    assert_eq!(forms(&delay.data), [DataForm::Raw, DataForm::L5k, DataForm::Decorated]);
    assert_eq!(forms(&delay.forces), [DataForm::Raw]);
    assert!(matches!(&delay.data[0].value, Value::Bytes { bytes, .. } if bytes[4..6] == [0x88, 0x13]));
    assert!(matches!(&delay.data[2].value, Value::Structure { members, .. } if members[0].data_type == "DINT"));
    assert_eq!(delay.comments[0].operand.as_str(), ".DN");
    assert_eq!(forms(&tag(&reading, "Title").data), [DataForm::String]);
}

#[test]
fn tag_when_an_array_then_has_dimensions_and_indices() {
    let (_, reading) = sample();
    let grid = tag(&reading, "Grid");
    assert_eq!(grid.dimensions.sizes(), [2, 2]);
    assert!(matches!(&grid.data[0].value, Value::Array { elements, .. } if elements[0].0.sizes() == [0, 1]));
}

#[test]
fn tag_when_not_base_then_is_of_its_kind() {
    let (_, reading) = sample();
    assert!(matches!(tag(&reading, "Sent").kind, TagKind::Produced(info) if info.rpi_us.unwrap().value == 20_500));
    assert!(
        matches!(tag(&reading, "Received").kind, TagKind::Consumed(info) if info.producer.as_ref().unwrap().is("Other"))
    );
    assert!(matches!(tag(&reading, "Short").kind, TagKind::Alias(target) if target.text == "Doors:SI.Pt00Data"));
}

/// REQ-LANG-013
#[test]
fn routine_when_of_any_language_then_is_named() {
    let (_, reading) = sample();
    let routines = &reading.file.programs[0].routines;
    assert_eq!(routines[0].rungs()[0].comment.as_ref().unwrap().text, "two\nlines");
    assert!(matches!(&routines[1].body, RoutineBody::Island { language, .. } if language.is("ST")));
    assert!(matches!(&routines[2].body, RoutineBody::Ladder(rungs) if rungs.is_empty()));
    assert!(matches!(&routines[3].body, RoutineBody::Encoded { .. }));
    assert!(reading.file.islands[0].kind.is("Trends"));
}

#[test]
fn names_when_read_then_are_where_their_spans_say() {
    let (sources, reading) = sample();
    let program = &reading.file.programs[0];
    assert_eq!(sources.text(program.name.span), "Guard");
    assert_eq!(sources.text(program.fault_routine.as_ref().unwrap().span), "Fault");
    assert_eq!(sources.text(program.routines[0].rungs()[0].span), "XIC(Delay.DN)OTE(Short);");
    assert_eq!(sources.line_column(program.name.span).line, 46);
}
