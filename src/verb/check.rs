//! `twinrung check`: the verdict.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use crate::failed;
use crate::findings::{self, Count, Format};
use crate::input::{self, Complete, Input};
use crate::terminal::Terminal;

/// Arguments of `check`.
#[derive(Debug, Args)]
#[command(after_help = "Exit code: 0 no errors, 1 errors (or warnings with --deny warnings), 2 could not read.")]
pub struct Check {
    /// The project: .rll, .L5K, .L5X, a folder, or an image
    file: PathBuf,
    /// How to print the findings
    #[arg(long, value_enum, default_value = "human")]
    format: Format,
    /// Fail on warnings too
    #[arg(long, value_name = "warnings", value_parser = ["warnings"])]
    deny: Option<String>,
    /// Print notes too
    #[arg(long)]
    notes: bool,
    #[command(flatten)]
    complete: Complete,
}

/// Checks and prints the findings.
pub fn run(arguments: &Check) -> io::Result<ExitCode> {
    let mut out = io::stdout().lock();
    let read = match input::open(&arguments.file, &arguments.complete).map_err(failed)? {
        Input::Project(read) => read,
        Input::Image(loaded) => {
            let short = twinrung_bytecode::signature::short_form(loaded.image.application_signature());
            writeln!(out, "{}: admitted, safety application signature {short}", arguments.file.display())?;
            return Ok(ExitCode::SUCCESS);
        }
    };
    let count = Count::of(&read.findings);
    match arguments.format {
        Format::Json => findings::print_json(&mut out, &read.sources, &read.findings)?,
        Format::Human => {
            findings::print_human(&mut out, &read.sources, &read.findings, Terminal::of_stdout(), arguments.notes)?;
            writeln!(out, "{}: {}", arguments.file.display(), findings::summary(count))?;
        }
    }
    let failed = count.errors > 0 || (arguments.deny.is_some() && count.warnings > 0);
    Ok(ExitCode::from(u8::from(failed)))
}
