//! The two signatures of an image, as a tree of SHA-256 hashes (DESIGN 5).
//!
//! ```text
//! leaf        = H("twinrung leaf 1", kind, name, content)
//! group       = H("twinrung group 1", group name, leaf hash *)           code, data, configuration
//! application = H("twinrung application 1", code, data, configuration)
//! image       = H("twinrung image 1", application, H("twinrung image body 1", every byte but the signatures))
//! ```
//!
//! Every part of a hash but the last is closed by its length, so that no two contents run together. The application
//! signature covers texts and declarations, never bytecode: it stays the same when a later version of the compiler
//! makes other bytes of the same application. Both depend on content alone.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::{self, Write};

use sha2::{Digest, Sha256};

use crate::container;
use crate::error::ImageError;
use crate::image::{AddOnRecord, Attributes, Image, Owner, TypeKind, TypeReference};
use crate::index::{ProgramIndex, RoutineIndex};
use crate::layout::{self, TypeLayout};
use crate::text;

/// Both signatures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Signatures {
    /// Over the application's texts and declarations.
    pub application: [u8; 32],
    /// Over the application signature and all bytes of the image.
    pub image: [u8; 32],
}

/// The part of the application that a leaf belongs to, in the order in which they are gathered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Group {
    /// Routines, programs and Add-On Instructions.
    Code,
    /// Types and tags.
    Data,
    /// Controller, task, modules and tag map.
    Configuration,
}

/// What a leaf is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LeafKind {
    /// The text of a routine.
    Routine,
    /// A program's declaration.
    Program,
    /// An Add-On Instruction's declaration.
    AddOn,
    /// A user-defined type.
    Type,
    /// The tags of the controller, or of a program, with their initial values.
    Tags,
    /// The controller.
    Controller,
    /// The safety task.
    Task,
    /// A module.
    Module,
    /// The tag map.
    Map,
}

impl LeafKind {
    /// The group that gathers leaves of this kind.
    pub const fn group(self) -> Group {
        match self {
            LeafKind::Routine | LeafKind::Program | LeafKind::AddOn => Group::Code,
            LeafKind::Type | LeafKind::Tags => Group::Data,
            LeafKind::Controller | LeafKind::Task | LeafKind::Module | LeafKind::Map => Group::Configuration,
        }
    }

    /// Its name, for people and for the hash.
    pub const fn name(self) -> &'static str {
        match self {
            LeafKind::Routine => "routine",
            LeafKind::Program => "program",
            LeafKind::AddOn => "Add-On Instruction",
            LeafKind::Type => "type",
            LeafKind::Tags => "tags",
            LeafKind::Controller => "controller",
            LeafKind::Task => "task",
            LeafKind::Module => "module",
            LeafKind::Map => "tag map",
        }
    }
}

/// One named thing that the application signature covers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Leaf {
    /// What it is.
    pub kind: LeafKind,
    /// Which one: `Program/Routine` for a routine, the program for its tags, empty for the controller's tags.
    pub name: String,
    /// The hash of its content.
    pub hash: [u8; 32],
}

/// The short form of a signature, `11b2_536b`: its first four bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShortForm([u8; 4]);

/// The short form of a signature.
pub fn short_form(signature: &[u8; 32]) -> ShortForm {
    ShortForm(signature.first_chunk().copied().unwrap_or_default())
}

impl fmt::Display for ShortForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c, d] = self.0;
        write!(f, "{a:02x}{b:02x}_{c:02x}{d:02x}")
    }
}

/// A signature in 64 hexadecimal digits; other bytes in two for each.
pub fn long_form(signature: &[u8]) -> String {
    signature.iter().fold(String::with_capacity(signature.len().saturating_mul(2)), |mut text, byte| {
        // A string takes whatever is written to it.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// The bytes that pairs of hexadecimal digits write; `None` where a character is no digit or the last has no partner.
pub fn bytes_of(digits: &str) -> Option<Vec<u8>> {
    let nibble = |digit: &u8| char::from(*digit).to_digit(16).and_then(|value| u8::try_from(value).ok());
    let pair = |pair: &[u8]| match pair {
        [high, low] => Some(nibble(high)? << 4 | nibble(low)?),
        _ => None,
    };
    digits.as_bytes().chunks(2).map(pair).collect()
}

/// The signature that [`long_form`] writes.
pub fn of_long_form(text: &str) -> Option<[u8; 32]> {
    bytes_of(text)?.try_into().ok()
}

/// Hashes text as it is written.
struct Content(Sha256);

impl Write for Content {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.update(text.as_bytes());
        Ok(())
    }
}

impl Content {
    /// A part that its length closes off from the next.
    fn part(&mut self, text: &str) {
        self.0.update(text.as_bytes());
        self.0.update((text.len() as u64).to_le_bytes());
    }

    fn attributes(&mut self, attributes: &Attributes) {
        for (key, value) in attributes {
            self.part(key);
            self.part(value);
        }
    }
}

fn leaf(
    kind: LeafKind,
    name: String,
    write: impl FnOnce(&mut Content) -> Result<(), text::Stop>,
) -> Result<Leaf, ImageError> {
    let mut content = Content(Sha256::new_with_prefix(b"twinrung leaf 1\0"));
    content.part(kind.name());
    content.part(&name);
    match write(&mut content) {
        // A hash takes whatever is written to it.
        Ok(()) | Err(text::Stop::Writer) => Ok(Leaf { kind, name, hash: content.0.finalize().into() }),
        Err(text::Stop::Image(error)) => Err(error),
    }
}

/// Everything that the application signature covers, in the order of the image's tables.
///
/// # Errors
///
/// The types have no layout, or an alias has no text.
pub fn leaves(image: &Image) -> Result<Vec<Leaf>, ImageError> {
    let layouts = layout::layouts(&image.types).map_err(|why| ImageError::Layout { why })?;
    leaves_with(image, &layouts)
}

pub(crate) fn leaves_with(image: &Image, layouts: &[TypeLayout]) -> Result<Vec<Leaf>, ImageError> {
    let mut leaves = Vec::new();
    for (index, routine) in image.routines.iter().enumerate() {
        let name = text::routine_name(image, RoutineIndex(index as u32));
        leaves.push(leaf(LeafKind::Routine, name, |out| Ok(out.write_str(&routine.text)?))?);
    }
    for program in &image.programs {
        leaves
            .push(leaf(LeafKind::Program, program.name.clone(), |out| Ok(text::write_program(image, program, out)?))?);
    }
    for add_on in &image.add_ons {
        leaves.push(leaf(LeafKind::AddOn, add_on.name.clone(), |out| {
            out.attributes(&add_on.attributes);
            Ok(text::write_add_on(image, add_on, out)?)
        })?);
    }
    for record in image.types.iter().filter(|record| record.kind == TypeKind::User) {
        leaves.push(leaf(LeafKind::Type, record.name.clone(), |out| Ok(text::write_type(image, record, out)?))?);
    }
    let programs = (0..image.programs.len()).map(|index| Some(ProgramIndex(index as u16)));
    for scope in core::iter::once(None).chain(programs) {
        let name = scope.and_then(|program| image.programs.get(program.position()));
        let name = name.map_or_else(String::new, |program| program.name.clone());
        leaves.push(leaf(LeafKind::Tags, name, |out| {
            image.tags.iter().filter(|tag| tag.program == scope).for_each(|tag| out.attributes(&tag.attributes));
            text::write_tags(image, layouts, scope, out)
        })?);
    }
    leaves.push(leaf(LeafKind::Controller, image.controller.name.clone(), |out| {
        out.attributes(&image.controller.attributes);
        Ok(text::write_controller(&image.controller, out)?)
    })?);
    if let Some(task) = &image.task {
        leaves.push(leaf(LeafKind::Task, task.name.clone(), |out| Ok(text::write_task(image, task, out)?))?);
    }
    for module in &image.modules {
        leaves.push(leaf(LeafKind::Module, module.name.clone(), |out| Ok(text::write_module(module, out)?))?);
    }
    leaves.push(leaf(LeafKind::Map, String::new(), |out| Ok(text::write_map(image, out)?))?);
    Ok(leaves)
}

/// The application signature that leaves give.
pub fn application_signature(leaves: &[Leaf]) -> [u8; 32] {
    let mut application = Sha256::new_with_prefix(b"twinrung application 1\0");
    for (group, name) in [(Group::Code, "code"), (Group::Data, "data"), (Group::Configuration, "configuration")] {
        let mut content = Content(Sha256::new_with_prefix(b"twinrung group 1\0"));
        content.part(name);
        for leaf in leaves.iter().filter(|leaf| leaf.kind.group() == group) {
            content.0.update(leaf.hash);
        }
        application.update(content.0.finalize());
    }
    application.finalize().into()
}

/// The safety instruction signatures of all Add-On Instructions, in the order of their table: what of each executes, with the
/// instructions and types that it uses, and nothing of comments and descriptions (1756-RM093 Appendix B; the hash is decided).
/// The initial values of its parameters and local tags are among its attributes; those of a tag of its type belong to the tag.
///
/// # Errors
///
/// As [`leaves`].
pub fn safety_instruction_signatures(image: &Image) -> Result<Vec<[u8; 32]>, ImageError> {
    let leaves = leaves(image)?;
    Ok(image.add_ons.iter().map(|add_on| safety_instruction_signature(image, &leaves, add_on)).collect())
}

fn safety_instruction_signature(image: &Image, leaves: &[Leaf], first: &AddOnRecord) -> [u8; 32] {
    let mut names = alloc::vec![first.name.as_str()];
    let mut types = alloc::vec![first.instance_type];
    let mut taken = 0_usize;
    // The list of types grows while it is gone through; each type is taken once, and there are finitely many.
    while let Some(index) = types.get(taken).copied() {
        taken = taken.saturating_add(1);
        let Some(record) = image.types.get(index.position()) else { continue };
        names.push(record.name.as_str());
        let own = match record.kind {
            TypeKind::AddOn(index) => image.add_ons.get(index.position()),
            TypeKind::Predefined | TypeKind::User => None,
        };
        let members = record.members.iter().map(|member| member.type_reference);
        let parameters = own.iter().flat_map(|own| &own.parameters).map(|parameter| parameter.type_reference);
        for used in members.chain(parameters) {
            match used {
                TypeReference::Structure(used) if !types.contains(&used) => types.push(used),
                TypeReference::Structure(_) | TypeReference::Element(_) => {}
            }
        }
    }
    let mut content = Content(Sha256::new_with_prefix(b"twinrung safety instruction 1\0"));
    content.part(&first.name);
    // The leaves begin with the routines, in the order of their table.
    for (position, leaf) in leaves.iter().enumerate() {
        let is_used = match leaf.kind {
            LeafKind::Routine => image.routines.get(position).is_some_and(|routine| match routine.owner {
                Owner::AddOn(owner) => {
                    image.add_ons.get(owner.position()).is_some_and(|one| names.contains(&one.name.as_str()))
                }
                Owner::Program(_) => false,
            }),
            LeafKind::AddOn | LeafKind::Type => names.contains(&leaf.name.as_str()),
            _ => false,
        };
        if is_used {
            content.0.update(leaf.hash);
        }
    }
    content.0.finalize().into()
}

/// The image signature over an application signature and the hash of the image's bytes.
pub(crate) fn image_signature(application: &[u8; 32], body: &[u8; 32]) -> [u8; 32] {
    let mut hash = Sha256::new_with_prefix(b"twinrung image 1\0");
    hash.update(application);
    hash.update(body);
    hash.finalize().into()
}

/// The bytes of an image with both signatures computed: what the compiler hands over. It verifies nothing: what
/// [`crate::admit`] refuses can be sealed.
///
/// # Errors
///
/// As [`leaves`].
pub fn seal(image: &Image) -> Result<Vec<u8>, ImageError> {
    let application = application_signature(&leaves(image)?);
    let mut bytes = container::encode_unsigned(image);
    let image = image_signature(&application, &container::body_hash(&bytes));
    container::sign(&mut bytes, &Signatures { application, image });
    Ok(bytes)
}

impl fmt::Display for Signatures {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&short_form(&self.application).to_string())?;
        write!(f, " ({})", short_form(&self.image))
    }
}
