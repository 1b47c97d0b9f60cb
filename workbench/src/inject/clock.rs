//! Simulated time that disturbs what both channels share at one moment.

use twinrung_bytecode::injection::Flip;
use twinrung_controller::{Moment, Part, Reference, ScanClock, Shared, SharedMemory, Side, Simulated};

/// The moments at which bits flip.
pub(super) const MOMENTS: [Moment; 6] = [
    Moment::Begun,
    Moment::After(Part::Freeze),
    Moment::After(Part::Primary),
    Moment::After(Part::Partner),
    Moment::After(Part::Compare),
    Moment::After(Part::Publish),
];

/// Bits that flip.
#[derive(Debug, Clone, Copy)]
pub(super) struct Disturbance {
    pub(super) moment: Moment,
    pub(super) memory: SharedMemory,
    pub(super) bits: [Option<(Side, u64)>; 2],
}

/// The clock of a run.
#[derive(Debug, Clone)]
pub(super) struct Clock {
    simulated: Simulated,
    disturbance: Option<Disturbance>,
    flip: Option<Flip>,
}

impl Clock {
    pub(super) fn new(period_ms: i64) -> Clock {
        Clock { simulated: Simulated::new(period_ms), disturbance: None, flip: None }
    }

    pub(super) fn disturb(&mut self, disturbance: Disturbance) {
        self.disturbance = Some(disturbance);
    }

    pub(super) fn flip(&self) -> Option<Flip> {
        self.flip
    }
}

impl ScanClock for Clock {
    fn begin(&mut self) {}

    fn ended(&mut self, _part: Part) {}

    fn expired(&mut self) -> bool {
        false
    }

    fn reference(&mut self) -> Option<Reference> {
        self.simulated.reference()
    }

    fn disturb(&mut self, moment: Moment, shared: &mut Shared<'_>) {
        let Some(disturbance) = self.disturbance.take_if(|disturbance| disturbance.moment == moment) else { return };
        for (side, bit) in disturbance.bits.into_iter().flatten() {
            self.flip = self.flip.max(Some(shared.flip(side, disturbance.memory, bit)));
        }
    }
}
