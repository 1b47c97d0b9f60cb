//! Add-On Instructions.

use super::{
    Attribute, Class, Data, Dimensions, ExternalAccess, Island, Name, Operand, Routine, Span, Spanned, Tag, Text,
    Trivia, Usage,
};

/// An `ADD_ON_INSTRUCTION_DEFINITION`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct AddOnInstruction {
    /// The instruction's name, its mnemonic in rungs.
    pub name: Name,
    /// Whether this comes along as context of a partial export, or is what was exported.
    pub usage: Usage,
    /// Standard or safety; standard when the file is silent.
    pub class: Option<Spanned<Class>>,
    /// `1.0`: major and minor revision, as written.
    pub revision: Option<Text>,
    /// Who made it.
    pub vendor: Option<Text>,
    /// Whether the Prescan routine is executed in prescan.
    pub execute_prescan: Option<Spanned<bool>>,
    /// Whether the Postscan routine is executed in postscan.
    pub execute_postscan: Option<Spanned<bool>>,
    /// Whether the EnableInFalse routine is executed when the rung is false.
    pub execute_enable_in_false: Option<Spanned<bool>>,
    /// Parameters in order; EnableIn and EnableOut only where the file writes them.
    pub parameters: Vec<Parameter>,
    /// Local tags in order.
    pub local_tags: Vec<Tag>,
    /// Logic, Prescan, Postscan, EnableInFalse: by their names.
    pub routines: Vec<Routine>,
    /// The history of its signatures, oldest first.
    pub history: Vec<HistoryEntry>,
    /// What else stands in it and is skipped.
    pub islands: Vec<Island>,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Everything else: dates, authors, notes of the revision, signatures.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}

/// An entry of the signature history of an Add-On Instruction.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HistoryEntry {
    /// What it says: user, date and time, signature, description.
    pub attributes: Vec<Attribute>,
    /// What else stands in it, as it stands.
    pub text: Text,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole entry.
    pub span: Span,
}

/// A parameter of an Add-On Instruction.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Parameter {
    /// The parameter's name.
    pub name: Name,
    /// Input, output, or by reference; nothing when the file is silent.
    pub usage: Option<Spanned<ParameterUsage>>,
    /// The type (an alias parameter has none in L5X).
    pub data_type: Option<Name>,
    /// Array dimensions (InOut only).
    pub dimensions: Dimensions,
    /// The local tag or parameter, member or bit, that an alias parameter stands for.
    pub alias_for: Option<Box<Operand>>,
    /// Whether a call must give an argument for it.
    pub required: Option<Spanned<bool>>,
    /// Whether the instruction's face shows it.
    pub visible: Option<Spanned<bool>>,
    /// Whether logic may not write it.
    pub constant: Option<Spanned<bool>>,
    /// Default value, in each form the file has.
    pub default: Vec<Data>,
    /// Display radix.
    pub radix: Option<Name>,
    /// External access.
    pub external_access: Option<Spanned<ExternalAccess>>,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}

/// How a parameter passes its value.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ParameterUsage {
    /// Copied in before the logic.
    Input,
    /// Copied out after the logic.
    Output,
    /// The argument itself.
    InOut,
}
