//! How long the fuzzer takes to find what stands in the copy.

use std::fmt;
use std::fs;
use std::io;
use std::io::Read;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use twinrung_mutants::{BuildError, SWITCH};
use twinrung_workbench::evidence::{Conditions, Measured};
use twinrung_workbench::fuzz::Report;
use twinrung_workbench::provenance::Provenance;

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
    /// Which of the defects that are woven into the build is switched on, by its number from 1; 0 for none.
    pub switch: usize,
}

/// Why nothing could be measured.
#[derive(Debug)]
pub enum MeasureError {
    /// The copy does not compile: the compiler's words.
    Sources(String),
    /// Cargo builds nothing.
    Build(BuildError),
    /// The fuzzer did not end as it should: its last words.
    Fuzz(String),
    /// What was found shows in the project without the defect as well: the case.
    Sound(PathBuf),
    /// A program cannot be started or a file not be read.
    Io(io::Error),
}

impl fmt::Display for MeasureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MeasureError::Sources(said) => write!(f, "the tree with the defect does not build:\n{said}"),
            MeasureError::Build(error) => error.fmt(f),
            MeasureError::Fuzz(said) => write!(f, "the fuzzer did not end as it should:\n{said}"),
            MeasureError::Sound(case) => {
                write!(f, "what was found shows without the defect too, so nothing is known of it: {}", case.display())
            }
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

impl Bench {
    /// Builds the command as it stands in the copy.
    ///
    /// # Errors
    ///
    /// It does not build.
    pub fn build(&self, tree: &ScratchTree) -> Result<(), MeasureError> {
        match twinrung_mutants::build(tree.root(), &self.words()) {
            Ok(built) if built.words.is_empty() => Ok(()),
            Ok(built) => Err(MeasureError::Sources(built.words.join("\n"))),
            Err(error) => Err(MeasureError::Build(error)),
        }
    }

    /// What cargo is told, to build the command.
    pub fn words(&self) -> Vec<String> {
        let folder = self.folder.join("build").display().to_string();
        let words = [
            "build",
            "--quiet",
            "--profile",
            "defects",
            "--package",
            "twinrung",
            "--bin",
            "twinrung",
            "--target-dir",
            &folder,
        ];
        words.map(str::to_owned).to_vec()
    }

    /// Keeps the command that was built last as that of the project without a defect.
    ///
    /// # Errors
    ///
    /// It cannot be copied.
    pub fn keep_sound(&self) -> Result<(), MeasureError> {
        fs::copy(self.built(), self.sound())?;
        Ok(())
    }

    /// Runs the fuzzer that was built last. What it finds must not show in the project without the defect.
    ///
    /// # Errors
    ///
    /// It cannot be run, or ends otherwise than with its verdict, or found something that is not the defect.
    pub fn run(&self) -> Result<(Measured, Conditions), MeasureError> {
        let (report, cases) = (self.folder.join("report.json"), self.folder.join("cases"));
        match fs::remove_file(&report) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error.into()),
            _ => {}
        }
        let mut command = Command::new(self.built());
        command.args(["fuzz", "--differences", "1", "--as-found", "--seed", &self.seed.to_string()]);
        command.args(["--jobs", &self.jobs.to_string(), "--time", &format!("{}s", self.limit_s)]);
        command.env(SWITCH, self.switch.to_string());
        command.arg("--cases").arg(&cases).arg("--report").arg(&report);
        if self.plain {
            command.arg("--plain");
        }
        let said = ended(command, Duration::from_secs(u64::from(self.limit_s) + GRACE_S))?;
        let report: Report = fs::read(&report)
            .ok()
            .and_then(|bytes| serde_json::from_slice(&bytes).ok())
            .ok_or_else(|| MeasureError::Fuzz(last_lines(&said)))?;
        let Provenance { version, rustc, processor, cores, .. } =
            report.runs.into_iter().next().map(|run| run.provenance).unwrap_or_default();
        let (rustc, processor) = (rustc.unwrap_or_default(), processor.unwrap_or_default());
        let Bench { jobs, limit_s, seed, .. } = *self;
        let conditions =
            Conditions { jobs, limit_s, seed, version, rustc, processor, cores: cores.unwrap_or_default() };
        let Some(first) = report.differences.first() else {
            return Ok((Measured { found: false, seconds: report.seconds, cases: report.programs }, conditions));
        };
        let case = cases.join(format!("case-{}.rll", first.program));
        let mut again = Command::new(self.sound());
        again.args(["fuzz", "--replay"]).arg(&case);
        if !again.stdin(Stdio::null()).output()?.status.success() {
            return Err(MeasureError::Sound(case));
        }
        Ok((Measured { found: true, seconds: first.after_seconds, cases: first.after_programs }, conditions))
    }

    fn built(&self) -> PathBuf {
        self.folder.join("build/defects/twinrung")
    }

    fn sound(&self) -> PathBuf {
        self.folder.join("twinrung-without-a-defect")
    }
}

/// Seconds beyond the limit after which the fuzzer is taken to hang: a defect may keep an interpreter from ever ending.
const GRACE_S: u64 = 60;

/// What a program said on its standard error until it ended, or was ended.
fn ended(mut command: Command, limit: Duration) -> Result<Vec<u8>, MeasureError> {
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn()?;
    let mut errors = child.stderr.take();
    let reader = thread::spawn(move || {
        let mut said = Vec::new();
        let read = errors.as_mut().map_or(Ok(0), |errors| errors.read_to_end(&mut said));
        read.map(|_| said)
    });
    let begun = Instant::now();
    while child.try_wait()?.is_none() {
        if begun.elapsed() > limit {
            child.kill()?;
            child.wait()?;
            return Err(MeasureError::Fuzz(format!("it did not end within {} s", limit.as_secs())));
        }
        thread::sleep(Duration::from_millis(50));
    }
    Ok(reader.join().unwrap_or_else(|_| Ok(Vec::new()))?)
}

/// The last lines that a program said.
fn last_lines(said: &[u8]) -> String {
    let said = String::from_utf8_lossy(said);
    let lines: Vec<&str> = said.lines().collect();
    lines[lines.len().saturating_sub(12)..].join("\n")
}
