//! An L5K export of the shape of RM084: everything in it is read.

use twinrung_grammar::tree::{
    AttributeValue, Class, Element, ParameterUsage, RoutineBody, RungKind, Sources, TagKind, Value,
};
use twinrung_grammar::{Reading, print_file, print_rung, read};

const SAMPLE: &str = include_str!("samples/cell.L5K");

fn sample() -> Reading {
    read(&mut Sources::new(), "cell.L5K", SAMPLE.into())
}

#[test]
fn export_when_read_then_has_no_error() {
    assert_eq!(sample().errors, []);
}

#[test]
fn export_when_printed_then_reads_as_the_same_text() {
    let text = print_file(&sample().file);
    let again = read(&mut Sources::new(), "printed.rll", text.clone().into());
    assert_eq!(again.errors, []);
    assert_eq!(print_file(&again.file), text);
}

/// REQ-LANG-010
#[test]
fn controller_when_read_then_has_its_settings() {
    let file = sample().file;
    let controller = file.controller.unwrap();
    let safety = controller.safety.unwrap();
    assert_eq!(file.ie_version.unwrap().text, "2.11");
    assert_eq!(controller.description.unwrap().text, "Press line 4\nSafety project, 25 $ a part");
    assert_eq!(controller.processor_type.unwrap().text, "1756-L73S");
    assert_eq!(
        safety.tag_map.iter().map(|entry| (entry.standard.as_str(), entry.safety.as_str())).collect::<Vec<_>>(),
        [("Panel_Reset", "Reset"), ("Panel_Mode", "Mode")]
    );
    assert_eq!(safety.locked.map(|flag| flag.value), Some(false));
}

#[test]
fn data_types_when_read_then_bits_have_their_hosts() {
    let file = sample().file;
    let bits = &file.data_types[0];
    assert!(bits.members[0].hidden);
    let place = bits.members[2].bit.as_ref().unwrap();
    assert_eq!((place.target.as_str(), place.number.value), ("ZZZZZZZZZZMyBits0", 1));
    let link = &file.data_types[1];
    assert_eq!(link.members[1].dimensions.sizes(), [4]);
    assert_eq!(link.members[3].data_type.as_str(), "AB:1734_IB8S_Safety2:I:0");
}

/// REQ-LANG-010, REQ-LANG-014
#[test]
fn modules_when_read_then_have_connections_and_what_is_not_visible() {
    let file = sample().file;
    let names: Vec<_> = file.modules.iter().map(|module| module.name.as_str()).collect();
    assert_eq!(names, ["Local", "Press_Line:Partner", "$NoName", "Doors"]);
    let doors = &file.modules[3];
    assert_eq!(doors.opaque[0].kind.as_str(), "ConfigData");
    let input = &doors.connections[0];
    assert_eq!(input.rpi_us.map(|time| time.value), Some(10_000));
    assert_eq!(input.reaction_time_limit_us.map(|time| time.value), Some(40_064));
    assert!(matches!(input.input.as_ref().unwrap().data[0].value, Value::List { .. }));
    assert_eq!(input.input.as_ref().unwrap().forces.len(), 1);
}

#[test]
fn add_on_instruction_when_read_then_has_parameters_and_routines() {
    let file = sample().file;
    let add_on = &file.add_on_instructions[0];
    assert_eq!(add_on.class.map(|class| class.value), Some(Class::Safety));
    let usages: Vec<_> = add_on.parameters.iter().map(|parameter| parameter.usage.unwrap().value).collect();
    assert_eq!(usages, [ParameterUsage::Input, ParameterUsage::Input, ParameterUsage::InOut, ParameterUsage::Output]);
    assert_eq!(add_on.parameters[3].alias_for.as_ref().unwrap().text, "State.0");
    assert!(matches!(&add_on.parameters[1].default[0].value, Value::Number(text) if text.text == "1"));
    assert!(matches!(&add_on.local_tags[1].data[0].value, Value::List { items, .. } if items.len() == 3));
    assert!(matches!(&add_on.routines[1].body, RoutineBody::Island { language, .. } if language.is("ST")));
    assert_eq!(file.encoded[0].name.as_ref().unwrap().as_str(), "Conveyor_Control");
}

#[test]
fn tags_when_read_then_are_of_every_kind() {
    let file = sample().file;
    let tag = |name: &str| file.tags.iter().find(|tag| tag.name.is(name)).unwrap();
    assert!(matches!(&tag("overflow").kind, TagKind::Alias(target) if target.text == "bits.MyBit0"));
    assert_eq!(tag("grid").dimensions.sizes(), [2, 3]);
    assert!(matches!(&tag("tag_a").kind, TagKind::Produced(info) if info.count.unwrap().value == 2));
    assert_eq!(tag("tag_a").forces.len(), 1);
    let TagKind::Consumed(consumed) = &tag("safetyConsumed").kind else { unreachable!() };
    assert_eq!(consumed.reaction_time_limit_us.map(|time| time.value), Some(29_952));
    assert_eq!(consumed.rpi_us.map(|time| time.value), Some(10_000));
    let comments: Vec<_> = tag("dint_a").comments.iter().map(|comment| comment.operand.as_str()).collect();
    assert_eq!(comments, [".0", "[3].Speed"]);
    assert_eq!(tag("alarm").attributes[0].key.as_str(), "ALMMSG.AM:en-us");
    assert!(matches!(&tag("alarm").attributes[2].value, AttributeValue::Words(_)));
}

#[test]
fn rungs_when_read_then_have_kinds_and_comments() {
    let file = sample().file;
    let rungs = file.programs[0].routines[0].rungs();
    assert_eq!(rungs[0].comment.as_ref().unwrap().text, "A comment over\ntwo lines; with \"quotes\"");
    assert_eq!(print_rung(&rungs[0]), "XIC(Start)XIO(Stop)OTE(Run);");
    assert_eq!(rungs[1].kind.value, RungKind::PendingReplaceOfNormal);
    let Element::Instruction(gsv) = &rungs[2].elements[0] else { unreachable!() };
    assert_eq!(
        gsv.operands.iter().map(|operand| operand.text.as_str()).collect::<Vec<_>>(),
        ["SAFETY", "", "SafetySignatureExists", "Tag"]
    );
}

#[test]
fn tasks_when_read_then_have_times_and_programs() {
    let file = sample().file;
    assert_eq!(file.tasks[1].watchdog_us.map(|time| time.value), Some(20_500));
    assert_eq!(file.tasks[1].programs[0].as_str(), "SafetyProgram");
}

#[test]
fn history_of_an_instruction_when_read_then_its_entries_have_their_attributes() {
    let file = sample().file;
    let [entry] = file.add_on_instructions[0].history.as_slice() else { unreachable!() };
    assert_eq!(entry.attributes[0].key.as_str(), "User");
    assert_eq!(entry.attributes[0].value.text().unwrap().as_str(), "RA-INT\\JBieder2");
}

/// REQ-LANG-013
#[test]
fn islands_when_skipped_then_are_named() {
    let file = sample().file;
    let kinds: Vec<_> = file.islands.iter().map(|island| island.kind.as_str()).collect();
    assert_eq!(kinds, ["PARAMETER_CONNECTION", "TREND", "QUICK_WATCH", "CONFIG", "CONFIG"]);
    assert_eq!(file.programs[0].islands[0].kind.as_str(), "CHILD_PROGRAMS");
}
