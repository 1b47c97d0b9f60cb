//! `twinrung test`: project verification tests, written as scenarios, on both interpreters, with coverage.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use twinrung_compiler::diagnostic::{Finding, UNREADABLE_FILE, reading_finding};
use twinrung_grammar::read_scenarios;
use twinrung_grammar::tree::Sources;
use twinrung_grammar::tree::scenario::{ScenarioFile, ScenarioItem};
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::diagram::Style;
use twinrung_workbench::scenario::Suite;
use twinrung_workbench::scenario::report::{self, ProjectReport};

use crate::findings::{self, Report};
use crate::format::{Format, write_json};
use crate::input::{self, Complete, Required};
use crate::progress::with_progress;
use crate::terminal::{self, Terminal};
use crate::watch::watched;
use crate::{exit, failed, files};

/// Arguments of `test`.
#[derive(Debug, Args)]
#[command(
    after_help = "A scenario file ends in .scenario and tests the project that it names, or the folder in which it stands. What it may\n\
say is in docs/scenarios.md. Every scenario begins with power-up; both channels are compared after each scan, and a stop of the\n\
controller that no scenario expects is a failure.\n\
Exit code: 0 all met and the coverage enough, 1 not met or refused, 2 unreadable, 3 a nonrecoverable fault that no scenario expects,\n\
4 a recoverable one."
)]
pub struct Test {
    /// Scenario files, and folders that hold some at any depth
    #[arg(required = true, value_name = "SCENARIO|FOLDER")]
    files: Vec<PathBuf>,
    /// Play only scenarios whose name holds this text; the coverage is then not judged
    #[arg(long, value_name = "NAME")]
    filter: Option<String>,
    /// Coverage in percent that is the least accepted, whatever the files say
    #[arg(long, value_name = "PERCENT", value_parser = clap::value_parser!(u8).range(0..=100))]
    minimum: Option<u8>,
    /// What is printed
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    /// Also write JUnit XML
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Also write a page
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Test again whenever a scenario or its project changes, until interrupted
    #[arg(long)]
    watch: bool,
    #[command(flatten)]
    required: Required,
    #[command(flatten)]
    complete: Complete,
}

const NOTHING_TESTED: &str = "; nothing was tested";

/// Scenario files that test one project.
struct Group {
    project: PathBuf,
    files: Vec<(PathBuf, ScenarioFile)>,
}

/// What a run of all files came to.
type Tested = Result<Vec<ProjectReport>, ExitCode>;

/// Tests.
pub fn run(arguments: &Test) -> io::Result<ExitCode> {
    if arguments.watch {
        let places = || found(&arguments.files).map(|files| watch_places(&files));
        return watched(places, || once(arguments).map(|_| ())).map(|never| match never {});
    }
    once(arguments)
}

fn once(arguments: &Test) -> io::Result<ExitCode> {
    let mut out = terminal::out();
    let reports = match tested(arguments, &mut out)? {
        Ok(reports) => reports,
        Err(code) => return Ok(code),
    };
    let terminal = Terminal::of_stdout();
    match arguments.format {
        Format::Human => {
            let style = Style { columns: terminal.columns, colour: terminal.colour };
            let texts: Vec<String> = reports.iter().map(|one| report::text(one, style)).collect();
            out.write_all(texts.join("\n").as_bytes())?;
        }
        Format::Json => write_json(&mut out, &serde_json::json!({ "projects": reports }))?,
    }
    if let Some(path) = &arguments.junit {
        files::write_whole(path, report::junit(&reports)?.as_bytes())?;
    }
    if let Some(path) = &arguments.html {
        files::write_whole(path, report::page(&reports).as_bytes())?;
    }
    Ok(code(&reports))
}

fn code(reports: &[ProjectReport]) -> ExitCode {
    let stopped = reports.iter().flat_map(|one| &one.scenarios).find_map(|scenario| scenario.stopped);
    match stopped {
        Some((_, reason)) => exit::of_scans(Some(reason)),
        None if reports.iter().all(ProjectReport::is_good) => ExitCode::SUCCESS,
        None => ExitCode::from(exit::REFUSED),
    }
}

fn tested(arguments: &Test, out: &mut dyn Write) -> io::Result<Tested> {
    let mut sources = Sources::new();
    let mut wrong = Vec::new();
    let groups = groups(&found(&arguments.files)?, &mut sources, &mut wrong)?;
    if !wrong.is_empty() {
        return refused(out, &sources, &wrong).map(Err);
    }
    let mut reports = Vec::with_capacity(groups.len());
    for group in groups {
        let loaded = match input::image(out, &group.project, &arguments.complete, NOTHING_TESTED)? {
            Ok(loaded) => loaded,
            Err(code) => return Ok(Err(code)),
        };
        if let Err(error) = arguments.required.check(&loaded) {
            writeln!(out, "{error}{NOTHING_TESTED}")?;
            return Ok(Err(ExitCode::from(exit::REFUSED)));
        }
        let mut suite = Suite::new(&loaded.image, &loaded.bytes);
        for (path, file) in &group.files {
            wrong.extend(suite.add(path, file));
        }
        if !wrong.is_empty() {
            return refused(out, &sources, &wrong).map(Err);
        }
        suite.demand(arguments.minimum);
        if let Some(text) = &arguments.filter {
            suite.filter(text);
        }
        // A filter may concern one project of several.
        if suite.is_empty() {
            continue;
        }
        let name = group.project.display().to_string();
        let report =
            with_progress(suite.len() as u64, |progress| suite.run::<Primary, Partner>(name, &sources, progress));
        reports.push(report.map_err(failed)?);
    }
    if reports.is_empty() {
        return Err(io::Error::other("no scenario is left to play"));
    }
    Ok(Ok(reports))
}

fn refused(out: &mut dyn Write, sources: &Sources, wrong: &[Finding]) -> io::Result<ExitCode> {
    let report = Report { sources, trees: &[], findings: wrong };
    findings::print_human(out, &report, Terminal::of_stdout(), true)?;
    writeln!(out, "{}{NOTHING_TESTED}", findings::summary(findings::Count::of(wrong)))?;
    let unreadable = wrong.iter().any(|finding| finding.code == &UNREADABLE_FILE);
    Ok(ExitCode::from(if unreadable { exit::UNREADABLE } else { exit::REFUSED }))
}

/// The scenario files that are meant, each once.
fn found(paths: &[PathBuf]) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for path in paths {
        let unreadable = |error: io::Error| io::Error::other(format!("{}: {error}", path.display()));
        if !fs::metadata(path).map_err(unreadable)?.is_dir() {
            found.push(path.clone());
            continue;
        }
        let before = found.len();
        let mut open = vec![path.clone()];
        while let Some(folder) = open.pop() {
            for entry in fs::read_dir(&folder).map_err(unreadable)? {
                let entry = entry.map_err(unreadable)?;
                // A link is not followed: it may lead back.
                let kind = entry.file_type().map_err(unreadable)?;
                if kind.is_dir() {
                    open.push(entry.path());
                } else if entry.path().extension().is_some_and(|extension| extension == "scenario") {
                    found.push(entry.path());
                }
            }
        }
        if found.len() == before {
            return Err(io::Error::other(format!("{}: there is no .scenario file in this folder", path.display())));
        }
        found[before..].sort();
    }
    let mut seen = std::collections::BTreeSet::new();
    found.retain(|path| seen.insert(path.clone()));
    Ok(found)
}

fn groups(paths: &[PathBuf], sources: &mut Sources, wrong: &mut Vec<Finding>) -> io::Result<Vec<Group>> {
    let mut groups: Vec<Group> = Vec::new();
    for path in paths {
        let bytes = fs::read(path).map_err(|error| io::Error::other(format!("{}: {error}", path.display())))?;
        let reading = read_scenarios(sources, path, bytes);
        wrong.extend(reading.errors.iter().map(reading_finding));
        let project = project_of(path, &reading.file);
        match groups.iter_mut().find(|group| group.project == project) {
            Some(group) => group.files.push((path.clone(), reading.file)),
            None => groups.push(Group { project, files: vec![(path.clone(), reading.file)] }),
        }
    }
    Ok(groups)
}

/// The project that a file names, or the folder in which it stands.
fn project_of(path: &Path, file: &ScenarioFile) -> PathBuf {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let named = file.items.iter().find_map(|item| match item {
        ScenarioItem::Project(name) => Some(name.as_str()),
        _ => None,
    });
    named.map_or_else(|| folder.to_owned(), |name| folder.join(name))
}

/// The folders that hold the scenarios and what they test.
fn watch_places(files: &[PathBuf]) -> Vec<PathBuf> {
    let mut sources = Sources::new();
    let mut places: Vec<PathBuf> = Vec::new();
    for path in files {
        let project = fs::read(path).map(|bytes| project_of(path, &read_scenarios(&mut sources, path, bytes).file));
        for place in std::iter::once(path.clone()).chain(project.ok()) {
            let folder = if place.is_dir() { place } else { place.parent().unwrap_or(Path::new(".")).to_owned() };
            let folder = if folder.as_os_str().is_empty() { PathBuf::from(".") } else { folder };
            if !places.contains(&folder) {
                places.push(folder);
            }
        }
    }
    places
}
