//! How long the fuzzer takes to find what stands in the copy.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde::{Deserialize, Serialize};

use crate::ScratchTree;

/// How the fuzzer is run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Bench {
    /// Where the copy is built, and where reports go.
    pub folder: PathBuf,
    /// Threads.
    pub jobs: u32,
    /// After so many seconds a defect counts as missed.
    pub limit_s: u32,
    /// The first seed.
    pub seed: u64,
    /// Random programs alone, without guidance.
    pub plain: bool,
}

/// What a run of the fuzzer came to.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Whether it found a difference.
    pub found: bool,
    /// Seconds until then, or the limit.
    pub seconds: f64,
    /// Programs that had been run.
    pub cases: u64,
}

/// Why nothing could be measured.
#[derive(Debug)]
pub enum MeasureError {
    /// The copy does not build: the compiler's last words.
    Build(String),
    /// The fuzzer did not end as it should: its last words.
    Fuzz(String),
    /// A program cannot be started or a file not be read.
    Io(io::Error),
}

impl fmt::Display for MeasureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MeasureError::Build(said) => write!(f, "the tree with the defect does not build:\n{said}"),
            MeasureError::Fuzz(said) => write!(f, "the fuzzer did not end as it should:\n{said}"),
            MeasureError::Io(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for MeasureError {}

impl From<io::Error> for MeasureError {
    fn from(error: io::Error) -> MeasureError {
        MeasureError::Io(error)
    }
}

/// The part of the fuzzer's report that says when it found something.
#[derive(Deserialize)]
struct Report {
    seconds: f64,
    programs: u64,
    differences: Vec<Difference>,
}

#[derive(Deserialize)]
struct Difference {
    after_seconds: f64,
    after_programs: u64,
}

impl Bench {
    /// Builds the command as it stands in the copy.
    ///
    /// # Errors
    ///
    /// It does not build.
    pub fn build(&self, tree: &ScratchTree) -> Result<(), MeasureError> {
        let built = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .args(["build", "--quiet", "--profile", "defects", "--package", "twinrung", "--bin", "twinrung"])
            .arg("--target-dir")
            .arg(self.folder.join("build"))
            .current_dir(tree.root())
            .stdin(Stdio::null())
            .output()?;
        if built.status.success() { Ok(()) } else { Err(MeasureError::Build(last_lines(&built.stderr))) }
    }

    /// Runs the fuzzer that was built last.
    ///
    /// # Errors
    ///
    /// It cannot be run, or ends otherwise than with its verdict.
    pub fn run(&self) -> Result<Measured, MeasureError> {
        let report = self.folder.join("report.json");
        match fs::remove_file(&report) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error.into()),
            _ => {}
        }
        let mut command = Command::new(self.folder.join("build/defects/twinrung"));
        command.args(["fuzz", "--differences", "1", "--as-found", "--seed", &self.seed.to_string()]);
        command.args(["--jobs", &self.jobs.to_string(), "--time", &format!("{}s", self.limit_s)]);
        command.arg("--cases").arg(self.folder.join("cases")).arg("--report").arg(&report);
        if self.plain {
            command.arg("--plain");
        }
        let ran = command.stdin(Stdio::null()).output()?;
        measured(&report).ok_or_else(|| MeasureError::Fuzz(last_lines(&ran.stderr)))
    }
}

fn measured(report: &Path) -> Option<Measured> {
    let report: Report = serde_json::from_slice(&fs::read(report).ok()?).ok()?;
    Some(match report.differences.first() {
        Some(first) => Measured { found: true, seconds: first.after_seconds, cases: first.after_programs },
        None => Measured { found: false, seconds: report.seconds, cases: report.programs },
    })
}

/// The last lines that a program said.
fn last_lines(said: &[u8]) -> String {
    let said = String::from_utf8_lossy(said);
    let lines: Vec<&str> = said.lines().collect();
    lines[lines.len().saturating_sub(12)..].join("\n")
}
