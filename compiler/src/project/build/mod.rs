//! Making a project out of a tree: in the order in which one thing needs another.

mod add_ons;
mod aliases;
mod component_names;
mod controller;
mod map;
mod modules;
mod outputs;
mod programs;
mod sizes;
mod tasks;

pub(crate) use add_ons::is_argument;

use twinrung_catalog::{Element, PredefinedType};
use twinrung_grammar::tree::{self, Span};

use super::data::Defaults;
use super::names_in_scope::ScopeNames;
use super::reading::{Context, Mnemonics, Operands};
use super::tags::TagTable;
use super::{Project, TagClass, TagScope, Types, standard};
use crate::completion::Completion;
use crate::diagnostic::{DUPLICATE_NAME, ENCODED, Finding, Findings};
use crate::names::{Map, Set, fold};

/// What a project is made of.
pub(crate) struct Inputs<'a> {
    /// The file, or the folder merged into one.
    pub file: &'a tree::File,
    /// What completes it.
    pub completion: &'a Completion,
    /// Whether it is a library: Add-On Instructions only, all of class Safety, for every controller.
    pub library: bool,
}

impl<'a> Inputs<'a> {
    /// The file and then its contexts.
    fn files(&self) -> impl Iterator<Item = (&'a tree::File, bool)> + use<'a> {
        std::iter::once((self.file, false)).chain(self.completion.contexts.iter().map(|file| (file, true)))
    }
}

/// Makes the project, reporting what is faulty.
pub(crate) fn build(inputs: &Inputs<'_>, findings: &mut Findings) -> Project {
    let controller = inputs.file.controller.as_deref();
    let span = controller.map_or_else(|| first_span(inputs.file), |controller| controller.span);
    let profile = if inputs.library { None } else { controller::profile(inputs, span, findings) };
    encoded(inputs.file, findings);

    let mut types = Types::default();
    declare_types(inputs, &mut types, findings);
    let mut mnemonics = Mnemonics::new();
    let shown_add_ons = add_ons::declare(inputs, &mut types, &mut mnemonics, findings);

    let mut names = ScopeNames::default();
    let mut defaults = Defaults::default();
    let mut add_ons = add_ons::build(&shown_add_ons, &mut types, &mut defaults, &mut names, findings);
    let modules = modules::build(inputs, findings);
    let programs::Skeleton { mut programs, mut routines, routine_names, safety, standard: standard_programs } =
        programs::skeleton(inputs, &shown_add_ons, &mut add_ons, findings);
    names.programs = safety.iter().map(|_| Map::default()).collect();
    names.standard = standard_programs.iter().map(|_| Map::default()).collect();

    let mut table = TagTable {
        tags: Vec::new(),
        names,
        types: &mut types,
        defaults: &mut defaults,
        findings,
        aliases: Vec::new(),
        cells: (0, 0),
        context: false,
    };
    for (file, context) in inputs.files() {
        table.context = context;
        for tag in &file.tags {
            if tag.usage != tree::Usage::Reference {
                table.declare(tag, TagScope::Controller, None);
            }
        }
    }
    table.context = true;
    for (position, (shown, module)) in modules.iter().enumerate() {
        table.declare_module(shown, module, position);
    }
    table.context = false;
    for (position, shown) in safety.iter().enumerate() {
        for tag in shown.tags {
            table.declare(tag, TagScope::Program(super::ProgramId(position as u16)), Some(TagClass::Safety));
        }
    }
    for (position, shown) in standard_programs.iter().enumerate() {
        for tag in &shown.tags {
            table.declare(tag, TagScope::StandardProgram(position as u32), Some(TagClass::Standard));
        }
    }
    let TagTable { mut tags, names, aliases: pending, .. } = table;

    let (mut task_list, event_tasks) = tasks::build(inputs, &programs, span, findings);
    let safety_tasks: Vec<_> =
        task_list.iter().filter(|task| task.class == TagClass::Safety).map(|task| task.name.clone()).collect();
    let mut slot_names = Set::default();
    aliases::resolve(
        &pending,
        &mut tags,
        &aliases::Surroundings {
            types: &types,
            names: &names,
            add_ons: &add_ons,
            profile: profile.as_ref(),
            routine_names: &routine_names,
        },
        &mut slot_names,
        findings,
    );
    let map = map::build(inputs, &tags, &names, findings);

    let context =
        Context::new(&types, &tags, &names, &add_ons, profile.as_ref(), &routine_names, &event_tasks, &safety_tasks);
    let mut operands = Operands::default();
    let rungs = programs::read_rungs(&context, &mnemonics, &mut operands, &routines, &safety, &shown_add_ons, findings);
    outputs::check(&inputs.completion.outputs, &context, span, findings);
    slot_names.extend(context.into_slot_names());
    for (routine, rungs) in routines.iter_mut().zip(rungs) {
        routine.rungs = rungs;
    }
    for tag in slot_names {
        tags[tag.position()].uses_slot_name = true;
    }
    programs::entry_points(&safety, &mut programs, &routine_names, findings);

    let mut standard_writes = Vec::new();
    if !standard_programs.is_empty() {
        let catalog = standard_mnemonics();
        let writing = add_ons::standard_arguments(inputs);
        for (position, program) in standard_programs.iter().enumerate() {
            standard::writes(program, position, &names, &tags, &catalog, &writing, &mut standard_writes);
        }
    }
    let safety_task = tasks::safety_task(&mut task_list);
    let project = Project {
        name: controller.map(|controller| controller.name.text.clone()).unwrap_or_default(),
        profile,
        types,
        defaults,
        add_ons,
        programs,
        routines,
        tags,
        opcodes: operands.opcodes,
        operands: operands.table,
        modules: modules.into_iter().map(|(_, module)| module).collect(),
        map,
        tasks: task_list,
        safety_task,
        forces: forces(inputs.file),
        standard_writes,
        event_tasks,
        attributes: controller::attributes(inputs.file),
        outputs: inputs.completion.outputs.clone(),
        library: inputs.library,
        span,
    };
    sizes::check(&project, findings);
    component_names::check(&project, findings);
    project
}

fn standard_mnemonics() -> Map<tree::CompactString, &'static twinrung_catalog::Instruction> {
    let mut table = Map::default();
    for declaration in twinrung_catalog::instructions::ALL {
        for name in std::iter::once(declaration.mnemonic).chain(declaration.also.iter().copied()) {
            table.insert(fold(name), *declaration);
        }
    }
    table
}

fn declare_types(inputs: &Inputs<'_>, types: &mut Types, findings: &mut Findings) {
    let mut seen: Map<tree::CompactString, Span> = Map::default();
    for (file, context) in inputs.files() {
        for data_type in &file.data_types {
            if data_type.usage == tree::Usage::Reference {
                continue;
            }
            let folded = fold(data_type.name.as_str());
            match seen.get(&folded) {
                Some(first) if !context => {
                    let message = format!("the type `{}` is declared twice", data_type.name);
                    let finding = Finding::new(&DUPLICATE_NAME, data_type.name.span, message)
                        .label(*first, "first declared here")
                        .help("rename one of the two");
                    findings.push(finding);
                }
                Some(_) => {}
                None => {
                    seen.insert(folded, data_type.name.span);
                    let name = data_type.name.as_str();
                    if PredefinedType::by_name(name).is_none() && Element::by_name(name).is_none() {
                        types.declare(data_type);
                    } else if data_type.type_class.as_ref().is_none_or(|class| class.is("User")) {
                        let message = format!("`{name}` is the name of a predefined type");
                        let finding = Finding::new(&DUPLICATE_NAME, data_type.name.span, message);
                        findings.push(finding.help("give the type another name"));
                    }
                }
            }
        }
    }
}

/// Encoded components at the top of the file; those of programs are reported with the program.
fn encoded(file: &tree::File, findings: &mut Findings) {
    for encoded in &file.encoded {
        let safety = encoded.attributes.iter().any(|attribute| {
            attribute.key.is("Class")
                && attribute.value.text().is_some_and(|text| text.as_str().eq_ignore_ascii_case("Safety"))
        });
        if safety {
            findings.push(encoded_finding(encoded));
        }
    }
}

/// The finding for an encoded component.
pub(super) fn encoded_finding(encoded: &tree::Encoded) -> Finding {
    let name = encoded.name.as_ref().map(|name| format!(" `{name}`")).unwrap_or_default();
    let message = format!("the {}{name} is encoded and cannot be verified", encoded.kind);
    Finding::new(&ENCODED, encoded.kind.span, message).help("export it without source protection")
}

/// A place that stands for the whole file.
fn first_span(file: &tree::File) -> Span {
    let source = file.sources.first().copied().unwrap_or_default();
    file.export.as_ref().map_or(Span::new(source, 0, 0), |export| export.span)
}

/// Where forces are installed on safety data or on anything of which the file does not say what it is.
fn forces(file: &tree::File) -> Vec<Span> {
    let holds = |data: &tree::Data| match &data.value {
        tree::Value::List { items, .. } => !items.is_empty(),
        tree::Value::Bytes { bytes, .. } => bytes.iter().any(|byte| *byte != 0),
        _ => true,
    };
    let of_tag = |tag: &tree::Tag| tag.class.is_none_or(|class| class.value == tree::Class::Safety);
    let tags = file.tags.iter().filter(|tag| of_tag(tag)).flat_map(|tag| &tag.forces);
    let programs = file
        .programs
        .iter()
        .filter(|program| program.class.is_some_and(|class| class.value == tree::Class::Safety))
        .flat_map(|program| &program.tags)
        .flat_map(|tag| &tag.forces);
    let connections = file.modules.iter().flat_map(|module| &module.connections).filter(|connection| {
        let kind = connection.connection_type.as_ref();
        kind.is_some_and(|kind| kind.as_str().to_ascii_lowercase().starts_with("safety"))
    });
    let module_tags = connections
        .flat_map(|connection| [&connection.input, &connection.output])
        .flatten()
        .flat_map(|tag| &tag.forces);
    tags.chain(programs).chain(module_tags).filter(|data| holds(data)).map(|data| data.value.span()).collect()
}
