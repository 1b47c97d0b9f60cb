//! `twinrung build`: from a project to a signed image.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use twinrung_bytecode::signature::{long_form, short_form};

use crate::findings;
use crate::input::{self, Complete, Input};
use crate::terminal::{self, Terminal};
use crate::{exit, failed, files};

/// Arguments of `build`.
#[derive(Debug, Args)]
#[command(
    after_help = "The safety application signature covers the logic and the declarations, and stays the same across releases\n\
of this tool; the image signature covers the bytes too. A signature says which program this is, not who made it.\n\
Exit code: 0 built, 1 refused, 2 could not read."
)]
pub struct Build {
    /// The project: .rll, .L5K, .L5X or a folder
    file: PathBuf,
    /// Where to write the image; without it nothing is written
    #[arg(short, long, value_name = "IMAGE")]
    output: Option<PathBuf>,
    /// Refuse an image whose bound in instructions is above the budget of its watchdog
    #[arg(long)]
    require_bound: bool,
    #[command(flatten)]
    complete: Complete,
}

/// Checks, compiles, verifies as a loader would, and writes the image whole or not at all.
pub fn run(arguments: &Build) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let Input::Project(read) = input::open(&arguments.file, &arguments.complete).map_err(failed)? else {
        return Err(io::Error::other(format!("{} is an image already", arguments.file.display())));
    };
    let Some(project) = &read.project else { return read.refuse(&mut out, &arguments.file, "; no image is written") };
    findings::print_human(&mut out, &read.report(), Terminal::of_stdout(), false)?;
    let loaded = input::compiled(project).map_err(failed)?;
    if arguments.require_bound
        && let Err(error) = input::within_budget(&loaded)
    {
        writeln!(out, "{}: {error}; no image is written", arguments.file.display())?;
        return Ok(ExitCode::from(exit::REFUSED));
    }
    if let Some(path) = &arguments.output {
        files::write_whole(path, &loaded.bytes)?;
        writeln!(
            out,
            "wrote {} ({} bytes, {} rungs)",
            path.display(),
            loaded.bytes.len(),
            loaded.image.rung_counts().iter().sum::<u32>()
        )?;
    }
    let (application, image) = (loaded.image.application_signature(), loaded.image.image_signature());
    writeln!(out, "safety application signature  {}  {}", short_form(application), long_form(application))?;
    writeln!(out, "image signature               {}  {}", short_form(image), long_form(image))?;
    // The process ends: to give the memory back piece by piece would take a tenth of the time.
    std::mem::forget((read, loaded));
    Ok(ExitCode::SUCCESS)
}
