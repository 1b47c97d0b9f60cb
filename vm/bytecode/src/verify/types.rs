//! Structure types and the declarations of Add-On Instructions.

use twinrung_catalog::Element;

use super::declarations::check_unordered_names;
use super::tables::Tables;
use crate::error::ImageError;
use crate::image::*;
use crate::index::{AddOnIndex, RoutineIndex, TypeIndex};
use crate::layout;
use crate::names;

/// Types beyond what their layout has shown: members, dimensions, REAL.
pub(super) fn check_types(tables: &Tables<'_>) -> Result<(), ImageError> {
    for (index, record) in tables.image.types.iter().enumerate() {
        let type_index = TypeIndex(index as u16);
        if record.members.is_empty() {
            return Err(ImageError::EmptyType { type_index });
        }
        // neutral-text-and-l5x.md D.4.
        if record.kind == TypeKind::User
            && let Some(member) = record.members.iter().position(|member| member.dimensions[1] != 0)
        {
            return Err(ImageError::MemberDimensions { type_index, member });
        }
        if !tables.has_real() && tables.layout(type_index).is_some_and(|layout| layout.holds_real) {
            return Err(ImageError::RealType { type_index });
        }
        // A predefined type has one spelling; a user's type cannot have the name of one.
        let predefined = twinrung_catalog::PredefinedType::by_name(&record.name);
        let named = predefined.is_some_and(|known| known.name == record.name);
        if (record.kind == TypeKind::Predefined) != named || (!named && predefined.is_some()) {
            return Err(ImageError::NameReserved { what: "type", index });
        }
        if let TypeKind::AddOn(add_on) = record.kind {
            let known = tables.image.add_ons.get(add_on.position());
            if known.is_none_or(|known| known.instance_type != type_index) {
                return Err(ImageError::InstanceType { add_on });
            }
        }
    }
    Ok(())
}

/// Add-On Instructions: their instance types, parameters and routines.
pub(super) fn check_add_ons(tables: &Tables<'_>) -> Result<(), ImageError> {
    let mut owned = alloc::vec![0usize; tables.image.add_ons.len()];
    for routine in &tables.image.routines {
        if let Owner::AddOn(add_on) = routine.owner
            && let Some(count) = owned.get_mut(add_on.position())
        {
            *count = count.saturating_add(1);
        }
    }
    for ((index, record), owned) in tables.image.add_ons.iter().enumerate().zip(owned) {
        let add_on = AddOnIndex(index as u16);
        let instance = tables.image.types.get(record.instance_type.position());
        let instance = instance
            .filter(|instance| instance.kind == TypeKind::AddOn(add_on) && instance.name == record.name)
            .ok_or(ImageError::InstanceType { add_on })?;
        check_enable_parameters(add_on, record)?;
        check_parameters(tables, add_on, record, instance)?;
        check_add_on_routines(tables.image, add_on, record, owned)?;
    }
    Ok(())
}

fn check_enable_parameters(add_on: AddOnIndex, record: &AddOnRecord) -> Result<(), ImageError> {
    let expected = [("EnableIn", Usage::Input), ("EnableOut", Usage::Output)];
    let fits = record.parameters.len() >= expected.len()
        && record.parameters.iter().zip(expected).all(|(parameter, (name, usage))| {
            parameter.name == name
                && parameter.usage == usage
                && parameter.type_reference == TypeReference::Element(Element::Bool)
                && !parameter.argument
        });
    if fits { Ok(()) } else { Err(ImageError::EnableParameters { add_on }) }
}

/// Input and Output parameters are elementary and lie in the instance in declared order; InOut parameters are passed
/// by reference, are always given, and have names of their own.
fn check_parameters(
    tables: &Tables<'_>,
    add_on: AddOnIndex,
    record: &AddOnRecord,
    instance: &TypeRecord,
) -> Result<(), ImageError> {
    let by_reference = record.parameters.iter().filter(|parameter| parameter.usage == Usage::InOut);
    let names = instance.members.iter().map(|member| &member.name).chain(by_reference.map(|parameter| &parameter.name));
    check_unordered_names("parameter", names::is_component, names.map(|name| name.as_str()))?;
    let mut next_member = 0usize;
    for (parameter_index, parameter) in record.parameters.iter().enumerate() {
        let wrong = ImageError::Parameter { add_on, parameter: parameter_index };
        let known = match parameter.type_reference {
            TypeReference::Element(_) => true,
            TypeReference::Structure(index) => index.position() < tables.layouts.len(),
        };
        if !known || layout::elements(parameter.dimensions).is_none() {
            return Err(wrong);
        }
        match parameter.usage {
            Usage::Input | Usage::Output => {
                let member = parameter.member.map(usize::from);
                let held = instance.members.get(next_member).filter(|_| member == Some(next_member));
                let held = held.ok_or(ImageError::InstanceMembers { add_on })?;
                if held.name != parameter.name
                    || held.type_reference != parameter.type_reference
                    || held.dimensions != parameter.dimensions
                {
                    return Err(ImageError::InstanceMembers { add_on });
                }
                if parameter.dimensions != [0; 3] || matches!(parameter.type_reference, TypeReference::Structure(_)) {
                    return Err(wrong);
                }
                next_member = next_member.saturating_add(1);
            }
            Usage::InOut => {
                if parameter.member.is_some() || !parameter.argument {
                    return Err(wrong);
                }
                if !tables.has_real() && tables.holds_real(parameter.type_reference) {
                    return Err(wrong);
                }
            }
        }
    }
    // Expressions name them.
    let reserved = |name: &str| names::is_reserved(name);
    let parameter = record.parameters.iter().position(|parameter| reserved(&parameter.name));
    if let Some(index) = parameter.or_else(|| instance.members.iter().position(|member| reserved(&member.name))) {
        return Err(ImageError::NameReserved { what: "parameter", index });
    }
    Ok(())
}

fn check_add_on_routines(
    image: &Image,
    add_on: AddOnIndex,
    record: &AddOnRecord,
    owned: usize,
) -> Result<(), ImageError> {
    let named = [(Some(record.logic), "Logic"), (record.prescan, "Prescan"), (record.enable_in_false, "EnableInFalse")];
    let fits = |routine: RoutineIndex, name: &str| {
        image
            .routines
            .get(routine.position())
            .is_some_and(|found| found.owner == Owner::AddOn(add_on) && found.name == name)
    };
    let all = named.iter().all(|(routine, name)| routine.is_none_or(|routine| fits(routine, name)));
    let count = named.iter().filter(|(routine, _)| routine.is_some()).count();
    if all && count == owned { Ok(()) } else { Err(ImageError::AddOnRoutines { add_on }) }
}
