//! The seam for clocks: what measures a scan, and what judges it in real time. In simulated time nothing does, and the
//! instruction budget is the watchdog.

use crate::time::Reference;

/// The parts of a scan, in their order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Part {
    /// Inputs and mapped tags are copied into both channels.
    Freeze,
    /// Channel 1 executes.
    Primary,
    /// Channel 2 executes.
    Partner,
    /// The channels are compared, and a part of the image is checked.
    Compare,
    /// Outputs are published.
    Publish,
}

impl Part {
    /// All parts, in their order.
    pub const ALL: [Part; 5] = [Part::Freeze, Part::Primary, Part::Partner, Part::Compare, Part::Publish];
}

/// Moments at which fault injection gets at what both channels share.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Moment {
    /// The scan has begun: its time is judged and held, inputs are not copied yet.
    Begun,
    /// A part has ended.
    After(Part),
}

/// Watches a scan from outside.
pub trait ScanClock {
    /// A scan begins.
    fn begin(&mut self);

    /// A part has ended.
    fn ended(&mut self, part: Part);

    /// Whether the watchdog has expired; asked once, before outputs are published.
    fn expired(&mut self) -> bool;

    /// What another source of time says; asked once at each scan boundary, also where nothing executes. Without one, time is
    /// only judged for running backwards.
    fn reference(&mut self) -> Option<Reference> {
        None
    }

    /// Fault injection, between the parts of a scan.
    #[cfg(feature = "injection")]
    fn disturb(&mut self, moment: Moment, shared: &mut crate::Shared<'_>) {
        let _ = (moment, shared);
    }
}

/// Simulated time: the second source is the count of scan boundaries, at the period, and the two must never part.
#[derive(Debug, Clone, Copy)]
pub struct Simulated {
    period_ms: i64,
    boundaries: i64,
}

impl Simulated {
    /// With a period in ms, before the first boundary.
    pub const fn new(period_ms: i64) -> Simulated {
        Simulated { period_ms, boundaries: 0 }
    }
}

impl ScanClock for Simulated {
    fn begin(&mut self) {}

    fn ended(&mut self, _part: Part) {}

    fn expired(&mut self) -> bool {
        false
    }

    fn reference(&mut self) -> Option<Reference> {
        let ms = self.boundaries.saturating_mul(self.period_ms);
        self.boundaries = self.boundaries.saturating_add(1);
        Some(Reference { ms, tolerance_ms: 0 })
    }
}

/// No clock: simulated time.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoClock;

impl ScanClock for NoClock {
    fn begin(&mut self) {}

    fn ended(&mut self, _part: Part) {}

    fn expired(&mut self) -> bool {
        false
    }
}
