//! The partner as the controller sees it.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::{Channel, Representation, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, WordCell};
use twinrung_bytecode::layout::TypeLayout;
use twinrung_bytecode::observer::Observer;

use crate::ladder::Ladder;
use crate::load::{Library, LoadError, Unit, load, needs_library};
use crate::state::{RECORD_WORDS, State};
use crate::walk::Walker;

/// The safety partner.
#[derive(Debug, Clone)]
pub struct Partner {
    /// What it executes.
    pub(crate) ladder: Ladder,
    /// What that changes.
    pub(crate) state: State,
    /// S:FS as the last execution had it.
    pub(crate) first_scan: bool,
}

impl Partner {
    /// Loads records and the layouts of their types; `library` is the ladder of the safety application instructions.
    fn from_records(image: &Image, layouts: &[TypeLayout], library: Option<&Library>) -> Result<Partner, LoadError> {
        let (ladder, size) = load(Unit { image, layouts }, library.map(Library::unit))?;
        let (bits, words) = (image.initial_bits.len(), image.initial_words.len());
        let state = State::new(&ladder, size, bits, words, image.event_tasks.len());
        Ok(Partner { ladder, state, first_scan: false })
    }

    fn set_first_scan(&mut self, first_scan: bool) {
        self.first_scan = first_scan;
        self.state.memory.set_bit(self.ladder.own.first_scan_bit, first_scan);
    }
}

impl Channel for Partner {
    type LoadError = LoadError;

    const REPRESENTATION: Representation = Representation::Complemented;

    fn load(image: &AdmittedImage) -> Result<Partner, LoadError> {
        let records = image.image();
        if !needs_library(records) {
            return Partner::from_records(records, image.layouts(), None);
        }
        let library = Library::read(twinrung_safety_partner::LIBRARY, twinrung_safety_partner::SIGNATURE)?;
        Partner::from_records(records, image.layouts(), Some(&library))
    }

    fn reset(&mut self) {
        self.state.reset(&self.ladder);
        self.set_first_scan(false);
    }

    fn prescan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        self.state.begin();
        self.state.status = crate::state::Flags::default();
        self.state.cleared_faults = 0;
        self.state.records.fill([0; RECORD_WORDS]);
        // Timers of the library belong to the prescan of their instruction, which a fault may end this one before.
        let image_words = self.state.memory.image_words;
        self.state.memory.set_stamps(0..image_words, inputs.now_ms);
        self.set_first_scan(false);
        self.state.armed = true;
        Walker::new(&self.ladder, &mut self.state, observer, inputs).prescan()
    }

    fn scan<O: Observer>(&mut self, inputs: ScanInputs<'_>, observer: &mut O) -> ScanEnd {
        self.state.begin();
        let first_scan = core::mem::replace(&mut self.state.armed, false);
        self.set_first_scan(first_scan);
        Walker::new(&self.ladder, &mut self.state, observer, inputs).scan()
    }

    fn set_bit(&mut self, cell: BitCell, value: bool) {
        if cell.position() < self.state.memory.image_bits {
            self.state.memory.set_bit(cell.0, value);
        }
    }

    fn set_word(&mut self, cell: WordCell, value: i32) {
        if cell.position() < self.state.memory.image_words {
            self.state.memory.set_word(cell.0, value);
        }
    }

    fn bits(&self) -> &[u8] {
        self.state.memory.bits.get(..self.state.memory.image_bits).unwrap_or(&[])
    }

    fn words(&self) -> &[u32] {
        self.state.memory.words.get(..self.state.memory.image_words).unwrap_or(&[])
    }

    fn status(&self) -> Status {
        self.state.status(self.first_scan)
    }

    fn events(&self, task: EventTaskIndex) -> u32 {
        self.state.events.get(task.position()).copied().unwrap_or(0)
    }

    fn fault_record(&self, program: ProgramIndex) -> Option<[i32; RECORD_WORDS]> {
        self.state.records.get(program.position()).copied()
    }

    fn path_signature(&self) -> u32 {
        self.state.path
    }
}
