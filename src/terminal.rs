//! The standard output and the standard error: how wide they are, whether colour makes sense there, and what happens when
//! nobody reads them any more.

use std::fmt;
use std::io::{self, ErrorKind, IsTerminal, StderrLock, StdoutLock, Write};

/// A stream whose reader may go away (`| head`). From then on what is written is dropped: files are still written, and the
/// exit code still says what was found.
#[derive(Debug)]
pub struct Unread<W>(W);

/// The standard output.
pub fn out() -> Unread<StdoutLock<'static>> {
    Unread(io::stdout().lock())
}

/// The standard error.
pub fn err() -> Unread<StderrLock<'static>> {
    Unread(io::stderr().lock())
}

/// Says something beside the output. Where even that cannot be written there is nobody left to tell.
pub fn tell(message: fmt::Arguments<'_>) {
    let _ = writeln!(err(), "{message}");
}

impl<W: Write> Write for Unread<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.0.write(bytes) {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(bytes.len()),
            other => other,
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self.0.flush() {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
            other => other,
        }
    }
}

/// Where text goes.
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
        Terminal::of(io::stdout().is_terminal())
    }

    /// Looks at the standard error.
    pub fn of_stderr() -> Terminal {
        Terminal::of(io::stderr().is_terminal())
    }

    fn of(is_terminal: bool) -> Terminal {
        let columns = terminal_size::terminal_size()
            .filter(|_| is_terminal)
            .map_or(COLUMNS_WITHOUT_TERMINAL, |(width, _)| usize::from(width.0).min(COLUMNS_MAX));
        Terminal { columns, colour: is_terminal && std::env::var_os("NO_COLOR").is_none() }
    }
}
