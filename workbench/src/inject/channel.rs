//! A channel with something wrong about it.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::{
    Channel, FaultRecord, MajorFault, Place, Representation, ScanEnd, ScanInputs, Status,
};
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, RoutineIndex, WordCell};
use twinrung_bytecode::injection::{Flip, Injectable, Memory};
use twinrung_bytecode::observer::Observer;

use super::fault::{Behaviour, Time};

/// What is wrong with a channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Wrong {
    /// Bits flip once, before or after the execution.
    Flip { memory: Memory, bits: [Option<u64>; 2], after: bool },
    /// A bit is stuck.
    Stuck { memory: Memory, bit: u64, value: bool },
    /// The channel is told another time.
    Time(Time),
    /// It misbehaves; the number says in which way where there are several.
    Behaviour(Behaviour, u64),
}

/// A channel that does what it is told to do wrong, and otherwise what the channel within does.
#[derive(Debug, Clone)]
pub struct Disturbed<C> {
    inner: C,
    wrong: Option<Wrong>,
    flip: Option<Flip>,
    now_ms: i64,
    since_ms: i64,
    status_bit: Option<u64>,
    shown: Option<Shown>,
}

/// What a late channel shows.
#[derive(Debug, Clone)]
struct Shown {
    bits: Vec<u8>,
    words: Vec<u32>,
    status: Status,
    path: u32,
}

/// Bits of a status and a path signature, in this order: six flags, minor faults, cleared faults, executed, path.
pub(super) const STATUS_BITS: u64 = 6 + 32 + 32 + 64 + 32;
/// Ways of ending that are not [`ScanEnd::Completed`].
pub(super) const ENDS: u64 = 2;

impl<C: Injectable> Disturbed<C> {
    /// From now on something is wrong.
    pub(super) fn disturb(&mut self, wrong: Wrong) {
        self.wrong = Some(wrong);
        self.since_ms = self.now_ms;
    }

    /// The size of a memory in bits.
    pub(super) fn memory_bits(&mut self, memory: Memory) -> u64 {
        self.inner.memory_bits(memory)
    }

    /// What became of the bits that were turned round or held.
    pub(super) fn flip(&self) -> Option<Flip> {
        self.flip
    }

    fn turn(&mut self, memory: Memory, bits: [Option<u64>; 2]) {
        for bit in bits.into_iter().flatten() {
            let flip = self.inner.flip_bit(memory, bit);
            self.flip = self.flip.max(Some(flip));
        }
    }

    fn misbehave<O: Observer>(
        &mut self,
        (behaviour, number): (Behaviour, u64),
        inputs: ScanInputs<'_>,
        observer: &mut O,
    ) -> ScanEnd {
        if behaviour != Behaviour::Stops {
            self.wrong = None;
        }
        match behaviour {
            Behaviour::Stops | Behaviour::Skips => ScanEnd::Completed,
            Behaviour::Repeats => {
                self.inner.scan(inputs, observer);
                self.inner.scan(inputs, observer)
            }
            Behaviour::Late => {
                let inner = &self.inner;
                let (bits, words) = (inner.bits().to_vec(), inner.words().to_vec());
                self.shown = Some(Shown { bits, words, status: inner.status(), path: inner.path_signature() });
                self.inner.scan(inputs, observer)
            }
            Behaviour::EndWrong => {
                self.inner.scan(inputs, observer);
                let place = Place { program: ProgramIndex(0), routine: RoutineIndex(0), rung: 0, element: 0 };
                match number {
                    0 => ScanEnd::BudgetExceeded,
                    _ => ScanEnd::MajorFault(MajorFault { code: 20, place }),
                }
            }
            Behaviour::StatusWrong => {
                self.status_bit = Some(number);
                self.inner.scan(inputs, observer)
            }
        }
    }
}

impl<C: Injectable> Channel for Disturbed<C> {
    type LoadError = C::LoadError;
    const REPRESENTATION: Representation = C::REPRESENTATION;

    fn load(image: &AdmittedImage) -> Result<Self, C::LoadError> {
        let inner = C::load(image)?;
        Ok(Disturbed { inner, wrong: None, flip: None, now_ms: 0, since_ms: 0, status_bit: None, shown: None })
    }

    fn reset(&mut self) {
        self.inner.reset();
    }

    fn prescan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        self.inner.prescan(inputs, observer)
    }

    fn scan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        self.now_ms = inputs.now_ms;
        (self.shown, self.status_bit) = (None, None);
        match self.wrong {
            None => self.inner.scan(inputs, observer),
            Some(Wrong::Flip { memory, bits, after }) => {
                self.wrong = None;
                if after {
                    let end = self.inner.scan(inputs, observer);
                    self.turn(memory, bits);
                    end
                } else {
                    self.turn(memory, bits);
                    self.inner.scan(inputs, observer)
                }
            }
            Some(Wrong::Stuck { memory, bit, value }) => {
                self.flip = Some(self.inner.force_bit(memory, bit, value));
                let end = self.inner.scan(inputs, observer);
                self.inner.force_bit(memory, bit, value);
                end
            }
            Some(Wrong::Time(time)) => {
                let now_ms = time.of(self.since_ms, inputs.now_ms);
                self.inner.scan(ScanInputs { now_ms, ..inputs }, observer)
            }
            Some(Wrong::Behaviour(behaviour, number)) => self.misbehave((behaviour, number), inputs, observer),
        }
    }

    fn set_bit(&mut self, cell: BitCell, value: bool) {
        self.inner.set_bit(cell, value);
    }

    fn set_word(&mut self, cell: WordCell, value: i32) {
        self.inner.set_word(cell, value);
    }

    fn bits(&self) -> &[u8] {
        self.shown.as_ref().map_or_else(|| self.inner.bits(), |shown| &shown.bits)
    }

    fn words(&self) -> &[u32] {
        self.shown.as_ref().map_or_else(|| self.inner.words(), |shown| &shown.words)
    }

    fn status(&self) -> Status {
        let mut status = self.shown.as_ref().map_or_else(|| self.inner.status(), |shown| shown.status);
        match self.status_bit {
            Some(0) => status.first_scan ^= true,
            Some(1) => status.overflow ^= true,
            Some(2) => status.zero ^= true,
            Some(3) => status.negative ^= true,
            Some(4) => status.carry ^= true,
            Some(5) => status.minor_fault ^= true,
            Some(bit @ 6..=37) => status.minor_faults ^= 1 << (bit - 6),
            Some(bit @ 38..=69) => status.cleared_faults ^= 1 << (bit - 38),
            Some(bit @ 70..=133) => status.executed ^= 1 << (bit - 70),
            _ => {}
        }
        status
    }

    fn events(&self, task: EventTaskIndex) -> u32 {
        self.inner.events(task)
    }

    fn fault_record(&self, program: ProgramIndex) -> Option<FaultRecord> {
        self.inner.fault_record(program)
    }

    fn path_signature(&self) -> u32 {
        let path = self.shown.as_ref().map_or_else(|| self.inner.path_signature(), |shown| shown.path);
        match self.status_bit {
            Some(bit @ 134..=165) => path ^ (1 << (bit - 134)),
            _ => path,
        }
    }
}
