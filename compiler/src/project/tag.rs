//! Tags and the safety tag map.

use twinrung_bytecode::image::TypeReference;
use twinrung_grammar::tree::{self, CompactString, Span};

use super::data::Region;
use super::{ProgramId, TagId};
use crate::diagnostic::Finding;
use crate::operand::{Reference, Walk};

/// Standard or safety.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TagClass {
    /// Ordinary data: safety logic neither reads nor writes it.
    Standard,
    /// Safety data.
    Safety,
}

/// Where a tag is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TagScope {
    /// Everywhere.
    Controller,
    /// In one safety program.
    Program(ProgramId),
    /// In a program of class Standard.
    StandardProgram(u32),
}

/// What a tag is connected to.
#[derive(Debug, Clone)]
pub enum TagKind {
    /// Plain data.
    Base,
    /// Another name for data; nothing where the target could not be resolved.
    Alias(Option<Box<AliasTarget>>),
    /// Sent to other controllers.
    Produced,
    /// Received from another controller.
    Consumed,
    /// Input data of the module at this position of [`super::Project::modules`].
    ModuleInput(usize),
    /// Output data of the module at this position.
    ModuleOutput(usize),
}

/// What an alias designates.
#[derive(Debug, Clone)]
pub struct AliasTarget {
    /// The target as the declaration writes it.
    pub reference: Reference,
    pub(crate) walk: Walk,
}

/// A tag.
#[derive(Debug, Clone)]
pub struct Tag {
    /// Its name; of a module's tag `Module:I`.
    pub name: CompactString,
    /// A module's tag by rack and slot, `Rack:1:I`: read as the same tag, and printed when the project writes it.
    pub slot_name: Option<CompactString>,
    /// Whether the project writes [`Tag::slot_name`] anywhere.
    pub uses_slot_name: bool,
    /// Where it is declared.
    pub span: Span,
    /// Where it is known.
    pub scope: TagScope,
    /// Standard or safety.
    pub class: TagClass,
    /// What it is connected to.
    pub kind: TagKind,
    /// The type's name as the declaration writes it.
    pub type_name: CompactString,
    /// Where the type is named.
    pub type_span: Span,
    /// The type of one element; nothing for a standard tag, and where it is faulty.
    pub type_reference: Option<TypeReference>,
    /// Dimensions, 0 = unused; first = leftmost.
    pub dimensions: [u32; 3],
    /// Whether logic may not write it.
    pub constant: bool,
    /// Declared integrity.
    pub sil: Option<u32>,
    /// Further settings that belong to the signed declaration.
    pub attributes: Vec<(String, String)>,
    /// Initial values of its cells, where they are not those of its type.
    pub initial: Option<Box<Region>>,
    /// The class that the declaration itself names.
    pub explicit_class: Option<(TagClass, Span)>,
    /// Why it cannot be used, reported where safety logic uses it.
    pub fault: Option<Box<Finding>>,
    /// What a consumed tag declares of its connection.
    pub connection: Option<Box<tree::ConsumeInfo>>,
    /// `MappedFrom`.
    pub mapped_from: Option<(CompactString, Span)>,
}

impl Tag {
    /// The name under which the image and every recording know it.
    pub fn image_name(&self) -> &str {
        match &self.slot_name {
            Some(slot_name) if self.uses_slot_name => slot_name,
            _ => &self.name,
        }
    }

    /// Whether it is an alias.
    pub fn is_alias(&self) -> bool {
        matches!(self.kind, TagKind::Alias(_))
    }
}

/// One line of the safety tag map.
#[derive(Debug, Clone)]
pub struct MapLine {
    /// The standard tag that is read: its name as declared.
    pub standard: CompactString,
    /// The safety tag that receives its value.
    pub safety: TagId,
    /// Where the line stands.
    pub span: Span,
}
