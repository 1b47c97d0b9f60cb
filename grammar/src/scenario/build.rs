//! The pieces of a scenario file, out of the bytes at their places.

use crate::excerpt::Excerpt;
use crate::tree::Text;
use crate::tree::scenario::Literal;

pub(crate) fn literal(file: Excerpt<'_>, start: usize, end: usize) -> Literal {
    Literal { text: file.slice(start, end).to_owned(), span: file.locate(start, end) }
}

/// The text between the quotes; the place is that of the text with them.
pub(crate) fn quoted(file: Excerpt<'_>, start: usize, end: usize) -> Text {
    Text::new(file.slice(start + 1, end.saturating_sub(1)), file.locate(start, end))
}
