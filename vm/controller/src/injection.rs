//! Fault injection: the bits of what both channels share. Only with the feature `injection`.

use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::injection::{BitVisitor, Flip};

use crate::controller::{Controller, PartnerHalf, PrimaryHalf};
use crate::fault::{SafetyFault, StopReason};
use crate::image_check::ImageCheck;
use crate::mode::Mode;

/// The halves of the controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// That of the primary.
    Primary,
    /// That of the partner.
    Partner,
}

/// What a controller holds besides its channels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SharedMemory {
    /// The sealed bytes that the running check goes over, and how far it is. There is one.
    Image,
    /// Driven inputs and system values.
    Inputs,
    /// Published outputs.
    Outputs,
    /// Which cells are inputs and outputs.
    Configuration,
    /// The time of the scan, and what it is judged by.
    Time,
    /// The budget of instructions.
    Budget,
    /// The permission to publish, with its challenge.
    Verdict,
    /// Whether logic may execute.
    Permit,
    /// The mode, and whether the task is stopped. There is one.
    Mode,
}

impl SharedMemory {
    /// All of them.
    pub const ALL: [SharedMemory; 9] = [
        SharedMemory::Image,
        SharedMemory::Inputs,
        SharedMemory::Outputs,
        SharedMemory::Configuration,
        SharedMemory::Time,
        SharedMemory::Budget,
        SharedMemory::Verdict,
        SharedMemory::Permit,
        SharedMemory::Mode,
    ];

    /// Whether each half has its own.
    pub const fn is_twofold(self) -> bool {
        !matches!(self, SharedMemory::Image | SharedMemory::Mode)
    }
}

/// What a controller holds besides its channels, with its bits laid open.
pub struct Shared<'c> {
    first: &'c mut PrimaryHalf,
    second: &'c mut PartnerHalf,
    check: &'c mut ImageCheck,
    mode: &'c mut Mode,
    stopped: &'c mut Option<StopReason>,
}

impl<A: Channel, B: Channel> Controller<A, B> {
    /// What it holds besides its channels.
    pub fn shared(&mut self) -> Shared<'_> {
        Shared {
            first: &mut self.first,
            second: &mut self.second,
            check: &mut self.check,
            mode: &mut self.mode,
            stopped: &mut self.stopped,
        }
    }
}

impl Shared<'_> {
    fn visit_bits(&mut self, side: Side, memory: SharedMemory, visitor: &mut BitVisitor) {
        match (memory, side) {
            (SharedMemory::Image, _) => self.check.visit_bits(visitor),
            (SharedMemory::Mode, _) => {
                let mut runs = *self.mode == Mode::Run;
                visitor.field(&mut runs);
                *self.mode = if runs { Mode::Run } else { Mode::Program };
                let (was, mut is) = (self.stopped.is_some(), self.stopped.is_some());
                visitor.field(&mut is);
                if was != is {
                    *self.stopped = is.then_some(StopReason::Safety(SafetyFault::ControllerCorrupted));
                }
            }
            (_, Side::Primary) => self.first.visit_bits(memory, visitor),
            (_, Side::Partner) => self.second.visit_bits(memory, visitor),
        }
    }

    /// The size of a memory in bits.
    pub fn bits(&mut self, side: Side, memory: SharedMemory) -> u64 {
        let mut visitor = BitVisitor::count();
        self.visit_bits(side, memory, &mut visitor);
        visitor.passed()
    }

    /// Turns a bit round.
    pub fn flip(&mut self, side: Side, memory: SharedMemory, bit: u64) -> Flip {
        let mut visitor = BitVisitor::turn(bit);
        self.visit_bits(side, memory, &mut visitor);
        visitor.outcome()
    }
}
