//! Runs one image twice, by steps and observed in the order of the text, and holds both to equal cells and status.

use alloc::vec::Vec;

use twinrung_bytecode::channel::{Channel, Place, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, WordCell};
use twinrung_bytecode::observer::{Observer, Silent};

use super::assembler::{Assembler, Cell};
use crate::Primary;

/// Records what it is told.
#[derive(Default)]
pub(crate) struct Recorder {
    pub(crate) rungs: Vec<u32>,
    pub(crate) results: Vec<(u32, u32, bool, bool)>,
    pub(crate) bits: Vec<(u32, bool)>,
    pub(crate) words: Vec<(u32, i32)>,
    pub(crate) retired: u64,
}

impl Observer for Recorder {
    fn rung_entered(&mut self, place: Place) {
        self.rungs.push(place.rung);
    }

    fn element_result(&mut self, place: Place, condition_in: bool, condition_out: bool) {
        self.results.push((place.rung, place.element, condition_in, condition_out));
    }

    fn bit_written(&mut self, cell: BitCell, value: bool) {
        self.bits.push((cell.0, value));
    }

    fn word_written(&mut self, cell: WordCell, value: i32) {
        self.words.push((cell.0, value));
    }

    fn instructions_retired(&mut self, count: u64) {
        self.retired += count;
    }
}

/// An image in execution.
pub(crate) struct Rig {
    pub(crate) assembler: Assembler,
    pub(crate) silent: Primary,
    pub(crate) observed: Primary,
    pub(crate) recorder: Recorder,
    pub(crate) now_ms: i64,
    pub(crate) budget: u64,
    pub(crate) system_values: Vec<i32>,
}

impl Rig {
    /// Tags and the main routine's rungs.
    pub(crate) fn new(tags: &str, rungs: &[&str]) -> Rig {
        let mut assembler = Assembler::new();
        assembler.tags(tags);
        assembler.main(rungs);
        Rig::of(assembler)
    }

    pub(crate) fn of(assembler: Assembler) -> Rig {
        let silent = assembler.build();
        let observed = assembler.build();
        let (recorder, system_values) = (Recorder::default(), Vec::new());
        Rig { assembler, silent, observed, recorder, now_ms: 0, budget: u64::MAX, system_values }
    }

    /// Prescan at the current time.
    pub(crate) fn prescan(&mut self) -> ScanEnd {
        let inputs = ScanInputs { now_ms: self.now_ms, budget: self.budget, system_values: &self.system_values };
        let end = self.silent.prescan(inputs, &mut Silent);
        assert_eq!(end, self.observed.prescan(inputs, &mut self.recorder));
        self.same();
        end
    }

    /// One scan at the current time, which then goes on by 10 ms.
    pub(crate) fn scan(&mut self) -> ScanEnd {
        let inputs = ScanInputs { now_ms: self.now_ms, budget: self.budget, system_values: &self.system_values };
        let end = self.silent.scan(inputs, &mut Silent);
        assert_eq!(end, self.observed.scan(inputs, &mut self.recorder));
        self.now_ms += 10;
        self.same();
        end
    }

    fn same(&self) {
        assert_eq!(self.silent.bits(), self.observed.bits());
        assert_eq!(self.silent.words(), self.observed.words());
        assert_eq!(self.silent.status(), self.observed.status());
        assert_eq!(self.silent.fault_record(ProgramIndex(0)), self.observed.fault_record(ProgramIndex(0)));
        assert_eq!(self.silent.path_signature(), self.observed.path_signature());
        assert_eq!(self.silent.events(EventTaskIndex(0)), self.observed.events(EventTaskIndex(0)));
    }

    /// Sets a tag: a BOOL by 0 or 1.
    pub(crate) fn set(&mut self, name: &str, value: i32) {
        let cell = self.assembler.cell(name);
        for primary in [&mut self.silent, &mut self.observed] {
            match cell {
                Cell::Bit(cell) => primary.set_bit(BitCell(cell), value != 0),
                Cell::Word(cell) => primary.set_word(WordCell(cell), value),
            }
        }
    }

    pub(crate) fn set_real(&mut self, name: &str, value: f32) {
        self.set(name, value.to_bits() as i32);
    }

    pub(crate) fn get(&mut self, name: &str) -> i32 {
        match self.assembler.cell(name) {
            Cell::Bit(cell) => i32::from(self.silent.bits()[cell as usize]),
            Cell::Word(cell) => self.silent.words()[cell as usize] as i32,
        }
    }

    pub(crate) fn get_real(&mut self, name: &str) -> f32 {
        f32::from_bits(self.get(name) as u32)
    }

    /// Several tags at once, by names with blanks between.
    pub(crate) fn all(&mut self, names: &str) -> Vec<i32> {
        names.split_whitespace().map(|name| self.get(name)).collect()
    }

    pub(crate) fn status(&self) -> Status {
        self.silent.status()
    }

    /// S:V S:Z S:N S:C as digits.
    pub(crate) fn flags(&self) -> [bool; 4] {
        let status = self.status();
        [status.overflow, status.zero, status.negative, status.carry]
    }
}
