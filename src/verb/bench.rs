//! `twinrung bench`: scan time against period and watchdog.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use twinrung_workbench::Threads;
use twinrung_workbench::bench::{self, Driven, Plan, Report};
use twinrung_workbench::mix::{Mix, Program};

use crate::format::{Format, write_json};
use crate::input::{self, Complete, Loaded, Required};
use crate::progress::with_progress;
use crate::terminal::{self, Terminal, tell};
use crate::{exit, failed, files};

/// Arguments of `bench`.
#[derive(Debug, Args)]
#[command(
    after_help = "Without a stimulus every input that no logic writes is driven at random: all off, all on, then one in 16 changes in each\n\
scan. Plain numbers keep their values. Times are those of this machine, in a release build; instructions and their bound are\n\
the same everywhere.\n\
Exit code: 0 measured, 1 refused, 2 unreadable, 3 nonrecoverable fault, 4 recoverable fault not handled."
)]
pub struct Bench {
    /// The project: .rll, .L5K, .L5X, a folder, or an image
    #[arg(required_unless_present = "mix", conflicts_with = "mix")]
    file: Option<PathBuf>,
    /// Scans whose time is taken
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=bench::SCANS_MAX))]
    scans: u64,
    /// What drives the inputs, from its first row again when it is over; in a folder, its stimulus.csv where this is not given
    #[arg(long, value_name = "CSV", conflicts_with = "mix")]
    stimulus: Option<PathBuf>,
    /// Seed of the random inputs, and of a generated program
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// One scan in each period, judged by the watchdog; shows how late scans begin
    #[arg(long)]
    realtime: bool,
    /// Execute both channels at the same time, on this many threads: 1 or 2. The second takes a processor for itself
    #[arg(long, value_name = "N", default_value_t = Threads::One)]
    threads: Threads,
    /// Do not measure what each instruction costs here, and estimate no time for the longest path
    #[arg(long)]
    no_estimate: bool,
    /// What is printed
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    /// Also write a page with the histogram
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    #[command(flatten)]
    required: Required,
    /// Measure a generated program, which is complete: simple (one shape of rung) or plant (rungs as plants have them)
    #[arg(long, value_name = "MIX", conflicts_with = "Complete")]
    mix: Option<Mix>,
    /// Rungs of the generated program
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = rungs, requires = "mix")]
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

const NOTHING_MEASURED: &str = "; nothing was measured";

/// A number of rungs that an image has room for.
fn rungs(text: &str) -> Result<usize, String> {
    let most = twinrung_bytecode::limits::RUNGS;
    text.parse().ok().filter(|rungs| (1..=most).contains(rungs)).ok_or_else(|| format!("1 to {most} rungs"))
}

/// Measures.
pub fn run(arguments: &Bench) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let loaded = match loaded(arguments, &mut out)? {
        Ok(loaded) => loaded,
        Err(code) => return Ok(code),
    };
    if let Err(error) = arguments.required.check(&loaded) {
        writeln!(out, "{error}{NOTHING_MEASURED}")?;
        return Ok(ExitCode::from(exit::REFUSED));
    }
    let plan = plan(arguments)?;
    let measurement = with_progress(bench::scans_in_all(&plan), |progress| {
        bench::measure(&loaded.image, &loaded.bytes, &plan, progress)
    })
    .map_err(failed)?;
    // What was measured is shown even where no instruction could be calibrated.
    let estimate = (!arguments.no_estimate).then(|| bench::estimate(&loaded.image));
    let report = Report::new(&loaded.image, &measurement, estimate);
    match arguments.format {
        Format::Human => out.write_all(bench::picture(&report, Terminal::of_stdout().columns).as_bytes())?,
        Format::Json => write_json(&mut out, &report)?,
    }
    if let Some(path) = &arguments.html {
        files::write_whole(path, bench::page(&report).as_bytes())?;
        tell(format_args!("wrote {}", path.display()));
    }
    if cfg!(debug_assertions) {
        tell(format_args!("this is a debug build: its times say nothing about a release build"));
    }
    Ok(exit::of_scans(measurement.stopped.map(|(_, reason)| reason)))
}

fn plan(arguments: &Bench) -> io::Result<Plan> {
    let plan =
        Plan { scans: arguments.scans, realtime: arguments.realtime, threads: arguments.threads, ..Plan::default() };
    let Some(file) = &arguments.file else {
        // Every contender begins with the first scan, and compares states after the last.
        return Ok(Plan { inputs: Driven::Toggles(arguments.toggles), warm_up: 0, ..plan });
    };
    let stimulus = input::stimulus(file, arguments.stimulus.as_deref())?;
    Ok(Plan { inputs: stimulus.map_or(Driven::Random(arguments.seed), Driven::Stimulus), ..plan })
}

fn loaded(arguments: &Bench, out: &mut dyn Write) -> io::Result<Result<Loaded, ExitCode>> {
    if let Some(file) = &arguments.file {
        return input::image(out, file, &arguments.complete, NOTHING_MEASURED);
    }
    let mix = arguments.mix.unwrap_or(Mix::Simple);
    let program = Program::new(mix, arguments.rungs, arguments.seed);
    if let Some(folder) = &arguments.keep {
        keep(&program, folder, arguments.scans, arguments.toggles)?;
    }
    let name = PathBuf::from(format!("{mix}.rll"));
    input::image_of(out, &name, &input::read_text(&name, &program.rll()), NOTHING_MEASURED)
}

fn keep(program: &Program, folder: &std::path::Path, scans: u64, toggles: usize) -> io::Result<()> {
    std::fs::create_dir_all(folder)?;
    files::write_whole(&folder.join("project.rll"), program.rll().as_bytes())?;
    files::write_whole(&folder.join("project.L5X"), program.l5x().as_bytes())?;
    files::write_whole(&folder.join("stimulus.csv"), twinrung_workbench::mix::Toggles::csv(scans, toggles).as_bytes())
}
