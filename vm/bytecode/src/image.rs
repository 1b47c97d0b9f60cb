//! The records of an image. All tags here are safety tags; standard tags are names in the map.
//!
//! Names are ordered by [`crate::names::order`]. Cells are assigned to the tags that are no aliases in table order,
//! without gaps.

use alloc::string::String;
use alloc::vec::Vec;

use twinrung_catalog::Element;
use twinrung_catalog::instructions::system::ATTRIBUTES;

use crate::index::{AddOnIndex, OperandIndex, ProgramIndex, RoutineIndex, TypeIndex};

/// An image before it is admitted, or as the compiler builds it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Image {
    /// The controller that the application was compiled for.
    pub controller: ControllerRecord,
    /// Structure types, each after those that its members use.
    pub types: Vec<TypeRecord>,
    /// Add-On Instructions, each after those that it calls.
    pub add_ons: Vec<AddOnRecord>,
    /// Programs in order of their names (fold case).
    pub programs: Vec<ProgramRecord>,
    /// Tags: controller scope first, then program by program, each scope in order of the names (fold case).
    pub tags: Vec<TagRecord>,
    /// Routines, owner by owner (programs, then Add-On Instructions), in order of the names.
    pub routines: Vec<RoutineRecord>,
    /// The operand table.
    pub operands: OperandTable,
    /// The safety task; a library of Add-On Instructions has none.
    pub task: Option<TaskRecord>,
    /// Safety modules in order of the names.
    pub modules: Vec<ModuleRecord>,
    /// Standard tags and the safety tags that they are copied to at the start of every scan, in order of the latter,
    /// each at most once.
    pub map: Vec<MapRecord>,
    /// Attributes that GSV and SSV name, each once; their values lie one after the other.
    pub system_values: Vec<SystemValueRecord>,
    /// Event tasks that EVENT names, each once.
    pub event_tasks: Vec<String>,
    /// Initial value of every bit cell, 0 or 1.
    pub initial_bits: Vec<u8>,
    /// Initial value of every word cell.
    pub initial_words: Vec<i32>,
}

impl Image {
    /// How many values of system attributes a scan receives.
    pub fn system_values_length(&self) -> usize {
        let end = |record: &SystemValueRecord| {
            let attribute = ATTRIBUTES.iter().find(|attribute| attribute.number == record.attribute);
            record.first.saturating_add(attribute.map_or(0, |attribute| attribute.length)) as usize
        };
        self.system_values.iter().map(end).max().unwrap_or(0)
    }
}

/// Settings that belong to the signed declaration but not to execution: key and canonical text, sorted by key byte by
/// byte. A text is quoted, without quotes or control characters inside, or plain ([`crate::names::is_setting`]).
pub type Attributes = Vec<(String, String)>;

/// The controller.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ControllerRecord {
    /// Project name.
    pub name: String,
    /// Catalogue number.
    pub processor: String,
    /// Major revision.
    pub revision: u16,
    /// Further settings (SafetyNetwork, ...).
    pub attributes: Attributes,
}

/// The setting of a controller that configures a replaced safety module always (1734-UM013 Chapter 8).
pub const CONFIGURE_ALWAYS: (&str, &str) = ("ConfigureSafetyIOAlways", "Yes");

impl ControllerRecord {
    /// Whether it configures a replaced safety module always, and not only when no safety signature exists.
    pub fn configures_always(&self) -> bool {
        self.attributes.iter().any(|(key, value)| (key.as_str(), value.as_str()) == CONFIGURE_ALWAYS)
    }
}

/// The type of a tag, member or parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TypeReference {
    /// An elementary type.
    Element(Element),
    /// A structure.
    Structure(TypeIndex),
}

/// What a structure is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TypeKind {
    /// Declared in the catalog; the members are the catalog's, in its order.
    Predefined,
    /// A user-defined type, or the type of a module's tag.
    User,
    /// The instance type of an Add-On Instruction: its parameters other than InOut, then its local tags.
    AddOn(AddOnIndex),
}

/// A structure type.
#[derive(Debug, Clone, PartialEq)]
pub struct TypeRecord {
    /// The type's name.
    pub name: String,
    /// What it is.
    pub kind: TypeKind,
    /// Members in declared order; hidden hosts of packed BOOLs are not listed.
    pub members: Vec<MemberRecord>,
}

/// A member of a structure.
#[derive(Debug, Clone, PartialEq)]
pub struct MemberRecord {
    /// Its name.
    pub name: String,
    /// Its type.
    pub type_reference: TypeReference,
    /// Up to three dimensions, 0 = unused; a member of a user-defined type has at most one.
    pub dimensions: [u32; 3],
}

/// Which way a parameter of an Add-On Instruction passes data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Usage {
    /// Copied in.
    Input,
    /// Copied out.
    Output,
    /// By reference.
    InOut,
}

/// A parameter of an Add-On Instruction.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterRecord {
    /// Its name.
    pub name: String,
    /// Its direction.
    pub usage: Usage,
    /// Its type.
    pub type_reference: TypeReference,
    /// Dimensions (InOut arrays), 0 = unused.
    pub dimensions: [u32; 3],
    /// Whether a call has an argument for it.
    pub argument: bool,
    /// The member of the instance type that holds it; `None` for InOut.
    pub member: Option<u16>,
}

/// An Add-On Instruction.
#[derive(Debug, Clone, PartialEq)]
pub struct AddOnRecord {
    /// Its name, which is its mnemonic.
    pub name: String,
    /// Its instance type.
    pub instance_type: TypeIndex,
    /// Parameters in declared order; `EnableIn` and `EnableOut` are the first two.
    pub parameters: Vec<ParameterRecord>,
    /// Runs while the rung is true.
    pub logic: RoutineIndex,
    /// Runs at prescan, after Logic was prescanned, with true rungs.
    pub prescan: Option<RoutineIndex>,
    /// Runs while the rung is false; without it nothing runs then.
    pub enable_in_false: Option<RoutineIndex>,
    /// Further settings (Revision, ...).
    pub attributes: Attributes,
}

/// A program.
#[derive(Debug, Clone, PartialEq)]
pub struct ProgramRecord {
    /// Its name.
    pub name: String,
    /// The routine that the task runs.
    pub main: Option<RoutineIndex>,
    /// The routine that handles its recoverable faults.
    pub fault: Option<RoutineIndex>,
    /// Whether the task skips it.
    pub disabled: bool,
}

/// Who owns a routine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owner {
    /// A program.
    Program(ProgramIndex),
    /// An Add-On Instruction.
    AddOn(AddOnIndex),
}

/// A routine.
#[derive(Debug, Clone, PartialEq)]
pub struct RoutineRecord {
    /// Who owns it.
    pub owner: Owner,
    /// Its name.
    pub name: String,
    /// Its code; see [`mod@crate::format`].
    pub code: Vec<u8>,
    /// Its canonical text without comments: one rung per line, each ending in `;` and a line feed.
    pub text: String,
}

/// What a tag is connected to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TagKind {
    /// Plain data.
    Base,
    /// Another name for what this operand (a reference) designates; has no cells of its own.
    Alias(OperandIndex),
    /// Sent to other controllers at the end of a scan.
    Produced,
    /// Received from another controller, frozen at the start of a scan.
    Consumed,
    /// Input data of a module, frozen at the start of a scan.
    ModuleInput,
    /// Output data of a module, published at the end of a scan.
    ModuleOutput,
}

/// A tag.
#[derive(Debug, Clone, PartialEq)]
pub struct TagRecord {
    /// Its name; for a module's tag the whole name (`Doors:I`).
    pub name: String,
    /// The program that it belongs to; `None` = controller scope.
    pub program: Option<ProgramIndex>,
    /// Its type (of one element).
    pub type_reference: TypeReference,
    /// Up to three dimensions, 0 = unused; first = leftmost.
    pub dimensions: [u32; 3],
    /// What it is connected to.
    pub kind: TagKind,
    /// Whether logic may not write it.
    pub constant: bool,
    /// First cell in the bit space (0 for an alias).
    pub bit_cell: u32,
    /// First cell in the word space (0 for an alias).
    pub word_cell: u32,
    /// Further settings (SIL, RPI, Producer, ...).
    pub attributes: Attributes,
}

/// The safety task.
#[derive(Debug, Clone, PartialEq)]
pub struct TaskRecord {
    /// Its name.
    pub name: String,
    /// Period in microseconds.
    pub period_us: u32,
    /// Watchdog in microseconds.
    pub watchdog_us: u32,
    /// Priority.
    pub priority: u8,
    /// Programs in the order in which they run.
    pub schedule: Vec<ProgramIndex>,
}

/// A safety module: configuration as canonical text.
#[derive(Debug, Clone, PartialEq)]
pub struct ModuleRecord {
    /// Its name.
    pub name: String,
    /// Canonical declaration text, without comments.
    pub text: String,
}

/// One line of the tag map.
#[derive(Debug, Clone, PartialEq)]
pub struct MapRecord {
    /// The standard tag that is read.
    pub standard: String,
    /// The safety tag that receives its value.
    pub safety: crate::index::TagIndex,
}

/// An attribute that GSV or SSV names.
#[derive(Debug, Clone, PartialEq)]
pub struct SystemValueRecord {
    /// [`twinrung_catalog::instructions::system::Attribute::number`].
    pub attribute: u8,
    /// Program or routine that it belongs to: index; 0 for the task and the controller.
    pub instance: u32,
    /// First position in the slice of values that a scan receives.
    pub first: u32,
    /// The program in which THIS was written, or whose record is meant; used by `MajorFaultRecord`.
    pub program: Option<ProgramIndex>,
}

/// All operands: entry `i` is `bytes[offsets[i]..offsets[i + 1]]`; see [`mod@crate::format`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OperandTable {
    /// Where each entry begins; one more at the end.
    pub offsets: Vec<u32>,
    /// The entries.
    pub bytes: Vec<u8>,
}

impl OperandTable {
    /// The bytes of an entry; `None` when there is no such entry.
    pub fn entry(&self, index: OperandIndex) -> Option<&[u8]> {
        let begin = *self.offsets.get(index.position())? as usize;
        let end = *self.offsets.get(index.position().checked_add(1)?)? as usize;
        self.bytes.get(begin..end)
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        self.offsets.len().saturating_sub(1)
    }

    /// Whether there is no entry.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
