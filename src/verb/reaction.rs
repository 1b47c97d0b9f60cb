//! `twinrung reaction`: how long each chain from a safety input to a safety output takes at most.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use serde::Serialize;
use twinrung_compiler::CheckedProject;
use twinrung_workbench::reaction::{self, Chain, Settings, milliseconds};

use crate::format::{Format, write_json};
use crate::input::{self, Complete, Input};
use crate::{exit, failed, terminal};

/// Arguments of `reaction`.
#[derive(Debug, Args)]
#[command(
    after_help = "Logix system reaction time (1756-RM093 Appendix C): input module and filter, input connection, period and watchdog of the\n\
safety task, output connection, output module. A chain may be listed that the logic never uses; none that it uses is left out.\n\
Exit code: 0 added up, 1 refused, or a chain is slower than --limit or not known, 2 could not read."
)]
pub struct Reaction {
    /// The project: .rll, .L5K, .L5X or a folder
    file: PathBuf,
    /// A project that produces tags which FILE consumes; may be given several times
    #[arg(long, value_name = "FILE")]
    producer: Vec<PathBuf>,
    /// Reaction time of the sensors in ms
    #[arg(long, value_name = "MS", default_value_t = 0)]
    sensor: u32,
    /// Reaction time of the actuators in ms
    #[arg(long, value_name = "MS", default_value_t = 0)]
    actuator: u32,
    /// Reaction time of a kind of module in ms, from its own manual; may be given several times
    #[arg(long, value_name = "CATALOG=MS", value_parser = module_time)]
    module: Vec<(String, u64)>,
    /// Years between proof tests
    #[arg(long, value_name = "YEARS", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=20))]
    proof_test: u32,
    /// Longest time from event to safe state that the hazard allows, in ms
    #[arg(long, value_name = "MS")]
    limit: Option<u32>,
    /// How to print
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    #[command(flatten)]
    complete: Complete,
}

/// `1791ES-IB8XOBV4=16.2`, in µs.
fn module_time(text: &str) -> Result<(String, u64), String> {
    let wrong = || format!("`{text}` is not CATALOG=MS, as 1791ES-IB8XOBV4=16.2");
    let (catalog_number, time) = text.split_once('=').ok_or_else(wrong)?;
    let time: f64 = time.parse().map_err(|_| wrong())?;
    if catalog_number.is_empty() || !(0.0..=60_000.0).contains(&time) {
        return Err(wrong());
    }
    Ok((catalog_number.to_owned(), (time * 1000.0).ceil() as u64))
}

/// Adds up and prints.
pub fn run(arguments: &Reaction) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let project = match project(&mut out, &arguments.file, &arguments.complete)? {
        Ok(project) => project,
        Err(code) => return Ok(code),
    };
    let mut producers = Vec::new();
    for path in &arguments.producer {
        match self::project(&mut out, path, &Complete::default())? {
            Ok(project) => producers.push(project),
            Err(code) => return Ok(code),
        }
    }
    let settings = Settings {
        sensor_us: u64::from(arguments.sensor) * 1000,
        actuator_us: u64::from(arguments.actuator) * 1000,
        proof_test_years: arguments.proof_test,
        modules_us: arguments.module.clone(),
    };
    let producers: Vec<&CheckedProject> = producers.iter().collect();
    let chains = reaction::chains(&project, &producers, &settings).map_err(failed)?;
    let limit_us = arguments.limit.map(|limit| u64::from(limit) * 1000);
    let beyond = |chain: &&Chain| limit_us.is_some_and(|limit| chain.system_us.is_none_or(|us| us > limit));
    let too_slow = chains.iter().filter(beyond).count();
    match arguments.format {
        Format::Human => human(&mut out, &project.name, &chains, arguments.limit, too_slow)?,
        Format::Json => {
            write_json(&mut out, &Json { controller: &project.name, chains: &chains, beyond_limit: too_slow })?
        }
    }
    Ok(if too_slow > 0 { ExitCode::from(exit::REFUSED) } else { ExitCode::SUCCESS })
}

fn project(out: &mut dyn Write, path: &Path, complete: &Complete) -> io::Result<Result<CheckedProject, ExitCode>> {
    let Input::Project(read) = input::open(path, complete).map_err(failed)? else {
        return Err(io::Error::other(format!("{} is an image: its modules are in the project alone", path.display())));
    };
    if read.project.is_none() {
        return read.refuse(out, path, "; nothing was added up").map(Err);
    }
    read.project.map(Ok).ok_or_else(|| io::Error::other(format!("{} holds nothing", path.display())))
}

#[derive(Serialize)]
struct Json<'a> {
    controller: &'a str,
    chains: &'a [Chain],
    beyond_limit: usize,
}

fn human(out: &mut dyn Write, name: &str, chains: &[Chain], limit: Option<u32>, too_slow: usize) -> io::Result<()> {
    for chain in chains {
        writeln!(out, "{}\n  -> {}", chain.inputs.join(", "), chain.outputs.join(", "))?;
        for part in &chain.components {
            writeln!(out, "  {:>11} ms  {:<36} {}", time(part.us), part.name, part.because)?;
        }
        writeln!(out, "  {:>11} ms  Logix system reaction time", time(chain.logix_us))?;
        writeln!(out, "  {:>11} ms  system reaction time, sensor and actuator included", time(chain.system_us))?;
        let years = chain.failure.proof_test_years;
        let (on_demand, per_hour) = (figure(chain.failure.on_demand), figure(chain.failure.per_hour));
        writeln!(out, "  PFH {per_hour} per hour, PFD {on_demand} with a proof test every {years} years: the sum of")?;
        for element in &chain.failure.elements {
            let (on_demand, per_hour) = (figure(element.on_demand), figure(element.per_hour));
            writeln!(out, "    {:<24} PFH {per_hour:<8} PFD {on_demand:<8} {}", element.subject, element.source)?;
        }
        writeln!(out)?;
    }
    writeln!(out, "{name}: {} from a safety input to a safety output", many(chains.len(), "chain"))?;
    if let Some(limit) = limit {
        writeln!(out, "{} not within {limit} ms", many(too_slow, "chain"))?;
    }
    Ok(())
}

fn many(count: usize, word: &str) -> String {
    format!("{count} {word}{}", if count == 1 { "" } else { "s" })
}

fn time(us: Option<u64>) -> String {
    us.map_or_else(|| "not known".to_owned(), milliseconds)
}

fn figure(value: Option<f64>) -> String {
    value.map_or_else(|| "?".to_owned(), |value| format!("{value:.2e}"))
}
