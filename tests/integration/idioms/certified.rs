//! What of a routine is not certified, by the tables alone: the compiler has no say here.

use std::collections::BTreeSet;
use std::fmt;

use twinrung_catalog::types::LISTED_WITHOUT_LAYOUT;
use twinrung_catalog::{Element, Instruction, PredefinedType};
use twinrung_grammar::tree::{File, Routine, RoutineBody};

use super::convert::Idiom;
use super::walk::{instructions, uncertified_operators};

/// What keeps a routine from being certified.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stop {
    /// An instruction that Tables 10 to 12 do not list.
    Instruction(String),
    /// A function or operator that the footnotes of Table 12 exclude.
    Operator(String),
    /// A type that Table 7 does not list, and that is made of none of it.
    Type(String),
    /// A routine in another language.
    Language(String),
    /// A name that the export does not declare.
    Undeclared(String),
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Stop::Instruction(name) => write!(f, "instruction {name}"),
            Stop::Operator(name) => write!(f, "operator {name}"),
            Stop::Type(name) => write!(f, "type {name}"),
            Stop::Language(name) => write!(f, "language {name}"),
            Stop::Undeclared(name) => write!(f, "not in the export: {name}"),
        }
    }
}

/// Everything that stops a routine; nothing when all of it is certified.
pub fn stops(idiom: &Idiom) -> BTreeSet<Stop> {
    let file = &idiom.file;
    let mut found: BTreeSet<Stop> = idiom.undeclared.iter().cloned().map(Stop::Undeclared).collect();
    let programs = file.programs.iter().flat_map(|program| &program.routines);
    let add_ons = file.add_on_instructions.iter().flat_map(|add_on| &add_on.routines);
    programs.chain(add_ons).for_each(|routine| judge_routine(file, routine, &mut found));
    let tags = file.tags.iter().chain(file.programs.iter().flat_map(|program| &program.tags));
    let locals = file.add_on_instructions.iter().flat_map(|add_on| &add_on.local_tags);
    let parameters = file.add_on_instructions.iter().flat_map(|add_on| &add_on.parameters);
    let members = file.data_types.iter().flat_map(|data_type| &data_type.members);
    let names = tags.chain(locals).filter_map(|tag| tag.data_type.as_ref());
    let names = names.chain(parameters.filter_map(|parameter| parameter.data_type.as_ref()));
    let names = names.chain(members.filter(|member| member.bit.is_none()).map(|member| &member.data_type));
    found.extend(
        names.filter(|name| !is_certified_type(file, name.as_str())).map(|name| Stop::Type(name.text.to_string())),
    );
    found
}

fn judge_routine(file: &File, routine: &Routine, found: &mut BTreeSet<Stop>) {
    match &routine.body {
        RoutineBody::Ladder(rungs) => {
            for instruction in rungs.iter().flat_map(|rung| instructions(&rung.elements)) {
                let mnemonic = instruction.mnemonic.as_str();
                let is_own = file.add_on_instructions.iter().any(|one| one.name.is(mnemonic));
                if !is_own && Instruction::by_mnemonic(mnemonic).is_none() {
                    found.insert(Stop::Instruction(mnemonic.to_ascii_uppercase()));
                }
                found.extend(instruction.operands.iter().flat_map(uncertified_operators).map(Stop::Operator));
            }
        }
        RoutineBody::Island { language, .. } => {
            found.insert(Stop::Language(language.text.to_string()));
        }
        RoutineBody::Encoded { .. } => {
            found.insert(Stop::Language("encoded".to_owned()));
        }
    }
}

fn is_certified_type(file: &File, name: &str) -> bool {
    Element::by_name(name).is_some()
        || PredefinedType::by_name(name).is_some()
        || LISTED_WITHOUT_LAYOUT.iter().any(|listed| listed.eq_ignore_ascii_case(name))
        || file.data_types.iter().any(|one| one.name.is(name))
        || file.add_on_instructions.iter().any(|one| one.name.is(name))
}
