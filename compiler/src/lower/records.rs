//! Declarations as records.

use sha2::{Digest, Sha256};
use twinrung_bytecode::image::*;
use twinrung_bytecode::layout::elements;
use twinrung_bytecode::signature::long_form;

use super::operands::Interner;
use super::order::{Order, kind};
use crate::operand::Operand;
use crate::project::{self, Project, TagKind as Kind, TagScope};

/// The controller; left open in a library.
pub(super) fn controller(project: &Project) -> ControllerRecord {
    match &project.profile {
        Some(profile) => ControllerRecord {
            name: if project.name.is_empty() { "Controller".to_owned() } else { project.name.to_string() },
            processor: profile.controller.catalog_number.to_owned(),
            revision: profile.revision,
            attributes: settings(&project.attributes),
        },
        None => ControllerRecord::default(),
    }
}

/// Structure types.
pub(super) fn types(project: &Project, order: &Order) -> Vec<TypeRecord> {
    let lower = |index: &twinrung_bytecode::index::TypeIndex| {
        let record = project.types.record(*index);
        let members = record.members.iter().map(|member| MemberRecord {
            name: member.name.clone(),
            type_reference: order.type_reference(member.type_reference),
            dimensions: member.dimensions,
        });
        TypeRecord { name: record.name.clone(), kind: kind(order, record.kind), members: members.collect() }
    };
    order.types.iter().map(lower).collect()
}

/// Tags with their cells; aliases get their target later.
pub(super) fn tags(project: &Project, order: &Order, image: &mut Image) {
    let (mut bit_cell, mut word_cell) = (0u32, 0u32);
    for id in &order.tags {
        let tag = project.tag(*id);
        let Some(type_reference) = tag.type_reference else { continue };
        let mut record = TagRecord {
            name: tag.image_name().to_owned(),
            program: match tag.scope {
                TagScope::Program(program) => Some(order.program(program)),
                TagScope::Controller | TagScope::StandardProgram(_) => None,
            },
            type_reference: order.type_reference(type_reference),
            dimensions: tag.dimensions,
            kind: match tag.kind {
                Kind::Base | Kind::Alias(_) => TagKind::Base,
                Kind::Produced => TagKind::Produced,
                Kind::Consumed => TagKind::Consumed,
                Kind::ModuleInput(_) => TagKind::ModuleInput,
                Kind::ModuleOutput(_) => TagKind::ModuleOutput,
            },
            constant: tag.constant,
            bit_cell: 0,
            word_cell: 0,
            attributes: settings(&tag.attributes),
        };
        if !tag.is_alias() {
            let (bits, words) = project.types.cells(type_reference);
            let count = elements(tag.dimensions).unwrap_or(1);
            (record.bit_cell, record.word_cell) = (bit_cell, word_cell);
            bit_cell = bit_cell.saturating_add(bits.saturating_mul(count));
            word_cell = word_cell.saturating_add(words.saturating_mul(count));
        }
        image.tags.push(record);
    }
    image.initial_bits = vec![0; bit_cell as usize];
    image.initial_words = vec![0; word_cell as usize];
}

/// What aliases designate.
pub(super) fn aliases(project: &Project, order: &Order, operands: &mut Interner<'_>, image: &mut Image) {
    for (record, id) in image.tags.iter_mut().zip(&order.tags) {
        if let Kind::Alias(Some(target)) = &project.tag(*id).kind {
            let operand = operands.operand(&Operand::Reference(target.reference.clone()));
            record.kind = TagKind::Alias(operand);
            if target.reference.location.bit.is_some() {
                record.type_reference = TypeReference::Element(twinrung_catalog::Element::Bool);
            }
        }
    }
}

/// Add-On Instructions.
pub(super) fn add_ons(project: &Project, order: &Order) -> Vec<AddOnRecord> {
    let parameter = |parameter: &project::Parameter| ParameterRecord {
        name: parameter.name.to_string(),
        usage: parameter.usage,
        type_reference: parameter
            .type_reference
            .map_or(TypeReference::Element(twinrung_catalog::Element::Bool), |reference| {
                order.type_reference(reference)
            }),
        dimensions: parameter.dimensions,
        argument: parameter.argument,
        member: parameter.member,
    };
    let lower = |id: &project::AddOnId| {
        let add_on = project.add_on(*id);
        let mut attributes = add_on.attributes.clone();
        attributes.extend(initial_values(project, add_on));
        attributes.sort();
        AddOnRecord {
            name: add_on.name.to_string(),
            instance_type: add_on
                .instance_type
                .map_or(twinrung_bytecode::index::TypeIndex(u16::MAX), |index| order.type_index(index)),
            parameters: add_on.parameters.iter().map(parameter).collect(),
            logic: add_on
                .logic
                .map_or(twinrung_bytecode::index::RoutineIndex(u32::MAX), |routine| order.routine(routine)),
            prescan: add_on.prescan.map(|routine| order.routine(routine)),
            enable_in_false: add_on.enable_in_false.map(|routine| order.routine(routine)),
            attributes: settings(&attributes),
        }
    };
    order.add_ons.iter().map(lower).collect()
}

/// What an instance holds before anything runs decides what executes as much as a rung does: a hash of it, where it is not all 0.
fn initial_values(project: &Project, add_on: &project::AddOn) -> Option<(String, String)> {
    let region = project.defaults.of(add_on.instance_type?)?;
    let mut hash = Sha256::new_with_prefix(b"twinrung initial values 1\0");
    hash.update(&region.bits);
    hash.update((region.bits.len() as u64).to_le_bytes());
    region.words.iter().for_each(|word| hash.update(word.to_le_bytes()));
    Some(("InitialValues".to_owned(), long_form(&hash.finalize())))
}

/// Programs.
pub(super) fn programs(project: &Project, order: &Order) -> Vec<ProgramRecord> {
    let lower = |id: &project::ProgramId| {
        let program = project.program(*id);
        ProgramRecord {
            name: program.name.to_string(),
            main: program.main.map(|routine| order.routine(routine)),
            fault: program.fault.map(|routine| order.routine(routine)),
            disabled: program.disabled,
        }
    };
    order.programs.iter().map(lower).collect()
}

/// The safety task.
pub(super) fn task(project: &Project, order: &Order) -> Option<TaskRecord> {
    let task = &project.tasks[project.safety_task?];
    let microseconds = |value: Option<(u64, twinrung_grammar::tree::Span)>| {
        value.map_or(0, |(value, _)| u32::try_from(value).unwrap_or(u32::MAX))
    };
    Some(TaskRecord {
        name: task.name.to_string(),
        period_us: microseconds(task.period_us),
        watchdog_us: microseconds(task.watchdog_us.or(task.period_us)),
        priority: u8::try_from(task.priority.0).unwrap_or(u8::MAX),
        schedule: task.schedule.iter().filter_map(|one| one.program).map(|program| order.program(program)).collect(),
    })
}

/// Safety modules.
pub(super) fn modules(project: &Project) -> Vec<ModuleRecord> {
    let mut list: Vec<ModuleRecord> = project
        .modules
        .iter()
        .filter(|module| module.safety)
        .map(|module| ModuleRecord { name: module.name.to_string(), text: module.text.clone() })
        .collect();
    list.sort_by(|left, right| crate::names::compare(&left.name, &right.name));
    list
}

/// The tag map.
pub(super) fn map(project: &Project, order: &Order) -> Vec<MapRecord> {
    let mut list: Vec<MapRecord> = project
        .map
        .iter()
        .map(|line| MapRecord { standard: line.standard.to_string(), safety: order.tag(line.safety) })
        .collect();
    list.sort_by_key(|line| line.safety);
    list
}

/// Settings as an image writes them: what holds other characters than a plain setting may is put between quotes.
fn settings(list: &[(String, String)]) -> Attributes {
    let plain = |value: &str| {
        !value.is_empty() && value.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"_ #+-./:\\".contains(&byte))
    };
    let write = |value: &String| {
        if plain(value) {
            value.clone()
        } else {
            let inner: String = value.chars().map(|c| if c == '"' || c.is_control() { ' ' } else { c }).collect();
            format!("\"{inner}\"")
        }
    };
    let mut list: Attributes = list.iter().map(|(key, value)| (key.clone(), write(value))).collect();
    list.sort();
    list
}
