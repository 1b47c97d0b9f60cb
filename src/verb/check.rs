//! `twinrung check`: the verdict.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use twinrung_grammar::tree::Sources;

use crate::findings::{self, Format, Report};
use crate::input::{self, Complete, Input};
use crate::terminal::{self, Terminal};
use crate::{exit, failed};

/// Arguments of `check`.
#[derive(Debug, Args)]
#[command(after_help = "Exit code: 0 no errors, 1 errors (or warnings with --deny warnings), 2 could not read.\n\
\n\
A warning that is meant can be accepted, for a reason that every report shows: write `allow W0101: the reason` in\n\
a comment of the source, in the rung comment or in the description of what it is about.")]
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
    let mut out = terminal::out();
    let read = match input::open(&arguments.file, &arguments.complete).map_err(failed)? {
        Input::Project(read) => read,
        Input::Image(loaded) => {
            let short = twinrung_bytecode::signature::short_form(loaded.image.application_signature());
            if arguments.format == Format::Human {
                writeln!(out, "{}: admitted, safety application signature {short}", arguments.file.display())?;
            } else {
                // An admitted image has nothing to find.
                let report = Report { sources: &Sources::new(), trees: &[], findings: &[] };
                findings::print(&mut out, &report, arguments.format, Terminal::of_stdout(), false)?;
            }
            return Ok(ExitCode::SUCCESS);
        }
    };
    let count = read.count();
    findings::print(&mut out, &read.report(), arguments.format, Terminal::of_stdout(), arguments.notes)?;
    if arguments.format == Format::Human {
        let hidden = if count.notes > 0 && !arguments.notes { " (--notes shows the notes)" } else { "" };
        writeln!(out, "{}: {}{hidden}", arguments.file.display(), findings::summary(count))?;
    }
    let unreadable = read.is_unreadable();
    // The process ends: to give the memory back piece by piece would take a tenth of the time.
    std::mem::forget(read);
    Ok(if unreadable {
        ExitCode::from(exit::UNREADABLE)
    } else if count.errors > 0 || (arguments.deny.is_some() && count.warnings > 0) {
        ExitCode::from(exit::REFUSED)
    } else {
        ExitCode::SUCCESS
    })
}
