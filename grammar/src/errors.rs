//! The list in which a reading gathers its errors.

use crate::limits::ERRORS_MAX;
use crate::tree::{ErrorKind, ReadError, Span};

/// Errors in the order found, up to a limit.
#[derive(Debug, Default)]
pub(crate) struct Errors {
    list: Vec<ReadError>,
}

impl Errors {
    /// Adds an error; the one past the limit says that there are more.
    pub(crate) fn push(&mut self, error: ReadError) {
        if self.list.len() < ERRORS_MAX {
            self.list.push(error);
        } else if self.list.len() == ERRORS_MAX {
            self.list.push(ReadError::new(
                ErrorKind::TooMany,
                error.span,
                format!("more than {ERRORS_MAX} errors; the others are not listed"),
            ));
        }
    }

    /// Adds an error of a kind at a place.
    pub(crate) fn add(&mut self, kind: ErrorKind, span: Span, message: impl Into<String>) {
        self.push(ReadError::new(kind, span, message));
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The errors, ordered by place.
    pub(crate) fn into_list(mut self) -> Vec<ReadError> {
        self.list.sort_by_key(|error| (error.span.source, error.span.start));
        self.list
    }
}
