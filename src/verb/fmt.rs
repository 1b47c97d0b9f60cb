//! `twinrung fmt`: the canonical form of `.rll`, and the layout of `.scenario`.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use twinrung_grammar::tree::Sources;
use twinrung_grammar::{Unprintable, laid_out, print_file_checked, read_path};

use crate::findings;
use crate::terminal::{self, Terminal};
use crate::{failed, files, input};

/// Arguments of `fmt`.
#[derive(Debug, Args)]
#[command(after_help = "A .rll or .scenario file is rewritten in place; an export (.L5K, .L5X) is printed as .rll.\n\
Exit code: 0 done (with --check: already canonical), 1 --check found another form, 2 could not read.")]
pub struct Fmt {
    /// A .rll or .scenario file or a folder of them, rewritten; or an export, printed
    file: PathBuf,
    /// Rewrite nothing; say whether something would change
    #[arg(long)]
    check: bool,
}

/// Formats.
pub fn run(arguments: &Fmt) -> io::Result<ExitCode> {
    let mut changed = false;
    for path in rll_files(&arguments.file)? {
        changed |= if files::has_ending(&path, "scenario") {
            let before = input::text(&path)?;
            written(&path, &before, &laid_out(&before), arguments.check)?
        } else {
            format_one(&path, arguments.check)?
        };
    }
    Ok(ExitCode::from(u8::from(arguments.check && changed)))
}

fn rll_files(path: &Path) -> io::Result<Vec<PathBuf>> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let mut files: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(path)? {
        let path = entry?.path();
        if files::has_ending(&path, "rll") || files::has_ending(&path, "scenario") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

fn format_one(path: &Path, check: bool) -> io::Result<bool> {
    let before = fs::read(path).map_err(|error| io::Error::other(format!("{}: {error}", path.display())))?;
    let mut sources = Sources::new();
    let reading = read_path(&mut sources, path);
    if !reading.errors.is_empty() {
        let found: Vec<_> = reading.errors.iter().map(twinrung_compiler::diagnostic::reading_finding).collect();
        let trees = std::slice::from_ref(&reading.file);
        let report = findings::Report { sources: &sources, trees, findings: &found };
        findings::print_human(&mut terminal::err(), &report, Terminal::of_stderr(), true)?;
        return Err(failed(Unformatted(path.display().to_string())));
    }
    let unprintable = |why| failed(NotWritable { path: path.display().to_string(), why });
    let after = print_file_checked(&reading.file).map_err(unprintable)?;
    if !files::has_ending(path, "rll") {
        terminal::out().write_all(after.as_bytes())?;
        return Ok(false);
    }
    written(path, &String::from_utf8_lossy(&before), &after, check)
}

/// Writes the canonical text where it differs, or says that it does; whether it does.
fn written(path: &Path, before: &str, after: &str, check: bool) -> io::Result<bool> {
    let changed = after != before;
    if changed && check {
        writeln!(terminal::out(), "{}: not in canonical form", path.display())?;
    } else if changed {
        files::write_whole(path, after.as_bytes())?;
        writeln!(terminal::out(), "{}: rewritten", path.display())?;
    }
    Ok(changed)
}

/// A file that cannot be read is left as it is.
#[derive(Debug)]
struct Unformatted(String);

impl std::fmt::Display for Unformatted {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: could not be read as a whole, and was left as it is", self.0)
    }
}

impl std::error::Error for Unformatted {}

/// A file whose text would not read as what the file says is left as it is.
#[derive(Debug)]
struct NotWritable {
    path: String,
    why: Unprintable,
}

impl std::fmt::Display for NotWritable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: holds what .rll cannot say, and was left as it is; {}; correct it there", self.path, self.why)
    }
}

impl std::error::Error for NotWritable {}
