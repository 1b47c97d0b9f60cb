//! A body at work, and what follows when it ends.

use twinrung_bytecode::observer::ElementUpset;
use twinrung_catalog::Opcode;

use crate::ladder::{BodyIndex, NONE};
use crate::state::Flags;

/// How a body's rungs are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Executed.
    Normal,
    /// Visited with false rungs; instructions do their prescan action.
    Prescan,
}

/// What follows when a body ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Link {
    /// The program has ended.
    Program,
    /// A JSR goes on; entry of the subroutines.
    Subroutine(u32),
    /// A call of an Add-On Instruction goes on: outputs are copied.
    AddOn(u32),
    /// Logic has been prescanned; the Prescan routine of the call follows.
    AddOnPrescan(u32),
    /// A safety application instruction goes on, with the status as it was.
    Safety(u32, Flags),
    /// Its Logic has been prescanned; the Prescan routine follows.
    SafetyPrescan(u32, Flags),
    /// Its Prescan routine has run.
    SafetyPrescanned(u32, Flags),
    /// The fault routine has ended; whether the MCR override was on.
    Fault(bool),
}

/// A body at work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Frame {
    /// The body.
    pub(crate) body: BodyIndex,
    /// The next step.
    pub(crate) next: u32,
    /// The rung at work.
    pub(crate) rung: u32,
    /// The condition at the element at work.
    pub(crate) rail: bool,
    /// Conditions before the open branches, innermost in bit 0.
    pub(crate) before: u64,
    /// Whether a leg of each open branch was true.
    pub(crate) legs: u64,
    /// Branches that end false because a fault was cleared within them.
    pub(crate) dead: u64,
    /// How rungs are taken.
    pub(crate) mode: Mode,
    /// What follows.
    pub(crate) link: Link,
    /// Bound arguments of the call that runs this body begin here.
    pub(crate) bound: u32,
    /// How the instruction at work is upset.
    pub(crate) upset: ElementUpset,
    /// Whether it is being repeated.
    pub(crate) repeating: bool,
    /// The step of a rung that is to be repeated; [`NONE`] where none is.
    pub(crate) again: u32,
}

impl Frame {
    /// A body from its beginning.
    pub(crate) const fn new(body: BodyIndex, begin: u32, mode: Mode, link: Link, bound: u32) -> Frame {
        Frame {
            body,
            next: begin,
            rung: 0,
            rail: false,
            before: 0,
            legs: 0,
            dead: 0,
            mode,
            link,
            bound,
            upset: ElementUpset::None,
            repeating: false,
            again: NONE,
        }
    }

    /// Begins a rung.
    pub(crate) const fn begin_rung(&mut self, number: u32, rail: bool) {
        self.rung = number;
        self.rail = rail;
        self.before = 0;
        self.legs = 0;
        self.dead = 0;
    }

    /// Begins a branch.
    pub(crate) const fn branch(&mut self) {
        self.before = (self.before << 1) | self.rail as u64;
        self.legs <<= 1;
        self.dead <<= 1;
    }

    /// Ends a leg and begins the next.
    pub(crate) const fn next_leg(&mut self) {
        self.legs |= self.rail as u64;
        self.rail = self.before & 1 != 0;
    }

    /// Ends a branch.
    pub(crate) const fn end_branch(&mut self) {
        let ends = (self.legs & 1 != 0) | self.rail;
        self.rail = ends & (self.dead & 1 == 0);
        self.before >>= 1;
        self.legs >>= 1;
        self.dead >>= 1;
    }

    /// After a cleared fault: the leg goes on false, later legs begin false, open branches end false (REQ-EXEC-051).
    pub(crate) const fn go_on_false(&mut self) {
        self.rail = false;
        self.before = 0;
        self.dead = u64::MAX;
    }
}

/// An instruction that does more than compute: it leaves its rung, its body or the scan.
pub(crate) const fn is_control(opcode: Opcode) -> bool {
    matches!(opcode, Opcode::Jmp | Opcode::Jsr | Opcode::Ret | Opcode::Tnd)
}
