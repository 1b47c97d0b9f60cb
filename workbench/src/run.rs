//! A run: a controller, a stimulus, a recording. The same stimulus gives the same recording on every machine.

use std::fmt;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::index::TagIndex;
use twinrung_bytecode::observer::Silent;
use twinrung_controller::{Controller, Mode, Simulated, StopReason};

use crate::drive::{Drive, cells};
use crate::hold::{Hold, Holds};
use crate::names;
use crate::recording::{Recording, Row};
use crate::signal::{Signal, SignalError};
use crate::stimulus::Stimulus;

/// Why a run cannot begin.
#[derive(Debug, Clone, PartialEq)]
pub enum RunError {
    /// A name of the stimulus or the recording.
    Signal(SignalError),
    /// A cell of the stimulus.
    Cell {
        /// Line in the file, from 1.
        line: u64,
        /// What is wrong with it.
        error: SignalError,
    },
    /// The image has no safety task.
    NoTask,
    /// A channel could not load the image.
    Load(String),
    /// The period is not a whole number of milliseconds.
    Period(u32),
    /// More scans than a measurement can have.
    Scans(u64),
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RunError::Signal(error) => write!(f, "{error}"),
            RunError::Cell { line, error } => write!(f, "line {line}: {error}"),
            RunError::NoTask => f.write_str("the image has no safety task"),
            RunError::Load(error) => f.write_str(error),
            RunError::Scans(scans) => {
                write!(f, "{scans} scans are more than a measurement can have: {}", crate::bench::SCANS_MAX)
            }
            RunError::Period(period_us) => {
                write!(f, "a period of {period_us} us is not a whole number of milliseconds")
            }
        }
    }
}

impl std::error::Error for RunError {}

impl From<SignalError> for RunError {
    fn from(error: SignalError) -> RunError {
        RunError::Signal(error)
    }
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// Scan boundaries that passed.
    pub scans: u64,
    /// The scan (from 0) in which the safety task stopped, its time in ms, and why.
    pub stopped: Option<(u64, u64, StopReason)>,
    /// Most instructions that one channel executed in a scan.
    pub instructions_max: u64,
}

/// A controller with a stimulus and a recording, ready to run.
pub struct Run<A: Channel, B: Channel> {
    controller: Controller<A, B>,
    drive: Drive,
    holds: Holds,
    clock: Simulated,
    signals: Vec<Signal>,
    recording: Recording,
    period_ms: u64,
    outcome: Outcome,
}

impl<A: Channel, B: Channel> Run<A, B> {
    /// Loads an admitted image into both channels, powered up with the mode switch in Run. `bytes` are the sealed bytes that were admitted.
    pub fn new(image: AdmittedImage, bytes: &[u8]) -> Result<Run<A, B>, RunError> {
        Run::in_mode(image, bytes, Mode::Run)
    }

    /// The same in a mode of choice.
    pub fn in_mode(image: AdmittedImage, bytes: &[u8], mode: Mode) -> Result<Run<A, B>, RunError> {
        let (controller, period_ms) = powered_up(image, bytes, mode)?;
        Ok(Run {
            controller,
            drive: Drive::default(),
            clock: Simulated::new(period_ms as i64),
            holds: Holds::default(),
            signals: Vec::new(),
            recording: Recording::default(),
            period_ms,
            outcome: Outcome { scans: 0, stopped: None, instructions_max: 0 },
        })
    }

    /// Holds a value from now on: one that comes in before the logic, one that goes out behind it.
    pub fn hold(&mut self, one: Hold) {
        self.holds.add(one);
    }

    /// The controller.
    pub fn controller(&mut self) -> &mut Controller<A, B> {
        &mut self.controller
    }

    /// The period in ms.
    pub fn period_ms(&self) -> u64 {
        self.period_ms
    }

    /// Takes on a stimulus.
    pub fn stimulate(&mut self, stimulus: &Stimulus) -> Result<(), RunError> {
        self.drive = Drive::new(&mut self.controller, stimulus)?;
        Ok(())
    }

    /// Takes on the names to record.
    pub fn record(&mut self, names: &[String]) -> Result<(), RunError> {
        let image = self.controller.image();
        self.signals = names.iter().map(|name| names::signal(image, name)).collect::<Result<_, _>>()?;
        self.recording = Recording { names: names.to_vec(), rows: Vec::new() };
        Ok(())
    }

    /// Adds tags to those that are published.
    pub fn publish_also(&mut self, names: &[String]) -> Result<(), RunError> {
        for name in names {
            let signal = names::signal(self.controller.image(), name)?;
            if let Some(range) = cells(signal) {
                self.controller.publish_also(range);
            }
        }
        Ok(())
    }

    /// Passes scan boundaries at 0, period, 2 x period, ... up to and including `until_ms`. `progress` is told after each
    /// scan how many there were.
    pub fn until(&mut self, until_ms: u64, mut progress: impl FnMut(u64)) -> Outcome {
        let mut time_ms = self.outcome.scans.saturating_mul(self.period_ms);
        while time_ms <= until_ms {
            self.drive.until(&mut self.controller, time_ms);
            self.holds.drive(&mut self.controller);
            let report = self.controller.scan_observed(time_ms as i64, &mut self.clock, &mut Silent, &mut Silent);
            if let (Some(reason), None) = (report.stopped, self.outcome.stopped) {
                self.outcome.stopped = Some((self.outcome.scans, time_ms, reason));
            }
            self.outcome.instructions_max = self.outcome.instructions_max.max(report.instructions);
            if !self.signals.is_empty() {
                let values = self.signals.iter().map(|signal| self.holds.read(*signal, &self.controller)).collect();
                self.recording.rows.push(Row { time_ms, values });
            }
            self.outcome.scans += 1;
            progress(self.outcome.scans);
            time_ms += self.period_ms;
        }
        self.outcome
    }

    /// What was recorded so far.
    pub fn recording(&self) -> &Recording {
        &self.recording
    }
}

/// A controller with an admitted image, powered up in a mode, and its period in ms.
pub(crate) fn powered_up<A: Channel, B: Channel>(
    image: AdmittedImage,
    bytes: &[u8],
    mode: Mode,
) -> Result<(Controller<A, B>, u64), RunError> {
    let period_us = image.image().task.as_ref().ok_or(RunError::NoTask)?.period_us;
    if !period_us.is_multiple_of(1000) {
        return Err(RunError::Period(period_us));
    }
    let mut controller = Controller::load(image, bytes).map_err(|error| RunError::Load(error.to_string()))?;
    if mode == Mode::Run {
        controller.power_up_in_run();
    }
    Ok((controller, u64::from(period_us / 1000)))
}

/// What is recorded when nobody says: what the stimulus drives, then what is published, then the outputs and codes of safety
/// application instructions; at most `most` names.
pub fn default_names(image: &AdmittedImage, stimulus: Option<&Stimulus>, most: usize) -> Vec<String> {
    use twinrung_bytecode::image::{TypeKind, TypeReference};
    let mut found: Vec<String> = stimulus.map(|stimulus| stimulus.tags.clone()).unwrap_or_default();
    found.retain(|name| names::signal(image, name).is_ok());
    let records = image.image();
    let instructions = records.tags.iter().enumerate().filter(|(_, tag)| match tag.type_reference {
        TypeReference::Structure(index) => records.types.get(index.position()).is_some_and(|record| {
            record.kind == TypeKind::Predefined
                && twinrung_catalog::PredefinedType::by_name(&record.name).is_some_and(|known| known.backs_one_call)
        }),
        TypeReference::Element(_) => false,
    });
    for (_, tag) in instructions {
        for member in ["O1", "O2", "FP", "FaultCode", "DiagnosticCode"] {
            let name = format!("{}.{member}", tag.name);
            if tag.program.is_none() && names::signal(image, &name).is_ok() {
                found.push(name);
            }
        }
    }
    for range in image.published() {
        let written = image.program_writes();
        for (name, signal) in names::values_of(image, range.tag) {
            if matches!(signal, Signal::Bit(cell) if written.has_bit(cell)) {
                found.push(format!("Published:{name}"));
            }
        }
    }
    if found.is_empty() {
        let tags = records.tags.iter().enumerate();
        found = tags
            .flat_map(|(index, _)| names::values_of(image, TagIndex(index as u32)))
            .map(|(name, _)| name)
            .take(most)
            .collect();
    }
    found.truncate(most);
    found
}
