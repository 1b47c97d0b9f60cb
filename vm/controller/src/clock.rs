//! The seam for clocks: what measures a scan, and what judges it in real time. In simulated time nothing does, and the
//! instruction budget is the watchdog.

/// The parts of a scan, in their order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
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

/// Watches a scan from outside.
pub trait ScanClock {
    /// A scan begins.
    fn begin(&mut self);

    /// A part has ended.
    fn ended(&mut self, part: Part);

    /// Whether the watchdog has expired; asked once, before outputs are published.
    fn expired(&mut self) -> bool;
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
