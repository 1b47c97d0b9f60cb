//! Which name means what where.

use twinrung_bytecode::image::TypeReference;
use twinrung_grammar::tree::CompactString;

use super::{AddOnId, Tag, TagId, TagScope};
use crate::names::{Map, fold};
use crate::operand::Scope;

/// A tag that a name means.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Found {
    /// The tag.
    pub tag: TagId,
    /// Whether the name is a module's tag by rack and slot.
    pub by_slot: bool,
}

/// What a name means in an Add-On Instruction.
#[derive(Debug, Clone, Copy)]
pub(crate) enum AddOnName {
    /// A parameter other than InOut, or a local tag.
    Member { member: u16, type_reference: Option<TypeReference>, dimensions: [u32; 3] },
    /// An InOut parameter.
    InOut { parameter: u16, type_reference: Option<TypeReference>, dimensions: [u32; 3] },
}

/// Names of every scope.
#[derive(Debug, Default)]
pub(crate) struct ScopeNames {
    /// Of the controller.
    pub controller: Map<CompactString, Found>,
    /// Of each safety program.
    pub programs: Vec<Map<CompactString, Found>>,
    /// Of each standard program.
    pub standard: Vec<Map<CompactString, Found>>,
    /// Of each Add-On Instruction, with the spelling.
    pub add_ons: Vec<Map<CompactString, (AddOnName, CompactString)>>,
}

impl ScopeNames {
    /// The table of a scope's own tags.
    pub fn table(&mut self, scope: TagScope) -> Option<&mut Map<CompactString, Found>> {
        match scope {
            TagScope::Controller => Some(&mut self.controller),
            TagScope::Program(program) => self.programs.get_mut(program.position()),
            TagScope::StandardProgram(program) => self.standard.get_mut(program as usize),
        }
    }

    /// The tag that a name means: a program's own tags hide those of the controller.
    pub fn find(&self, scope: Scope, name: &str) -> Option<Found> {
        let folded = fold(name);
        let own = match scope {
            Scope::Program(program) => self.programs.get(program.position()).and_then(|table| table.get(&folded)),
            Scope::Controller | Scope::AddOn(_) => None,
        };
        own.or_else(|| self.controller.get(&folded)).copied()
    }

    /// The tag that a name means in a standard program.
    pub fn find_in_standard(&self, program: usize, name: &str) -> Option<Found> {
        let folded = fold(name);
        let own = self.standard.get(program).and_then(|table| table.get(&folded));
        own.or_else(|| self.controller.get(&folded)).copied()
    }

    /// What a name means in an Add-On Instruction.
    pub fn find_in_add_on(&self, add_on: AddOnId, name: &str) -> Option<AddOnName> {
        self.add_ons.get(add_on.position()).and_then(|table| table.get(&fold(name))).map(|(name, _)| *name)
    }

    /// The names of an Add-On Instruction, for suggestions.
    pub fn names_in_add_on(&self, add_on: AddOnId) -> impl Iterator<Item = &str> {
        self.add_ons.get(add_on.position()).into_iter().flatten().map(|(_, (_, name))| name.as_str())
    }

    /// The names that a scope sees, for suggestions.
    pub fn names<'a>(&'a self, scope: Scope, tags: &'a [Tag]) -> impl Iterator<Item = &'a str> {
        let own = match scope {
            Scope::Program(program) => self.programs.get(program.position()),
            Scope::Controller | Scope::AddOn(_) => None,
        };
        own.into_iter()
            .flat_map(Map::values)
            .chain(self.controller.values())
            .map(|found| &tags[found.tag.position()])
            .flat_map(|tag| std::iter::once(tag.name.as_str()).chain(tag.slot_name.as_deref()))
    }
}
