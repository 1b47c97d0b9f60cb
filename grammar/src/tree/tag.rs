//! Tags.

use super::{Attribute, Class, Data, Dimensions, ExternalAccess, Name, Operand, Span, Spanned, Text, Trivia};

/// A tag of the controller, of a program, or of an Add-On Instruction.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Tag {
    /// The tag's name.
    pub name: Name,
    /// Whether this comes along as context of a partial export, or is what was exported.
    pub usage: super::Usage,
    /// Base, alias, produced or consumed.
    pub kind: TagKind,
    /// The type; an alias has none of its own.
    pub data_type: Option<Name>,
    /// Array dimensions in the order of subscripts.
    pub dimensions: Dimensions,
    /// Standard or safety, when the declaration says so.
    pub class: Option<Spanned<Class>>,
    /// For tags of a program that are its parameters.
    pub parameter: Option<Spanned<TagUsage>>,
    /// Logic may not write it.
    pub constant: Option<Spanned<bool>>,
    /// External access.
    pub external_access: Option<Spanned<ExternalAccess>>,
    /// Display radix.
    pub radix: Option<Name>,
    /// `MappedFrom := standard tag`: copied from it at the start of each safety task scan.
    /// An L5X says the same in [`super::SafetyInfo::tag_map`].
    pub mapped_from: Option<Name>,
    /// `SIL := 2|3`: the declared integrity of what this tag carries.
    pub sil: Option<Spanned<u32>>,
    /// Initial data, in each form the file has; empty means zeros.
    pub data: Vec<Data>,
    /// Forces, in each form the file has.
    pub forces: Vec<Data>,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Comments on members, elements and bits.
    pub comments: Vec<OperandComment>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Declared with the tag before it: `a, b : BOOL;`. Only the printer cares.
    pub joins_previous: bool,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}

/// What kind of tag.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum TagKind {
    /// Holds data of its own.
    Base,
    /// Another name for a tag, an element, a member or a bit.
    Alias(Box<Operand>),
    /// Sent to other controllers.
    Produced(Box<ProduceInfo>),
    /// Received from another controller.
    Consumed(Box<ConsumeInfo>),
}

/// The usage of a program's tag.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum TagUsage {
    /// Private to the program.
    Local,
    /// Input parameter.
    Input,
    /// Output parameter.
    Output,
    /// Reference parameter.
    InOut,
    /// Public parameter.
    Public,
}

/// How a tag is produced. Times in microseconds.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ProduceInfo {
    /// How many consumers at most.
    pub count: Option<Spanned<u32>>,
    /// Requested packet interval, µs.
    pub rpi_us: Option<Spanned<u64>>,
    /// Shortest interval that a consumer may ask for, µs.
    pub rpi_min_us: Option<Spanned<u64>>,
    /// Longest interval that a consumer may ask for, µs.
    pub rpi_max_us: Option<Spanned<u64>>,
    /// Whether the data carry a connection status.
    pub connection_status: Option<Spanned<bool>>,
    /// Whether consumers may ask for unicast.
    pub unicast: Option<Spanned<bool>>,
}

/// From where and how a tag is consumed. Times in microseconds.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ConsumeInfo {
    /// The producing controller (a module of this project).
    pub producer: Option<Name>,
    /// The tag there.
    pub remote_tag: Option<Text>,
    /// Requested packet interval, µs.
    pub rpi_us: Option<Spanned<u64>>,
    /// Timeout multiplier.
    pub timeout_multiplier: Option<Spanned<u32>>,
    /// Network delay multiplier, percent.
    pub network_delay_multiplier: Option<Spanned<u32>>,
    /// Connection reaction time limit, µs.
    pub reaction_time_limit_us: Option<Spanned<u64>>,
    /// Whether the data carry a connection status.
    pub connection_status: Option<Spanned<bool>>,
    /// Whether the connection is unicast.
    pub unicast: Option<Spanned<bool>>,
}

/// A comment on part of a tag: `.0`, `[3].Speed`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OperandComment {
    /// What it is about, after the tag's name.
    pub operand: Text,
    /// The comment.
    pub text: Text,
}
