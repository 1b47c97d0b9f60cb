//! The whole logic as one network of places: for each rung the operations that lead from places to places.

use twinrung_grammar::tree::Span;

use super::places::{Places, Slot};
use crate::project::RoutineId;

/// A read of a place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Read {
    /// The place.
    pub slot: Slot,
    /// The rung that reads.
    pub unit: u32,
    /// The operand.
    pub span: Span,
    /// Whether what is read counts as qualified, since the sequence for parameters of an operator terminal is kept.
    pub accepted: bool,
}

/// A write, for the report.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Write {
    /// The rung that writes.
    pub unit: u32,
    /// The operand.
    pub span: Span,
}

/// A rung; that of an Add-On Instruction once for each instance.
#[derive(Debug, Clone)]
pub(crate) struct Unit {
    /// Its operations.
    pub ops: std::ops::Range<u32>,
    /// The routine.
    pub routine: RoutineId,
    /// The rung.
    pub rung: u32,
    /// What must be so for the rung to be executed at all; what it writes stays when it is not.
    pub guard: u32,
    /// The zone of MCR that it stands in: what makes the zone enabled, what disabled.
    pub zone: Option<(u32, u32)>,
    /// Whether something on the rung was left out as faulty: then nothing is said about it.
    pub incomplete: bool,
}

/// How a read joins what was computed so far on a rung.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Join {
    /// In series.
    Series,
    /// In parallel.
    Either,
    /// As another input of a computation.
    Mixed,
    /// In series; it can spoil and cannot qualify.
    Taint,
}

/// How a bit follows the rung condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Follow {
    /// OTE: 1 when true, 0 when false.
    Coil,
    /// OTL: 1 when true.
    Latch,
    /// OTU: 0 when true.
    Unlatch,
    /// Either value by either condition: the timing bit of a timer, the pulse of a one-shot.
    Pulse,
    /// The pulse of a falling one-shot: 1 when false.
    Falling,
}

/// One operation. `u32` are positions in [`Network::reads`] and [`Network::writes`].
#[derive(Debug, Clone, Copy)]
pub(crate) enum Op {
    /// A contact in series; `selected` by what was computed from variable subscripts.
    Contact { on: u32, off: u32, selected: bool },
    /// What was computed, as a contact in series.
    Test,
    /// A contact that is never true.
    Never,
    /// A one-shot: its output is false also while its input stays true.
    Edge,
    /// A branch begins.
    Open,
    /// Its next leg begins.
    Leg,
    /// It ends.
    Close,
    /// Begins a computation with constants.
    Clear,
    /// Begins a computation with nothing.
    Nothing,
    /// Joins a place.
    Join { read: u32, how: Join },
    /// A place receives what was computed when the condition is true.
    Store { slot: Slot, write: u32 },
    /// A place receives what was computed whatever the condition is.
    Put { slot: Slot, write: u32 },
    /// A place receives the reasons for which the condition is false, or what was computed.
    Break { slot: Slot, write: u32 },
    /// A place receives the reasons of both, in series with what was computed.
    Any { slot: Slot, write: u32 },
    /// A BOOL follows the condition, in series with what was computed.
    Bit { on: Slot, off: Slot, follow: Follow, write: u32 },
}

/// The network.
#[derive(Default)]
pub(crate) struct Network {
    pub places: Places,
    pub units: Vec<Unit>,
    pub ops: Vec<Op>,
    pub reads: Vec<Read>,
    pub writes: Vec<Write>,
    /// Places where everything is executed: the rails of main routines.
    pub rails: Vec<Slot>,
    /// Operands of safety instructions that take no unqualified data: the read, and the operand's name.
    pub safety_only: Vec<(u32, &'static str)>,
}
