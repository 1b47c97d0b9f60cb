//! The pieces of a scenario file, out of the bytes at their places.

use crate::excerpt::Excerpt;
use crate::tree::scenario::{Literal, Terminal};
use crate::tree::{Name, Text};

pub(crate) fn literal(file: Excerpt<'_>, start: usize, end: usize) -> Literal {
    Literal { text: file.slice(start, end).to_owned(), span: file.locate(start, end) }
}

/// The text between the quotes; the place is that of the text with them.
pub(crate) fn quoted(file: Excerpt<'_>, start: usize, end: usize) -> Text {
    Text::new(file.slice(start + 1, end.saturating_sub(1)), file.locate(start, end))
}

/// A terminal as a report names it.
pub(crate) fn words(terminal: &Terminal) -> Name {
    Name::new(format!("{} terminal {}", terminal.module, terminal.text), terminal.span)
}
