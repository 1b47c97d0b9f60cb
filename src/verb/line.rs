//! `twinrung line`: several controllers in one simulated time, with produced and consumed safety tags between them.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::line::{Joining, Line};

use crate::input::{self, Complete};
use crate::play::{self, explained, listed};
use crate::terminal;
use crate::{exit, failed};

/// Scans of the slowest controller that a run goes on after the last row of its stimulus.
const PERIODS_AFTER_STIMULUS: u64 = 10;

/// Arguments of `line`.
#[derive(Debug, Args)]
#[command(
    after_help = "Names have the controller's name before them: Cell_A/Doors:I.Pt00Data, Cell_B/Published:Drives:O.Pt00Data.\n\
A stimulus also drives Cell_A/Controller:Mode (0 Program, 1 Run), Cell_A/Controller:Partner (0: the safety partner fails) and\n\
Cell_B/Line_Stop:Network (0: the network loses what this consumed tag waits for; 1: it carries it).\n\
Consumed tags get RunMode and ConnectionFaulted as Table 9 of 1756-RM093 has them, and are 0 unless their producer runs.\n\
Exit code: 0 end reached, 1 refused, 2 unreadable, 3 a controller with a nonrecoverable fault, 4 with a recoverable one."
)]
pub struct LineOfControllers {
    /// The projects: .rll, .L5K, .L5X, folders or images; each is known by the name of its controller
    #[arg(required = true, num_args = 2..)]
    files: Vec<PathBuf>,
    /// What drives the inputs
    #[arg(long, value_name = "CSV")]
    stimulus: Option<PathBuf>,
    /// What to record: names, or @FILE with one name on each line; what the stimulus drives where this is not given
    #[arg(long, value_name = "NAME,NAME|@LIST")]
    record: Option<String>,
    /// How long a packet is on its way between controllers, in ms
    #[arg(long, value_name = "MS", default_value_t = 1, value_parser = clap::value_parser!(u64).range(..=60_000))]
    delay: u64,
    /// When the first scan of each controller begins, in ms, in the order of the projects; 0 where this is not given
    #[arg(long, value_name = "MS,MS", value_delimiter = ',')]
    phase: Vec<u64>,
    /// Where to write the recording: a row whenever a controller has scanned
    #[arg(long, value_name = "CSV")]
    out: Option<PathBuf>,
    /// Until when, in ms
    #[arg(long, value_name = "MS", value_parser = clap::value_parser!(u64).range(..=100_000_000))]
    until: Option<u64>,
    /// Draw no timing diagram
    #[arg(long)]
    quiet: bool,
}

/// Runs them together.
pub fn run(arguments: &LineOfControllers) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let mut joining = Vec::new();
    for (position, path) in arguments.files.iter().enumerate() {
        let loaded = match input::image(&mut out, path, &Complete::default(), "; nothing was run")? {
            Ok(loaded) => loaded,
            Err(code) => return Ok(code),
        };
        let name = loaded.image.image().controller.name.clone();
        let phase_ms = arguments.phase.get(position).copied().unwrap_or(0);
        joining.push(Joining { name, image: loaded.image, bytes: loaded.bytes, phase_ms, execution_us: 0 });
    }
    let period = |one: &Joining| one.image.image().task.as_ref().map_or(0, |task| u64::from(task.period_us / 1000));
    let longest_ms = joining.iter().map(period).max().unwrap_or(0);
    let images: Vec<_> = joining.iter().map(|one| (one.name.clone(), one.image.clone())).collect();
    let stimulus = match &arguments.stimulus {
        Some(path) => input::stimulus(path, Some(path))?,
        None => None,
    };
    let delay_us = arguments.delay.saturating_mul(1000);
    let mut line: Line<Primary, Partner> = match Line::new(joining, delay_us, |_| 0) {
        Ok(line) => line,
        Err(why) => {
            writeln!(out, "{why}; nothing was run")?;
            return Ok(ExitCode::from(exit::REFUSED));
        }
    };
    for tag in line.unconnected() {
        terminal::tell(format_args!("nobody here produces what {tag} consumes: its connection is faulted"));
    }
    if let Some(stimulus) = &stimulus {
        line.stimulate(stimulus).map_err(failed)?;
    }
    let names = match &arguments.record {
        Some(list) => listed(list)?,
        None => line.recordable(stimulus.as_ref()),
    };
    line.record(&names).map_err(failed)?;
    let last_ms = stimulus.as_ref().map_or(0, twinrung_workbench::Stimulus::last_ms);
    line.until(arguments.until.unwrap_or(last_ms.saturating_add(PERIODS_AFTER_STIMULUS * longest_ms)));
    if !arguments.quiet {
        play::draw(&mut out, line.recording())?;
    }
    if let Some(path) = &arguments.out {
        play::write(&mut out, line.recording(), path)?;
    }
    let mut code = ExitCode::SUCCESS;
    let mut worst = false;
    for (name, at_ms, reason) in line.stopped() {
        let (fault_type, fault_code) = reason.type_and_code();
        let what = images.iter().find(|(own, _)| own == name).map(|(_, image)| explained(image, reason));
        writeln!(out, "{name} stopped at {at_ms} ms: fault {fault_type}/{fault_code}, {}", what.unwrap_or_default())?;
        if !worst {
            code = exit::of_scans(Some(reason));
            worst = code == ExitCode::from(exit::NONRECOVERABLE);
        }
    }
    if line.stopped().next().is_none() {
        let count = line.names().count();
        writeln!(out, "{count} controllers, no difference between the channels of any of them")?;
    }
    Ok(code)
}
