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
    /// Whether it may see the initial value, since something that writes the place comes later in the scan.
    pub early: bool,
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
    /// The rail of its routine: why the routine is executed, and why it is not; what it writes stays when it is not.
    pub rail: (u32, u32),
    /// What jumps past the rung or ends the routine before it, where something does: this can spoil what the rung
    /// writes, and never qualifies it.
    pub spoil: Option<u32>,
    /// The zone of MCR that it stands in.
    pub zone: Option<Zone>,
    /// Whether something on the rung was left out as faulty: then nothing is said about it.
    pub incomplete: bool,
}

/// A zone of MCR.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Zone {
    /// What makes it enabled.
    pub on: u32,
    /// What makes it disabled.
    pub off: u32,
    /// Whether a jump leads into it past its begin: then its condition can spoil, and does not qualify.
    pub entered: bool,
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
    /// In parallel, as far as it is unqualified.
    Spoil,
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
    /// The pulse of a one-shot, the timing bit of a timer: 1 when true and, for a one-shot, false before; 0 in any case.
    Pulse,
    /// The pulse of a falling one-shot, the timing bit of TOF: 1 when false and true before; 0 in any case.
    Falling,
    /// The done bit of TOF: 1 when true, or true before; 0 when false.
    Held,
    /// The overflow bit of a counter: 1 when true and the count went beyond its end; as it was, and 0 before that, in any case.
    Beyond,
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
    /// A one-shot, by its storage bit: its output is true when the bit was 0, and false also when it was 1.
    Edge { on: u32, off: u32 },
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
    /// A place receives the reasons for which this is not executed with a true condition.
    Skipped { slot: Slot, write: u32 },
    /// A place receives the reasons for which this is not executed with a false condition.
    NotFalse { slot: Slot, write: u32 },
    /// What is computed may not be stored for the reasons that are read, too.
    Unless { read: u32 },
    /// A jump, or the end of the routine: a place receives the reasons for which it is taken or not, and what follows on
    /// the rung is spoiled by them.
    Leave { slot: Slot, write: u32 },
    /// The rung condition becomes that of a bit, which may be 1 while the rung is false.
    Resume { on: u32, off: u32 },
}

/// The network.
#[derive(Default)]
pub(crate) struct Network {
    pub places: Places,
    pub units: Vec<Unit>,
    pub ops: Vec<Op>,
    pub reads: Vec<Read>,
    pub writes: Vec<Write>,
    /// Places that begin with a path of neither origin: the rails of main routines.
    pub rails: Vec<Slot>,
    /// Bits that a prescan sets.
    pub set_by_prescan: Vec<Slot>,
    /// What a prescan copies, into the parameters of an Add-On Instruction and out of them.
    pub copied_by_prescan: Vec<(Slot, Slot)>,
    /// What places hold before anything runs.
    pub initial: super::initial::Initial,
    /// Operands of safety instructions that take no unqualified data: the read, and the operand's name.
    pub safety_only: Vec<(u32, &'static str)>,
}
