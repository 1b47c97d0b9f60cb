//! What a scan changes: cells, private state, status, and the stacks of execution. All of it is allocated by loading.

use alloc::vec;
use alloc::vec::Vec;

use twinrung_bytecode::channel::{FaultRecord, MajorFault, Status};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::limits;
use twinrung_catalog::Opcode;
use twinrung_safety_primary::State;

use crate::error::LoadError;
use crate::load::Loaded;
use crate::load::formula::{ADDRESSES, VALUES};
use crate::number::Number;
use crate::program::{Operand, Program, Range};
use crate::run::jsr_operands;
use crate::stack::Stack;

/// Routines within routines: a main routine, [`limits::CALL_DEPTH`] subroutines, [`limits::ADD_ON_DEPTH`] Add-On
/// Instructions, and the same again for the fault routine.
pub(crate) const FRAMES: usize = 2 * (limits::CALL_DEPTH + limits::ADD_ON_DEPTH + 1);
/// Branches open in all of them together.
pub(crate) const BRANCHES: usize = FRAMES * limits::BRANCH_DEPTH;
/// Values that one call passes.
pub(crate) const TRANSFERS: usize = 512;
/// A CONTROL whose last completed run ended while its rung was false: the mark in its hidden word (A.6).
pub(crate) const ENDED_WHILE_FALSE: i64 = i64::MIN;

/// Why a body runs, and what follows when it has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    /// Main routine of the program.
    Main,
    /// Called by this JSR.
    Subroutine { instruction: u32 },
    /// Logic of this Add-On call, executed or prescanned.
    Logic { call: u32 },
    /// The Prescan routine of this Add-On call.
    Prescan { call: u32 },
    /// The EnableInFalse routine of this Add-On call.
    EnableInFalse { call: u32 },
    /// The program's fault routine; the rail before it ran.
    FaultRoutine { rail: u8 },
    /// The program's fault routine in prescan.
    FaultPrescan,
}

/// A body that is being executed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Frame {
    pub(crate) body: u32,
    /// Next code, or the current step.
    pub(crate) position: u32,
    pub(crate) rung: u32,
    /// Whether `position` counts steps.
    pub(crate) stepping: bool,
    /// The rung condition, while it goes by codes.
    pub(crate) condition: bool,
    /// Whether a fault was cleared on this rung: nothing on it becomes true again (REQ-EXEC-051).
    pub(crate) halted: bool,
    /// Entries of the branch stack that belong to the frames below.
    pub(crate) branches: u32,
    /// The step at which it goes on by steps when the rung ends, or [`crate::program::NONE`].
    pub(crate) resume: u32,
    pub(crate) role: Role,
    pub(crate) prescan: bool,
}

/// Where a value is read or written, every subscript evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Slot {
    Constant(Number),
    Bit(u32),
    WordBit { word: u32, bit: u8, element: twinrung_catalog::Element },
    Word { word: u32, element: twinrung_catalog::Element },
    Region { bit: u32, bit_cells: u32, word: u32, word_cells: u32 },
}

/// The state of a library half, and of which instruction.
#[derive(Debug, Clone)]
pub(crate) struct Keeper {
    pub(crate) opcode: Opcode,
    pub(crate) state: State,
    /// Whether a prescan of the half has run since loading or reset; without one its first execution begins with it
    /// (REQ-EXEC-061).
    pub(crate) prescanned: bool,
}

/// Everything that a scan changes.
#[derive(Debug, Clone)]
pub(crate) struct Machine {
    /// Bit cells: the image's, then constants, then scratch; a power of two.
    pub(crate) bits: Vec<u8>,
    /// Word cells: the image's, then constants.
    pub(crate) words: Vec<u32>,
    /// One hidden word for every two word cells: the `last_time` of a TIMER, a mark for a CONTROL. Both have
    /// two words side by side, so half the cell of the first is theirs alone.
    pub(crate) hidden: Vec<i64>,
    pub(crate) keepers: Vec<Keeper>,
    pub(crate) initial_bits: Vec<u8>,
    pub(crate) initial_words: Vec<i32>,
    pub(crate) constants: Vec<i32>,
    pub(crate) status: Status,
    pub(crate) first_scan_armed: bool,
    pub(crate) events: Vec<u32>,
    pub(crate) records: Vec<FaultRecord>,
    pub(crate) frames: Stack<Frame>,
    /// Rung condition at a branch's begin, and the OR of its ended legs.
    pub(crate) branches: Stack<(bool, bool)>,
    /// Bodies that the prescan of this program has visited.
    pub(crate) visited: Vec<bool>,
    /// Backward jumps of each JMP in the execution of its routine that goes on, and then the same again for executions
    /// by the fault routine: it may call a routine that the fault has halted.
    pub(crate) jumps: Vec<u32>,
    pub(crate) values: [i32; VALUES],
    /// For each value whether something overflowed while it was computed.
    pub(crate) overflowed: [bool; VALUES],
    pub(crate) addresses: [(u32, u32, u32); ADDRESSES],
    pub(crate) slots: [Slot; TRANSFERS],
    pub(crate) numbers: [Number; TRANSFERS],
    /// What the return operands of each frame's JSR selected: `most_returns` for each frame.
    pub(crate) returns: Vec<Slot>,
    /// Return operands of the JSR that has the most.
    pub(crate) most_returns: usize,
    /// Cells of structures on their way between two routines.
    pub(crate) passing_bits: Vec<u8>,
    pub(crate) passing_words: Vec<u32>,
    pub(crate) copied: Vec<u8>,
    /// The program that runs.
    pub(crate) program: u16,
    /// The fault that its fault routine handles.
    pub(crate) handling: Option<MajorFault>,
    /// Whether no fault routine runs any more: one ran in this scan, or this is a prescan.
    pub(crate) handled: bool,
    /// Instructions of the execution that goes on; it counts from 0, whatever `status.executed` holds.
    pub(crate) spent: u64,
    /// Signature of the path that control has taken in this execution (REQ-SCAN-010).
    pub(crate) path: u32,
    /// Whether a word was set from outside to a negative value since timers were last checked.
    pub(crate) doubtful: bool,
}

impl Machine {
    pub(crate) fn new(image: &Image, loaded: &Loaded) -> Result<Machine, LoadError> {
        let mut keepers = Vec::with_capacity(loaded.safety_states.len());
        for opcode in &loaded.safety_states {
            let state = State::new(*opcode)
                .ok_or(LoadError::Unsupported("a safety application instruction without library"))?;
            keepers.push(Keeper { opcode: *opcode, state, prescanned: false });
        }
        let program = &loaded.program;
        let words = image.initial_words.len().saturating_add(loaded.constants.len());
        let (passing_bits, passing_words) = passing(program);
        let jsrs = program.instructions.iter().filter(|instruction| instruction.opcode == Opcode::Jsr);
        let most_returns = jsrs.map(|jsr| jsr_operands(program, *jsr, true).count).max().unwrap_or(0) as usize;
        let mut machine = Machine {
            bits: vec![0; loaded.bit_bank],
            words: vec![0; words],
            hidden: vec![0; (image.initial_words.len() / 2).saturating_add(1)],
            keepers,
            initial_bits: image.initial_bits.clone(),
            initial_words: image.initial_words.clone(),
            constants: loaded.constants.clone(),
            status: Status::default(),
            first_scan_armed: false,
            events: vec![0; image.event_tasks.len()],
            records: vec![FaultRecord::default(); image.programs.len()],
            frames: Stack::with_room(FRAMES),
            branches: Stack::with_room(BRANCHES),
            visited: vec![false; program.bodies.len()],
            jumps: vec![0; program.jumps.len().saturating_mul(2)],
            values: [0; VALUES],
            overflowed: [false; VALUES],
            addresses: [(0, 0, 0); ADDRESSES],
            slots: [Slot::Constant(Number::Integer(0)); TRANSFERS],
            numbers: [Number::Integer(0); TRANSFERS],
            returns: vec![Slot::Constant(Number::Integer(0)); FRAMES.saturating_mul(most_returns)],
            most_returns,
            passing_bits: vec![0; passing_bits],
            passing_words: vec![0; passing_words],
            copied: vec![0; if program.copies.is_empty() { 0 } else { limits::COPY_BYTES as usize }],
            program: 0,
            handling: None,
            handled: false,
            spent: 0,
            path: 0,
            doubtful: true,
        };
        machine.reset(program);
        Ok(machine)
    }

    /// Sets everything to what it is after loading.
    pub(crate) fn reset(&mut self, program: &Program) {
        self.bits.fill(0);
        for (cell, initial) in self.bits.iter_mut().zip(&self.initial_bits) {
            *cell = *initial & 1;
        }
        let initial = self.initial_words.iter().chain(&self.constants);
        for (cell, initial) in self.words.iter_mut().zip(initial) {
            *cell = *initial as u32;
        }
        for cell in [program.one, program.rail] {
            if let Some(cell) = self.bits.get_mut(cell as usize) {
                *cell = 1;
            }
        }
        self.hidden.fill(0);
        for keeper in &mut self.keepers {
            if let Some(state) = State::new(keeper.opcode) {
                keeper.state = state;
                keeper.prescanned = false;
            }
        }
        self.status = Status::default();
        self.first_scan_armed = false;
        self.events.fill(0);
        self.records.fill(FaultRecord::default());
        self.frames.clear();
        self.branches.clear();
        self.visited.fill(false);
        self.jumps.fill(0);
        self.handling = None;
        self.handled = false;
        self.path = 0;
        self.doubtful = true;
    }

    pub(crate) fn bit(&self, cell: u32) -> bool {
        self.bits.get(cell as usize).is_some_and(|cell| *cell & 1 != 0)
    }

    /// Writes a bit cell without reporting it: scratch, or where nobody observes.
    pub(crate) fn put_bit(&mut self, cell: u32, value: bool) {
        if let Some(cell) = self.bits.get_mut(cell as usize) {
            *cell = u8::from(value);
        }
    }

    pub(crate) fn word(&self, cell: u32) -> i32 {
        self.words.get(cell as usize).map_or(0, |cell| *cell as i32)
    }

    /// Writes a word cell without reporting it.
    pub(crate) fn put_word(&mut self, cell: u32, value: u32) {
        if let Some(cell) = self.words.get_mut(cell as usize) {
            *cell = value;
        }
    }

    /// The hidden word of the TIMER or CONTROL whose first word this is.
    pub(crate) fn hidden(&self, word: u32) -> i64 {
        self.hidden.get((word / 2) as usize).copied().unwrap_or(0)
    }

    pub(crate) fn put_hidden(&mut self, word: u32, value: i64) {
        if let Some(cell) = self.hidden.get_mut((word / 2) as usize) {
            *cell = value;
        }
    }

    /// Where the counters of backward jumps begin that are in use now.
    fn first_jump(&self) -> usize {
        if self.handling.is_some() { self.jumps.len() / 2 } else { 0 }
    }

    /// A routine with these JMPs begins: it counts its backward jumps anew (REQ-EXEC-016).
    pub(crate) fn clear_jumps(&mut self, jumps: Range) {
        let first = self.first_jump().saturating_add(jumps.first as usize);
        if let Some(counters) = self.jumps.get_mut(first..first.saturating_add(jumps.count as usize)) {
            counters.fill(0);
        }
    }

    /// How often a JMP has jumped backward since its routine began.
    pub(crate) fn backward_jumps(&mut self, jump: u32) -> Option<&mut u32> {
        let first = self.first_jump();
        self.jumps.get_mut(first.saturating_add(jump as usize))
    }

    /// What a safety call keeps of the library.
    pub(crate) fn keeper(&mut self, state: u32) -> Option<&mut Keeper> {
        self.keepers.get_mut(state as usize)
    }
}

/// Room that structures need on their way between two routines: the most that one instruction passes.
fn passing(program: &Program) -> (usize, usize) {
    let mut most = (0usize, 0usize);
    for instruction in &program.instructions {
        let mut sum = (0usize, 0usize);
        for operand in instruction.operands.of(&program.operands) {
            if let Operand::Region { bit_cells, word_cells, .. } = operand {
                sum.0 = sum.0.saturating_add(*bit_cells as usize);
                sum.1 = sum.1.saturating_add(*word_cells as usize);
            }
        }
        let passes = matches!(instruction.opcode, Opcode::Jsr | Opcode::Sbr | Opcode::Ret);
        if passes {
            most = (most.0.max(sum.0), most.1.max(sum.1));
        }
    }
    most
}
