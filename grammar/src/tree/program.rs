//! Programs and routines.

use super::{Attribute, Class, Encoded, Island, Name, Rung, Span, Spanned, Tag, Text, Trivia, Usage};

/// A `PROGRAM`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Program {
    /// The program's name.
    pub name: Name,
    /// Whether this comes along as context of a partial export, or is what was exported.
    pub usage: Usage,
    /// Standard or safety; standard when the file is silent.
    pub class: Option<Spanned<Class>>,
    /// The routine that the task calls.
    pub main_routine: Option<Name>,
    /// The routine that a fault of the program calls.
    pub fault_routine: Option<Name>,
    /// The program is not executed.
    pub disabled: Option<Spanned<bool>>,
    /// Test edits are active: somebody edits online.
    pub test_edits: Option<Spanned<bool>>,
    /// Only a folder of the project view.
    pub use_as_folder: Option<Spanned<bool>>,
    /// Its tags.
    pub tags: Vec<Tag>,
    /// Its routines.
    pub routines: Vec<Routine>,
    /// Encoded components.
    pub encoded: Vec<Encoded>,
    /// What else stands in it and is skipped.
    pub islands: Vec<Island>,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}

/// A `ROUTINE`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Routine {
    /// The routine's name.
    pub name: Name,
    /// Whether this comes along as context of a partial export, or is what was exported.
    pub usage: Usage,
    /// What is in it.
    pub body: RoutineBody,
    /// For people.
    pub description: Option<Box<Text>>,
    /// Everything else.
    pub attributes: Vec<Attribute>,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The whole declaration.
    pub span: Span,
}

impl Routine {
    /// The rungs of a ladder routine; empty for an island.
    pub fn rungs(&self) -> &[Rung] {
        match &self.body {
            RoutineBody::Ladder(rungs) => rungs,
            RoutineBody::Island { .. } | RoutineBody::Encoded { .. } => &[],
        }
    }
}

/// What a routine holds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum RoutineBody {
    /// Rungs.
    Ladder(Vec<Rung>),
    /// Another language, skipped: `ST`, `FBD`, `SFC`.
    Island {
        /// Which language.
        language: Name,
        /// What a text file has between the head and the end; empty from an L5X.
        text: Text,
    },
    /// Source protection: encoded, cannot be read.
    Encoded {
        /// What a text file has between the head and the end; empty from an L5X.
        text: Text,
    },
}
