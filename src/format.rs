//! How a verb prints what it found: for people or for machines.

use std::io::{self, Write};

use clap::ValueEnum;
use serde::Serialize;

/// For people, or for machines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For a terminal
    Human,
    /// One JSON value
    Json,
}

/// One JSON value, and the end of its last line.
pub fn write_json(out: &mut dyn Write, value: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, value)?;
    writeln!(out)
}
