//! What `cargo mutants --list --json` says of the mutants of a crate.

use serde::Deserialize;

/// A mutant.
#[derive(Debug, Clone, Deserialize)]
pub struct Mutant {
    /// Its name: place and what is changed.
    pub name: String,
    /// The file, from the root of the workspace.
    pub file: String,
    /// The function in which it lies; constants lie in none.
    pub function: Option<Function>,
    /// What is replaced.
    pub span: Span,
    /// What it is replaced with.
    pub replacement: String,
}

/// The function of a mutant.
#[derive(Debug, Clone, Deserialize)]
pub struct Function {
    /// From its first attribute to its closing brace.
    pub span: Span,
}

/// A part of a file: from the first place to before the second.
#[derive(Debug, Clone, Copy, Deserialize)]
pub struct Span {
    /// Where it begins.
    pub start: Place,
    /// Where it has ended.
    pub end: Place,
}

/// A place in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
pub struct Place {
    /// From 1.
    pub line: usize,
    /// In characters, from 1.
    pub column: usize,
}

impl Place {
    /// The place of a byte of a text, at which a character begins.
    pub fn of(text: &str, byte: usize) -> Place {
        let before = &text[..byte];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        Place { line: before.matches('\n').count() + 1, column: before[line_start..].chars().count() + 1 }
    }

    /// The byte of a text at which it lies.
    pub fn byte(self, text: &str) -> Option<usize> {
        let line = text.split_inclusive('\n').nth(self.line.checked_sub(1)?)?;
        let before: usize = text.split_inclusive('\n').take(self.line - 1).map(str::len).sum();
        let column = self.column.checked_sub(1)?;
        let within = line.char_indices().map(|(at, _)| at).chain([line.len()]).nth(column)?;
        Some(before + within)
    }
}

impl Span {
    /// The bytes of a text that it covers.
    pub fn bytes(self, text: &str) -> Option<std::ops::Range<usize>> {
        Some(self.start.byte(text)?..self.end.byte(text)?)
    }
}
