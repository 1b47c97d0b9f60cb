//! `twinrung build`: from a project to a signed image.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use twinrung_bytecode::signature::{long_form, short_form};

use crate::findings::{self, Count};
use crate::input::{self, Complete, Input};
use crate::terminal::Terminal;
use crate::{failed, files};

/// Arguments of `build`.
#[derive(Debug, Args)]
#[command(
    after_help = "The safety application signature covers the logic and the declarations, and stays the same across releases\n\
of this tool; the image signature covers the bytes too. A signature says which program this is, not who made it."
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
    let mut out = io::stdout().lock();
    let Input::Project(read) = input::open(&arguments.file, &arguments.complete).map_err(failed)? else {
        return Err(io::Error::other(format!("{} is an image already", arguments.file.display())));
    };
    findings::print_human(&mut out, &read.report(), Terminal::of_stdout(), false)?;
    let Some(project) = &read.project else {
        writeln!(
            out,
            "{}: {}; no image is written",
            arguments.file.display(),
            findings::summary(Count::of(&read.findings))
        )?;
        return Ok(ExitCode::from(1));
    };
    let (compiled, loaded) = input::compiled(project).map_err(failed)?;
    if let (true, Err(error)) = (arguments.require_bound, input::require_bound(&loaded)) {
        writeln!(out, "{}: {error}; no image is written", arguments.file.display())?;
        return Ok(ExitCode::from(1));
    }
    if let Some(path) = &arguments.output {
        files::write_whole(path, &compiled.bytes)?;
        writeln!(
            out,
            "wrote {} ({} bytes, {} rungs)",
            path.display(),
            compiled.bytes.len(),
            loaded.image.rung_counts().iter().sum::<u32>()
        )?;
    }
    let (application, image) = (loaded.image.application_signature(), loaded.image.image_signature());
    writeln!(out, "safety application signature  {}  {}", short_form(application), long_form(application))?;
    writeln!(out, "image signature               {}  {}", short_form(image), long_form(image))?;
    Ok(ExitCode::SUCCESS)
}
