//! A text to be read, and where its bytes stand in a file.

use crate::tree::{OriginMap, SourceId, Span};

/// A whole file, or a piece of one: the text of a rung or a value inside an L5X.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Excerpt<'a> {
    /// The text.
    pub text: &'a str,
    /// The file.
    pub source: SourceId,
    /// Where the text begins in it.
    pub start: u32,
    /// Where its bytes stand, when XML entities were resolved in it.
    pub map: Option<&'a OriginMap>,
}

impl<'a> Excerpt<'a> {
    /// The place in the file of the bytes `start..end` of the text.
    pub(crate) fn locate(&self, start: usize, end: usize) -> Span {
        match self.map {
            None => Span::new(self.source, self.start + start as u32, self.start + end as u32),
            Some(map) => Span::new(self.source, map.locate(start), map.locate_end(end)),
        }
    }

    /// The bytes `start..end` of the text; empty when they are not in it.
    pub(crate) fn slice(&self, start: usize, end: usize) -> &'a str {
        self.text.get(start..end).unwrap_or("")
    }
}
