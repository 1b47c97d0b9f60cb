//! `twinrung run`: scans on both interpreters, every tag compared, outputs recorded.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::{MajorFault, Place};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::signature::short_form;
use twinrung_controller::{SafetyFault, StopReason};
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::diagram::{self, Style};
use twinrung_workbench::difference;
use twinrung_workbench::run::default_names;
use twinrung_workbench::{Outcome, Recording, Run as Session, Stimulus};

use crate::findings;
use crate::input::{self, Complete, Input, Loaded};
use crate::terminal::Terminal;
use crate::{failed, files};

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
    #[arg(long, value_name = "MS")]
    until: Option<u64>,
    /// Refuse to run a program with another safety application signature
    #[arg(long, value_name = "SIGNATURE")]
    expect: Option<String>,
    /// Refuse an image whose bound in instructions is above the budget of its watchdog
    #[arg(long)]
    require_bound: bool,
    /// Draw no timing diagram
    #[arg(long)]
    quiet: bool,
    #[command(flatten)]
    complete: Complete,
}

/// Periods that a run goes on after the last row of its stimulus.
const PERIODS_AFTER_STIMULUS: u64 = 10;
/// Rows of a diagram that was not asked for name by name.
const DIAGRAM_ROWS: usize = 40;
/// A run shorter than this shows no progress bar.
const PROGRESS_AFTER: Duration = Duration::from_millis(500);

const REFUSED: u8 = 1;
const NONRECOVERABLE: u8 = 3;
const RECOVERABLE: u8 = 4;

/// Runs.
pub fn run(arguments: &Run) -> io::Result<ExitCode> {
    let terminal = Terminal::of_stdout();
    let Some(loaded) = loaded(arguments, terminal)? else { return Ok(ExitCode::from(REFUSED)) };
    input::expect(&loaded, arguments.expect.as_deref()).map_err(failed)?;
    if let (true, Err(error)) = (arguments.require_bound, input::require_bound(&loaded)) {
        println!("{error}; nothing was run");
        return Ok(ExitCode::from(REFUSED));
    }
    let stimulus = stimulus(arguments)?;
    let beside = arguments.file.join("record.txt");
    let names = match &arguments.record {
        Some(list) => listed(list)?,
        None if beside.is_file() => listed(&format!("@{}", beside.display()))?,
        None => default_names(&loaded.image, stimulus.as_ref(), DIAGRAM_ROWS),
    };
    let signature = short_form(loaded.image.application_signature());
    let mut session: Session<Primary, Partner> = Session::new(loaded.image, &loaded.bytes).map_err(failed)?;
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
    let mut out = io::stdout().lock();
    if !arguments.quiet {
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
    report(&mut out, session.controller().image(), &outcome, begun.elapsed())
}

fn loaded(arguments: &Run, terminal: Terminal) -> io::Result<Option<Loaded>> {
    match input::open(&arguments.file, &arguments.complete).map_err(failed)? {
        Input::Image(loaded) => Ok(Some(*loaded)),
        Input::Project(read) => {
            let Some(project) = &read.project else {
                findings::print_human(&mut io::stdout(), &read.report(), terminal, false)?;
                let count = findings::Count::of(&read.findings);
                println!("{}: {}; nothing was run", arguments.file.display(), findings::summary(count));
                return Ok(None);
            };
            let count = findings::Count::of(&read.findings);
            if count.warnings + count.suppressed > 0 {
                let path = arguments.file.display();
                eprintln!("{path}: {} (twinrung check {path} shows them)", findings::summary(count));
            }
            input::compiled(project).map(|(_, loaded)| Some(loaded)).map_err(failed)
        }
    }
}

fn stimulus(arguments: &Run) -> io::Result<Option<Stimulus>> {
    let beside = arguments.file.join("stimulus.csv");
    let path = match &arguments.stimulus {
        Some(path) => path,
        None if beside.is_file() => &beside,
        None => return Ok(None),
    };
    let text = read_text(path)?;
    let stimulus = Stimulus::read(&text).map_err(|error| io::Error::other(format!("{}: {error}", path.display())))?;
    Ok(Some(stimulus))
}

fn read_text(path: &Path) -> io::Result<String> {
    fs::read_to_string(path).map_err(|error| io::Error::other(format!("{}: {error}", path.display())))
}

fn listed(list: &str) -> io::Result<Vec<String>> {
    let Some(path) = list.strip_prefix('@') else { return Ok(split_names(list)) };
    let text = read_text(Path::new(path))?;
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

fn with_progress(scans: u64, run: impl FnOnce(&mut dyn FnMut(u64)) -> Outcome) -> Outcome {
    let bar = ProgressBar::with_draw_target(Some(scans), ProgressDrawTarget::hidden());
    bar.set_style(
        ProgressStyle::with_template("{bar:40} {pos}/{len} scans, {per_sec}, {eta} left")
            .unwrap_or_else(|_| ProgressStyle::default_bar()),
    );
    let begun = Instant::now();
    let mut shown = !io::stderr().is_terminal();
    let outcome = run(&mut |done| {
        if !shown && done.is_multiple_of(256) && begun.elapsed() > PROGRESS_AFTER {
            bar.set_draw_target(ProgressDrawTarget::stderr());
            shown = true;
        }
        if done.is_multiple_of(256) {
            bar.set_position(done);
        }
    });
    bar.finish_and_clear();
    outcome
}

fn write_recording(path: &Path, recording: &Recording) -> io::Result<()> {
    files::write_whole(path, recording.to_csv().as_bytes())
}

fn report(out: &mut dyn Write, image: &AdmittedImage, outcome: &Outcome, took: Duration) -> io::Result<ExitCode> {
    let Some((scan, time_ms, reason)) = outcome.stopped else {
        writeln!(
            out,
            "{} scans, no difference between the channels; at most {} instructions in a scan ({} ms)",
            outcome.scans,
            outcome.instructions_max,
            took.as_millis()
        )?;
        return Ok(ExitCode::SUCCESS);
    };
    let (fault_type, code) = reason.type_and_code();
    writeln!(
        out,
        "stopped in scan {scan} at {time_ms} ms, outputs off: fault {fault_type}/{code}, {}",
        explained(image, reason)
    )?;
    Ok(ExitCode::from(match reason {
        StopReason::Safety(_) => NONRECOVERABLE,
        StopReason::Recoverable(_) => RECOVERABLE,
    }))
}

fn explained(image: &AdmittedImage, reason: StopReason) -> String {
    match reason {
        StopReason::Safety(SafetyFault::Difference(found)) => difference::words(image, found),
        StopReason::Safety(SafetyFault::WatchdogExpired) => "the watchdog expired".to_owned(),
        StopReason::Safety(SafetyFault::BudgetExceeded) => {
            "the scan executed more instructions than its watchdog allows".to_owned()
        }
        StopReason::Safety(SafetyFault::ImageCorrupted) => {
            "the image in memory is not the one that was admitted".to_owned()
        }
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
