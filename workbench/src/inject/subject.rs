//! The project that is disturbed: its image, its inputs, and its run when nothing is wrong.

use std::fmt;
use std::sync::Arc;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_bytecode::injection::{Injectable, Memory};
use twinrung_bytecode::observer::Silent;
use twinrung_controller::{Controller, SharedMemory, Side, StopReason};

use crate::drive::{Drive, cells};
use crate::names;
use crate::run::RunError;
use crate::stimulus::Stimulus;

use super::channel::Disturbed;
use super::clock::Clock;
use super::upset::{Places, Upsetter};

/// Why there is nothing to disturb.
#[derive(Debug, Clone, PartialEq)]
pub enum SubjectError {
    /// It cannot be run.
    Run(RunError),
    /// It publishes nothing that a fault could make wrong.
    NothingPublished,
    /// It stops before its second scan.
    Stops,
}

impl fmt::Display for SubjectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SubjectError::Run(error) => write!(f, "{error}"),
            SubjectError::NothingPublished => f.write_str(
                "the project publishes nothing that a fault could make wrong: name its outputs with --outputs",
            ),
            SubjectError::Stops => f.write_str("the project stops before its second scan"),
        }
    }
}

impl std::error::Error for SubjectError {}

impl<E: Into<RunError>> From<E> for SubjectError {
    fn from(error: E) -> SubjectError {
        SubjectError::Run(error.into())
    }
}

/// A controller between two scans, with all that it needs to go on.
pub(super) struct State<A: Injectable, B: Injectable> {
    pub(super) controller: Controller<Disturbed<A>, Disturbed<B>>,
    pub(super) drive: Drive,
    pub(super) clock: Clock,
}

impl<A: Injectable, B: Injectable> Clone for State<A, B> {
    fn clone(&self) -> Self {
        State { controller: self.controller.clone(), drive: self.drive.clone(), clock: self.clock.clone() }
    }
}

/// A scan of the undisturbed run.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Golden {
    /// What was published at its end.
    pub(super) outputs: Outputs,
    /// Why the task had stopped by then, if it had.
    pub(super) stopped: Option<StopReason>,
    /// What an upset could strike in each channel.
    pub(super) places: [Places; 2],
}

/// Published values: those of BOOLs, then those of numbers.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Outputs {
    pub(super) bits: Vec<bool>,
    pub(super) words: Vec<i32>,
}

/// A project with its inputs.
pub struct Subject<A: Injectable, B: Injectable> {
    pub(super) bytes: Vec<u8>,
    pub(super) period_ms: i64,
    /// Rungs of each routine.
    pub(super) rungs: Arc<[u32]>,
    pub(super) golden: Vec<Golden>,
    /// Bits of each memory of each channel.
    pub(super) memory_bits: [[u64; 3]; 2],
    /// Bits of what both share, of one half.
    pub(super) shared_bits: [u64; 9],
    /// Inputs of which the stimulus drives one bit.
    pub(super) wires: Vec<BitCell>,
    published_bits: Vec<BitCell>,
    published_words: Vec<WordCell>,
    start: State<A, B>,
}

impl<A: Injectable, B: Injectable> Subject<A, B> {
    /// Loads a project, takes on its stimulus and the names that it publishes besides, and runs it undisturbed for at most so
    /// many scans.
    ///
    /// # Errors
    ///
    /// What cannot be run, publishes nothing, or stops before its second scan.
    pub fn new(
        image: &AdmittedImage,
        bytes: &[u8],
        stimulus: &Stimulus,
        outputs: &[String],
        scans: u32,
    ) -> Result<Subject<A, B>, SubjectError> {
        let period_us = image.image().task.as_ref().ok_or(RunError::NoTask)?.period_us;
        if !period_us.is_multiple_of(1000) {
            return Err(RunError::Period(period_us).into());
        }
        let period_ms = i64::from(period_us / 1000);
        let loaded = Controller::load(image.clone(), bytes);
        let mut controller = loaded.map_err(|error| RunError::Load(error.to_string()))?;
        controller.power_up_in_run();
        let mut published: Vec<_> = image.published().to_vec();
        for name in outputs {
            if let Some(range) = cells(names::signal(image, name).map_err(RunError::Signal)?) {
                controller.publish_also(range);
                published.push(range);
            }
        }
        let drive = Drive::new(&mut controller, stimulus)?;
        let bits = published.iter().flat_map(|range| range.bit_cell..range.bit_cell + range.bit_cells);
        let words = published.iter().flat_map(|range| range.word_cell..range.word_cell + range.word_cells);
        let (bits, words) = (bits.map(BitCell).collect::<Vec<_>>(), words.map(WordCell).collect::<Vec<_>>());
        if bits.is_empty() && words.is_empty() {
            return Err(SubjectError::NothingPublished);
        }
        let wires = stimulus.tags.iter().filter_map(|tag| match names::driven(image, tag) {
            Ok(crate::Signal::Bit(cell)) => Some(cell),
            _ => None,
        });
        let mut subject = Subject {
            bytes: bytes.to_vec(),
            period_ms,
            rungs: image.rung_counts().into(),
            golden: Vec::new(),
            memory_bits: [[0; 3]; 2],
            shared_bits: [0; 9],
            wires: wires.collect(),
            published_bits: bits,
            published_words: words,
            start: State { controller, drive, clock: Clock::new(period_ms) },
        };
        subject.run(scans)?;
        Ok(subject)
    }

    /// The run when nothing is wrong: once observed, for the places that an upset could strike, and once as it will be.
    fn run(&mut self, scans: u32) -> Result<(), SubjectError> {
        let mut observed = self.start.clone();
        let mut state = self.start.clone();
        for scan in 0..scans {
            let mut upsetters = [Upsetter::counting(self.rungs.clone()), Upsetter::counting(self.rungs.clone())];
            let [first, second] = &mut upsetters;
            let now_ms = observed.drive(scan, self.period_ms);
            observed.controller.scan_observed(now_ms, &mut observed.clock, first, second);
            let stopped = self.step(&mut state, scan);
            let places = upsetters.map(|upsetter| upsetter.places());
            self.golden.push(Golden { outputs: self.outputs(&state.controller), stopped, places });
            if stopped.is_some() {
                break;
            }
        }
        if self.golden.iter().filter(|golden| golden.stopped.is_none()).count() < 2 {
            return Err(SubjectError::Stops);
        }
        let (primary, partner) = state.controller.channels_mut();
        self.memory_bits = [
            Memory::ALL.map(|memory| primary.memory_bits(memory)),
            Memory::ALL.map(|memory| partner.memory_bits(memory)),
        ];
        self.shared_bits = SharedMemory::ALL.map(|memory| state.controller.shared().bits(Side::Primary, memory));
        Ok(())
    }

    /// One undisturbed scan.
    pub(super) fn step(&self, state: &mut State<A, B>, scan: u32) -> Option<StopReason> {
        let now_ms = state.drive(scan, self.period_ms);
        state.controller.scan_observed(now_ms, &mut state.clock, &mut Silent, &mut Silent).stopped
    }

    /// Before the first scan.
    pub(super) fn start(&self) -> State<A, B> {
        self.start.clone()
    }

    /// Scans that a fault can be injected in: those of the undisturbed run that executed.
    pub fn scans(&self) -> u32 {
        self.golden.iter().filter(|golden| golden.stopped.is_none()).count() as u32
    }

    /// What is published.
    pub(super) fn outputs<C: Channel, D: Channel>(&self, controller: &Controller<C, D>) -> Outputs {
        let bit = |cell: &BitCell| controller.published_bit(*cell).unwrap_or_default();
        let word = |cell: &WordCell| controller.published_word(*cell).unwrap_or_default();
        Outputs {
            bits: self.published_bits.iter().map(bit).collect(),
            words: self.published_words.iter().map(word).collect(),
        }
    }
}

impl<A: Injectable, B: Injectable> State<A, B> {
    /// Drives the inputs for a scan; its time.
    pub(super) fn drive(&mut self, scan: u32, period_ms: i64) -> i64 {
        let now_ms = i64::from(scan) * period_ms;
        self.drive.until(&mut self.controller, now_ms as u64);
        now_ms
    }
}

impl Outputs {
    /// Whether something is let out that is neither right nor off.
    pub(super) fn is_wrong(&self, golden: &Outputs) -> bool {
        self.bits.iter().zip(&golden.bits).any(|(found, right)| *found && !right)
            || self.words.iter().zip(&golden.words).any(|(found, right)| *found != 0 && found != right)
    }
}
