//! The class, instance and attribute of GSV and SSV. general-instructions.md A.10.

use twinrung_catalog::instructions::system::{ATTRIBUTES, Attribute};
use twinrung_grammar::tree::{self, CompactString};

use super::{Operand, Scope};
use crate::diagnostic::{Finding, OPERAND_TYPE};
use crate::names::{closest, fold};
use crate::project::reading::{Context, Refusal};
use crate::project::{ProgramId, RoutineId};
use crate::rules;

/// An attribute of a system object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SystemValue {
    /// Which attribute.
    pub attribute: &'static Attribute,
    /// Of which object.
    pub instance: SystemInstance,
    /// The program whose routine this is, when the text says THIS.
    pub this: Option<ProgramId>,
}

/// The object of an attribute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SystemInstance {
    /// The safety task.
    Task,
    /// A safety program.
    Program(ProgramId),
    /// A routine of a safety program.
    Routine(RoutineId),
    /// The controller.
    Controller,
}

/// Reads the class operand: a class that the safety task can reach.
pub(crate) fn class(shown: &tree::Operand) -> Result<Operand, Refusal> {
    let known = ATTRIBUTES.iter().find(|attribute| attribute.class.eq_ignore_ascii_case(&shown.text));
    match known {
        Some(attribute) => Ok(Operand::Text(attribute.class.into())),
        None => Err(rules::system_attribute::class(shown).into()),
    }
}

/// Reads the instance operand, which belongs to a class.
pub(crate) fn instance(
    context: &Context<'_>,
    scope: Scope,
    class: &str,
    shown: &tree::Operand,
) -> Result<Operand, Refusal> {
    let takes_one = ATTRIBUTES.iter().any(|attribute| attribute.class == class && attribute.has_instance);
    if !takes_one {
        return if shown.is_empty() {
            Ok(Operand::Text(CompactString::default()))
        } else {
            let message = format!("an object of class {class} has no instance name");
            Err(Finding::new(&OPERAND_TYPE, shown.span, message).help("leave the operand empty").into())
        };
    }
    if shown.is_empty() {
        let message = format!("class {class} needs the name of an object");
        return Err(Finding::new(&OPERAND_TYPE, shown.span, message).help("write THIS for the own one").into());
    }
    if shown.text.eq_ignore_ascii_case("THIS") {
        return Ok(Operand::Text("THIS".into()));
    }
    let is_it = |name: &&CompactString| name.eq_ignore_ascii_case(&shown.text);
    let routines = &context.routine_names;
    let found = match class {
        "TASK" => context.safety_tasks.iter().find(is_it).cloned(),
        "PROGRAM" => {
            let program = routines.program_names.get(&fold(&shown.text));
            program.and_then(|program| routines.program_spellings.get(program.position())).cloned()
        }
        _ => {
            let own = match scope {
                Scope::Program(program) => routines.programs.get(program.position()),
                Scope::AddOn(_) | Scope::Controller => None,
            };
            own.and_then(|names| names.get(&fold(&shown.text))).map(|(_, name)| name.clone())
        }
    };
    match found {
        Some(name) => Ok(Operand::Text(name)),
        None => {
            let message = format!("no safety {} is named `{}`", class.to_ascii_lowercase(), shown.text);
            let names = routines.program_spellings.iter().chain(context.safety_tasks).map(CompactString::as_str);
            let finding = Finding::new(&crate::diagnostic::UNKNOWN_PROGRAM, shown.span, message);
            Err(match closest(&shown.text, names) {
                Some(like) => finding.help(format!("did you mean `{like}`?")),
                None => finding.help("the safety task reaches safety objects only"),
            }
            .into())
        }
    }
}

/// Reads the attribute operand.
pub(crate) fn attribute(
    context: &Context<'_>,
    scope: Scope,
    class: &str,
    instance: &str,
    shown: &tree::Operand,
    writes: bool,
) -> Result<Operand, Refusal> {
    let of_class = || ATTRIBUTES.iter().filter(|attribute| attribute.class == class);
    let Some(attribute) = of_class().find(|attribute| attribute.name.eq_ignore_ascii_case(&shown.text)) else {
        return Err(rules::system_attribute::attribute(class, &shown.text, shown.span).into());
    };
    if writes && !attribute.writable {
        return Err(rules::system_attribute::read_only(attribute, shown.span).into());
    }
    if let Some(profile) = context.profile
        && attribute.requires != twinrung_catalog::Requires::Any
        && !rules::admission::offers(profile, attribute.requires)
    {
        return Err(rules::system_attribute::not_here(attribute, profile, shown.span).into());
    }
    let this = instance == "THIS";
    let own = match scope {
        Scope::Program(program) => Some(program),
        Scope::AddOn(_) | Scope::Controller => None,
    };
    let routines = &context.routine_names;
    let object = match (class, this) {
        ("TASK", _) => Some(SystemInstance::Task),
        ("SAFETY", _) => Some(SystemInstance::Controller),
        ("PROGRAM", true) => own.map(SystemInstance::Program),
        ("PROGRAM", false) => routines.program_names.get(&fold(instance)).copied().map(SystemInstance::Program),
        ("ROUTINE", true) => context.own_routine().map(SystemInstance::Routine),
        ("ROUTINE", false) => own
            .and_then(|program| routines.programs.get(program.position()))
            .and_then(|names| names.get(&fold(instance)))
            .map(|(routine, _)| SystemInstance::Routine(*routine)),
        _ => None,
    };
    match object {
        Some(object) => {
            let this = if this { own } else { None };
            Ok(Operand::SystemValue(SystemValue { attribute, instance: object, this }))
        }
        None => {
            let message = format!("`{instance}` names no object of class {class} here");
            Err(Finding::new(&OPERAND_TYPE, shown.span, message)
                .help("name a routine of the same program; an Add-On Instruction has no THIS")
                .into())
        }
    }
}
