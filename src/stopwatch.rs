//! What is measured, on what, and how long that takes.

use std::ffi::OsStr;
use std::fs;
use std::time::{Duration, Instant};

use jiff::{Timestamp, Unit};
use twinrung_workbench::provenance::Provenance;

/// Runs since a measurement began.
pub struct Stopwatch {
    begun: Timestamp,
    elapsed: Instant,
    processor: Option<Duration>,
}

impl Stopwatch {
    /// A measurement begins.
    pub fn start() -> Stopwatch {
        Stopwatch { begun: Timestamp::now(), elapsed: Instant::now(), processor: processor_time() }
    }

    /// It has ended, after running on so many threads.
    pub fn provenance(&self, jobs: usize) -> Provenance {
        let said = |text: &str| Some(text.to_owned()).filter(|text| !text.is_empty());
        let used = self.processor.zip(processor_time()).map(|(before, now)| now.saturating_sub(before));
        Provenance {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            // Told by who builds a release, since a build cannot see whether what it builds is what was committed.
            commit: option_env!("TWINRUNG_COMMIT").and_then(said),
            rustc: said(env!("TWINRUNG_RUSTC")),
            processor: processor_name(),
            cores: std::thread::available_parallelism().ok().map(usize::from),
            system: Some(format!("{} {}", std::env::consts::OS, std::env::consts::ARCH)),
            begun: self.begun.round(Unit::Second).ok().map(|begun| begun.to_string()),
            command: Some(command()),
            jobs,
            seconds: self.elapsed.elapsed().as_secs_f64(),
            processor_seconds: used.map(|used| used.as_secs_f64()),
        }
    }
}

/// The command as it was given, so that it can be given again.
fn command() -> String {
    let words: Vec<String> =
        std::iter::once("twinrung".to_owned()).chain(std::env::args_os().skip(1).map(|word| quoted(&word))).collect();
    words.join(" ")
}

/// A word as a shell takes it for one.
pub fn quoted(word: &OsStr) -> String {
    let word = word.to_string_lossy().into_owned();
    let is_plain = |one: char| one.is_ascii_alphanumeric() || "-_./,:=@%+".contains(one);
    if word.chars().all(is_plain) && !word.is_empty() { word } else { format!("'{}'", word.replace('\'', "'\\''")) }
}

/// Where the system says it in a file.
fn processor_name() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// Processor time that this process has used, all threads together.
#[cfg(unix)]
fn processor_time() -> Option<Duration> {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Some(Duration::new(u64::try_from(time.tv_sec).ok()?, u32::try_from(time.tv_nsec).ok()?))
}

/// Processor time that this process has used, all threads together.
#[cfg(not(unix))]
fn processor_time() -> Option<Duration> {
    None
}
