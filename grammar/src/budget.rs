//! The memory that a tree may take, counted while it grows.

use crate::limits::TREE_BYTES_MAX;
use crate::tree::{ErrorKind, ReadError, Span};

/// A run of text takes about this many bytes of tree for each of its own, at most: `,` is a leg or
/// an operand.
pub(crate) const BYTES_FOR_EACH: usize = 48;

/// What is left.
#[derive(Debug)]
pub(crate) struct Budget {
    left: usize,
}

impl Default for Budget {
    fn default() -> Budget {
        Budget { left: TREE_BYTES_MAX }
    }
}

impl Budget {
    /// Takes some of it.
    ///
    /// # Errors
    /// When nothing is left.
    pub(crate) fn spend(&mut self, bytes: usize, place: Span) -> Result<(), ReadError> {
        match self.left.checked_sub(bytes) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => {
                self.left = 0;
                let message = format!("what was read takes more than {TREE_BYTES_MAX} bytes; the rest is not read");
                Err(ReadError::new(ErrorKind::TooLarge, place, message))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn budget_when_spent_to_the_limit_then_holds() {
        assert!(Budget::default().spend(TREE_BYTES_MAX, Span::default()).is_ok());
    }

    #[test]
    fn budget_when_one_past_the_limit_then_is_an_error() {
        let error = Budget::default().spend(TREE_BYTES_MAX + 1, Span::default()).unwrap_err();
        assert_eq!(error.kind, ErrorKind::TooLarge);
    }
}
