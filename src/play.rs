//! Scans with a stimulus, as every verb that plays one does them: the end, the timing diagram, the recording, what became of it.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Args;
use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::{Channel, MajorFault, Place};
use twinrung_bytecode::image::Image;
use twinrung_controller::StopReason;
use twinrung_primary::Primary;
use twinrung_workbench::both_versions::own_rung;
use twinrung_workbench::diagram::{self, Style};
use twinrung_workbench::recording::Recording;
use twinrung_workbench::{Outcome, Run as Session, Stimulus, difference};

use crate::progress::with_progress;
use crate::terminal::Terminal;
use crate::{exit, failed, files, input};

/// Rows of a diagram that was not asked for name by name.
pub const DIAGRAM_ROWS: usize = 40;
/// Periods that a run goes on after the last row of its stimulus.
const PERIODS_AFTER_STIMULUS: u64 = 10;
/// The latest end of a run in ms: time stamps have room for it, and nobody waits for it.
const UNTIL_MS_MAX: u64 = 1_000_000_000_000;

/// How long, and where to.
#[derive(Debug, Args)]
pub struct Playing {
    /// Where to write the recording
    #[arg(long, value_name = "CSV")]
    out: Option<PathBuf>,
    /// Time of the last scan in ms; without it some periods after the stimulus's last row
    #[arg(long, value_name = "MS", value_parser = clap::value_parser!(u64).range(..=UNTIL_MS_MAX))]
    until: Option<u64>,
    /// Draw no timing diagram
    #[arg(long)]
    quiet: bool,
}

/// What was played.
pub struct Played {
    outcome: Outcome,
    took: Duration,
}

impl Playing {
    /// Records `names` under a stimulus until the end that was asked for.
    pub fn play<B: Channel>(
        &self,
        session: &mut Session<Primary, B>,
        stimulus: Option<&Stimulus>,
        names: &[String],
    ) -> io::Result<Played> {
        if let Some(stimulus) = stimulus {
            session.stimulate(stimulus).map_err(failed)?;
        }
        session.record(names).map_err(failed)?;
        let period_ms = session.period_ms();
        let until_ms =
            self.until.unwrap_or_else(|| stimulus.map_or(0, Stimulus::last_ms) + PERIODS_AFTER_STIMULUS * period_ms);
        let begun = Instant::now();
        let outcome = with_progress(until_ms / period_ms + 1, |progress| session.until(until_ms, progress));
        Ok(Played { outcome, took: begun.elapsed() })
    }

    /// Draws the diagram under a heading, writes the recording, and says how it ended.
    pub fn show<B: Channel>(
        &self,
        out: &mut dyn Write,
        session: &mut Session<Primary, B>,
        played: &Played,
        heading: &str,
    ) -> io::Result<ExitCode> {
        if !self.quiet {
            writeln!(out, "{heading}\n")?;
            draw(out, session.recording())?;
        }
        if let Some(path) = &self.out {
            write(out, session.recording(), path)?;
        }
        played.report(out, session.controller().image())
    }
}

/// Draws the timing diagram.
pub fn draw(out: &mut dyn Write, recording: &Recording) -> io::Result<()> {
    let terminal = Terminal::of_stdout();
    let style = Style { columns: terminal.columns, colour: terminal.colour };
    out.write_all(diagram::draw(recording, style).as_bytes())?;
    writeln!(out)
}

/// Writes the recording to a file, and says so.
pub fn write(out: &mut dyn Write, recording: &Recording, path: &Path) -> io::Result<()> {
    files::write_whole(path, recording.to_csv().as_bytes())?;
    writeln!(out, "wrote {} ({} rows)", path.display(), recording.rows.len())
}

impl Played {
    /// When the last scan was in which the task executed, in ms: the last of all, or that in which it stopped.
    pub fn executed_until_ms(&self, period_ms: u64) -> Option<u64> {
        let last = self.outcome.scans.checked_sub(1)?.saturating_mul(period_ms);
        Some(self.stopped().map_or(last, |(at_ms, _)| at_ms))
    }

    /// When and why the task stopped, if it did.
    pub fn stopped(&self) -> Option<(u64, StopReason)> {
        self.outcome.stopped.map(|(_, at_ms, reason)| (at_ms, reason))
    }

    fn report(&self, out: &mut dyn Write, image: &AdmittedImage) -> io::Result<ExitCode> {
        let code = exit::of_scans(self.stopped().map(|(_, reason)| reason));
        let Some((scan, time_ms, reason)) = self.outcome.stopped else {
            writeln!(
                out,
                "{} scans, no difference between the channels; at most {} instructions in a scan; took {} ms",
                self.outcome.scans,
                self.outcome.instructions_max,
                self.took.as_millis()
            )?;
            return Ok(code);
        };
        let (fault_type, fault_code) = reason.type_and_code();
        writeln!(
            out,
            "stopped in scan {scan} at {time_ms} ms, outputs off: fault {fault_type}/{fault_code}, {}",
            explained(image, reason)
        )?;
        Ok(code)
    }
}

/// Why the task stopped, in words.
pub fn explained(image: &AdmittedImage, reason: StopReason) -> String {
    match reason {
        StopReason::Safety(fault) => difference::fault_words(image, fault),
        StopReason::PartnershipLost => "the partnership of primary and safety partner is lost".to_owned(),
        StopReason::Recoverable(MajorFault { code, place }) => {
            format!("major fault 4/{code} at {}", place_words(image.image(), place))
        }
    }
}

fn place_words(image: &Image, place: Place) -> String {
    let program = image.programs.get(place.program.position()).map_or("?", |program| program.name.as_str());
    let routine = image.routines.get(place.routine.position());
    let (name, text) = routine.map_or(("?", ""), |routine| (routine.name.as_str(), routine.text.as_str()));
    format!("{program}/{name}, {}, instruction {}", rung_words(text, place.rung as usize), place.element)
}

/// A rung by the number that a person finds it by, also while both versions of an online edit stand in its routine.
fn rung_words(text: &str, rung: usize) -> String {
    let own = own_rung(text, rung);
    match (own.original, own.changed) {
        (Some(original), Some(changed)) if original == changed => format!("rung {original}"),
        (Some(original), Some(changed)) => format!("rung {original} ({changed} of the changed project)"),
        (Some(original), None) => format!("rung {original} of the original rungs"),
        (None, Some(changed)) => format!("rung {changed} of the changed rungs"),
        (None, None) => "between the original and the changed rungs".to_owned(),
    }
}

/// The names of `TAG,TAG`, or those of the file of `@FILE`, one on each line.
pub fn listed(list: &str) -> io::Result<Vec<String>> {
    let Some(path) = list.strip_prefix('@') else { return Ok(split_names(list)) };
    let text = input::text(Path::new(path))?;
    Ok(text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
        .map(str::to_owned)
        .collect())
}

/// Splits at commas outside brackets: `Levels[1,2],Motor` is two names.
fn split_names(list: &str) -> Vec<String> {
    let mut names = vec![String::new()];
    let mut depth = 0_usize;
    for character in list.chars() {
        match character {
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if character == ',' && depth == 0 {
            names.push(String::new());
        } else if let Some(name) = names.last_mut() {
            name.push(character);
        }
    }
    names.into_iter().map(|name| name.trim().to_owned()).filter(|name| !name.is_empty()).collect()
}
