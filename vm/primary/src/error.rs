//! Why an image could not be loaded.

use core::fmt;

/// Why this channel cannot load an admitted image.
///
/// An admitted image is well formed, so [`LoadError::Malformed`] says that this channel's decoder and the verifier
/// understand the format differently. That is a defect of this product and not of the application.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadError {
    /// Bytes or indices are not what the image format says; what was being decoded.
    Malformed(&'static str),
    /// A table of this channel would exceed its bound; which one. Divide the application into smaller routines.
    TooLarge(&'static str),
    /// The application uses something that this channel does not execute; what.
    Unsupported(&'static str),
}

impl fmt::Display for LoadError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LoadError::Malformed(what) => write!(formatter, "the primary cannot decode {what}"),
            LoadError::TooLarge(what) => write!(formatter, "the primary has no room for {what}"),
            LoadError::Unsupported(what) => write!(formatter, "the primary does not execute {what}"),
        }
    }
}

impl core::error::Error for LoadError {}
