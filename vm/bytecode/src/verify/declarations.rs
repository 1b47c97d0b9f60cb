//! Names, table order, indices between tables, controller, programs, task, map, system values.

use alloc::vec::Vec;
use core::cmp::Ordering;

use twinrung_catalog::instructions::system::ATTRIBUTES;
use twinrung_catalog::{Controller, Instruction, Requires};

use crate::error::ImageError;
use crate::image::*;
use crate::index::*;
use crate::limits;
use crate::names;

/// Names are written as names are and follow each other in order, without one twice.
fn check_names<'a>(
    what: &'static str,
    is_name: fn(&str) -> bool,
    list: impl Iterator<Item = &'a str>,
) -> Result<(), ImageError> {
    let mut before: Option<&str> = None;
    for (index, name) in list.enumerate() {
        if !is_name(name) {
            return Err(ImageError::Name { what, index });
        }
        match before.map(|before| names::order(before, name)) {
            Some(Ordering::Greater) => return Err(ImageError::NameOrder { what, index }),
            Some(Ordering::Equal) => return Err(ImageError::NameTwice { what, index }),
            Some(Ordering::Less) | None => before = Some(name),
        }
    }
    Ok(())
}

/// Names are written as names are, in any order, without one twice.
pub(super) fn check_unordered_names<'a>(
    what: &'static str,
    is_name: fn(&str) -> bool,
    list: impl Iterator<Item = &'a str>,
) -> Result<(), ImageError> {
    let mut sorted: Vec<(usize, &str)> = list.enumerate().collect();
    if let Some((index, _)) = sorted.iter().find(|(_, name)| !is_name(name)) {
        return Err(ImageError::Name { what, index: *index });
    }
    sorted.sort_by(|left, right| names::order(left.1, right.1).then(left.0.cmp(&right.0)));
    for pair in sorted.windows(2) {
        if let [(_, before), (index, name)] = pair
            && names::order(before, name) == Ordering::Equal
        {
            return Err(ImageError::NameTwice { what, index: *index });
        }
    }
    Ok(())
}

fn check_attributes(what: &'static str, index: usize, attributes: &Attributes) -> Result<(), ImageError> {
    let wrong = ImageError::AttributeKeys { what, index };
    let named = attributes.iter().all(|(key, _)| names::is_component(key));
    let sorted = attributes.windows(2).all(|pair| matches!(pair, [(before, _), (key, _)] if before < key));
    if !named || !sorted {
        return Err(wrong);
    }
    if attributes.iter().all(|(_, value)| names::is_setting(value)) { Ok(()) } else { Err(wrong) }
}

/// The names of all tables.
pub(super) fn check_all_names(image: &Image) -> Result<(), ImageError> {
    check_unordered_names("type", names::is_type_name, image.types.iter().map(|record| record.name.as_str()))?;
    check_unordered_names("Add-On Instruction", names::is_component, image.add_ons.iter().map(|r| r.name.as_str()))?;
    check_names("program", names::is_component, image.programs.iter().map(|record| record.name.as_str()))?;
    check_names("module", names::is_module_name, image.modules.iter().map(|record| record.name.as_str()))?;
    check_unordered_names("event task", names::is_component, image.event_tasks.iter().map(|name| name.as_str()))?;
    for (index, record) in image.types.iter().enumerate() {
        if twinrung_catalog::Element::by_name(&record.name).is_some() {
            return Err(ImageError::NameReserved { what: "type", index });
        }
        check_unordered_names("member", names::is_component, record.members.iter().map(|member| member.name.as_str()))?;
    }
    for (index, record) in image.add_ons.iter().enumerate() {
        if Instruction::by_mnemonic(&record.name).is_some() {
            return Err(ImageError::NameReserved { what: "Add-On Instruction", index });
        }
        check_attributes("Add-On Instruction", index, &record.attributes)?;
    }
    if let Some(task) = &image.task
        && !names::is_component(&task.name)
    {
        return Err(ImageError::Name { what: "task", index: 0 });
    }
    check_attributes("controller", 0, &image.controller.attributes)
}

/// The controller is known; a library may leave it open.
pub(super) fn check_controller(
    record: &ControllerRecord,
    library: bool,
) -> Result<Option<&'static Controller>, ImageError> {
    if library && record.processor.is_empty() {
        return Ok(None);
    }
    // The catalogue's own spelling: the text of the declaration has one form.
    let controller = Controller::by_catalog_number(&record.processor)
        .filter(|known| known.catalog_number == record.processor)
        .ok_or(ImageError::UnknownController)?;
    if !controller.knows_revision(record.revision) {
        return Err(ImageError::UnknownRevision { revision: record.revision });
    }
    if !names::is_component(&record.name) {
        return Err(ImageError::Name { what: "controller", index: 0 });
    }
    Ok(Some(controller))
}

/// Routines stand owner by owner, in order of their names, and programs name their own.
pub(super) fn check_routines(image: &Image) -> Result<(), ImageError> {
    let mut before: Option<(&RoutineRecord, (u8, u16))> = None;
    for (index, routine) in image.routines.iter().enumerate() {
        let wrong = ImageError::RoutineOwner { routine: RoutineIndex(index as u32) };
        let (owner, known) = match routine.owner {
            Owner::Program(program) => ((0, program.0), program.position() < image.programs.len()),
            Owner::AddOn(add_on) => ((1, add_on.0), add_on.position() < image.add_ons.len()),
        };
        if !known {
            return Err(wrong);
        }
        if !names::is_component(&routine.name) {
            return Err(ImageError::Name { what: "routine", index });
        }
        if let Some((earlier, earlier_owner)) = before {
            match earlier_owner.cmp(&owner) {
                Ordering::Greater => return Err(wrong),
                Ordering::Equal => match names::order(&earlier.name, &routine.name) {
                    Ordering::Less => {}
                    Ordering::Equal => return Err(ImageError::NameTwice { what: "routine", index }),
                    Ordering::Greater => return Err(ImageError::NameOrder { what: "routine", index }),
                },
                Ordering::Less => {}
            }
        }
        before = Some((routine, owner));
    }
    for (index, program) in image.programs.iter().enumerate() {
        let this = ProgramIndex(index as u16);
        let owned = |routine: RoutineIndex| {
            image.routines.get(routine.position()).is_some_and(|record| record.owner == Owner::Program(this))
        };
        let same = program.main.is_some() && program.main == program.fault;
        if same || !program.main.is_none_or(owned) || !program.fault.is_none_or(owned) {
            return Err(ImageError::ProgramRoutine { program: this });
        }
    }
    Ok(())
}

/// The task: period, watchdog, priority, schedule. 1756-RM093; DESIGN 4.
pub(super) fn check_task(image: &Image) -> Result<(), ImageError> {
    let task = image.task.as_ref().ok_or(ImageError::NoTask)?;
    if !(limits::PERIOD_US_LEAST..=limits::PERIOD_US).contains(&task.period_us) {
        return Err(ImageError::Period { microseconds: task.period_us });
    }
    if task.watchdog_us == 0 || task.watchdog_us > task.period_us {
        return Err(ImageError::Watchdog { microseconds: task.watchdog_us });
    }
    if task.priority > 15 {
        return Err(ImageError::Priority { priority: task.priority });
    }
    let mut scheduled = alloc::vec![false; image.programs.len()];
    for program in &task.schedule {
        let seen = scheduled.get_mut(program.position()).ok_or(ImageError::IndexRange { what: "task", index: 0 })?;
        if core::mem::replace(seen, true) {
            return Err(ImageError::ScheduledTwice { program: *program });
        }
    }
    Ok(())
}

/// A library has Add-On Instructions and nothing that needs a controller.
pub(super) fn check_library(image: &Image) -> Result<(), ImageError> {
    let empty = image.task.is_none()
        && image.programs.is_empty()
        && image.tags.is_empty()
        && image.modules.is_empty()
        && image.map.is_empty()
        && image.system_values.is_empty()
        && image.event_tasks.is_empty();
    if empty { Ok(()) } else { Err(ImageError::NotALibrary) }
}

/// Lines of the map lead to different plain tags of the controller, in the order of the tags.
pub(super) fn check_map(image: &Image) -> Result<Vec<bool>, ImageError> {
    let mut mapped = alloc::vec![false; image.tags.len()];
    let mut before: Option<TagIndex> = None;
    for (line, record) in image.map.iter().enumerate() {
        if !names::is_tag_path(&record.standard) {
            return Err(ImageError::Name { what: "tag map line", index: line });
        }
        if before.is_some_and(|before| before >= record.safety) {
            return Err(ImageError::MapOrder { line });
        }
        before = Some(record.safety);
        let tag = image.tags.get(record.safety.position()).ok_or(ImageError::MapTarget { line })?;
        if tag.program.is_some() || tag.kind != TagKind::Base || tag.constant {
            return Err(ImageError::MapTarget { line });
        }
        if let Some(mapped) = mapped.get_mut(record.safety.position()) {
            *mapped = true;
        }
    }
    Ok(mapped)
}

/// System values: known attributes of existing objects, their values one after the other, none twice.
pub(super) fn check_system_values(image: &Image, controller: Option<&Controller>) -> Result<(), ImageError> {
    let mut next = 0u32;
    let mut seen = Vec::with_capacity(image.system_values.len());
    for (index, record) in image.system_values.iter().enumerate() {
        let value = SystemValueIndex(index as u16);
        let attribute = ATTRIBUTES
            .iter()
            .find(|known| known.number == record.attribute)
            .filter(|known| known.requires == Requires::Any || controller.is_none_or(Controller::has_real))
            .ok_or(ImageError::SystemValueAttribute { value })?;
        let instances = match attribute.class {
            "PROGRAM" => image.programs.len(),
            "ROUTINE" => image.routines.len(),
            _ => 1,
        };
        let program = record.program.map(ProgramIndex::position);
        let program_fits = match (attribute.class, program) {
            // The record that SSV writes belongs to a program, and the interpreters must know which.
            ("PROGRAM", None) => attribute.name != "MajorFaultRecord",
            ("PROGRAM", Some(program)) => program == record.instance as usize,
            (_, program) => program.is_none_or(|program| program < image.programs.len()),
        };
        if record.instance as usize >= instances || !program_fits {
            return Err(ImageError::SystemValueInstance { value });
        }
        if record.first != next {
            return Err(ImageError::SystemValueOrder { value });
        }
        next = next.saturating_add(attribute.length);
        seen.push((record.attribute, record.instance, value));
    }
    seen.sort();
    for pair in seen.windows(2) {
        if let [(attribute, instance, _), (again, same, value)] = pair
            && (attribute, instance) == (again, same)
        {
            return Err(ImageError::SystemValueOrder { value: *value });
        }
    }
    Ok(())
}

/// Attributes of tags; their names are checked with the tags.
pub(super) fn check_tag_attributes(index: usize, tag: &TagRecord) -> Result<(), ImageError> {
    check_attributes("tag", index, &tag.attributes)
}
