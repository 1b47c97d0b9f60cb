//! Reading numbers and pieces from bytes: every step checked, every failure with its offset.

use crate::error::ImageError;

/// A position in the bytes of one section, or of the whole file.
#[derive(Debug, Clone)]
pub(super) struct Cursor<'a> {
    rest: &'a [u8],
    offset: usize,
}

impl<'a> Cursor<'a> {
    /// Reads `bytes`, whose first byte stands at `offset` of the file.
    pub(super) fn new(bytes: &'a [u8], offset: usize) -> Cursor<'a> {
        Cursor { rest: bytes, offset }
    }

    /// Where the next byte stands in the file.
    pub(super) fn offset(&self) -> usize {
        self.offset
    }

    /// Bytes that are left.
    pub(super) fn remaining(&self) -> usize {
        self.rest.len()
    }

    /// The next `count` bytes.
    pub(super) fn take(&mut self, count: usize) -> Result<&'a [u8], ImageError> {
        let (piece, rest) = self.rest.split_at_checked(count).ok_or(ImageError::Truncated { offset: self.offset })?;
        self.rest = rest;
        self.offset = self.offset.saturating_add(count);
        Ok(piece)
    }

    /// The next bytes as an array.
    pub(super) fn array<const N: usize>(&mut self) -> Result<[u8; N], ImageError> {
        let (piece, rest) = self.rest.split_first_chunk().ok_or(ImageError::Truncated { offset: self.offset })?;
        self.rest = rest;
        self.offset = self.offset.saturating_add(N);
        Ok(*piece)
    }

    /// Refuses bytes that are left over.
    pub(super) fn finish(&self) -> Result<(), ImageError> {
        if self.rest.is_empty() { Ok(()) } else { Err(ImageError::SlackBytes { offset: self.offset }) }
    }
}
