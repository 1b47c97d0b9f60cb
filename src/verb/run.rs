//! `twinrung run`: scans on both interpreters, every tag compared, outputs recorded.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Args;
use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::{Channel, MajorFault, Place};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::signature::short_form;
use twinrung_controller::StopReason;
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::diagram::{self, Style};
use twinrung_workbench::difference;
use twinrung_workbench::run::default_names;
use twinrung_workbench::{OnThread, Outcome, Recording, Run as Session, Stimulus, Threads};

use crate::input::{self, Complete, Loaded, Required};
use crate::progress::with_progress;
use crate::terminal::{self, Terminal};
use crate::{exit, failed, files};

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
    /// Where to write the recording
    #[arg(long, value_name = "CSV")]
    out: Option<PathBuf>,
    /// Time of the last scan in ms; without it some periods after the stimulus's last row
    #[arg(long, value_name = "MS", value_parser = clap::value_parser!(u64).range(..=UNTIL_MS_MAX))]
    until: Option<u64>,
    /// Execute both channels at the same time, on this many threads: 1 or 2; the recording is the same
    #[arg(long, value_name = "N", default_value_t = Threads::One)]
    threads: Threads,
    /// Draw no timing diagram
    #[arg(long)]
    quiet: bool,
    #[command(flatten)]
    required: Required,
    #[command(flatten)]
    complete: Complete,
}

/// Periods that a run goes on after the last row of its stimulus.
pub(super) const PERIODS_AFTER_STIMULUS: u64 = 10;
/// Rows of a diagram that was not asked for name by name.
pub(super) const DIAGRAM_ROWS: usize = 40;
/// The latest end of a run in ms: time stamps have room for it, and nobody waits for it.
pub(super) const UNTIL_MS_MAX: u64 = 1_000_000_000_000;

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
    if let Some(stimulus) = &stimulus {
        session.stimulate(stimulus).map_err(failed)?;
    }
    session.record(&names).map_err(failed)?;
    session.publish_also(&arguments.complete.outputs).map_err(failed)?;
    let period_ms = session.period_ms();
    let until_ms = arguments
        .until
        .unwrap_or_else(|| stimulus.as_ref().map_or(0, Stimulus::last_ms) + PERIODS_AFTER_STIMULUS * period_ms);
    let begun = Instant::now();
    let outcome = with_progress(until_ms / period_ms + 1, |progress| session.until(until_ms, progress));
    if !arguments.quiet {
        let terminal = Terminal::of_stdout();
        writeln!(
            out,
            "safety application {signature}, one scan every {period_ms} ms, both channels compared after each\n"
        )?;
        let style = Style { columns: terminal.columns, colour: terminal.colour };
        out.write_all(diagram::draw(session.recording(), style).as_bytes())?;
        writeln!(out)?;
    }
    if let Some(path) = &arguments.out {
        write_recording(path, session.recording())?;
        writeln!(out, "wrote {} ({} rows)", path.display(), session.recording().rows.len())?;
    }
    report(out, session.controller().image(), &outcome, begun.elapsed())
}

pub(super) fn listed(list: &str) -> io::Result<Vec<String>> {
    let Some(path) = list.strip_prefix('@') else { return Ok(split_names(list)) };
    let text = input::text(Path::new(path))?;
    Ok(text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
        .map(str::to_owned)
        .collect())
}

/// Splits at commas outside brackets: `Levels[1,2],Motor` is two names.
fn split_names(list: &str) -> Vec<String> {
    let mut names = vec![String::new()];
    let mut depth = 0_usize;
    for character in list.chars() {
        match character {
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if character == ',' && depth == 0 {
            names.push(String::new());
        } else if let Some(name) = names.last_mut() {
            name.push(character);
        }
    }
    names.into_iter().map(|name| name.trim().to_owned()).filter(|name| !name.is_empty()).collect()
}

pub(super) fn write_recording(path: &Path, recording: &Recording) -> io::Result<()> {
    files::write_whole(path, recording.to_csv().as_bytes())
}

pub(super) fn report(
    out: &mut dyn Write,
    image: &AdmittedImage,
    outcome: &Outcome,
    took: Duration,
) -> io::Result<ExitCode> {
    let code = exit::of_scans(outcome.stopped.map(|(_, _, reason)| reason));
    let Some((scan, time_ms, reason)) = outcome.stopped else {
        writeln!(
            out,
            "{} scans, no difference between the channels; at most {} instructions in a scan; took {} ms",
            outcome.scans,
            outcome.instructions_max,
            took.as_millis()
        )?;
        return Ok(code);
    };
    let (fault_type, fault_code) = reason.type_and_code();
    writeln!(
        out,
        "stopped in scan {scan} at {time_ms} ms, outputs off: fault {fault_type}/{fault_code}, {}",
        explained(image, reason)
    )?;
    Ok(code)
}

pub(super) fn explained(image: &AdmittedImage, reason: StopReason) -> String {
    match reason {
        StopReason::Safety(fault) => difference::fault_words(image, fault),
        StopReason::Recoverable(MajorFault { code, place }) => {
            format!("major fault 4/{code} at {}", place_words(image.image(), place))
        }
    }
}

fn place_words(image: &Image, place: Place) -> String {
    let program = image.programs.get(place.program.position()).map_or("?", |program| program.name.as_str());
    let routine = image.routines.get(place.routine.position()).map_or("?", |routine| routine.name.as_str());
    format!("{program}/{routine}, rung {}, instruction {}", place.rung, place.element)
}
