//! The compiled library against the catalog: every instruction is there, with the parameters that the calls need.

use twinrung_bytecode::image::{AddOnRecord, Image, Usage};
use twinrung_bytecode::{AdmittedImage, admit_library};
use twinrung_catalog::instruction::SafetyApplication;
use twinrung_catalog::{MemberRole, instructions};
use twinrung_safety_partner::{LIBRARY, PREFIX, SIGNATURE, SOURCES, mnemonic, source};

fn library() -> AdmittedImage {
    admit_library(LIBRARY).unwrap_or_else(|error| panic!("the library is not admitted: {error}"))
}

fn safety_applications() -> impl Iterator<Item = (&'static str, &'static SafetyApplication)> {
    instructions::ALL.iter().filter_map(|instruction| instruction.safety.map(|safety| (instruction.mnemonic, safety)))
}

fn definition<'image>(image: &'image Image, mnemonic: &str) -> &'image AddOnRecord {
    let name = format!("{PREFIX}{mnemonic}");
    image.add_ons.iter().find(|add_on| add_on.name == name).unwrap_or_else(|| panic!("{name} is missing"))
}

fn parameters(add_on: &AddOnRecord, usage: Usage) -> Vec<&str> {
    let own = |name: &str| name != "EnableIn" && name != "EnableOut";
    let of_usage = add_on.parameters.iter().filter(|parameter| parameter.usage == usage);
    of_usage.map(|parameter| parameter.name.as_str()).filter(|name| own(name)).collect()
}

#[test]
fn signature_when_the_library_is_admitted_then_it_is_its_image_signature() {
    assert_eq!(SIGNATURE, library().image_signature());
}

#[test]
fn library_when_admitted_then_it_defines_each_safety_instruction_of_the_catalog_and_no_other() {
    let library = library();
    let add_ons = &library.image().add_ons;
    let mut defined: Vec<&str> = add_ons.iter().filter_map(|add_on| mnemonic(&add_on.name)).collect();
    let mut declared: Vec<&str> = safety_applications().map(|(mnemonic, _)| mnemonic).collect();
    defined.sort_unstable();
    declared.sort_unstable();
    assert_eq!(defined, declared);
}

#[test]
fn definitions_when_compared_with_the_catalog_then_inputs_are_the_mirrored_members_in_operand_order() {
    let library = library();
    for (mnemonic, safety) in safety_applications() {
        let add_on = definition(library.image(), mnemonic);
        assert_eq!(parameters(add_on, Usage::Input), safety.mirrored, "{mnemonic}");
    }
}

#[test]
fn definitions_when_compared_with_the_catalog_then_outputs_are_the_output_members() {
    let library = library();
    for (mnemonic, safety) in safety_applications() {
        let output = |role| role == MemberRole::Output;
        let members = safety.backing.members.iter().filter(|member| output(member.role) && member.name != "EnableOut");
        let members: Vec<&str> = members.map(|member| member.name).collect();
        let add_on = definition(library.image(), mnemonic);
        assert_eq!(parameters(add_on, Usage::Output), members, "{mnemonic}");
    }
}

#[test]
fn definitions_when_admitted_then_each_has_logic_prescan_and_enable_in_false() {
    let library = library();
    let incomplete = |add_on: &&AddOnRecord| add_on.prescan.is_none() || add_on.enable_in_false.is_none();
    let incomplete: Vec<&str> =
        library.image().add_ons.iter().filter(incomplete).map(|add_on| add_on.name.as_str()).collect();
    assert!(incomplete.is_empty(), "{incomplete:?}");
}

#[test]
fn sources_when_searched_for_their_definition_then_each_is_listed_under_its_name() {
    let defines = |name: &str, text: &str| text.contains(&format!("ADD_ON_INSTRUCTION_DEFINITION {name} ("));
    let wrong: Vec<&str> = SOURCES
        .iter()
        .filter(|(name, text)| !defines(name, text) && !defines(&format!("{PREFIX}{name}"), text))
        .map(|(name, _)| *name)
        .collect();
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn source_when_asked_in_any_case_then_it_is_found() {
    assert_eq!(source("thrse"), source("THRSe"));
    assert!(source("THRSE").is_some_and(|text| text.contains("Safety_THRSe")));
    assert_eq!(source("XIC"), None);
}
