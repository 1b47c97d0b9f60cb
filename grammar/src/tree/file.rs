//! A file, or a folder merged into one.

use super::{
    AddOnInstruction, Attribute, DataType, Module, Name, Program, Routine, SourceId, Span, Spanned, Tag, Task, Text,
    Trivia,
};

/// Everything that one file says, or a folder of files as one project.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct File {
    /// The files it was read from.
    pub sources: Vec<SourceId>,
    /// What form the (first) file has.
    pub form: FileForm,
    /// What an L5X says about itself.
    pub export: Option<Box<Export>>,
    /// `IE_VER := 2.11;` of an L5K.
    pub ie_version: Option<Text>,
    /// The controller; nothing when the file begins at a program or routine.
    pub controller: Option<Box<Controller>>,
    /// User-defined and module-defined types.
    pub data_types: Vec<DataType>,
    /// I/O modules, the controller and its partner among them where an export lists them.
    pub modules: Vec<Module>,
    /// Add-On Instructions.
    pub add_on_instructions: Vec<AddOnInstruction>,
    /// Controller-scoped tags.
    pub tags: Vec<Tag>,
    /// Programs.
    pub programs: Vec<Program>,
    /// Routines outside a program: a file that begins at ROUTINE.
    pub routines: Vec<Routine>,
    /// Tasks.
    pub tasks: Vec<Task>,
    /// Encoded components, which cannot be read.
    pub encoded: Vec<Encoded>,
    /// What else stands in it and is skipped: trends, parameter connections, ...
    pub islands: Vec<Island>,
    /// Comments of the source around everything.
    pub trivia: Trivia,
}

/// The form of a file.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum FileForm {
    /// `.rll` or `.L5K`: one grammar.
    #[default]
    Text,
    /// `.L5X`.
    Xml,
}

/// The part that a component plays in a partial export.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Usage {
    /// What was exported (`Use="Target"`), and everything in a file that makes no difference.
    #[default]
    Target,
    /// Comes along because the target refers to it (`Use="Context"`).
    Context,
    /// Only named (`Use="Reference"`).
    Reference,
}

/// The attributes of `<RSLogix5000Content>`.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Export {
    /// `17.00`: the version of the software that exported.
    pub software_revision: Option<Text>,
    /// `Controller` for a whole project; `Program`, `Routine`, `Rung`, `DataType`,
    /// `AddOnInstructionDefinition`, `Module`, `Tag` for a partial export.
    pub target_type: Option<Name>,
    /// The exported component.
    pub target_name: Option<Name>,
    /// `Standard` or `Safety`.
    pub target_class: Option<Name>,
    /// Whether referenced components come along.
    pub contains_context: Option<Spanned<bool>>,
    /// `NoRawData L5KData ...`
    pub options: Option<Text>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// The start tag.
    pub span: Span,
}

impl Export {
    /// Whether this is less than a whole project.
    pub fn is_partial(&self) -> bool {
        self.target_type.as_ref().is_some_and(|target| !target.is("Controller"))
            || self.contains_context.is_some_and(|context| context.value)
    }
}

/// The `CONTROLLER` itself; what it holds is in [`File`].
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Controller {
    /// The controller's name.
    pub name: Name,
    /// Whether this comes along as context of a partial export, or is what was exported.
    pub usage: Usage,
    /// Catalogue number, `1756-L73S`.
    pub processor_type: Option<Text>,
    /// Major revision.
    pub major: Option<Spanned<u32>>,
    /// Minor revision.
    pub minor: Option<Spanned<u32>>,
    /// Safety network number of the chassis, as written (`.rll`; an L5X has it on the module
    /// `Local`).
    pub safety_network: Option<Text>,
    /// What concerns safety; nothing when the file is silent.
    pub safety: Option<Box<SafetyInfo>>,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The declaration's head.
    pub span: Span,
}

/// The controller's safety settings.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct SafetyInfo {
    /// Locked when it was exported; informational.
    pub locked: Option<Spanned<bool>>,
    /// The maker's signature when it was exported; informational.
    pub signature: Option<Text>,
    /// `SIL2/PLd` or `SIL3/PLe` (newer controllers).
    pub level: Option<Text>,
    /// Replaced modules are configured without asking.
    pub configure_io_always: Option<Spanned<bool>>,
    /// The signature may not be changed in Run mode.
    pub signature_run_mode_protect: Option<Spanned<bool>>,
    /// Standard tags that are copied to safety tags. (`.rll` says the same with `MappedFrom`.)
    pub tag_map: Vec<MapEntry>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Where.
    pub span: Span,
}

/// `standard=safety` of the safety tag map.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MapEntry {
    /// The standard tag that is read.
    pub standard: Name,
    /// The safety tag that takes its value.
    pub safety: Name,
    /// Both.
    pub span: Span,
}

/// A component that the maker's software encoded: it cannot be read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Encoded {
    /// `Routine`, `AddOnInstructionDefinition`, ...
    pub kind: Name,
    /// Its name, where the file still says it.
    pub name: Option<Name>,
    /// What else the file says.
    pub attributes: Vec<Attribute>,
    /// What a text file has between the head and the end; empty from an L5X.
    pub text: Text,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole element.
    pub span: Span,
}

/// Something that is no business of a safety compiler: skipped, and named.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Island {
    /// `TREND`, `PARAMETER_CONNECTION`, `Trends`, ...
    pub kind: Name,
    /// Its name, where it has one.
    pub name: Option<Name>,
    /// Everything from its first to its last word; empty from an L5X.
    pub text: Text,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole of it.
    pub span: Span,
}
