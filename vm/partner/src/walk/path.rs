//! The signature of the path that control took through an execution. REQ-SCAN-010.

use twinrung_bytecode::observer::Observer;

use super::Walker;

/// What control did; the discriminant is the event's number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u32)]
pub(crate) enum Event {
    /// A routine begins: its index.
    Begins = 1,
    /// A JMP is taken: the rung that it goes to.
    Jumps = 2,
    /// A routine ends behind its last rung: its number of rungs.
    Ends = 3,
    /// RET or TND ends a routine: the rung where that stands.
    Returns = 4,
    /// An instruction raises a major fault: its code.
    Faults = 5,
}

/// Where the number of the event stands.
const NUMBER_BITS: u32 = 28;
/// An odd factor: no two signatures become one by it.
const FACTOR: u32 = 0x9E37_79B1;

/// The signature after one more event.
const fn extended(signature: u32, event: Event, number: u32) -> u32 {
    let number = number & ((1 << NUMBER_BITS) - 1);
    let event = (event as u32) << NUMBER_BITS;
    (signature.rotate_left(5) ^ (event | number)).wrapping_mul(FACTOR)
}

impl<O: Observer> Walker<'_, O> {
    /// Takes an event into the signature; the path within the library is this channel's own affair.
    pub(super) fn follow(&mut self, event: Event, number: u32) {
        if !self.state.in_library {
            self.state.path = extended(self.state.path, event, number);
        }
    }
}
