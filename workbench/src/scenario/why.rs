//! Why something was not met: the signals around it, and the rung that decided the tag. A scenario gives the same scans each
//! time, so it is played again and recorded.

use std::cell::Cell;

use serde::Serialize;
use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_plant::Stimulus;

use super::play::{Failure, Stage};
use super::value::{Check, Place};
use super::{Change, Scenario};
use crate::RunError;
use crate::coverage::{Coverage, RungId, Watch};
use crate::names;
use crate::recording::{Recording, Row};
use crate::signal::{ReadSignal, Signal};

/// What a report shows beside a failure.
#[derive(Debug, Clone)]
pub struct Picture {
    /// The scans around it: what is driven, what stands on the rung, what was expected.
    pub recording: Recording,
    /// The rung that decided what was found; nothing where no rung has written it.
    pub decision: Option<Decision>,
}

/// The rung that decided the value of a tag.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Decision {
    /// The tag.
    pub tag: String,
    /// `Program/Routine`.
    pub routine: String,
    /// The rung, from 0.
    pub rung: u32,
    /// Its text.
    pub text: String,
    /// The instructions, by position, at which power ended when it was last evaluated.
    pub blocking: Vec<u32>,
    /// The texts of those.
    pub blocked_by: Vec<String>,
}

/// Signals of one picture.
const SIGNALS_MAX: usize = 24;
/// Scans before the moment of the expectation, and after the one that shows the failure.
const BEFORE: u64 = 10;
const AFTER: u64 = 5;

/// Plays a scenario again up to a failure.
///
/// # Errors
///
/// As [`super::play()`].
pub fn picture<A: Channel, B: Channel>(
    image: &AdmittedImage,
    bytes: &[u8],
    scenario: &Scenario,
    failure: &Failure,
) -> Result<Picture, RunError> {
    let looked_at = looked_at(scenario, failure);
    let decision = decision::<A, B>(image, bytes, scenario, failure, &looked_at)?;
    let from_ms =
        failure.expectation.and_then(|position| scenario.expectations.get(position)).map_or(0, |one| one.from_ms);
    let from_ms = if from_ms > failure.at_ms || failure.at_ms - from_ms > 100_000 { failure.at_ms } else { from_ms };
    let signals = signals(image, scenario, failure, decision.as_ref(), &looked_at);
    let mut stage: Stage<'_, A, B> = Stage::new(image, bytes, scenario)?;
    let (begin_ms, end_ms) = (
        from_ms.saturating_sub(BEFORE * stage.period_ms),
        (failure.at_ms + AFTER * stage.period_ms).min(scenario.end_ms),
    );
    let mut coverage = Coverage::new(image);
    let scanning = Cell::new(false);
    let mut watch = Watch::new(&mut coverage, &stage.controller, &scanning, false);
    let mut rows = Vec::new();
    let mut time_ms = 0;
    while time_ms <= end_ms {
        stage.scan(time_ms, &scanning, &mut watch);
        if time_ms >= begin_ms {
            let values = signals.iter().map(|(_, signal)| signal.read(&stage.controller)).collect();
            rows.push(Row { time_ms, values });
        }
        time_ms += stage.period_ms;
    }
    let names = signals.into_iter().map(|(name, _)| name).collect();
    Ok(Picture { recording: Recording { names, rows }, decision })
}

/// What was looked at in the controller; a terminal is shown by the tags that follow it.
fn looked_at(scenario: &Scenario, failure: &Failure) -> Vec<(String, Signal)> {
    let expectation = failure.expectation.and_then(|position| scenario.expectations.get(position));
    let checks = expectation.map_or(&[][..], |expectation| expectation.kind.checks());
    let signal = |check: &Check| match check.place {
        Place::Signal(signal) => Some((check.name.clone(), signal)),
        Place::Terminal(..) => None,
    };
    checks.iter().filter_map(signal).collect()
}

/// The rung that wrote the first tag that was looked at.
fn decision<A: Channel, B: Channel>(
    image: &AdmittedImage,
    bytes: &[u8],
    scenario: &Scenario,
    failure: &Failure,
    looked_at: &[(String, Signal)],
) -> Result<Option<Decision>, RunError> {
    let Some((tag, signal)) = looked_at.first() else { return Ok(None) };
    let mut stage: Stage<'_, A, B> = Stage::new(image, bytes, scenario)?;
    let mut coverage = Coverage::new(image);
    let scanning = Cell::new(false);
    let mut watch = Watch::new(&mut coverage, &stage.controller, &scanning, true);
    let mut time_ms = 0;
    while time_ms <= failure.at_ms {
        stage.scan(time_ms, &scanning, &mut watch);
        time_ms += stage.period_ms;
    }
    let Some(id) = watch.writer(*signal) else { return Ok(None) };
    Ok(Some(of_rung(&watch, tag, id)))
}

fn of_rung(watch: &Watch<'_>, tag: &str, id: RungId) -> Decision {
    let coverage = watch.coverage();
    let rung = coverage.program().rung(id);
    let fact = watch.fact(id).map(Vec::as_slice).unwrap_or_default();
    let blocking: Vec<u32> = fact
        .iter()
        .zip(0_u32..)
        .filter(|((reached, passed), _)| *reached && !*passed)
        .map(|(_, position)| position)
        .collect();
    let text = |position: &u32| rung.names.get(*position as usize).cloned();
    Decision {
        tag: tag.to_owned(),
        routine: coverage.routine_name(rung).to_owned(),
        rung: rung.number,
        text: rung.text.clone(),
        blocked_by: blocking.iter().filter_map(text).collect(),
        blocking,
    }
}

/// What is driven, what stands on the rung, what was looked at: each once, as many as one picture shows.
fn signals(
    image: &AdmittedImage,
    scenario: &Scenario,
    failure: &Failure,
    decision: Option<&Decision>,
    looked_at: &[(String, Signal)],
) -> Vec<(String, Signal)> {
    let mut found: Vec<(String, Signal)> = Vec::new();
    let mut add = |name: &str, signal: Signal| {
        if found.iter().all(|(other, at)| *at != signal && !other.eq_ignore_ascii_case(name)) {
            found.push((name.to_owned(), signal));
        }
    };
    for action in scenario.actions.iter().filter(|action| action.at_ms > 0 && action.at_ms <= failure.at_ms) {
        match &action.change {
            Change::Drive { name, signal, .. } => add(name, *signal),
            Change::Plant { module, stimulus: Stimulus::Signal(at, _) | Stimulus::Fault(at, _) } => {
                if let Some((name, signal)) = scenario.sites.get(*module).and_then(|site| site.data_of(*at)) {
                    add(name, *signal);
                }
            }
            Change::Plant { .. } | Change::Mode(_) => {}
        }
    }
    for name in decision.map(|decision| operands(&decision.text)).unwrap_or_default() {
        if let Ok(signal) = names::signal(image, &name) {
            add(&name, signal);
        }
    }
    let room = SIGNALS_MAX.saturating_sub(looked_at.len());
    let surplus = found.len().saturating_sub(room);
    // What was driven first matters least.
    found.drain(..surplus);
    found.retain(|(name, _)| looked_at.iter().all(|(other, _)| !other.eq_ignore_ascii_case(name)));
    found.extend(looked_at.iter().cloned());
    if looked_at.is_empty() {
        found.push(("Controller:Fault".to_owned(), Signal::ControllerFault));
    }
    found
}

/// The operands of a rung that may be names.
fn operands(text: &str) -> Vec<String> {
    let (_, rung) = crate::coverage::parsed(text);
    let mut found = Vec::new();
    if let Some(rung) = rung {
        crate::coverage::collect(&rung.elements, &mut |instruction| {
            found.extend(instruction.operands.iter().map(|operand| operand.text.to_string()));
        });
    }
    found
}
