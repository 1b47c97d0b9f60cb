//! The class of a member, by the catalogue or by its name.

use super::{MemberClass, Module};

/// The class of a member of a module's input tag: as the catalogue has it, and for a module or member that it does not
/// have by the name (decided): read-backs, output monitors, power status, process alarms, fault reasons and what belongs to
/// test outputs are marked STANDARD in every module manual, all other members carry safety data.
pub fn class_of_input(catalog_number: &str, member: &str) -> MemberClass {
    let known = Module::by_catalog_number(catalog_number).and_then(|module| {
        let chosen = module.input_status.iter().flat_map(|choice| choice.each_member());
        module.each_input().chain(chosen).find(|one| one.name.eq_ignore_ascii_case(member))
    });
    if let Some(known) = known {
        return known.class;
    }
    let begins = |beginning: &str| member.get(..beginning.len()).is_some_and(|one| one.eq_ignore_ascii_case(beginning));
    if ["RunMode", "ConnectionFaulted"].iter().any(|name| member.eq_ignore_ascii_case(name)) {
        MemberClass::ConnectionStatus
    } else if begins("Test") || STANDARD_ENDINGS.iter().any(|ending| ends(member, ending)) {
        MemberClass::Standard
    } else {
        MemberClass::Safety
    }
}

const STANDARD_ENDINGS: [&str; 9] = [
    "Readback",
    "Monitor",
    "PowerStatus",
    "InputPower",
    "OutputPower",
    "TestOutputStatus",
    "Alarm",
    "AlarmStatus",
    "FaultReason",
];

fn ends(member: &str, ending: &str) -> bool {
    let at = member.len().saturating_sub(ending.len());
    member.get(at..).is_some_and(|end| end.eq_ignore_ascii_case(ending))
}

/// Whether a member of a module's input tag says that data is valid, and not what a device says.
pub fn is_status(member: &str) -> bool {
    ends(member, "Status")
}

/// Whether a member of a module's output tag switches a safety output; test outputs do not.
pub fn is_safety_output(catalog_number: &str, member: &str) -> bool {
    let known = Module::by_catalog_number(catalog_number).and_then(|module| {
        let mut members = module.output_data.iter().flat_map(|choice| choice.each_member());
        members.find(|one| one.name.eq_ignore_ascii_case(member))
    });
    match known {
        Some(known) => known.class == MemberClass::Safety,
        None => !member.get(..4).is_some_and(|one| one.eq_ignore_ascii_case("Test")),
    }
}
