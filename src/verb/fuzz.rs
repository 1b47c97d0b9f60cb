//! `twinrung fuzz`: random valid programs on both interpreters, every value compared after every scan.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use twinrung_workbench::fuzz::{
    Campaign, Case, Coverage, Failure, Outcome, Plan, Report, SCHEMA, Subject, Told, is_replaying, replay, shrink,
};
use twinrung_workbench::generate::Genome;

use crate::stopwatch::Stopwatch;
use crate::{exit, failed, files, input, terminal};

/// The evaluators that run against each other.
#[cfg(not(feature = "judge"))]
type Contest = twinrung_workbench::fuzz::Pairs<twinrung_primary::Primary, twinrung_partner::Partner>;
#[cfg(feature = "judge")]
type Contest = twinrung_trio::Trios;

/// Arguments of `fuzz`.
#[derive(Debug, Args)]
#[command(
    after_help = "Programs are drawn from a seed, or are changes of programs that reached something new: an instruction with another\n\
kind of operand or value, another way through the program, another state of a timer or safety instruction. --plain draws\n\
each from its seed alone, and then a seed gives the same program and inputs everywhere.\n\
A difference is made as small as it gets and written as CASES/case-N.rll and CASES/case-N.csv, which --replay runs again.\n\
Exit code: 0 no difference, 1 a difference, 2 unreadable."
)]
pub struct Fuzz {
    /// How long, as 30s, 5m or 2h; a program that was begun is run to its end, and what differs made small
    #[arg(long, value_name = "TIME", default_value = "30s", value_parser = duration)]
    time: Duration,
    /// The first seed; programs are numbered on from it, so that campaigns that are added up begin a million apart
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// End after so many programs
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    programs: Option<u64>,
    /// Scans of each program; more for larger ones where this is not given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=SCANS_MAX))]
    scans: Option<u32>,
    /// Rungs of each main routine, at most, without guidance; else most programs are small and some are large
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
    /// Draw every program by itself, without guidance
    #[arg(long)]
    plain: bool,
    /// Folder for the choices of programs that reached something new; those in it are run first
    #[arg(long, value_name = "FOLDER", conflicts_with = "plain")]
    corpus: Option<PathBuf>,
    /// Leave what differs as large as it was found
    #[arg(long)]
    as_found: bool,
    /// Write the totals as JSON; they are added to those of a file that is there already
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Show how often each instruction was executed
    #[arg(long)]
    coverage: bool,
    /// Run a case again: its .rll, with the .csv beside it
    #[arg(long, value_name = "CASE", conflicts_with_all = ["time", "seed", "programs", "scans", "rungs", "jobs", "differences", "cases", "plain", "corpus", "as_found", "report", "coverage"])]
    replay: Option<PathBuf>,
    /// Make the case that is run again as small as it gets, and write it where it was
    #[arg(long, requires = "replay")]
    shrink: bool,
}

/// More scans of one program say nothing that another program would not say sooner.
const SCANS_MAX: i64 = 1_000_000;
/// Rungs of a main routine: what a program of the generator still compiles within the limits.
const RUNGS_MAX: i64 = 2_000;
const JOBS_MAX: i64 = 1_024;
/// What was not reached is listed up to so many.
const LISTED: usize = 8;

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
        Some(case) => again(case, arguments.shrink),
        None => campaign(arguments),
    }
}

fn again(path: &Path, smaller: bool) -> io::Result<ExitCode> {
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
            if smaller {
                let (case, report) = shrink::<Contest>(case);
                files::write_whole(path, case.text.as_bytes()).map_err(failed)?;
                files::write_whole(&inputs, case.to_csv().as_bytes()).map_err(failed)?;
                writeln!(out, "made smaller: {}", report.trim_end())?;
            }
            Ok(ExitCode::from(exit::REFUSED))
        }
    }
}

fn campaign(arguments: &Fuzz) -> io::Result<ExitCode> {
    let cores = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let plan = Plan {
        time: arguments.time,
        seed: arguments.seed,
        programs: arguments.programs.unwrap_or(u64::MAX),
        scans: arguments.scans.map(|scans| scans as usize),
        rungs: arguments.rungs.map(|rungs| rungs as usize),
        jobs: arguments.jobs.map_or(cores, |jobs| jobs as usize),
        differences: arguments.differences as usize,
        as_found: arguments.as_found,
        guided: !arguments.plain,
        earlier: arguments.corpus.as_deref().map_or(Ok(Vec::new()), genomes)?,
    };
    // Before hours go by: a file that cannot be added to, or has no place, is said now.
    arguments.report.as_deref().map_or(Ok(()), files::make_folder_of)?;
    let earlier = arguments.report.as_deref().map_or(Ok(None), reported)?;
    let begun = Instant::now();
    let stopwatch = Stopwatch::start();
    let bar = progress(arguments);
    // What was found stands in the output even where its files could not be written.
    let mut unwritten = None;
    let campaign = plan.run::<Contest>(|told| {
        let written = match told {
            Told::Program(campaign) => {
                show(&bar, campaign, begun.elapsed());
                Ok(())
            }
            Told::Kept(genome) => arguments.corpus.as_deref().map_or(Ok(()), |folder| keep(folder, genome)),
            Told::Difference(campaign) => {
                campaign.failures.last().map_or(Ok(()), |failure| written(&arguments.cases, failure))
            }
        };
        if let Err(error) = written {
            unwritten.get_or_insert(error);
        }
    });
    bar.finish_and_clear();
    let took = begun.elapsed();
    if let Some(path) = &arguments.report {
        let here = Report::new(&campaign, &plan, cfg!(feature = "judge"), stopwatch.provenance(plan.jobs));
        let report = earlier.map_or_else(
            || here.clone(),
            |mut earlier| {
                earlier.add(&here);
                earlier
            },
        );
        files::write_whole(path, &serde_json::to_vec_pretty(&report)?).map_err(failed)?;
    }
    let code = summary(arguments, &campaign, took)?;
    if let Some(error) = unwritten {
        terminal::tell(format_args!("twinrung: {error}"));
    }
    Ok(code)
}

/// The totals that stand in a file already; none where there is no such file.
fn reported(path: &Path) -> io::Result<Option<Report>> {
    let wrong = |error: &dyn std::fmt::Display| io::Error::other(format!("{}: {error}", path.display()));
    let bytes = match fs::read(path) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(wrong(&error)),
    };
    let report: Report = serde_json::from_slice(&bytes)
        .map_err(|error| wrong(&format_args!("no report of a campaign, so nothing can be added to it: {error}")))?;
    if !report.is_known() {
        return Err(wrong(&format_args!("a report of form {}, and this release knows {SCHEMA}", report.schema)));
    }
    Ok(Some(report))
}

/// The genomes that an earlier campaign kept; none where there is no such folder yet.
fn genomes(folder: &Path) -> io::Result<Vec<Genome>> {
    let wrong = |path: &Path, error: &dyn std::fmt::Display| io::Error::other(format!("{}: {error}", path.display()));
    let mut paths = match fs::read_dir(folder) {
        Ok(entries) => entries.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<PathBuf>>>()?,
        Err(error) if error.kind() == io::ErrorKind::NotFound => Vec::new(),
        Err(error) => return Err(wrong(folder, &error)),
    };
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "json"));
    paths.sort();
    let read = |path: &PathBuf| {
        let bytes = fs::read(path).map_err(|error| wrong(path, &error))?;
        serde_json::from_slice(&bytes).map_err(|error| wrong(path, &error))
    };
    paths.iter().map(read).collect()
}

/// Writes a genome under a name that its content gives.
fn keep(folder: &Path, genome: &Genome) -> io::Result<()> {
    fs::create_dir_all(folder).map_err(|error| io::Error::other(format!("{}: {error}", folder.display())))?;
    let bytes = serde_json::to_vec(genome)?;
    let path = folder.join(format!("{:016x}.json", genome.fingerprint()));
    files::write_whole(&path, &bytes).map_err(failed)
}

fn progress(arguments: &Fuzz) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(arguments.time.as_millis() as u64 / 100);
    let style = ProgressStyle::with_template("{bar:30} {elapsed} {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}

fn show(bar: &ProgressBar, campaign: &Campaign, took: Duration) {
    // Drawn some ten times in a second: the text costs more than a small program.
    if bar.is_hidden() || (bar.elapsed().as_millis() / 100) as u64 == bar.position() && campaign.programs > 1 {
        return;
    }
    bar.set_position((took.as_millis() / 100) as u64);
    let coverage = &campaign.total.executions.coverage;
    let per_second = |count: u64| count as f64 / took.as_secs_f64().max(f64::EPSILON);
    bar.set_message(format!(
        "{} programs ({:.0}/s), {:.1e} instructions/s, {} instruction pairs, {} of {} operand kinds, {} kept, {} differences",
        campaign.programs,
        per_second(campaign.programs),
        per_second(campaign.total.instructions),
        coverage.pairs(),
        coverage.points(),
        Coverage::reachable(),
        campaign.kept,
        campaign.failures.len()
    ));
}

/// Writes a difference.
fn written(folder: &Path, failure: &Failure) -> io::Result<()> {
    fs::create_dir_all(folder).map_err(|error| io::Error::other(format!("{}: {error}", folder.display())))?;
    let path = folder.join(format!("case-{}.rll", failure.number));
    files::write_whole(&path, failure.case.text.as_bytes()).map_err(failed)?;
    files::write_whole(&path.with_extension("csv"), failure.case.to_csv().as_bytes()).map_err(failed)
}

fn summary(arguments: &Fuzz, campaign: &Campaign, took: Duration) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    for failure in &campaign.failures {
        writeln!(out, "{failure}\n")?;
    }
    for (finding, (count, number)) in &campaign.reasons {
        writeln!(out, "refused {count}, first program {number}: {finding}")?;
    }
    if campaign.programs == campaign.refused {
        return Err(io::Error::other("no program was run: give --time or --programs more"));
    }
    let coverage = &campaign.total.executions.coverage;
    if arguments.coverage {
        write!(out, "{coverage}")?;
    }
    let missing = coverage.missing();
    let listed: Vec<String> = missing.iter().take(LISTED).map(ToString::to_string).collect();
    let rest = if missing.len() > LISTED { " ... (all of them: --coverage)" } else { "" };
    writeln!(out, "{campaign}")?;
    writeln!(
        out,
        "reached: {} of {} operand kinds, values and outcomes, {} pairs of instructions; not reached: {}{rest}",
        coverage.points(),
        Coverage::reachable(),
        coverage.pairs(),
        if listed.is_empty() { "nothing".to_owned() } else { listed.join(", ") }
    )?;
    let per_second = |count: u64| count as f64 / took.as_secs_f64().max(f64::EPSILON);
    writeln!(
        out,
        "from seed {}, {:.1} s, {:.0} programs, {:.0} rungs and {:.0} instructions in a second",
        arguments.seed,
        took.as_secs_f64(),
        per_second(campaign.programs),
        per_second(campaign.total.executions.rungs),
        per_second(campaign.total.instructions)
    )?;
    if let Some(failure) = campaign.failures.first() {
        writeln!(
            out,
            "run it again: twinrung fuzz --replay {}/case-{}.rll",
            arguments.cases.display(),
            failure.number
        )?;
        return Ok(ExitCode::from(exit::REFUSED));
    }
    Ok(ExitCode::SUCCESS)
}
