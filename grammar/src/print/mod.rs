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

use crate::tree::{File, Operand};
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

/// The text of an operand, as it stands in a rung.
pub fn print_operand(operand: &Operand) -> &str {
    &operand.text
}
