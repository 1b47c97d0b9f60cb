//! A channel that holds and says what a test tells it, and executes nothing.

use alloc::vec::Vec;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::{Channel, FaultRecord, Representation, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::image::{Image, ProgramRecord};
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, WordCell};
use twinrung_bytecode::observer::Observer;

/// What it holds and says; cells complemented where it is the second of two.
#[derive(Clone)]
pub(crate) struct Holding<const SECOND: bool> {
    pub(crate) bits: Vec<u8>,
    pub(crate) words: Vec<u32>,
    pub(crate) status: Status,
    pub(crate) events: [u32; 2],
    pub(crate) records: [FaultRecord; 2],
    pub(crate) path: u32,
}

/// Cells of each kind: more than one step of the second comparison, and no whole number of steps.
pub(crate) const CELLS: usize = 75;

/// An image with two programs, two event tasks and so many cells.
pub(crate) fn image() -> Image {
    let program = |name: &str| ProgramRecord { name: name.into(), main: None, fault: None, disabled: false };
    Image {
        programs: alloc::vec![program("First"), program("Second")],
        event_tasks: alloc::vec!["One".into(), "Two".into()],
        initial_bits: alloc::vec![0; CELLS],
        initial_words: alloc::vec![0; CELLS],
        ..Image::default()
    }
}

impl<const SECOND: bool> Holding<SECOND> {
    const MASK: u32 = if SECOND { u32::MAX } else { 0 };

    /// Holds a pattern in which no two neighbours are alike.
    pub(crate) fn new() -> Holding<SECOND> {
        let bit = |cell: usize| (cell % 2) as u8 ^ Self::MASK as u8;
        let word = |cell: usize| (cell as u32).wrapping_mul(0x9E37_79B9) ^ Self::MASK;
        Holding {
            bits: (0..CELLS).map(bit).collect(),
            words: (0..CELLS).map(word).collect(),
            status: Status { overflow: true, executed: 12, minor_faults: 3, ..Status::default() },
            events: [4, 5],
            records: [[1; 11], [2; 11]],
            path: 0x1234_5678,
        }
    }
}

impl<const SECOND: bool> Channel for Holding<SECOND> {
    type LoadError = &'static str;
    const REPRESENTATION: Representation = if SECOND { Representation::Complemented } else { Representation::Plain };

    fn load(_image: &AdmittedImage) -> Result<Self, &'static str> {
        Ok(Holding::new())
    }

    fn reset(&mut self) {}

    fn prescan<O: Observer>(&mut self, _inputs: ScanInputs<'_>, _observer: &mut O) -> ScanEnd {
        ScanEnd::Completed
    }

    fn scan<O: Observer>(&mut self, _inputs: ScanInputs<'_>, _observer: &mut O) -> ScanEnd {
        ScanEnd::Completed
    }

    fn set_bit(&mut self, _cell: BitCell, _value: bool) {}

    fn set_word(&mut self, _cell: WordCell, _value: i32) {}

    fn bits(&self) -> &[u8] {
        &self.bits
    }

    fn words(&self) -> &[u32] {
        &self.words
    }

    fn status(&self) -> Status {
        self.status
    }

    fn events(&self, task: EventTaskIndex) -> u32 {
        self.events.get(task.position()).copied().unwrap_or_default()
    }

    fn fault_record(&self, program: ProgramIndex) -> Option<FaultRecord> {
        self.records.get(program.position()).copied()
    }

    fn path_signature(&self) -> u32 {
        self.path
    }
}
