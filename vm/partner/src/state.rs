//! Everything of a channel that a scan changes.

use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::channel::Status;
use twinrung_bytecode::limits;

use crate::ladder::{Argument, Ladder, Location};
use crate::load::{ADDRESSES, VALUES};
use crate::memory::{Memory, Size};
use crate::stack::Stack;
use crate::walk::address::Address;
use crate::walk::frame::Frame;
use crate::walk::value::Value;

/// S:V in [`Flags::key`].
pub(crate) const OVERFLOW: u64 = 1;
/// S:Z.
pub(crate) const ZERO: u64 = 2;
/// S:N.
pub(crate) const NEGATIVE: u64 = 4;
/// S:C.
pub(crate) const CARRY: u64 = 8;
/// All four.
pub(crate) const ALL_FLAGS: u64 = OVERFLOW | ZERO | NEGATIVE | CARRY;

/// The arithmetic status.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Flags {
    /// The flags; within a region the place of the instruction that set them stands above.
    pub(crate) key: u64,
    /// Minor faults since the last prescan.
    pub(crate) minor_faults: u32,
}

/// An argument whose place has been found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Bound {
    /// The argument.
    pub(crate) argument: Argument,
    /// Its place, where it has one.
    pub(crate) location: Location,
}

/// Bodies within bodies: subroutines and Add-On Instructions, once more within the fault routine, and the library's.
pub(crate) const FRAMES: usize = 2 * (limits::CALL_DEPTH + limits::ADD_ON_DEPTH + 1) + limits::ADD_ON_DEPTH + 2;

/// The words of a MajorFaultRecord.
pub(crate) const RECORD_WORDS: usize = 11;

/// What a scan changes.
#[derive(Debug, Clone)]
pub(crate) struct State {
    /// Cells.
    pub(crate) memory: Memory,
    /// Arithmetic status.
    pub(crate) status: Flags,
    /// Instructions executed since loading.
    pub(crate) executed: u64,
    /// Of them, before this scan.
    pub(crate) executed_before: u64,
    /// Signature of the path that control took in this execution (REQ-SCAN-010).
    pub(crate) path: u32,
    /// Faults that fault routines cleared since the last prescan.
    pub(crate) cleared_faults: u32,
    /// Whether the next scan is the first after a prescan.
    pub(crate) armed: bool,
    /// Whether a fault was raised in this scan.
    pub(crate) faulted: bool,
    /// Whether the fault routine is at work.
    pub(crate) in_fault_routine: bool,
    /// Whether the library is at work.
    pub(crate) in_library: bool,
    /// Fault records by program.
    pub(crate) records: Vec<[i32; RECORD_WORDS]>,
    /// How often EVENT triggered each task in this scan.
    pub(crate) events: Vec<u32>,
    /// Backward jumps in the execution of their routine; those within the fault routine apart, because it may execute a
    /// routine that it interrupted.
    pub(crate) jumps: Vec<[u32; 2]>,
    /// Bodies that this prescan of a program has reached.
    pub(crate) visited: Vec<bool>,
    /// Bodies that wait for the one at work.
    pub(crate) frames: Stack<Frame>,
    /// Places of the arguments of calls that are at work.
    pub(crate) bound: Stack<Bound>,
    /// Parameters on their way from JSR to SBR and from RET to JSR.
    pub(crate) passed: Vec<Value>,
    /// Bytes on their way in COP.
    pub(crate) bytes: Vec<u8>,
    /// Values of an expression.
    pub(crate) values: Vec<Value>,
    /// Addresses of an expression.
    pub(crate) addresses: Vec<Address>,
}

impl State {
    /// The state after loading. Everything that a scan can need has its room from here on.
    pub(crate) fn new(ladder: &Ladder, size: Size, image_bits: usize, image_words: usize, event_tasks: usize) -> State {
        let arguments = |count: usize| count.saturating_mul(FRAMES).saturating_add(1);
        let calls = ladder.calls.iter().map(|call| call.arguments.len());
        let subroutines = ladder
            .subroutines
            .iter()
            .map(|call| call.inputs.len().saturating_add(call.receivers.len()).saturating_add(call.returns.len()));
        let longest = calls.chain(subroutines).max().unwrap_or(0).saturating_add(limits::JSR_PARAMETERS);
        let used_words = ladder.initial_words.len();
        let mut state = State {
            memory: Memory::new(size, image_bits, image_words, used_words),
            status: Flags::default(),
            executed: 0,
            executed_before: 0,
            path: 0,
            cleared_faults: 0,
            armed: false,
            faulted: false,
            in_fault_routine: false,
            in_library: false,
            records: vec![[0; RECORD_WORDS]; ladder.programs.len()],
            events: vec![0; event_tasks],
            jumps: vec![[0; 2]; ladder.counters as usize],
            visited: vec![false; ladder.bodies.len()],
            frames: Stack::new(FRAMES),
            bound: Stack::new(arguments(longest)),
            passed: vec![Value::default(); parameter_cells(ladder)],
            bytes: vec![0; limits::COPY_BYTES as usize],
            values: vec![Value::default(); VALUES],
            addresses: vec![Address::default(); ADDRESSES],
        };
        state.reset(ladder);
        state
    }

    /// Back to what it was after loading.
    pub(crate) fn reset(&mut self, ladder: &Ladder) {
        for (cell, value) in ladder.initial_bits.iter().enumerate() {
            self.memory.set_bit(cell as u32, *value);
        }
        for (cell, value) in ladder.initial_words.iter().enumerate() {
            self.memory.set_word(cell as u32, *value);
        }
        let used_words = self.memory.used_words;
        self.memory.set_stamps(0..used_words, 0);
        self.status = Flags::default();
        self.executed = 0;
        self.executed_before = 0;
        self.cleared_faults = 0;
        self.armed = false;
        self.records.fill([0; RECORD_WORDS]);
        self.events.fill(0);
        self.begin();
    }

    /// What begins anew with each execution.
    pub(crate) fn begin(&mut self) {
        self.executed_before = self.executed;
        self.path = 0;
        self.faulted = false;
        self.in_fault_routine = false;
        self.in_library = false;
        self.events.fill(0);
        self.frames.clear();
        self.bound.clear();
        self.status.key = 0;
    }

    /// The status as the controller compares it.
    pub(crate) fn status(&self, first_scan: bool) -> Status {
        let flag = |mask: u64| self.status.key & mask != 0;
        Status {
            first_scan,
            overflow: flag(OVERFLOW),
            zero: flag(ZERO),
            negative: flag(NEGATIVE),
            carry: flag(CARRY),
            minor_fault: self.status.minor_faults != 0,
            minor_faults: self.status.minor_faults,
            executed: self.executed,
            cleared_faults: self.cleared_faults,
        }
    }

    /// S:V becomes set; a change logs a minor fault 4/4.
    pub(crate) fn set_overflow(&mut self) {
        if self.status.key & OVERFLOW == 0 {
            self.status.key |= OVERFLOW;
            self.log_minor_fault();
        }
    }

    /// Logs a minor fault.
    pub(crate) fn log_minor_fault(&mut self) {
        self.status.minor_faults = self.status.minor_faults.wrapping_add(1);
    }
}

/// Cells of the longest parameter list of a JSR.
fn parameter_cells(ladder: &Ladder) -> usize {
    let cells = |argument: &Argument| match argument {
        Argument::Span(span) => ladder.spans.get(*span as usize).map_or(1, |span| {
            (span.bits.saturating_add(span.words) as usize).saturating_mul(span.count as usize).max(1)
        }),
        _ => 1,
    };
    let list = |arguments: &[Argument]| arguments.iter().map(cells).fold(0, usize::saturating_add);
    let lists = ladder.subroutines.iter().flat_map(|call| [list(&call.receivers), list(&call.returns)]);
    lists.max().unwrap_or(0)
}
