//! Add-On Instructions.

use twinrung_bytecode::image::{TypeReference, Usage};
use twinrung_bytecode::index::AddOnIndex;
use twinrung_bytecode::layout::elements;
use twinrung_bytecode::limits;
use twinrung_catalog::Element;
use twinrung_grammar::tree::{self, Class, CompactString, Span};

use super::Inputs;
use crate::diagnostic::{
    ADD_ON_SHAPE, BAD_NAME, DUPLICATE_NAME, ENCODED, Finding, Findings, NOT_SUPPORTED, OVER_LIMIT,
};
use crate::names::{Map, fold, name_fault};
use crate::project::add_on::{Local, Parameter};
use crate::project::data::{self, Defaults, Region};
use crate::project::names_in_scope::{AddOnName, ScopeNames};
use crate::project::reading::{Meaning, Mnemonics};
use crate::project::tags::type_finding;
use crate::project::types::{dimensions, usage};
use crate::project::{AddOn, AddOnId, Types};

/// The safety Add-On Instructions of the files, each once, and their mnemonics.
pub(super) fn declare<'a>(
    inputs: &Inputs<'a>,
    types: &mut Types,
    mnemonics: &mut Mnemonics,
    findings: &mut Findings,
) -> Vec<&'a tree::AddOnInstruction> {
    let mut list: Vec<&tree::AddOnInstruction> = Vec::new();
    for (file, context) in inputs.files() {
        for encoded in &file.encoded {
            if let (true, Some(name)) = (encoded.kind.is("AddOnInstructionDefinition"), &encoded.name) {
                mnemonics.add(name.as_str(), Meaning::Reported);
                types.declare_members(name.as_str(), Vec::new());
            }
        }
        for shown in &file.add_on_instructions {
            if shown.usage == tree::Usage::Reference {
                continue;
            }
            let safety = inputs.library || shown.class.is_some_and(|class| class.value == Class::Safety);
            let meaning = if safety { Meaning::AddOn(AddOnId(list.len() as u16)) } else { Meaning::StandardAddOn };
            let taken = safety && (types.knows(shown.name.as_str()) || Element::by_name(shown.name.as_str()).is_some());
            if taken || !mnemonics.add(shown.name.as_str(), meaning) {
                if !context && safety {
                    let message = format!("`{}` is already the name of an instruction or type", shown.name);
                    let finding = Finding::new(&DUPLICATE_NAME, shown.name.span, message);
                    findings.push(finding.help("rename the Add-On Instruction"));
                }
                continue;
            }
            if !safety {
                types.declare_not_safe(shown.name.as_str());
            }
            if safety {
                if let Some(fault) = name_fault(shown.name.as_str()) {
                    let message = format!("`{}` is no name: {fault}", shown.name);
                    findings.push(Finding::new(&BAD_NAME, shown.name.span, message));
                }
                if list.len() >= usize::from(u16::MAX - 1) {
                    findings.push(Finding::new(&OVER_LIMIT, shown.name.span, "there are too many Add-On Instructions"));
                    continue;
                }
                types.declare_add_on(AddOnIndex(list.len() as u16), shown.name.as_str(), members(shown));
                list.push(shown);
            }
        }
    }
    list
}

/// Whether a parameter is the system-defined one of this name.
fn is_enable(parameter: &tree::Parameter) -> bool {
    parameter.name.is("EnableIn") || parameter.name.is("EnableOut")
}

fn declared(shown: &tree::AddOnInstruction) -> impl Iterator<Item = &tree::Parameter> {
    shown.parameters.iter().filter(|parameter| !is_enable(parameter))
}

/// Members of the instance type: EnableIn, EnableOut, the other parameters but InOut, local tags.
fn members(shown: &tree::AddOnInstruction) -> Vec<(CompactString, CompactString, [u32; 3], Span)> {
    let enable = ["EnableIn", "EnableOut"].map(|name| (name.into(), "BOOL".into(), [0; 3], shown.name.span));
    let parameters =
        declared(shown).filter(|one| direction(one) != Usage::InOut && one.alias_for.is_none()).map(|one| {
            let (name, span) = type_of(one);
            (one.name.text.clone(), name, [0; 3], span)
        });
    let locals = shown.local_tags.iter().map(|tag| {
        let (name, span) = tag
            .data_type
            .as_ref()
            .map_or_else(|| (CompactString::default(), tag.name.span), |name| (name.text.clone(), name.span));
        (tag.name.text.clone(), name, dimensions(tag.dimensions), span)
    });
    enable.into_iter().chain(parameters).chain(locals).collect()
}

fn type_of(parameter: &tree::Parameter) -> (CompactString, Span) {
    parameter
        .data_type
        .as_ref()
        .map_or_else(|| (CompactString::default(), parameter.name.span), |name| (name.text.clone(), name.span))
}

fn direction(parameter: &tree::Parameter) -> Usage {
    parameter.usage.map_or(Usage::Input, |shown| usage(shown.value))
}

/// Builds them, with the names of each one's scope and what its instances hold before anything runs.
pub(super) fn build(
    shown: &[&tree::AddOnInstruction],
    types: &mut Types,
    defaults: &mut Defaults,
    names: &mut ScopeNames,
    findings: &mut Findings,
) -> Vec<AddOn> {
    let mut list: Vec<AddOn> = shown.iter().map(|one| build_one(one, types, names, findings)).collect();
    // An instance type stands after the types within it: in that order each finds the defaults of those.
    let mut order: Vec<usize> = (0..list.len()).filter(|at| list[*at].instance_type.is_some()).collect();
    order.sort_by_key(|at| list[*at].instance_type);
    for at in order {
        set_defaults(shown[at], &list[at], types, defaults, findings);
    }
    for add_on in &mut list {
        add_on.attributes.sort();
    }
    list
}

fn build_one(
    shown: &tree::AddOnInstruction,
    types: &mut Types,
    names: &mut ScopeNames,
    findings: &mut Findings,
) -> AddOn {
    let mut table: Map<CompactString, (AddOnName, CompactString)> = Map::default();
    let instance_type = match types.resolve(shown.name.as_str()) {
        Ok(TypeReference::Structure(index)) => Some(index),
        Ok(TypeReference::Element(_)) => None,
        Err(fault) => {
            let name = shown.name.as_str();
            let what = if fault.member.is_some() { fault.member.unwrap_or(shown.name.span) } else { shown.name.span };
            findings.push(type_finding(types, name, name, what, &fault));
            None
        }
    };
    let mut parameters = Vec::with_capacity(shown.parameters.len() + 2);
    let mut member = 0u16;
    let mut declare = |name: &CompactString, span: Span, meaning: AddOnName, findings: &mut Findings| {
        if table.insert(fold(name), (meaning, name.clone())).is_some() {
            let message = format!("`{name}` is declared twice in this Add-On Instruction");
            findings.push(Finding::new(&DUPLICATE_NAME, span, message).help("rename one of the two"));
        }
    };
    let bool_type = TypeReference::Element(Element::Bool);
    for (name, usage) in [("EnableIn", Usage::Input), ("EnableOut", Usage::Output)] {
        let name = CompactString::from(name);
        let meaning = AddOnName::Member { member, type_reference: Some(bool_type), dimensions: [0; 3] };
        declare(&name, shown.name.span, meaning, findings);
        parameters.push(Parameter {
            name,
            span: shown.name.span,
            usage,
            type_reference: Some(bool_type),
            dimensions: [0; 3],
            argument: false,
            member: Some(member),
            constant: false,
        });
        member += 1;
    }
    if shown.parameters.len() > limits::ADD_ON_PARAMETERS {
        let message = format!("an Add-On Instruction has at most {} parameters", limits::ADD_ON_PARAMETERS);
        findings.push(Finding::new(&OVER_LIMIT, shown.name.span, message));
    }
    for one in declared(shown) {
        if one.alias_for.is_some() {
            let message = format!("the parameter `{}` is an alias, which is not compiled", one.name);
            findings.push(
                Finding::new(&NOT_SUPPORTED, one.name.span, message).help("declare it as a parameter of its own"),
            );
            continue;
        }
        let usage = direction(one);
        let (type_name, type_span) = type_of(one);
        let type_reference = match types.resolve(&type_name) {
            Ok(type_reference) => Some(type_reference),
            // The instance type has the same fault, and it was reported there.
            Err(_) if usage != Usage::InOut => None,
            Err(fault) => {
                findings.push(type_finding(types, one.name.as_str(), &type_name, type_span, &fault));
                None
            }
        };
        if usage != Usage::InOut && matches!(type_reference, Some(TypeReference::Structure(_))) {
            let message = format!("the parameter `{}` is a structure: structures pass as InOut only", one.name);
            findings.push(Finding::new(&ADD_ON_SHAPE, type_span, message).help("declare it InOut"));
        }
        if usage != Usage::InOut && !one.dimensions.is_scalar() {
            let message = format!("the parameter `{}` is an array: arrays pass as InOut only", one.name);
            findings.push(Finding::new(&ADD_ON_SHAPE, type_span, message).help("declare it InOut"));
        }
        let shape = dimensions(one.dimensions);
        let cells = type_reference.map_or((0, 0), |reference| types.cells(reference));
        let count = elements(shape).map_or(u64::MAX, u64::from);
        if u64::from(cells.0.max(cells.1)).saturating_mul(count) > u64::from(limits::WORD_CELLS) {
            let message = format!("the parameter `{}` is larger than any tag", one.name);
            findings.push(Finding::new(&OVER_LIMIT, one.name.span, message));
            continue;
        }
        let own_member = (usage != Usage::InOut).then_some(member);
        let position = parameters.len() as u16;
        let meaning = match own_member {
            Some(member) => AddOnName::Member { member, type_reference, dimensions: [0; 3] },
            None => AddOnName::InOut { parameter: position, type_reference, dimensions: shape },
        };
        declare(&one.name.text, one.name.span, meaning, findings);
        member += u16::from(own_member.is_some());
        parameters.push(Parameter {
            name: one.name.text.clone(),
            span: one.name.span,
            usage,
            type_reference,
            dimensions: if usage == Usage::InOut { shape } else { [0; 3] },
            argument: is_argument(one),
            member: own_member,
            constant: one.constant.is_some_and(|constant| constant.value),
        });
    }
    let mut locals = Vec::with_capacity(shown.local_tags.len());
    for tag in &shown.local_tags {
        let type_name = tag.data_type.as_ref().map_or("", |name| name.as_str());
        let type_reference = types.resolve(type_name).ok();
        let shape = dimensions(tag.dimensions);
        let meaning = AddOnName::Member { member, type_reference, dimensions: shape };
        declare(&tag.name.text, tag.name.span, meaning, findings);
        locals.push(Local {
            name: tag.name.text.clone(),
            span: tag.name.span,
            member,
            type_reference,
            dimensions: shape,
        });
        member = member.saturating_add(1);
    }
    names.add_ons.push(table);
    let revision = shown.revision.as_ref().map(|revision| ("Revision".to_owned(), revision.as_str().to_owned()));
    let vendor = shown.vendor.as_ref().map(|vendor| ("Vendor".to_owned(), vendor.as_str().to_owned()));
    AddOn {
        name: shown.name.text.clone(),
        span: shown.name.span,
        instance_type,
        parameters,
        locals,
        logic: None,
        prescan: None,
        enable_in_false: None,
        attributes: revision.into_iter().chain(vendor).collect(),
    }
}

/// Initial values of an instance: those of the types within it, then those that the declarations give.
fn set_defaults(
    shown: &tree::AddOnInstruction,
    add_on: &AddOn,
    types: &Types,
    defaults: &mut Defaults,
    findings: &mut Findings,
) {
    let Some(index) = add_on.instance_type else { return };
    let record = types.record(index);
    let layout = types.layout(index);
    let mut region = Region { bits: vec![0; layout.bit_cells as usize], words: vec![0; layout.word_cells as usize] };
    let data_of = |name: &str| {
        let parameter = shown.parameters.iter().find(|one| one.name.is(name)).map(|one| &one.default);
        parameter.or_else(|| shown.local_tags.iter().find(|one| one.name.is(name)).map(|one| &one.data))
    };
    let mut by_name: Map<CompactString, &Vec<tree::Data>> = Map::default();
    for name in record.members.iter().map(|member| member.name.as_str()) {
        if let Some(data) = data_of(name) {
            by_name.insert(name.into(), data);
        }
    }
    for (member, place) in record.members.iter().zip(&layout.members) {
        let data = by_name.get(member.name.as_str()).map_or(&[][..], |data| data.as_slice());
        let read = data::read(types, defaults, data, member.type_reference, member.dimensions, findings);
        let value = read.unwrap_or_else(|| defaults.blank(types, member.type_reference, member.dimensions));
        region.put(&value, place.bit_cell, place.word_cell);
    }
    defaults.set(index, region);
}

/// Reports what Add-On Instructions cannot have as routines.
pub(super) fn judge_routines(shown: &tree::AddOnInstruction, findings: &mut Findings) {
    for routine in &shown.routines {
        match &routine.body {
            tree::RoutineBody::Ladder(_) => {}
            tree::RoutineBody::Island { language, .. } => {
                let message = format!("routine `{}` is written in {language}", routine.name);
                findings.push(crate::rules::routine_language::finding(routine.name.span, &message));
            }
            tree::RoutineBody::Encoded { .. } => {
                let message = format!("routine `{}` is encoded and cannot be verified", routine.name);
                findings.push(Finding::new(&ENCODED, routine.name.span, message));
            }
        }
    }
    if !shown.routines.iter().any(|routine| routine.name.is("Logic")) {
        let message = format!("the Add-On Instruction `{}` has no routine Logic", shown.name);
        findings.push(Finding::new(&ADD_ON_SHAPE, shown.name.span, message));
    }
}

/// Whether a call writes an argument for a parameter: the required ones (neutral-text-and-l5x.md C.3). Where a declaration is
/// silent, an Input is required and an Output is not (decided).
pub(crate) fn is_argument(parameter: &tree::Parameter) -> bool {
    let silent = direction(parameter) == Usage::Input;
    direction(parameter) == Usage::InOut || parameter.required.map_or(silent, |required| required.value)
}

/// For each Add-On Instruction of any class, which of its arguments it may write.
pub(super) fn standard_arguments(inputs: &Inputs<'_>) -> Map<CompactString, Vec<bool>> {
    let mut table = Map::default();
    for (file, _) in inputs.files() {
        for shown in &file.add_on_instructions {
            let writes = declared(shown)
                .filter(|one| is_argument(one))
                .map(|one| match direction(one) {
                    Usage::Input => false,
                    Usage::Output => true,
                    Usage::InOut => !one.constant.is_some_and(|constant| constant.value),
                })
                .collect();
            table.entry(fold(shown.name.as_str())).or_insert(writes);
        }
    }
    table
}
