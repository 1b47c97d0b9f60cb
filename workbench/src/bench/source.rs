//! What drives the inputs of a measurement.

use twinrung_bytecode::channel::Channel;
use twinrung_controller::Controller;

use super::{Driven, Inputs, Plan};
use crate::drive::Drive;
use crate::mix::Toggles;
use crate::run::RunError;

/// What drives the inputs, at work.
pub(super) enum Source {
    Stimulus(Drive),
    Random(Inputs),
    Toggles(Box<Toggles>),
}

impl Source {
    pub(super) fn new<A: Channel, B: Channel>(
        controller: &mut Controller<A, B>,
        plan: &Plan,
    ) -> Result<Source, RunError> {
        match &plan.inputs {
            Driven::Stimulus(stimulus) => Drive::new(controller, stimulus).map(Source::Stimulus),
            Driven::Random(seed) => Ok(Source::Random(Inputs::new(controller, *seed))),
            Driven::Toggles(each_scan) => Toggles::new(controller, *each_scan)
                .map(|toggles| Source::Toggles(Box::new(toggles)))
                .ok_or_else(|| RunError::Load("it does not have the inputs of a generated program".to_owned())),
        }
    }

    /// Sets the inputs for a scan.
    pub(super) fn before<A: Channel, B: Channel>(
        &mut self,
        controller: &mut Controller<A, B>,
        scan: u64,
        time_ms: u64,
    ) {
        match self {
            Source::Stimulus(drive) => {
                if drive.is_over() {
                    drive.again(time_ms);
                }
                drive.until(controller, time_ms);
            }
            Source::Random(inputs) => inputs.before(controller, scan),
            Source::Toggles(toggles) => toggles.before(controller),
        }
    }
}
