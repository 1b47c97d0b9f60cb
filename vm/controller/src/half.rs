//! One half of the controller: all that a scan needs besides the channel, held once for each channel. The first half holds
//! values as they are, the second complemented, so that no fault in one place of memory reaches both channels, and what the
//! machine sees is what both halves say.

use alloc::vec::Vec;

use twinrung_bytecode::CellRange;
use twinrung_bytecode::channel::{Channel, ScanInputs};
use twinrung_bytecode::index::{BitCell, WordCell};

use crate::compare::mask;
use crate::time::{Reference, TimeCheck, TimeFault};
use crate::verdict::{Step, Verdict};

/// Whether logic may execute, as a number that no few flipped bits turn into another of these.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Permit {
    /// It may not: Program, or stopped.
    Halted,
    /// It may, after a prescan.
    Armed,
    /// It may.
    Running,
}

impl Permit {
    const ALL: [Permit; 3] = [Permit::Halted, Permit::Armed, Permit::Running];

    const fn number(self) -> u64 {
        match self {
            Permit::Halted => 0x0F1E_2D3C_4B5A_6978,
            Permit::Armed => 0x96A5_B4C3_D2E1_F00F,
            Permit::Running => 0xC33C_A55A_6996_0FF0,
        }
    }
}

/// One half. `MASK` is 0 where it holds values as they are, all ones where complemented.
#[derive(Debug, Clone)]
pub(crate) struct Half<const MASK: u32, V> {
    frozen: Vec<CellRange>,
    published: Vec<CellRange>,
    input_bits: Vec<u8>,
    input_words: Vec<u32>,
    output_bits: Vec<u8>,
    output_words: Vec<u32>,
    system_values: Vec<i32>,
    budget: u64,
    now_ms: u64,
    time: TimeCheck,
    permit: u64,
    challenge: u64,
    verdict: V,
    executed: u64,
}

impl<const MASK: u32, V: Verdict> Half<MASK, V> {
    /// The mask for numbers of 64 bits.
    const LONG: u64 = (MASK as u64) << 32 | MASK as u64;

    pub(crate) fn new(image: &twinrung_bytecode::AdmittedImage, budget: u64) -> Half<MASK, V> {
        let records = image.image();
        Half {
            frozen: image.frozen().to_vec(),
            published: image.published().to_vec(),
            input_bits: records.initial_bits.iter().map(|bit| bit ^ MASK as u8).collect(),
            input_words: records.initial_words.iter().map(|word| *word as u32 ^ MASK).collect(),
            output_bits: alloc::vec![MASK as u8; records.initial_bits.len()],
            output_words: alloc::vec![MASK; records.initial_words.len()],
            system_values: alloc::vec![0; records.system_values_length()],
            budget: budget ^ Self::LONG,
            now_ms: 0,
            time: TimeCheck::new(),
            permit: Permit::Halted.number() ^ Self::LONG,
            challenge: 0,
            verdict: V::begin(0),
            executed: 0,
        }
    }

    pub(crate) fn set_system_value(&mut self, position: usize, value: i32) {
        if let Some(slot) = self.system_values.get_mut(position) {
            *slot = value;
        }
    }

    pub(crate) fn freeze_also(&mut self, range: CellRange) {
        if !self.frozen.contains(&range) {
            self.frozen.push(range);
        }
    }

    pub(crate) fn publish_also(&mut self, range: CellRange) {
        if !self.published.contains(&range) {
            self.published.push(range);
        }
    }

    pub(crate) fn drive_bit(&mut self, cell: BitCell, value: bool) {
        if let Some(slot) = self.input_bits.get_mut(cell.position()) {
            *slot = u8::from(value) ^ MASK as u8;
        }
    }

    pub(crate) fn driven_bit(&self, cell: BitCell) -> Option<bool> {
        self.input_bits.get(cell.position()).map(|byte| byte ^ MASK as u8 == 1)
    }

    pub(crate) fn driven_word(&self, cell: WordCell) -> Option<i32> {
        self.input_words.get(cell.position()).map(|word| (word ^ MASK) as i32)
    }

    pub(crate) fn drive_word(&mut self, cell: WordCell, value: i32) {
        if let Some(slot) = self.input_words.get_mut(cell.position()) {
            *slot = value as u32 ^ MASK;
        }
    }

    pub(crate) fn permit(&mut self, permit: Permit) {
        self.permit = permit.number() ^ Self::LONG;
    }

    /// What this half permits; `None` where its number is none.
    pub(crate) fn permitted(&self) -> Option<Permit> {
        Permit::ALL.into_iter().find(|permit| permit.number() == self.permit ^ Self::LONG)
    }

    /// A scan begins at this time.
    pub(crate) fn begin(&mut self, now_ms: i64, reference: Option<Reference>) -> Option<TimeFault> {
        self.now_ms = now_ms as u64 ^ Self::LONG;
        self.challenge = self.challenge.wrapping_add(1);
        self.verdict = V::begin(self.challenge);
        let fault = self.time.judge(now_ms, reference);
        self.step(Step::Time, u64::from(fault.is_some()));
        fault
    }

    /// Which scan this is: another number in every scan.
    pub(crate) const fn challenge(&self) -> u64 {
        self.challenge
    }

    /// A step of the scan was taken; `remainder` is what it found wrong, 0 where that is nothing.
    pub(crate) fn step(&mut self, step: Step, remainder: u64) {
        self.verdict = self.verdict.after(step, remainder);
    }

    /// What the channel of this half is told.
    pub(crate) fn inputs(&self) -> ScanInputs<'_> {
        ScanInputs {
            now_ms: (self.now_ms ^ Self::LONG) as i64,
            budget: self.budget ^ Self::LONG,
            system_values: &self.system_values,
        }
    }

    /// Copies inputs and mapped tags into the channel of this half.
    pub(crate) fn freeze<C: Channel>(&mut self, channel: &mut C) {
        for range in &self.frozen {
            for (offset, value) in self.input_bits.get(bits_of(range)).unwrap_or_default().iter().enumerate() {
                let cell = BitCell(range.bit_cell.wrapping_add(offset as u32));
                channel.set_bit(cell, value ^ MASK as u8 == 1);
            }
            for (offset, value) in self.input_words.get(words_of(range)).unwrap_or_default().iter().enumerate() {
                let cell = WordCell(range.word_cell.wrapping_add(offset as u32));
                channel.set_word(cell, (value ^ MASK) as i32);
            }
        }
        self.executed = channel.status().executed;
        self.step(Step::Freeze, 0);
    }

    /// Whether the channel of this half has executed something since its inputs were frozen.
    pub(crate) fn has_executed<C: Channel>(&self, channel: &C) -> bool {
        channel.status().executed != self.executed
    }

    /// Takes over outputs from the channel of this half, as far as this half's verdict lets them through.
    pub(crate) fn publish<C: Channel>(&mut self, channel: &C) {
        let turn = mask(C::REPRESENTATION);
        let gate = self.verdict.gate(self.challenge);
        for range in &self.published {
            let source = channel.bits().get(bits_of(range)).unwrap_or_default();
            let target = self.output_bits.get_mut(bits_of(range)).unwrap_or_default();
            for (to, from) in target.iter_mut().zip(source) {
                *to = ((from ^ turn as u8) & gate as u8) ^ MASK as u8;
            }
            let source = channel.words().get(words_of(range)).unwrap_or_default();
            let target = self.output_words.get_mut(words_of(range)).unwrap_or_default();
            for (to, from) in target.iter_mut().zip(source) {
                *to = ((from ^ turn) & gate) ^ MASK;
            }
        }
    }

    /// Whether this half's verdict lets outputs through.
    pub(crate) fn is_open(&self) -> bool {
        self.verdict.gate(self.challenge) == u32::MAX
    }

    /// All outputs off.
    pub(crate) fn off(&mut self) {
        self.output_bits.fill(MASK as u8);
        self.output_words.fill(MASK);
    }

    /// What this half says of an output, as it is.
    pub(crate) fn output_bit(&self, cell: BitCell) -> Option<u8> {
        self.output_bits.get(cell.position()).map(|byte| byte ^ MASK as u8)
    }

    /// What this half says of an output, as it is.
    pub(crate) fn output_word(&self, cell: WordCell) -> Option<u32> {
        self.output_words.get(cell.position()).map(|word| word ^ MASK)
    }

    /// Whether another half says the same of all outputs that this one publishes.
    pub(crate) fn agrees<const OTHER: u32, W>(&self, other: &Half<OTHER, W>) -> bool {
        let turn = MASK ^ OTHER;
        self.published.iter().all(|range| {
            let (own_bits, other_bits) = (self.output_bits.get(bits_of(range)), other.output_bits.get(bits_of(range)));
            let (own_words, other_words) =
                (self.output_words.get(words_of(range)), other.output_words.get(words_of(range)));
            let (Some(own_bits), Some(other_bits), Some(own_words), Some(other_words)) =
                (own_bits, other_bits, own_words, other_words)
            else {
                return false;
            };
            own_bits.iter().zip(other_bits).all(|(own, other)| own ^ other == turn as u8)
                && own_words.iter().zip(other_words).all(|(own, other)| own ^ other == turn)
        })
    }

    /// For fault injection: everything that it holds.
    #[cfg(feature = "injection")]
    pub(crate) fn visit_bits(
        &mut self,
        memory: crate::SharedMemory,
        visitor: &mut twinrung_bytecode::injection::BitVisitor,
    ) {
        use crate::SharedMemory;
        let ranges = |ranges: &mut Vec<CellRange>, visitor: &mut twinrung_bytecode::injection::BitVisitor| {
            for range in ranges {
                visitor.field(&mut range.bit_cell);
                visitor.field(&mut range.bit_cells);
                visitor.field(&mut range.word_cell);
                visitor.field(&mut range.word_cells);
            }
        };
        match memory {
            SharedMemory::Inputs => {
                visitor.fields(&mut self.input_bits);
                visitor.fields(&mut self.input_words);
                visitor.fields(&mut self.system_values);
            }
            SharedMemory::Outputs => {
                visitor.fields(&mut self.output_bits);
                visitor.fields(&mut self.output_words);
            }
            SharedMemory::Configuration => {
                ranges(&mut self.frozen, visitor);
                ranges(&mut self.published, visitor);
            }
            SharedMemory::Time => {
                visitor.field(&mut self.now_ms);
                self.time.visit_bits(visitor);
            }
            SharedMemory::Budget => visitor.field(&mut self.budget),
            SharedMemory::Verdict => {
                visitor.field(self.verdict.number());
                visitor.field(&mut self.challenge);
                visitor.field(&mut self.executed);
            }
            SharedMemory::Permit => visitor.field(&mut self.permit),
            SharedMemory::Image | SharedMemory::Mode => {}
        }
    }
}

fn bits_of(range: &CellRange) -> core::ops::Range<usize> {
    let begin = range.bit_cell as usize;
    begin..begin.saturating_add(range.bit_cells as usize)
}

fn words_of(range: &CellRange) -> core::ops::Range<usize> {
    let begin = range.word_cell as usize;
    begin..begin.saturating_add(range.word_cells as usize)
}
