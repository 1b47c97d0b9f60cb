//! `twinrung fuzz`: random valid programs on both interpreters, every value compared after every scan.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use twinrung_workbench::fuzz::{Campaign, Case, Outcome, Ran, Report, Subject, is_replaying, ran, replay, size_of};
use twinrung_workbench::generate::Size;

use crate::{exit, failed, files, input, terminal};

/// The evaluators that run against each other.
#[cfg(not(feature = "judge"))]
type Contest = twinrung_workbench::fuzz::Pairs<twinrung_primary::Primary, twinrung_partner::Partner>;
#[cfg(feature = "judge")]
type Contest = twinrung_trio::Trios;

/// Arguments of `fuzz`.
#[derive(Debug, Args)]
#[command(
    after_help = "A seed gives the same program and the same inputs everywhere. A difference is made as small as it gets and written\n\
as CASES/seed-N.rll and CASES/seed-N.csv, which --replay runs again.\n\
Exit code: 0 no difference, 1 a difference, 2 unreadable."
)]
pub struct Fuzz {
    /// How long, as 30s, 5m or 2h; a program that was begun is run to its end, and what differs made small
    #[arg(long, value_name = "TIME", default_value = "30s", value_parser = duration)]
    time: Duration,
    /// The first seed
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// End after so many programs
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    programs: Option<u64>,
    /// Scans of each program
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=SCANS_MAX))]
    scans: u32,
    /// Rungs of each main routine; without it one program in four is large
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=RUNGS_MAX))]
    rungs: Option<u32>,
    /// Threads; as many as there are cores where this is not given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=JOBS_MAX))]
    jobs: Option<u32>,
    /// End after so many differences
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..))]
    differences: u32,
    /// Folder for what differs
    #[arg(long, value_name = "FOLDER", default_value = "cases")]
    cases: PathBuf,
    /// Leave what differs as large as it was found
    #[arg(long)]
    as_found: bool,
    /// Write the totals as JSON
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Show how often each instruction was executed
    #[arg(long)]
    coverage: bool,
    /// Run a case again: its .rll, with the .csv beside it
    #[arg(long, value_name = "CASE", conflicts_with_all = ["time", "seed", "programs", "scans", "rungs", "jobs", "differences", "cases", "as_found", "report", "coverage"])]
    replay: Option<PathBuf>,
}

/// More scans of one program say nothing that another program would not say sooner.
const SCANS_MAX: i64 = 1_000_000;
/// Rungs of a main routine: what a program of the generator still compiles within the limits.
const RUNGS_MAX: i64 = 2_000;
const JOBS_MAX: i64 = 1_024;

/// A time as people write it.
fn duration(text: &str) -> Result<Duration, String> {
    let wrong = || format!("`{text}` is no time: 30s, 5m, 2h");
    let (number, unit) = text.split_at(text.find(|one: char| !one.is_ascii_digit()).unwrap_or(text.len()));
    let seconds = match unit {
        "s" | "" => 1,
        "m" | "min" => 60,
        "h" => 3600,
        _ => return Err(wrong()),
    };
    number.parse::<u64>().ok().and_then(|number| number.checked_mul(seconds)).map(Duration::from_secs).ok_or_else(wrong)
}

/// Runs.
pub fn run(arguments: &Fuzz) -> io::Result<ExitCode> {
    // A panic of an evaluator is caught, made small and reported as what it is: a defect. Others are heard.
    let heard = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if !is_replaying() {
            heard(panic);
        }
    }));
    match &arguments.replay {
        Some(case) => again(case),
        None => campaign(arguments),
    }
}

fn again(path: &Path) -> io::Result<ExitCode> {
    let text = input::text(path)?;
    let inputs = path.with_extension("csv");
    let csv = input::text(&inputs)?;
    let subject = Subject::from_text(&text)
        .map_err(|findings| io::Error::other(format!("{}: {}", path.display(), findings.join("\n"))))?;
    let case = Case::read(text, &csv, &subject.image)
        .map_err(|error| io::Error::other(format!("{}: {error}", inputs.display())))?;
    let mut out = terminal::out();
    match replay::<Contest>(&case.text, &case.stimulus) {
        Outcome::Agreed(counts) => {
            writeln!(out, "{}: {} steps, no difference", path.display(), counts.scans)?;
            Ok(ExitCode::SUCCESS)
        }
        Outcome::Refused(findings) => Err(io::Error::other(findings.join("\n"))),
        Outcome::Failed { report, steps } => {
            writeln!(out, "{}: after step {steps}: {}", path.display(), report.trim_end())?;
            Ok(ExitCode::from(exit::REFUSED))
        }
    }
}

fn campaign(arguments: &Fuzz) -> io::Result<ExitCode> {
    let cores = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let jobs = arguments.jobs.map_or(cores, |jobs| jobs as usize);
    let (next, over) = (AtomicU64::new(arguments.seed), AtomicBool::new(false));
    let end = arguments.programs.map_or(u64::MAX, |programs| arguments.seed.saturating_add(programs));
    let begun = Instant::now();
    let bar = progress(arguments);
    let mut campaign = Campaign::default();
    let mut unwritten = None;
    thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel::<(u64, Ran)>();
        for _ in 0..jobs {
            let sender = sender.clone();
            let (next, over) = (&next, &over);
            scope.spawn(move || {
                while !over.load(Ordering::Relaxed) && begun.elapsed() < arguments.time {
                    let seed = next.fetch_add(1, Ordering::Relaxed);
                    let size = arguments.rungs.map_or_else(|| size_of(seed), |rungs| Size::of_rungs(rungs as usize));
                    let scans = arguments.scans as usize;
                    if seed >= end
                        || sender.send((seed, ran::<Contest>(seed, size, scans, arguments.as_found))).is_err()
                    {
                        break;
                    }
                }
            });
        }
        drop(sender);
        for (seed, ran) in receiver {
            campaign.add(seed, ran, begun.elapsed());
            show(&bar, &campaign, begun.elapsed());
            let is_new = campaign.failures.last().is_some_and(|failure| failure.seed == seed);
            if let (true, Err(error)) = (is_new, written(&arguments.cases, &campaign)) {
                unwritten.get_or_insert(error);
            }
            over.fetch_or(campaign.failures.len() >= arguments.differences as usize, Ordering::Relaxed);
        }
    });
    bar.finish_and_clear();
    let took = begun.elapsed();
    if let Some(path) = &arguments.report {
        let report = serde_json::to_vec_pretty(&Report::new(&campaign, arguments.seed, took))?;
        files::write_whole(path, &report).map_err(failed)?;
    }
    let code = summary(arguments, &campaign, took)?;
    // What was found stands in the output even where its files could not be written.
    if let Some(error) = unwritten {
        terminal::tell(format_args!("twinrung: {error}"));
    }
    Ok(code)
}

fn progress(arguments: &Fuzz) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(arguments.time.as_secs());
    let style = ProgressStyle::with_template("{bar:30} {elapsed} {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}

fn show(bar: &ProgressBar, campaign: &Campaign, took: Duration) {
    bar.set_position(took.as_secs());
    let coverage = &campaign.total.executions.coverage;
    let per_second = campaign.total.instructions as f64 / took.as_secs_f64().max(f64::EPSILON);
    let missing = coverage.missing();
    let rest = missing.first().map_or(String::new(), |first| format!(", {} not reached ({first} ...)", missing.len()));
    bar.set_message(format!(
        "{} programs, {per_second:.1e} instructions/s, {} instruction pairs{rest}, {} differences",
        campaign.programs,
        coverage.pairs(),
        campaign.failures.len()
    ));
}

/// Writes the last difference that was found.
fn written(folder: &Path, campaign: &Campaign) -> io::Result<()> {
    let Some(failure) = campaign.failures.last() else { return Ok(()) };
    fs::create_dir_all(folder).map_err(|error| io::Error::other(format!("{}: {error}", folder.display())))?;
    let path = folder.join(format!("seed-{}.rll", failure.seed));
    files::write_whole(&path, failure.case.text.as_bytes()).map_err(failed)?;
    files::write_whole(&path.with_extension("csv"), failure.case.to_csv().as_bytes()).map_err(failed)
}

fn summary(arguments: &Fuzz, campaign: &Campaign, took: Duration) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    for failure in &campaign.failures {
        writeln!(out, "{failure}\n")?;
    }
    for (finding, (count, seed)) in &campaign.reasons {
        writeln!(out, "refused {count}, first of seed {seed}: {finding}")?;
    }
    if campaign.programs == campaign.refused {
        return Err(io::Error::other("no program was run: give --time or --programs more"));
    }
    let coverage = &campaign.total.executions.coverage;
    if arguments.coverage {
        write!(out, "{coverage}")?;
    }
    let missing = coverage.missing();
    let missing = if missing.is_empty() { "nothing".to_owned() } else { missing.join(", ") };
    writeln!(out, "{campaign}")?;
    writeln!(
        out,
        "reached: {} pairs of instructions, {} forms of operands; not reached: {missing}",
        coverage.pairs(),
        coverage.forms()
    )?;
    let per_second = |count: u64| count as f64 / took.as_secs_f64().max(f64::EPSILON);
    writeln!(
        out,
        "from seed {}, {:.1} s, {:.0} rungs and {:.0} instructions in a second",
        arguments.seed,
        took.as_secs_f64(),
        per_second(campaign.total.executions.rungs),
        per_second(campaign.total.instructions)
    )?;
    if let Some(failure) = campaign.failures.first() {
        writeln!(out, "run it again: twinrung fuzz --replay {}/seed-{}.rll", arguments.cases.display(), failure.seed)?;
        return Ok(ExitCode::from(exit::REFUSED));
    }
    Ok(ExitCode::SUCCESS)
}
