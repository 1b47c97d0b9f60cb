//! One scenario on both channels.

use std::cell::Cell;

use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::observer::Silent;
use twinrung_bytecode::{AdmittedImage, CellRange};
use twinrung_controller::{Controller, Mode, ScanReport, StopReason};
use twinrung_grammar::tree::Span;
use twinrung_grammar::tree::scenario::Mode as Switch;
use twinrung_plant::Plant;

use super::judge::{Judge, State};
use super::value::Place;
use super::{Change, Scenario};
use crate::RunError;
use crate::coverage::{Coverage, Watch};
use crate::drive::cells;
use crate::signal::{ReadSignal, Signal, Value};
use crate::site::plant;

/// What came of a scenario.
#[derive(Debug, Clone)]
pub struct Played {
    /// Its name.
    pub name: String,
    /// Where its name stands.
    pub span: Span,
    /// Scans that were passed.
    pub scans: u64,
    /// Time of the last one in ms.
    pub end_ms: u64,
    /// Expectations.
    pub expectations: usize,
    /// What was not met, in order of time; nothing where all was.
    pub failures: Vec<Failure>,
    /// The time in ms at which the controller stopped, and why.
    pub stopped: Option<(u64, StopReason)>,
}

/// Something that was not met.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    /// Which expectation; nothing for a stop that none expected.
    pub expectation: Option<usize>,
    /// What was expected, as written.
    pub expected: String,
    /// Where that stands.
    pub span: Span,
    /// What was found.
    pub found: String,
    /// The time in ms of the scan that shows it.
    pub at_ms: u64,
}

/// A controller on which a scenario is played.
pub(super) struct Stage<'s, A: Channel, B: Channel> {
    pub controller: Controller<A, B>,
    scenario: &'s Scenario,
    frozen: Vec<CellRange>,
    bits: Vec<bool>,
    words: Vec<i32>,
    next: usize,
    /// The simulated modules, where the scenario is played at their terminals.
    plant: Plant,
    /// The period in ms.
    pub period_ms: u64,
}

impl<'s, A: Channel, B: Channel> Stage<'s, A, B> {
    /// Powers a controller up.
    pub fn new(image: &AdmittedImage, bytes: &[u8], scenario: &'s Scenario) -> Result<Stage<'s, A, B>, RunError> {
        let period_us = image.image().task.as_ref().ok_or(RunError::NoTask)?.period_us;
        if !period_us.is_multiple_of(1000) || period_us == 0 {
            return Err(RunError::Period(period_us));
        }
        let mut controller: Controller<A, B> =
            Controller::load(image.clone(), bytes).map_err(|error| RunError::Load(error.to_string()))?;
        if scenario.power_up == Switch::Run {
            controller.power_up_in_run();
        }
        let mut frozen = image.frozen().to_vec();
        for action in &scenario.actions {
            if let Change::Drive { signal, .. } = &action.change
                && let Some(range) = cells(*signal)
                && !frozen.contains(&range)
            {
                controller.freeze_also(range);
                frozen.push(range);
            }
        }
        let records = image.image();
        Ok(Stage {
            controller,
            scenario,
            frozen,
            bits: records.initial_bits.iter().map(|bit| *bit == 1).collect(),
            words: records.initial_words.clone(),
            next: 0,
            plant: plant(&scenario.sites),
            period_ms: u64::from(period_us / 1000),
        })
    }

    /// Everything up to and including the scan that begins at `time_ms`.
    pub fn scan(&mut self, time_ms: u64, scanning: &Cell<bool>, watch: &mut Watch<'_>) -> ScanReport {
        while let Some(action) = self.scenario.actions.get(self.next).filter(|action| action.at_ms <= time_ms) {
            self.next += 1;
            match action.change {
                Change::Mode(mode) => {
                    let mode = if mode == Switch::Run { Mode::Run } else { Mode::Program };
                    self.controller.request_mode(mode);
                }
                Change::Drive { signal, content, .. } => self.drive(signal, content),
                Change::Plant { module, stimulus } => self.plant.apply(module, &stimulus, action.at_ms),
            }
        }
        self.follow_terminals(time_ms);
        watch.freeze(&self.frozen, &self.bits, &self.words);
        let mut clock = crate::coverage::Begins(scanning);
        let report = self.controller.scan_observed(time_ms as i64, &mut clock, watch, &mut Silent);
        watch.scanned(&self.controller, report.executed);
        self.command_modules();
        report
    }

    /// The tags of simulated modules get what arrived from them up to a time in ms.
    fn follow_terminals(&mut self, time_ms: u64) {
        let scenario = self.scenario;
        if scenario.sites.is_empty() {
            return;
        }
        self.plant.through(time_ms);
        for (position, site) in scenario.sites.iter().enumerate() {
            let values: Vec<i32> =
                self.plant.stations().get(position).map_or_else(Vec::new, |one| one.values().collect());
            for ((_, signal), content) in site.inputs.iter().zip(values) {
                self.drive(*signal, content);
            }
        }
    }

    /// Simulated modules get what the scan has published: an output connection carries a packet for each period.
    fn command_modules(&mut self) {
        let Stage { scenario, plant, controller, .. } = self;
        for (position, site) in scenario.sites.iter().enumerate() {
            if !site.outputs.is_empty() {
                plant.receive(position, site.outputs.iter().map(|signal| signal.read(controller).is_true()));
            }
        }
    }

    /// What is looked at.
    pub fn value(&self, place: Place) -> Value {
        match place {
            Place::Signal(signal) => signal.read(&self.controller),
            Place::Terminal(position, terminal) => {
                let station = self.plant.stations().get(position);
                Value::Bool(station.and_then(|station| station.is_high(terminal)).unwrap_or_default())
            }
        }
    }

    fn drive(&mut self, signal: Signal, content: i32) {
        match signal {
            Signal::Bit(cell) => {
                if let Some(bit) = self.bits.get_mut(cell.position()) {
                    *bit = content != 0;
                }
                self.controller.drive_bit(cell, content != 0);
            }
            Signal::Word(cell, _) | Signal::WordBit(cell, _) => {
                let Some(word) = self.words.get_mut(cell.position()) else { return };
                *word = match signal {
                    Signal::WordBit(_, bit) if content != 0 => *word | (1 << bit.min(31)),
                    Signal::WordBit(_, bit) => *word & !(1 << bit.min(31)),
                    _ => content,
                };
                self.controller.drive_word(cell, *word);
            }
            // The plan drives cells only.
            _ => {}
        }
    }
}

/// Plays a scenario from power-up to its end, adds what it shows to the coverage, and says what was not met.
///
/// # Errors
///
/// An image without a safety task, or with a period that is no whole number of ms, or that a channel cannot load.
pub fn play<A: Channel, B: Channel>(
    image: &AdmittedImage,
    bytes: &[u8],
    scenario: &Scenario,
    coverage: &mut Coverage,
) -> Result<Played, RunError> {
    let mut stage: Stage<'_, A, B> = Stage::new(image, bytes, scenario)?;
    let scanning = Cell::new(false);
    let mut watch = Watch::new(coverage, &stage.controller, &scanning, false);
    let mut judge = Judge::new(&scenario.expectations, stage.period_ms);
    let mut stopped = None;
    let (mut time_ms, mut scans) = (0, 0);
    while time_ms <= scenario.end_ms {
        let report = stage.scan(time_ms, &scanning, &mut watch);
        if let (Some(reason), None) = (report.stopped, stopped) {
            stopped = Some((time_ms, reason));
        }
        judge.look(&stage, time_ms);
        scans += 1;
        time_ms += stage.period_ms;
    }
    let mut failures = failures(scenario, &judge);
    if let (Some((at_ms, reason)), false) = (stopped, judge.expects_stop()) {
        failures.push(unexpected_stop(image, scenario, at_ms, reason));
    }
    failures.sort_by_key(|failure| failure.at_ms);
    Ok(Played {
        name: scenario.name.clone(),
        span: scenario.span,
        scans,
        end_ms: time_ms.saturating_sub(stage.period_ms),
        expectations: scenario.expectations.len(),
        failures,
        stopped,
    })
}

fn failures(scenario: &Scenario, judge: &Judge<'_>) -> Vec<Failure> {
    let states = scenario.expectations.iter().zip(judge.states()).enumerate();
    states
        .filter_map(|(position, (expectation, state))| match state {
            State::NotMet { at_ms, found } => Some(Failure {
                expectation: Some(position),
                expected: expectation.text.clone(),
                span: expectation.span,
                found: found.clone(),
                at_ms: *at_ms,
            }),
            // A `never` is met when its time ran out without it; anything else has its last scan within the scenario.
            State::Open | State::Met => None,
        })
        .collect()
}

fn unexpected_stop(image: &AdmittedImage, scenario: &Scenario, at_ms: u64, reason: StopReason) -> Failure {
    let (fault_type, code) = reason.type_and_code();
    let words = match reason {
        StopReason::Safety(twinrung_controller::SafetyFault::Difference(found)) => {
            crate::difference::words(image, found)
        }
        StopReason::Recoverable(fault) => format!("major fault 4/{}", fault.code),
        StopReason::Safety(other) => format!("{other:?}"),
        StopReason::PartnershipLost => "the partnership is lost".to_owned(),
    };
    Failure {
        expectation: None,
        expected: "the controller runs to the end".to_owned(),
        span: scenario.span,
        found: format!("it stopped with fault {fault_type}/{code}: {words}"),
        at_ms,
    }
}
