//! A mode change in simulated time: more than one period, less than two (1756-RM093F p. 49).

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_controller::{Controller, Mode, StopReason};

use crate::hold::{Hold, Holds};
use crate::run::{RunError, powered_up};

/// How a mode change went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transition {
    /// When it was asked for, in µs after a scan.
    pub asked_us: u64,
    /// When it acted, in ms after that scan.
    pub acted_ms: u64,
    /// Why the safety task stopped in the scan that began then, if it did.
    pub stopped: Option<StopReason>,
}

impl Transition {
    /// How long it took, in µs.
    pub const fn took_us(&self) -> u64 {
        self.acted_ms.saturating_mul(1000).saturating_sub(self.asked_us)
    }
}

/// Scan boundaries within which a mode change must have acted.
const BOUNDARIES_MAX: u64 = 3;

/// Asks a controller for another mode `asked_us` after a scan, before the next one, and lets scans pass until it has it.
///
/// # Errors
///
/// As a run.
pub fn transition<A: Channel, B: Channel>(
    image: AdmittedImage,
    bytes: &[u8],
    to: Mode,
    asked_us: u64,
    holds: &[Hold],
) -> Result<Transition, RunError> {
    let from = if to == Mode::Run { Mode::Program } else { Mode::Run };
    let (mut controller, period_ms): (Controller<A, B>, u64) = powered_up(image, bytes, from)?;
    Holds::of(holds).drive(&mut controller);
    let mut report = controller.scan(0);
    controller.request_mode(to);
    let mut acted_ms = 0;
    for boundary in 1..=BOUNDARIES_MAX {
        acted_ms = boundary * period_ms;
        report = controller.scan(acted_ms as i64);
        if controller.mode() == to {
            break;
        }
    }
    Ok(Transition { asked_us, acted_ms, stopped: report.stopped })
}
