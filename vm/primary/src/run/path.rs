//! The signature of the path of control: what each transition of control adds to it. REQ-SCAN-010.

use crate::machine::Machine;

/// A transition of control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Event {
    /// This routine of the image begins.
    Begins { routine: u32 },
    /// A JMP is taken to this rung.
    Jumps { rung: u32 },
    /// A routine ends behind its last rung; it has so many.
    RunsOut { rungs: u32 },
    /// A routine ends by the RET or TND on this rung.
    Leaves { rung: u32 },
    /// An instruction raises a major fault with this code.
    Faults { code: u16 },
}

/// Bits of an event's number.
const NUMBER_BITS: u32 = 28;
const ROTATION: u32 = 5;
/// An odd constant, so that no two signatures become one by multiplication.
const MULTIPLIER: u32 = 0x9E37_79B1;

impl Event {
    /// The event in the upper bits, its number below.
    fn word(self) -> u32 {
        let (event, number) = match self {
            Event::Begins { routine } => (1u32, routine),
            Event::Jumps { rung } => (2, rung),
            Event::RunsOut { rungs } => (3, rungs),
            Event::Leaves { rung } => (4, rung),
            Event::Faults { code } => (5, u32::from(code)),
        };
        let mask = 1u32.wrapping_shl(NUMBER_BITS).wrapping_sub(1);
        event.wrapping_shl(NUMBER_BITS) | (number & mask)
    }
}

impl Machine {
    /// Adds a transition of control to the signature of the path.
    pub(crate) fn went(&mut self, event: Event) {
        self.path = (self.path.rotate_left(ROTATION) ^ event.word()).wrapping_mul(MULTIPLIER);
    }
}
