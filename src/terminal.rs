//! What the standard output is: how wide, and whether colour and progress make sense there.

use std::io::IsTerminal;

/// The standard output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Terminal {
    /// Columns; 100 where it is no terminal.
    pub columns: usize,
    /// Whether to colour.
    pub colour: bool,
}

/// Columns where the output goes to a file or a pipe: the same for everybody.
const COLUMNS_WITHOUT_TERMINAL: usize = 100;
/// Widest line that is still read easily.
const COLUMNS_MAX: usize = 160;

impl Terminal {
    /// Looks at the standard output.
    pub fn of_stdout() -> Terminal {
        let is_terminal = std::io::stdout().is_terminal();
        let columns = terminal_size::terminal_size()
            .filter(|_| is_terminal)
            .map_or(COLUMNS_WITHOUT_TERMINAL, |(width, _)| usize::from(width.0).min(COLUMNS_MAX));
        Terminal { columns, colour: is_terminal && std::env::var_os("NO_COLOR").is_none() }
    }
}
