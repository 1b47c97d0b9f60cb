//! Tree to text: the canonical form of `.rll`.
//!
//! Printing what was read and reading it again gives the same tree, spans aside; printing twice
//! gives the same text. A rung is written in the exporter's own blank style.

mod attributes;
mod declarations;
mod expression;
mod layout;
mod modules;
mod rung;
mod value;

pub use expression::{print_expression, print_tag};
pub use rung::{print_element, print_rung};

use crate::read::read;
use crate::tree::{File, Operand, Sources};
use layout::Layout;

/// The canonical text of a file.
///
/// A tree that was read with errors prints what could be read, and nothing else: print it only to
/// look at it. An L5X prints what `.rll` has words for; skipped components, and data that the
/// export holds only by member name, are not among it.
pub fn print_file(file: &File) -> String {
    let mut layout = Layout::new();
    declarations::file(&mut layout, file);
    layout.finish()
}

/// A tree that no text can say: an export may hold names and words that `.rll` has no way to write.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unprintable {
    /// What is wrong with the text that would have been printed.
    pub message: String,
    /// Its line where that shows; empty where the whole text is meant.
    pub line: String,
}

impl std::fmt::Display for Unprintable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line.trim() {
            "" => f.write_str(&self.message),
            line => write!(f, "{}: `{line}`", self.message),
        }
    }
}

impl std::error::Error for Unprintable {}

/// The canonical text of a file, read back to make sure that it says what the tree says: it reads without an error, and
/// prints as itself.
///
/// # Errors
/// When it does not: a name or a word of the tree cannot be written as text.
pub fn print_file_checked(file: &File) -> Result<String, Unprintable> {
    let text = print_file(file);
    let mut sources = Sources::new();
    let again = read(&mut sources, "printed.rll", text.clone().into_bytes());
    if let Some(error) = again.errors.first() {
        let number = sources.line_column(error.span).line as usize;
        let line = text.lines().nth(number.saturating_sub(1)).unwrap_or_default();
        return Err(Unprintable { message: error.message.clone(), line: line.to_owned() });
    }
    if print_file(&again.file) == text {
        return Ok(text);
    }
    Err(Unprintable { message: "the text would read as something else".to_owned(), line: String::new() })
}

/// The text of an operand, as it stands in a rung.
pub fn print_operand(operand: &Operand) -> &str {
    &operand.text
}
