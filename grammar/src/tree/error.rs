//! What can be wrong with a file as a file.

use super::Span;

macro_rules! error_kinds {
    ($($(#[$doc:meta])* $variant:ident => $name:literal,)*) => {
        /// The kinds of error in reading.
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
        #[non_exhaustive]
        pub enum ErrorKind { $($(#[$doc])* $variant,)* }

        impl ErrorKind {
            /// Every kind, in order of declaration.
            pub const ALL: &[ErrorKind] = &[$(ErrorKind::$variant,)*];

            /// A short stable name.
            pub fn name(self) -> &'static str {
                match self { $(ErrorKind::$variant => $name,)* }
            }
        }
    };
}

error_kinds! {
    /// The file cannot be opened or read from disk.
    Unreadable => "unreadable",
    /// Larger than the limit on files.
    TooLarge => "too-large",
    /// Bytes that are not UTF-8.
    NotUtf8 => "not-utf8",
    /// A character that no token begins with.
    UnknownCharacter => "unknown-character",
    /// A quoted text without its closing quote.
    UnclosedQuote => "unclosed-quote",
    /// A `(*` without its `*)`.
    UnclosedComment => "unclosed-comment",
    /// A block without its `END_...`.
    UnclosedBlock => "unclosed-block",
    /// An `END_...` of another block, or of none.
    StrayEnd => "stray-end",
    /// A word where no declaration begins.
    UnknownDeclaration => "unknown-declaration",
    /// A declaration whose text is not of the expected shape.
    MalformedDeclaration => "malformed-declaration",
    /// A rung whose text is not of the expected shape.
    MalformedRung => "malformed-rung",
    /// A statement of a scenario file whose text is not of the expected shape.
    MalformedScenario => "malformed-scenario",
    /// A rung kind that does not exist.
    UnknownRungKind => "unknown-rung-kind",
    /// An operand that should be a tag reference and is not one.
    MalformedTagReference => "malformed-tag-reference",
    /// An operand that should be an expression and is not one.
    MalformedExpression => "malformed-expression",
    /// A relation mixed with operators in a way that two tables of precedence read differently.
    AmbiguousRelation => "ambiguous-relation",
    /// An operand that should be an option word or a number and is neither.
    MalformedWords => "malformed-words",
    /// A literal that is not a number of any form, or beyond 64 bits.
    MalformedNumber => "malformed-number",
    /// A `$` escape that does not exist.
    MalformedEscape => "malformed-escape",
    /// Branches, expressions, lists or elements nested deeper than the limit.
    TooDeep => "too-deep",
    /// More operands, subscripts, items or errors than the limit.
    TooMany => "too-many",
    /// An attribute whose value is not of the kind that it needs.
    BadAttribute => "bad-attribute",
    /// The XML is not well-formed.
    MalformedXml => "malformed-xml",
    /// XML, but not an L5X.
    NotL5x => "not-l5x",
    /// Data of a tag that its form cannot hold.
    MalformedData => "malformed-data",
    /// A name that no component can have.
    BadName => "bad-name",
    /// Two controllers in one project.
    TwoControllers => "two-controllers",
    /// The file holds nothing to read.
    Empty => "empty",
}

/// Something wrong with a file: what, where, and a way out.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ReadError {
    /// What kind of error.
    pub kind: ErrorKind,
    /// One lower-case sentence.
    pub message: String,
    /// Where.
    pub span: Span,
    /// A way out, where there is one to name.
    pub help: Option<String>,
}

impl ReadError {
    /// An error at a place.
    pub fn new(kind: ErrorKind, span: Span, message: impl Into<String>) -> ReadError {
        ReadError { kind, message: message.into(), span, help: None }
    }

    /// The same with a way out.
    pub fn with_help(mut self, help: impl Into<String>) -> ReadError {
        self.help = Some(help.into());
        self
    }
}

impl std::fmt::Display for ReadError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for ReadError {}
