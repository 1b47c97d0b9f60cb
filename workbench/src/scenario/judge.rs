//! Expectations held against what the controller shows after each scan.

use twinrung_bytecode::channel::Channel;
use twinrung_controller::StopReason;

use super::play::Stage;
use super::{Expectation, Expected};
use crate::signal::Value;

/// What has become of one expectation.
#[derive(Debug, Clone, PartialEq)]
pub enum State {
    /// Its time has not come, or has not run out.
    Open,
    /// It is met.
    Met,
    /// It is not met, which shows in the scan that begins at this time in ms.
    NotMet {
        /// The scan's time in ms.
        at_ms: u64,
        /// What was found, in words.
        found: String,
    },
}

/// The expectations of one scenario and what has become of them.
pub struct Judge<'a> {
    expectations: &'a [Expectation],
    states: Vec<State>,
    period_ms: u64,
}

impl<'a> Judge<'a> {
    /// All are open.
    pub fn new(expectations: &'a [Expectation], period_ms: u64) -> Judge<'a> {
        Judge { expectations, states: vec![State::Open; expectations.len()], period_ms }
    }

    /// Looks at the controller, and at the terminals, after the scan that began at `time_ms`.
    pub fn look<A: Channel, B: Channel>(&mut self, stage: &Stage<'_, A, B>, time_ms: u64) {
        for (expectation, state) in self.expectations.iter().zip(&mut self.states) {
            let within = (expectation.from_ms..=expectation.until_ms).contains(&time_ms);
            if *state == State::Open && within {
                let last = time_ms.saturating_add(self.period_ms) > expectation.until_ms;
                *state = judged(expectation, stage, time_ms, last);
            }
        }
    }

    /// Whether the scenario says that the controller stops.
    pub fn expects_stop(&self) -> bool {
        let stops = self.expectations.iter().zip(&self.states);
        stops
            .into_iter()
            .any(|(expectation, state)| matches!(expectation.kind, Expected::Fault(..)) && *state == State::Met)
    }

    /// What has become of the expectations, in their order.
    pub fn states(&self) -> &[State] {
        &self.states
    }
}

fn judged<A: Channel, B: Channel>(
    expectation: &Expectation,
    stage: &Stage<'_, A, B>,
    time_ms: u64,
    last: bool,
) -> State {
    let not_met = |found: String| State::NotMet { at_ms: time_ms, found };
    match &expectation.kind {
        Expected::Reached(check, not_before_ms) => {
            let value = stage.value(check.place);
            match (check.holds(value), time_ms < *not_before_ms) {
                (true, true) => not_met(format!("{} {} too soon", check.name, was(check.shown(value)))),
                (true, false) => State::Met,
                (false, _) if last => not_met(format!("{} {}", check.name, was(check.shown(value)))),
                (false, _) => State::Open,
            }
        }
        Expected::Stays(check) => {
            let value = stage.value(check.place);
            match (check.holds(value), last) {
                (false, _) => not_met(format!("{} {}", check.name, was(check.shown(value)))),
                (true, true) => State::Met,
                (true, false) => State::Open,
            }
        }
        Expected::Never(checks) => {
            let values: Vec<Value> = checks.iter().map(|check| stage.value(check.place)).collect();
            if checks.iter().zip(&values).all(|(check, value)| check.holds(*value)) {
                let shown = checks
                    .iter()
                    .zip(&values)
                    .map(|(check, value)| format!("{} {}", check.name, was(check.shown(*value))));
                return not_met(shown.collect::<Vec<_>>().join(" and "));
            }
            if last { State::Met } else { State::Open }
        }
        Expected::Fault(fault_type, code) => match stage.controller.stopped() {
            Some(reason) if is_fault(reason, *fault_type, *code) => State::Met,
            Some(reason) if last => {
                let (fault_type, code) = reason.type_and_code();
                not_met(format!("the controller had stopped with fault {fault_type}/{code}"))
            }
            None if last => not_met("the controller had not stopped".to_owned()),
            _ => State::Open,
        },
    }
}

fn was(value: String) -> String {
    format!("was {value}")
}

/// A fault goes by the controller's type and code, or by those of the instruction that raised it.
fn is_fault(reason: StopReason, fault_type: u16, code: u16) -> bool {
    let raised = match reason {
        StopReason::Recoverable(fault) => Some((4, fault.code)),
        StopReason::Safety(_) | StopReason::PartnershipLost => None,
    };
    reason.type_and_code() == (fault_type, code) || raised == Some((fault_type, code))
}
