//! Rungs: mnemonics with operands, in series and in branches.

use super::{CompactString, Name, Span, Spanned, Text};

/// One rung of a ladder routine.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Rung {
    /// The number that an L5X gives it, from 0; order decides.
    pub number: Option<Spanned<u32>>,
    /// Normal, or part of an online edit.
    pub kind: Spanned<RungKind>,
    /// The rung comment (`RC:`), lines separated by line feeds.
    pub comment: Option<Box<Text>>,
    /// What is in series from rail to rail. Empty for `;`, and for a broken rung.
    pub elements: Vec<Element>,
    /// The text could not be read (an error says why); `elements` is empty.
    pub broken: bool,
    /// Comments of the source around it.
    pub trivia: Trivia,
    /// The rung's neutral text, `;` included.
    pub span: Span,
}

/// The state of a rung. Everything but normal is an online edit.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum RungKind {
    /// `N`
    #[default]
    Normal,
    /// `I`
    Insert,
    /// `D`
    Delete,
    /// `IR`
    InsertReplace,
    /// `rR`
    PendingReplaceOfInsertReplace,
    /// `R`
    Replace,
    /// `rI`
    PendingReplaceOfInsert,
    /// `rN`
    PendingReplaceOfNormal,
    /// `e`
    PendingInsert,
    /// `er`
    PendingReplace,
    /// `d`
    PendingDelete,
    /// `dN`
    PendingDeleteOfNormal,
    /// `dD`
    PendingDeleteOfDelete,
    /// `dI`
    PendingDeleteOfInsert,
    /// `dIR`
    PendingDeleteOfInsertReplace,
}

/// One thing in a series.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Element {
    /// A mnemonic with operands.
    Instruction(Instruction),
    /// Parallel legs.
    Branch(Branch),
}

impl Element {
    /// Where.
    pub fn span(&self) -> Span {
        match self {
            Element::Instruction(instruction) => instruction.span,
            Element::Branch(branch) => branch.span,
        }
    }
}

/// `XIC(a)`: a base instruction or a call of an Add-On Instruction; the grammar cannot tell.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Instruction {
    /// As written.
    pub mnemonic: Name,
    /// The operands in order.
    pub operands: Vec<Operand>,
    /// Mnemonic and parentheses.
    pub span: Span,
}

/// `[a ,b ]`: legs in parallel.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Branch {
    /// The legs from top to bottom, at least one.
    pub legs: Vec<Leg>,
    /// Brackets included.
    pub span: Span,
}

/// One leg of a branch; an empty one is a short circuit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Leg {
    /// What is in series.
    pub elements: Vec<Element>,
    /// From after the bracket or comma to before the next one.
    pub span: Span,
}

/// One operand: a flat run of atoms that only the instruction's declaration can give a meaning.
///
/// Ask [`crate::read_tag`], [`crate::read_expression`], [`crate::read_words`] or
/// [`crate::read_immediate`] for that meaning. It is kept as text: blanks at both ends removed,
/// blanks, line breaks and comments between atoms made one blank.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Operand {
    /// The text; empty for an empty operand, `?` for an unassigned one.
    pub text: CompactString,
    /// Where.
    pub span: Span,
    /// Where the bytes of `text` stand in the file; nothing when they are the span's own bytes.
    pub origin: Option<Box<OriginMap>>,
}

impl Operand {
    /// Nothing between the commas.
    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// `?`: the editor has a value elsewhere, or nobody entered one.
    pub fn is_unassigned(&self) -> bool {
        self.text == "?"
    }

    /// The place in the file of the bytes `start..end` of `text`.
    pub fn locate(&self, start: usize, end: usize) -> Span {
        match &self.origin {
            None => {
                let at = |offset: usize| self.span.start.saturating_add(offset as u32).min(self.span.end);
                Span::new(self.span.source, at(start), at(end))
            }
            Some(map) => Span::new(self.span.source, map.locate(start), map.locate_end(end)),
        }
    }
}

/// Where the bytes of a changed text stand in its file: after comments and line breaks were taken
/// out, or XML entities resolved.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct OriginMap {
    /// (offset in the text, offset in the file), ascending; between two entries both run alike.
    pieces: Vec<(u32, u32)>,
}

impl OriginMap {
    /// A map from ascending (offset in the text, offset in the file).
    pub fn new(pieces: Vec<(u32, u32)>) -> OriginMap {
        OriginMap { pieces }
    }

    /// Where the byte at `offset` stands in the file.
    pub fn locate(&self, offset: usize) -> u32 {
        let offset = offset as u32;
        let index = self.pieces.partition_point(|&(text, _)| text <= offset);
        match index.checked_sub(1).and_then(|index| self.pieces.get(index)) {
            Some(&(text, file)) => file.saturating_add(offset - text),
            None => 0,
        }
    }

    /// Where the byte before `offset` ends.
    pub fn locate_end(&self, offset: usize) -> u32 {
        match offset.checked_sub(1) {
            Some(last) => self.locate(last).saturating_add(1),
            None => self.locate(0),
        }
    }
}

/// Comments of the source (`//` and `(* *)`) that belong to a declaration or rung, delimiters
/// included. They mean nothing to a compiler; the printer puts them back.
#[derive(Clone, PartialEq, Eq, Default)]
pub struct Trivia(Option<Box<TriviaLines>>);

#[derive(Clone, PartialEq, Eq, Debug, Default)]
struct TriviaLines {
    leading: Vec<CompactString>,
    trailing: Vec<CompactString>,
    closing: Vec<CompactString>,
}

impl Trivia {
    /// No comment.
    pub fn none() -> Trivia {
        Trivia(None)
    }

    /// On lines of their own, before the declaration (or inside it).
    pub fn leading(&self) -> &[CompactString] {
        self.0.as_ref().map_or(&[], |lines| &lines.leading)
    }

    /// On the declaration's last line, or on the first line of a block.
    pub fn trailing(&self) -> &[CompactString] {
        self.0.as_ref().map_or(&[], |lines| &lines.trailing)
    }

    /// Before the `END_...` of a block, after everything in it.
    pub fn closing(&self) -> &[CompactString] {
        self.0.as_ref().map_or(&[], |lines| &lines.closing)
    }

    /// Adds a comment before the declaration.
    pub fn push_leading(&mut self, comment: impl Into<CompactString>) {
        self.0.get_or_insert_default().leading.push(comment.into());
    }

    /// Adds a comment on the declaration's line.
    pub fn push_trailing(&mut self, comment: impl Into<CompactString>) {
        self.0.get_or_insert_default().trailing.push(comment.into());
    }

    /// Adds a comment at the end of a block.
    pub fn push_closing(&mut self, comment: impl Into<CompactString>) {
        self.0.get_or_insert_default().closing.push(comment.into());
    }
}

impl std::fmt::Debug for Trivia {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.0 {
            None => f.write_str("-"),
            Some(lines) => lines.fmt(f),
        }
    }
}
