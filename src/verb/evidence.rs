//! `twinrung evidence`: what was measured of a release, added up, held against its floors, on one page.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use twinrung_workbench::evidence::{self, File, Sources};

use crate::format::{Format, write_json};
use crate::stopwatch::Stopwatch;
use crate::{exit, failed, files, terminal};

/// Arguments of `evidence`.
#[derive(Debug, Args)]
#[command(after_help = "Reads what stands in the folder and beside it in the project:\n\
  FOLDER/fuzz/*.json        reports of twinrung fuzz --report, added up\n\
  FOLDER/inject/*.json      reports of twinrung inject --report, added up\n\
  FOLDER/differences.toml   the differences that were found, and what became of them\n\
  tests/defects             the seeded defects, and times.toml\n\
  tests/mutants/*.toml      results of mutation testing\n\
  docs/independence.md      what the channels share, and what covers it\n\
What is missing counts as not met. docs/evidence.md says how to read the page, and how each report is made.\n\
Exit code: 0 all floors met, 1 something below its floor or not measured, 2 unreadable.")]
pub struct Evidence {
    /// The folder of the reports, in the project
    #[arg(long, value_name = "FOLDER", default_value = "evidence")]
    folder: PathBuf,
    /// The page
    #[arg(short, long, value_name = "FILE", default_value = "evidence.html")]
    output: PathBuf,
    /// What is printed
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Reads, judges, writes the page.
pub fn run(arguments: &Evidence) -> io::Result<ExitCode> {
    let stopwatch = Stopwatch::start();
    let evidence = evidence::Evidence::read(&sources(&arguments.folder)?).map_err(failed)?;
    let page = evidence::page(&evidence, &stopwatch.provenance(1));
    files::write_whole(&arguments.output, page.as_bytes())?;
    let mut out = terminal::out();
    match arguments.format {
        Format::Json => write_json(&mut out, &evidence)?,
        Format::Human => {
            for judged in &evidence.floors {
                let is_met = judged.state == evidence::State::Met;
                let mark = if is_met { "met    " } else { "NOT MET" };
                writeln!(out, "{mark}  {}: {} (demanded: {})", judged.what, judged.found, judged.demanded)?;
            }
            writeln!(
                out,
                "\n{} floors met, {} not; the page is {}",
                evidence.floors.len() - evidence.unmet().count(),
                evidence.unmet().count(),
                arguments.output.display()
            )?;
        }
    }
    Ok(if evidence.is_met { ExitCode::SUCCESS } else { ExitCode::from(exit::REFUSED) })
}

/// All files that evidence is read from.
fn sources(folder: &Path) -> io::Result<Sources> {
    if !folder.is_dir() {
        return Err(io::Error::other(format!(
            "{}: there is no such folder; run this in the project, or give --folder",
            folder.display()
        )));
    }
    // The project is around the folder, however that was said: `.`, a link, a path with `..`.
    let folder = folder.canonicalize().map_err(|error| unreadable(folder, &error))?;
    let project = folder.parent().unwrap_or(&folder).to_owned();
    let defects = listed(&project, &project.join("tests/defects"), "toml")?;
    let (times, defects) = defects.into_iter().partition::<Vec<File>, _>(|file| file.name.ends_with("/times.toml"));
    Ok(Sources {
        fuzz: listed(&project, &folder.join("fuzz"), "json")?,
        inject: listed(&project, &folder.join("inject"), "json")?,
        differences: one(&project, &folder.join("differences.toml"))?,
        defects,
        times: times.into_iter().next(),
        mutants: listed(&project, &project.join("tests/mutants"), "toml")?,
        independence: one(&project, &project.join("docs/independence.md"))?,
        samples: samples(&project)?,
    })
}

fn unreadable(path: &Path, error: &io::Error) -> io::Error {
    io::Error::other(format!("{}: {error}", path.display()))
}

/// Its path in the project, the same on every system.
fn name(project: &Path, path: &Path) -> String {
    let inside = path.strip_prefix(project).unwrap_or(path);
    inside.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

fn one(project: &Path, path: &Path) -> io::Result<Option<File>> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(File { name: name(project, path), bytes })),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(unreadable(path, &error)),
    }
}

/// What stands in a folder, by name; nothing where there is no such folder.
fn entries(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut paths = match fs::read_dir(folder) {
        Ok(entries) => entries.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<PathBuf>>>(),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Vec::new()),
        Err(error) => Err(error),
    }
    .map_err(|error| unreadable(folder, &error))?;
    paths.sort();
    Ok(paths)
}

/// The files of a folder that have this ending.
fn listed(project: &Path, folder: &Path, ending: &str) -> io::Result<Vec<File>> {
    let mut found = Vec::new();
    let is_meant = |path: &&PathBuf| {
        // A folder of results may be that of the crate that makes them.
        path.extension().is_some_and(|own| own == ending) && !path.ends_with("Cargo.toml")
    };
    for path in entries(folder)?.iter().filter(is_meant) {
        found.extend(one(project, path)?);
    }
    Ok(found)
}

/// The samples that run with a stimulus.
fn samples(project: &Path) -> io::Result<Vec<String>> {
    let folders = entries(&project.join("samples"))?;
    Ok(folders
        .iter()
        .filter(|folder| folder.join("stimulus.csv").is_file())
        .map(|folder| name(project, folder))
        .collect())
}
