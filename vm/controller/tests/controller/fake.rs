//! Channels whose behaviour a test chooses, and a controller around two of them.

use twinrung_bytecode::channel::{Channel, MajorFault, Place, Representation, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::format;
use twinrung_bytecode::image::{
    ControllerRecord, Image, OperandTable, Owner, ProgramRecord, RoutineRecord, TagKind, TagRecord, TaskRecord,
    TypeReference,
};
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, RoutineIndex, WordCell};
use twinrung_bytecode::observer::Observer;
use twinrung_bytecode::{AdmittedImage, admit, seal};
use twinrung_catalog::{Element, Opcode};
use twinrung_controller::Controller;

/// What a fake channel does in its scans: the initial value of the tag `Behaviour` tells.
pub const FAITHFUL: i32 = 0;
pub const DIFFERS_IN_A_BIT: i32 = 1;
pub const DIFFERS_IN_A_WORD: i32 = 2;
pub const DIFFERS_IN_STATUS: i32 = 3;
pub const FAULTS: i32 = 4;
pub const EXCEEDS_BUDGET: i32 = 5;
pub const DIFFERS_IN_RECORD: i32 = 6;
pub const DIFFERS_IN_PATH: i32 = 7;
pub const EXCEEDS_BUDGET_ON_ANOTHER_PATH: i32 = 8;
pub const EXECUTES_NOTHING: i32 = 9;
pub const LOSES_A_CELL: i32 = 10;
pub const FIRST_STOPS: i32 = 11;
pub const SECOND_STOPS: i32 = 12;
pub const FAULTS_IN_PRESCAN: i32 = 13;
pub const SECOND_FAULTS_IN_PRESCAN: i32 = 14;
pub const LOSES_A_CELL_IN_PRESCAN: i32 = 15;
pub const STOPS_IN_PRESCAN: i32 = 16;

const FAULT: ScanEnd = ScanEnd::MajorFault(MajorFault {
    code: 20,
    place: Place { program: ProgramIndex(0), routine: RoutineIndex(0), rung: 0, element: 0 },
});

/// Copies its input to its output; from its third scan on it behaves as it was told.
pub struct Fake<const SECOND: bool> {
    bits: Vec<u8>,
    words: Vec<u32>,
    behaviour: i32,
    scans: u64,
    pub prescans: u64,
    record: [i32; 11],
    /// Time and budget of the last scan.
    pub told: (i64, u64),
    /// The values of system attributes of the last scan.
    pub system_values: Vec<i32>,
}

pub const INPUT: BitCell = BitCell(0);
pub const OUTPUT: BitCell = BitCell(1);
pub const COUNT: WordCell = WordCell(1);
/// The cell of the tag that tells the behaviour, which nothing reads after loading.
pub const BEHAVIOUR: WordCell = WordCell(0);

impl<const SECOND: bool> Fake<SECOND> {
    const MASK: u32 = if SECOND { u32::MAX } else { 0 };

    fn plain_bit(&self, cell: BitCell) -> bool {
        (self.bits[cell.position()] ^ Self::MASK as u8) == 1
    }
}

impl<const SECOND: bool> Channel for Fake<SECOND> {
    type LoadError = String;
    const REPRESENTATION: Representation = if SECOND { Representation::Complemented } else { Representation::Plain };

    fn load(image: &AdmittedImage) -> Result<Self, String> {
        let records = image.image();
        Ok(Fake {
            bits: records.initial_bits.iter().map(|bit| bit ^ Self::MASK as u8).collect(),
            words: records.initial_words.iter().map(|word| *word as u32 ^ Self::MASK).collect(),
            behaviour: records.initial_words[0],
            scans: 0,
            prescans: 0,
            record: [0; 11],
            told: (0, 0),
            system_values: Vec::new(),
        })
    }

    fn reset(&mut self) {}

    fn prescan<O: Observer>(&mut self, _inputs: ScanInputs<'_>, _observer: &mut O) -> ScanEnd {
        self.prescans += 1;
        match self.behaviour {
            FAULTS_IN_PRESCAN => FAULT,
            SECOND_FAULTS_IN_PRESCAN if SECOND => FAULT,
            LOSES_A_CELL_IN_PRESCAN => {
                self.words.pop();
                ScanEnd::Completed
            }
            _ => ScanEnd::Completed,
        }
    }

    fn has_stopped(&self) -> bool {
        self.behaviour == STOPS_IN_PRESCAN
            || self.scans >= 3 && self.behaviour == if SECOND { SECOND_STOPS } else { FIRST_STOPS }
    }

    fn scan<O: Observer>(&mut self, inputs: ScanInputs<'_>, _observer: &mut O) -> ScanEnd {
        self.told = (inputs.now_ms, inputs.budget);
        self.system_values = inputs.system_values.to_vec();
        if self.behaviour == EXECUTES_NOTHING && self.scans == 2 {
            return ScanEnd::Completed;
        }
        self.scans += 1;
        let input = self.plain_bit(INPUT);
        self.set_bit(OUTPUT, input);
        self.set_word(COUNT, self.scans as i32);
        let acts = self.scans >= 3;
        match self.behaviour {
            DIFFERS_IN_A_BIT if acts && SECOND => self.set_bit(OUTPUT, !input),
            DIFFERS_IN_A_WORD if acts && SECOND => self.set_word(COUNT, -1),
            LOSES_A_CELL if acts => drop(self.words.pop()),
            DIFFERS_IN_RECORD if acts && SECOND => self.record[2] = 4,
            FAULTS if acts => return FAULT,
            EXCEEDS_BUDGET | EXCEEDS_BUDGET_ON_ANOTHER_PATH if acts => return ScanEnd::BudgetExceeded,
            _ => {}
        }
        ScanEnd::Completed
    }

    fn set_bit(&mut self, cell: BitCell, value: bool) {
        self.bits[cell.position()] = u8::from(value) ^ Self::MASK as u8;
    }

    fn set_word(&mut self, cell: WordCell, value: i32) {
        self.words[cell.position()] = value as u32 ^ Self::MASK;
    }

    fn bits(&self) -> &[u8] {
        &self.bits
    }

    fn words(&self) -> &[u32] {
        &self.words
    }

    fn status(&self) -> Status {
        let differs = self.behaviour == DIFFERS_IN_STATUS && self.scans >= 3 && SECOND;
        Status { executed: self.scans, carry: differs, ..Status::default() }
    }

    fn events(&self, _task: EventTaskIndex) -> u32 {
        self.scans as u32
    }

    fn fault_record(&self, _program: ProgramIndex) -> Option<[i32; 11]> {
        Some(self.record)
    }

    fn path_signature(&self) -> u32 {
        let differs = [DIFFERS_IN_PATH, EXCEEDS_BUDGET_ON_ANOTHER_PATH].contains(&self.behaviour);
        u32::from(differs && self.scans >= 3 && SECOND)
    }
}

fn tag(name: &str, element: Element, kind: TagKind, bit_cell: u32, word_cell: u32) -> TagRecord {
    TagRecord {
        name: name.into(),
        program: None,
        type_reference: TypeReference::Element(element),
        dimensions: [0; 3],
        kind,
        constant: false,
        bit_cell,
        word_cell,
        attributes: Vec::new(),
    }
}

/// An image of one program with one rung.
pub fn image(behaviour: i32) -> Image {
    Image {
        controller: ControllerRecord {
            name: "Fake".into(),
            processor: "1756-L73S".into(),
            revision: 20,
            attributes: Vec::new(),
        },
        programs: vec![ProgramRecord {
            name: "Main".into(),
            main: Some(RoutineIndex(0)),
            fault: None,
            disabled: false,
        }],
        tags: vec![
            tag("Behaviour", Element::Dint, TagKind::Base, 0, 0),
            tag("Count", Element::Dint, TagKind::Base, 0, 1),
            tag("In", Element::Bool, TagKind::ModuleInput, 0, 2),
            tag("Out", Element::Bool, TagKind::ModuleOutput, 1, 2),
        ],
        routines: vec![RoutineRecord {
            owner: Owner::Program(ProgramIndex(0)),
            name: "Main".into(),
            code: vec![format::RUNG, Opcode::Nop as u8, 0, format::END_RUNG],
            text: "NOP();\n".into(),
        }],
        operands: OperandTable { offsets: vec![0], bytes: Vec::new() },
        task: Some(TaskRecord {
            name: "Safety".into(),
            period_us: 10_000,
            watchdog_us: 10_000,
            priority: 5,
            schedule: vec![ProgramIndex(0)],
        }),
        initial_bits: vec![0; 2],
        initial_words: vec![behaviour, 0],
        ..Image::default()
    }
}

pub fn sealed(behaviour: i32) -> Vec<u8> {
    seal(&image(behaviour)).unwrap()
}

pub type Pair = Controller<Fake<false>, Fake<true>>;

pub fn running(behaviour: i32) -> Pair {
    running_image(&image(behaviour))
}

/// A controller that runs an image, with its input driven true.
pub fn running_image(image: &Image) -> Pair {
    let bytes = seal(image).unwrap();
    let mut controller = Pair::load(admit(&bytes).unwrap(), &bytes).unwrap();
    controller.power_up_in_run();
    controller.drive_bit(INPUT, true);
    controller
}
