//! `twinrung run`: scans on both interpreters, every tag compared, outputs recorded.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::signature::short_form;
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::run::default_names;
use twinrung_workbench::{OnThread, Run as Session, Threads};

use crate::input::{self, Complete, Loaded, Required};
use crate::play::{DIAGRAM_ROWS, Playing, listed};
use crate::{exit, failed, terminal};

/// Arguments of `run`.
#[derive(Debug, Args)]
#[command(
    after_help = "Stimulus: CSV with the header time_ms,TAG,TAG...; a row holds until the next one, an empty cell leaves the tag as it was.\n\
Names: EStop.O1  Doors:I.Pt00Data  Program:Safety_Main.Step  Published:TAG  Controller:Mode  Controller:Fault\n\
Exit code: 0 end reached, 1 refused, 2 unreadable, 3 nonrecoverable fault, 4 recoverable fault not handled."
)]
pub struct Run {
    /// The project: .rll, .L5K, .L5X, a folder, or an image
    file: PathBuf,
    /// What drives the inputs; in a folder, its stimulus.csv where this is not given
    #[arg(long, value_name = "CSV")]
    stimulus: Option<PathBuf>,
    /// What to record: names, or @FILE with one name on each line; in a folder, its record.txt where this is not given
    #[arg(long, value_name = "TAG,TAG|@LIST")]
    record: Option<String>,
    /// Execute both channels at the same time, on this many threads: 1 or 2; the recording is the same
    #[arg(long, value_name = "N", default_value_t = Threads::One)]
    threads: Threads,
    #[command(flatten)]
    playing: Playing,
    #[command(flatten)]
    required: Required,
    #[command(flatten)]
    complete: Complete,
}

/// Runs.
pub fn run(arguments: &Run) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let loaded = match input::image(&mut out, &arguments.file, &arguments.complete, "; nothing was run")? {
        Ok(loaded) => loaded,
        Err(code) => return Ok(code),
    };
    if let Err(error) = arguments.required.check(&loaded) {
        writeln!(out, "{error}; nothing was run")?;
        return Ok(ExitCode::from(exit::REFUSED));
    }
    match arguments.threads {
        Threads::One => scans::<Partner>(arguments, loaded, &mut out),
        Threads::Two => scans::<OnThread<Partner>>(arguments, loaded, &mut out),
    }
}

/// Runs with this partner.
fn scans<B: Channel>(arguments: &Run, loaded: Loaded, out: &mut dyn Write) -> io::Result<ExitCode> {
    let stimulus = input::stimulus(&arguments.file, arguments.stimulus.as_deref())?;
    let beside = arguments.file.join("record.txt");
    let names = match &arguments.record {
        Some(list) => listed(list)?,
        None if beside.is_file() => listed(&format!("@{}", beside.display()))?,
        None => default_names(&loaded.image, stimulus.as_ref(), DIAGRAM_ROWS),
    };
    let signature = short_form(loaded.image.application_signature());
    let mut session: Session<Primary, B> = Session::new(loaded.image, &loaded.bytes).map_err(failed)?;
    session.publish_also(&arguments.complete.outputs).map_err(failed)?;
    let heading = format!(
        "safety application {signature}, one scan every {} ms, both channels compared after each",
        session.period_ms()
    );
    let played = arguments.playing.play(&mut session, stimulus.as_ref(), &names)?;
    arguments.playing.show(out, &mut session, &played, &heading)
}
