//! `twinrung bench`: scan time against period and watchdog.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use twinrung_workbench::bench::{self, Driven, Plan, Report};
use twinrung_workbench::mix::{Mix, Program};
use twinrung_workbench::{RunError, Stimulus};

use crate::findings;
use crate::input::{self, Complete, Input, Loaded};
use crate::terminal::Terminal;
use crate::{failed, files};

/// Arguments of `bench`.
#[derive(Debug, Args)]
#[command(
    after_help = "Without --stimulus every input that no logic writes is driven at random: all off, all on, then one in 16 changes in each\n\
scan. Plain numbers keep their values. Times are those of this machine, in a release build; instructions and their bound are\n\
the same everywhere.\n\
Exit code: 0 measured, 1 refused, 2 unreadable, 3 nonrecoverable fault, 4 recoverable fault not handled."
)]
pub struct Bench {
    /// The project: .rll, .L5K, .L5X, a folder, or an image
    #[arg(required_unless_present = "mix", conflicts_with = "mix")]
    file: Option<PathBuf>,
    /// Scans whose time is taken
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..))]
    scans: u64,
    /// What drives the inputs, from its first row again when it is over
    #[arg(long, value_name = "CSV", conflicts_with = "mix")]
    stimulus: Option<PathBuf>,
    /// Seed of the random inputs, and of a generated program
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// One scan in each period, judged by the watchdog; shows how late scans begin
    #[arg(long)]
    realtime: bool,
    /// Do not measure what each instruction costs here, and estimate no time for the longest path
    #[arg(long)]
    no_estimate: bool,
    /// What is printed
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    /// Also write a page with the histogram
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Refuse to measure a program with another safety application signature
    #[arg(long, value_name = "SIGNATURE")]
    expect: Option<String>,
    /// Refuse an image whose bound in instructions is above the budget of its watchdog
    #[arg(long)]
    require_bound: bool,
    /// Measure a generated program: simple (one shape of rung) or plant (rungs as plants have them)
    #[arg(long, value_name = "MIX")]
    mix: Option<Mix>,
    /// Rungs of the generated program
    #[arg(long, value_name = "N", default_value_t = 1000, requires = "mix")]
    rungs: usize,
    /// Toggles of its 256 inputs before each scan
    #[arg(long, value_name = "N", default_value_t = 16, requires = "mix")]
    toggles: usize,
    /// Where to write the generated program: project.rll, project.L5X and stimulus.csv
    #[arg(long, value_name = "FOLDER", requires = "mix")]
    keep: Option<PathBuf>,
    #[command(flatten)]
    complete: Complete,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    Human,
    Json,
}

const REFUSED: u8 = 1;
const NONRECOVERABLE: u8 = 3;
const RECOVERABLE: u8 = 4;

/// Measures.
pub fn run(arguments: &Bench) -> io::Result<ExitCode> {
    let terminal = Terminal::of_stdout();
    let Some(loaded) = loaded(arguments, terminal)? else { return Ok(ExitCode::from(REFUSED)) };
    input::expect(&loaded, arguments.expect.as_deref()).map_err(failed)?;
    if let (true, Err(error)) = (arguments.require_bound, input::require_bound(&loaded)) {
        println!("{error}; nothing was measured");
        return Ok(ExitCode::from(REFUSED));
    }
    let plan = plan(arguments)?;
    let measurement = with_progress(bench::scans_in_all(&plan), |progress| {
        bench::measure(&loaded.image, &loaded.bytes, &plan, progress)
    })
    .map_err(failed)?;
    let estimate =
        if arguments.no_estimate { None } else { Some(bench::estimate(&loaded.image).map_err(io::Error::other)?) };
    let report = Report::new(&loaded.image, &measurement, estimate);
    let mut out = io::stdout().lock();
    match arguments.format {
        Format::Human => out.write_all(bench::picture(&report, terminal.columns).as_bytes())?,
        Format::Json => {
            serde_json::to_writer_pretty(&mut out, &report)?;
            writeln!(out)?;
        }
    }
    if let Some(path) = &arguments.html {
        files::write_whole(path, bench::page(&report).as_bytes())?;
        eprintln!("wrote {}", path.display());
    }
    if cfg!(debug_assertions) {
        eprintln!("this is a debug build: its times say nothing about a release build");
    }
    Ok(match measurement.stopped {
        None => ExitCode::SUCCESS,
        Some((_, twinrung_controller::StopReason::Safety(_))) => ExitCode::from(NONRECOVERABLE),
        Some((_, twinrung_controller::StopReason::Recoverable(_))) => ExitCode::from(RECOVERABLE),
    })
}

fn plan(arguments: &Bench) -> io::Result<Plan> {
    let plan = Plan { scans: arguments.scans, realtime: arguments.realtime, ..Plan::default() };
    if arguments.mix.is_some() {
        // Every contender begins with the first scan, and compares states after the last.
        return Ok(Plan { inputs: Driven::Toggles(arguments.toggles), warm_up: 0, ..plan });
    }
    let beside = arguments.file.as_ref().map(|file| file.join("stimulus.csv")).filter(|path| path.is_file());
    let inputs = match arguments.stimulus.as_ref().or(beside.as_ref()) {
        Some(path) => {
            let wrong = |error: &dyn std::fmt::Display| io::Error::other(format!("{}: {error}", path.display()));
            let text = fs::read_to_string(path).map_err(|error| wrong(&error))?;
            Driven::Stimulus(Stimulus::read(&text).map_err(|error| wrong(&error))?)
        }
        None => Driven::Random(arguments.seed),
    };
    Ok(Plan { inputs, ..plan })
}

fn loaded(arguments: &Bench, terminal: Terminal) -> io::Result<Option<Loaded>> {
    if let Some(mix) = arguments.mix {
        let program = Program::new(mix, arguments.rungs, arguments.seed);
        if let Some(folder) = &arguments.keep {
            keep(&program, folder, arguments.scans)?;
        }
        let name = PathBuf::from(format!("{mix}.rll"));
        return project(&name, input::read_text(&name, &program.rll()), terminal);
    }
    let Some(file) = &arguments.file else { return Ok(None) };
    match input::open(file, &arguments.complete).map_err(failed)? {
        Input::Image(loaded) => Ok(Some(*loaded)),
        Input::Project(read) => project(file, *read, terminal),
    }
}

fn project(path: &std::path::Path, read: input::Read, terminal: Terminal) -> io::Result<Option<Loaded>> {
    let Some(project) = &read.project else {
        findings::print_human(&mut io::stdout(), &read.report(), terminal, false)?;
        let count = findings::Count::of(&read.findings);
        println!("{}: {}; nothing was measured", path.display(), findings::summary(count));
        return Ok(None);
    };
    input::compiled(project).map(|(_, loaded)| Some(loaded)).map_err(failed)
}

fn keep(program: &Program, folder: &std::path::Path, scans: u64) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    files::write_whole(&folder.join("project.rll"), program.rll().as_bytes())?;
    files::write_whole(&folder.join("project.L5X"), program.l5x().as_bytes())?;
    files::write_whole(&folder.join("stimulus.csv"), twinrung_workbench::mix::Toggles::csv(scans).as_bytes())
}

fn with_progress<T>(
    scans: u64,
    measure: impl FnOnce(&mut dyn FnMut(u64)) -> Result<T, RunError>,
) -> Result<T, RunError> {
    if !io::stderr().is_terminal() {
        return measure(&mut |_| {});
    }
    let bar = ProgressBar::new(scans);
    bar.set_style(
        ProgressStyle::with_template("{bar:40} {pos}/{len} scans, {per_sec}, {eta} left")
            .unwrap_or_else(|_| ProgressStyle::default_bar()),
    );
    // Drawn between scans only, and seldom: the bar is not part of what is measured, but it warms no caches either.
    let measured = measure(&mut |done| {
        if done.is_multiple_of(256) {
            bar.set_position(done);
        }
    });
    bar.finish_and_clear();
    measured
}
