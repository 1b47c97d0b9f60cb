//! `twinrung check`: the verdict.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use twinrung_compiler::diagnostic::{BROKEN_FILE, Finding, UNREADABLE_FILE};
use twinrung_grammar::tree::Sources;

use crate::findings::{self, Count, Format, Report};
use crate::input::{self, Complete, Input};
use crate::terminal::Terminal;
use crate::{UNREADABLE, failed};

/// Exit code where something was found.
const FOUND: u8 = 1;

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
    let mut out = io::stdout().lock();
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
    let count = Count::of(&read.findings);
    findings::print(&mut out, &read.report(), arguments.format, Terminal::of_stdout(), arguments.notes)?;
    if arguments.format == Format::Human {
        writeln!(out, "{}: {}", arguments.file.display(), findings::summary(count))?;
    }
    let unreadable = |finding: &Finding| [&UNREADABLE_FILE, &BROKEN_FILE].contains(&finding.code);
    Ok(if read.findings.iter().any(unreadable) {
        ExitCode::from(UNREADABLE)
    } else if count.errors > 0 || (arguments.deny.is_some() && count.warnings > 0) {
        ExitCode::from(FOUND)
    } else {
        ExitCode::SUCCESS
    })
}
