//! `twinrung inject`: faults in a running project, and what found them.

use std::io::{self, IsTerminal, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::Duration;

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use twinrung_bytecode::signature::short_form;
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::Stimulus;
use twinrung_workbench::inject::{
    Campaign, Class, Fault, Group, Outcome, Plan, Recorded, Report, SCHEMA, Subject, is_injecting, page, random,
};

use crate::format::{Format, write_json};
use crate::input::{self, Complete};
use crate::stopwatch::{Stopwatch, quoted};
use crate::terminal::{self, tell};
use crate::{exit, failed, files};

/// Arguments of `inject`.
#[derive(Debug, Args)]
#[command(
    after_help = "The project runs with its stimulus, and in each injection one thing goes wrong in one scan. What becomes of it is\n\
compared with the run in which nothing is wrong:\n\
  masked    every published output was right as long as the fault was followed\n\
  latent    the same, and the bit is still wrong in a memory that no execution writes\n\
  detected  the task stopped, outputs off, and no wrong output was let out before\n\
  off       outputs were off that should be on, and never the other way\n\
  let out   an output was on that should be off, or a number was neither right nor 0\n\
Groups: channel (in one of them), shared (what both share), residual (what a controller alone cannot see: docs/independence.md).\n\
Exit code: 0 no wrong output let out, 1 wrong outputs let out, 2 unreadable."
)]
pub struct Inject {
    /// The project: .rll, .L5K, .L5X, a folder, or an image
    #[arg(required_unless_present = "list")]
    file: Option<PathBuf>,
    /// What drives the inputs; in a folder, its stimulus.csv where this is not given; without one, random inputs
    #[arg(long, value_name = "CSV")]
    stimulus: Option<PathBuf>,
    /// Scans of the undisturbed run; without it some more than the stimulus has
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=100_000))]
    scans: Option<u32>,
    /// Faults in all; a class with fewer places than its share is injected whole
    #[arg(long, value_name = "N", default_value_t = 20_000, value_parser = clap::value_parser!(u64).range(1..=1_000_000_000))]
    injections: u64,
    /// Seed of the places, and of random inputs
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Scans that each fault is followed for
    #[arg(long, value_name = "N", default_value_t = 50, value_parser = clap::value_parser!(u32).range(1..))]
    follow: u32,
    /// Threads; as many as there are cores where this is not given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_024))]
    jobs: Option<u32>,
    /// Groups of faults
    #[arg(long, value_name = "GROUP", value_delimiter = ',', default_value = "channel,shared")]
    group: Vec<Kind>,
    /// Only classes whose name contains this
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Inject one fault again, as a report names it
    #[arg(long, value_name = "FAULT", conflicts_with_all = ["injections", "jobs", "group", "only"])]
    replay: Option<Fault>,
    /// Also write a page
    #[arg(long, value_name = "FILE", conflicts_with_all = ["replay", "list"])]
    html: Option<PathBuf>,
    /// Also write the report as JSON, with what is needed to make it again, for `twinrung evidence`
    #[arg(long, value_name = "FILE", conflicts_with_all = ["replay", "list"])]
    report: Option<PathBuf>,
    /// List the classes of faults
    #[arg(long)]
    list: bool,
    /// What is printed
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    #[command(flatten)]
    complete: Complete,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Kind {
    Channel,
    Shared,
    Residual,
}

/// Scans of a run with random inputs.
const RANDOM_SCANS: u32 = 200;
/// Scans that a run goes on after the last row of its stimulus.
const SCANS_AFTER_STIMULUS: u64 = 10;
/// The longest run that a stimulus makes when nobody says how long.
const SCANS_MAX: u64 = 5_000;
const DRAWN_EVERY: Duration = Duration::from_millis(100);

/// Injects.
pub fn run(arguments: &Inject) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let Some(file) = arguments.file.as_ref().filter(|_| !arguments.list) else {
        for class in Class::all() {
            writeln!(out, "{:<9} {class}", class.group().name())?;
        }
        return Ok(ExitCode::SUCCESS);
    };
    let loaded = match input::image(&mut out, file, &arguments.complete, "; nothing was injected")? {
        Ok(loaded) => loaded,
        Err(code) => return Ok(code),
    };
    let given = input::stimulus(file, arguments.stimulus.as_deref())?;
    let period_ms = loaded.image.image().task.as_ref().map_or(1, |task| u64::from(task.period_us / 1000)).max(1);
    let scans = arguments.scans.unwrap_or_else(|| match &given {
        Some(stimulus) => (stimulus.last_ms() / period_ms + SCANS_AFTER_STIMULUS).clamp(2, SCANS_MAX) as u32,
        None => RANDOM_SCANS,
    });
    let driven_by = arguments.driven_by(given.is_some());
    let stimulus: Stimulus = given.unwrap_or_else(|| random(&loaded.image, scans, arguments.seed));
    let outputs = &arguments.complete.outputs;
    let subject: Subject<Primary, Partner> =
        Subject::new(&loaded.image, &loaded.bytes, &stimulus, outputs, scans).map_err(failed)?;
    // A panic of a disturbed channel is an outcome, and is counted. Others are heard.
    let heard = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if !is_injecting() {
            heard(panic);
        }
    }));
    if let Some(fault) = arguments.replay {
        return replay(&mut out, &subject, fault, arguments.follow);
    }
    let cores = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let jobs = arguments.jobs.map_or(cores, |jobs| jobs as usize);
    let groups = arguments.group.iter().map(|kind| match kind {
        Kind::Channel => Group::Channel,
        Kind::Shared => Group::Shared,
        Kind::Residual => Group::Residual,
    });
    let plan = Plan {
        injections: arguments.injections,
        seed: arguments.seed,
        follow: arguments.follow,
        jobs,
        groups: groups.collect(),
        only: arguments.only.clone(),
    };
    let campaign = Campaign::new(&subject, plan);
    if campaign.is_empty() {
        return Err(io::Error::other("there is nothing to inject: --list shows the classes of faults"));
    }
    // Before hours go by.
    arguments.html.iter().chain(&arguments.report).try_for_each(|path| files::make_folder_of(path))?;
    let stopwatch = Stopwatch::start();
    let report = with_bar(&campaign);
    let provenance = stopwatch.provenance(jobs);
    let signature = short_form(loaded.image.application_signature());
    let recorded = Recorded {
        schema: SCHEMA,
        project: file.display().to_string(),
        signature: signature.to_string(),
        stimulus: driven_by,
        injections: arguments.injections,
        replay: arguments.again(file),
        provenance,
        report,
    };
    if let Some(path) = &arguments.html {
        files::write_whole(path, page(&recorded).as_bytes())?;
    }
    if let Some(path) = &arguments.report {
        files::write_whole(path, &serde_json::to_vec_pretty(&recorded)?)?;
    }
    let report = &recorded.report;
    match arguments.format {
        Format::Human => {
            writeln!(
                out,
                "{}: safety application {signature}, {} scans, seed {}\n",
                file.display(),
                report.scans,
                report.seed
            )?;
            write!(out, "{report}")?;
            tell(format_args!("{} injections in {:.1} s", report.injected(), recorded.provenance.seconds));
        }
        Format::Json => write_json(&mut out, &recorded)?,
    }
    Ok(if report.let_out() == 0 { ExitCode::SUCCESS } else { ExitCode::from(exit::REFUSED) })
}

impl Inject {
    /// What drives the inputs, in words.
    fn driven_by(&self, is_given: bool) -> String {
        match &self.stimulus {
            Some(path) => path.display().to_string(),
            None if is_given => "its stimulus.csv".to_owned(),
            None => format!("random inputs, seed {}", self.seed),
        }
    }

    /// The command that injects one fault again, without the fault.
    fn again(&self, file: &Path) -> String {
        let mut words = vec!["twinrung inject".to_owned(), quoted(file.as_os_str())];
        words.extend(self.stimulus.iter().map(|path| format!("--stimulus {}", quoted(path.as_os_str()))));
        words.extend(self.scans.iter().map(|scans| format!("--scans {scans}")));
        words.extend(self.complete.words());
        words.push(format!("--seed {} --follow {} --replay", self.seed, self.follow));
        words.join(" ")
    }
}

fn with_bar(campaign: &Campaign<'_, Primary, Partner>) -> Report {
    let done = AtomicU64::new(0);
    if !io::stderr().is_terminal() {
        return campaign.run(&done);
    }
    let bar = ProgressBar::new(campaign.len());
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} faults, {per_sec}, {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let report = thread::scope(|scope| {
        let running = scope.spawn(|| campaign.run(&done));
        while !running.is_finished() {
            bar.set_position(done.load(Ordering::Relaxed));
            thread::sleep(DRAWN_EVERY);
        }
        running.join()
    });
    bar.finish_and_clear();
    report.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

fn replay(out: &mut dyn Write, subject: &Subject<Primary, Partner>, fault: Fault, follow: u32) -> io::Result<ExitCode> {
    let outcome = subject.replay(fault, follow);
    let words = match outcome {
        Outcome::Masked => "masked: every output was right".to_owned(),
        Outcome::Latent => "latent: every output was right, and the bit is still wrong".to_owned(),
        Outcome::Detected(mechanism, scans) => {
            format!("detected in scan {scans} of the fault by: {}", mechanism.words())
        }
        Outcome::Off => "off: outputs were off that should be on, and nothing was detected".to_owned(),
        Outcome::LetOut(scan) => format!("a wrong output was let out in scan {scan}"),
        Outcome::Impossible => "no such place, or no such value".to_owned(),
    };
    writeln!(out, "{fault}: {words}")?;
    Ok(if matches!(outcome, Outcome::LetOut(_)) { ExitCode::from(exit::REFUSED) } else { ExitCode::SUCCESS })
}
