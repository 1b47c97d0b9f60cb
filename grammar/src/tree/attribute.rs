//! Names, texts and attributes: the small change of every declaration.

use super::{CompactString, Span, Value};

/// A component's name, a keyword or a mnemonic, spelled as in the file. Logix compares names
/// without regard to case: use [`Name::is`].
#[derive(Clone, PartialEq, Eq, Hash, Debug, Default)]
pub struct Name {
    /// As written.
    pub text: CompactString,
    /// Where.
    pub span: Span,
}

impl Name {
    /// A name at a place.
    pub fn new(text: impl Into<CompactString>, span: Span) -> Name {
        Name { text: text.into(), span }
    }

    /// Whether it is this name, case aside.
    pub fn is(&self, other: &str) -> bool {
        self.text.eq_ignore_ascii_case(other)
    }

    /// As written.
    pub fn as_str(&self) -> &str {
        &self.text
    }
}

impl std::fmt::Display for Name {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.text)
    }
}

/// Free text (a description, a comment, a quoted value), escapes already resolved.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Default)]
pub struct Text {
    /// The text itself.
    pub text: CompactString,
    /// Where.
    pub span: Span,
}

impl Text {
    /// A text at a place.
    pub fn new(text: impl Into<CompactString>, span: Span) -> Text {
        Text { text: text.into(), span }
    }

    /// The text itself.
    pub fn as_str(&self) -> &str {
        &self.text
    }
}

/// A value and the place that said so.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Where.
    pub span: Span,
}

impl<T> Spanned<T> {
    /// A value at a place.
    pub fn new(value: T, span: Span) -> Spanned<T> {
        Spanned { value, span }
    }
}

/// Standard or safety: of tags, programs, tasks and Add-On Instructions.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Class {
    /// Ordinary logic and data.
    Standard,
    /// Executed and compared on both channels.
    Safety,
}

/// What operator stations and other external devices may do with a tag.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ExternalAccess {
    /// Read and write.
    ReadWrite,
    /// Read only.
    ReadOnly,
    /// Neither.
    None,
}

/// One `key := value` of an attribute list, or one XML attribute, that has no field of its own.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Attribute {
    /// The key, as written.
    pub key: Name,
    /// The value.
    pub value: AttributeValue,
}

/// What an attribute is set to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum AttributeValue {
    /// Unquoted: a number, a word, several words (`Mode := SAFETY_PULSE_TEST`); blanks as written.
    Words(Text),
    /// In double quotes; also every XML attribute.
    Quoted(Text),
    /// A bracketed list (`ExtendedProp := [[[...]]]`).
    List(Value),
}

impl AttributeValue {
    /// The text of words or of a quoted value; nothing for a list.
    pub fn text(&self) -> Option<&Text> {
        match self {
            AttributeValue::Words(text) | AttributeValue::Quoted(text) => Some(text),
            AttributeValue::List(_) => None,
        }
    }

    /// Where.
    pub fn span(&self) -> Span {
        match self {
            AttributeValue::Words(text) | AttributeValue::Quoted(text) => text.span,
            AttributeValue::List(value) => value.span(),
        }
    }
}
