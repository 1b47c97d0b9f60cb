//! The scan cycle with channels whose behaviour a test chooses.

use twinrung_bytecode::channel::{Channel, MajorFault, Place, Representation, ScanEnd, ScanInputs, Status};
use twinrung_bytecode::image::{
    ControllerRecord, Image, OperandTable, Owner, ProgramRecord, RoutineRecord, TagKind, TagRecord, TaskRecord,
    TypeReference,
};
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, RoutineIndex, WordCell};
use twinrung_bytecode::observer::Observer;
use twinrung_bytecode::observer::Silent;
use twinrung_bytecode::{AdmittedImage, admit, seal};
use twinrung_catalog::Element;
use twinrung_controller::{
    Controller, Difference, IMAGE_CHECK_BYTES_PER_SCAN, Mode, NoClock, Part, SafetyFault, ScanClock, StopReason,
};

/// What a fake channel does in its scans: the initial value of the tag `Behaviour` tells.
const FAITHFUL: i32 = 0;
const DIFFERS_IN_A_BIT: i32 = 1;
const DIFFERS_IN_A_WORD: i32 = 2;
const DIFFERS_IN_STATUS: i32 = 3;
const FAULTS: i32 = 4;
const EXCEEDS_BUDGET: i32 = 5;
const DIFFERS_IN_RECORD: i32 = 6;
const DIFFERS_IN_PATH: i32 = 7;
const EXCEEDS_BUDGET_ON_ANOTHER_PATH: i32 = 8;

/// Copies its input to its output; from its third scan on it behaves as it was told.
struct Fake<const SECOND: bool> {
    bits: Vec<u8>,
    words: Vec<u32>,
    behaviour: i32,
    scans: u64,
    prescans: u64,
    record: [i32; 11],
}

const INPUT: BitCell = BitCell(0);
const OUTPUT: BitCell = BitCell(1);
const COUNT: WordCell = WordCell(1);

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
        })
    }

    fn reset(&mut self) {}

    fn prescan<O: Observer>(&mut self, _inputs: ScanInputs<'_>, _observer: &mut O) -> ScanEnd {
        self.prescans += 1;
        ScanEnd::Completed
    }

    fn scan<O: Observer>(&mut self, _inputs: ScanInputs<'_>, _observer: &mut O) -> ScanEnd {
        self.scans += 1;
        let input = self.plain_bit(INPUT);
        self.set_bit(OUTPUT, input);
        self.set_word(COUNT, self.scans as i32);
        let acts = self.scans >= 3;
        match self.behaviour {
            DIFFERS_IN_A_BIT if acts && SECOND => self.set_bit(OUTPUT, !input),
            DIFFERS_IN_A_WORD if acts && SECOND => self.set_word(COUNT, -1),
            DIFFERS_IN_RECORD if acts && SECOND => self.record[2] = 4,
            FAULTS if acts => {
                let place = Place { program: ProgramIndex(0), routine: RoutineIndex(0), rung: 0, element: 0 };
                return ScanEnd::MajorFault(MajorFault { code: 20, place });
            }
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
        0
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

fn sealed(behaviour: i32) -> Vec<u8> {
    let image = Image {
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
            code: Vec::new(),
            text: String::new(),
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
    };
    seal(&image).unwrap()
}

type Pair = Controller<Fake<false>, Fake<true>>;

fn running(behaviour: i32) -> Pair {
    let bytes = sealed(behaviour);
    let mut controller = Pair::load(admit(&bytes).unwrap(), &bytes).unwrap();
    controller.power_up_in_run();
    controller.drive_bit(INPUT, true);
    controller
}

fn stopped_in_third_scan(behaviour: i32) -> Option<StopReason> {
    let mut controller = running(behaviour);
    assert_eq!(controller.scan(0).stopped, None);
    assert_eq!(controller.scan(10).stopped, None);
    assert_eq!(controller.published_bit(OUTPUT), Some(true), "on before the fault");
    let report = controller.scan(20);
    assert_eq!(controller.published_bit(OUTPUT), Some(false), "off in the scan of the fault");
    assert_eq!(controller.scan(30).stopped, report.stopped, "and it stays stopped");
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
    report.stopped
}

/// REQ-SCAN-001, REQ-SCAN-008
#[test]
fn scan_when_channels_agree_then_outputs_follow_the_frozen_inputs() {
    let mut controller = running(FAITHFUL);
    let report = controller.scan(0);
    assert!(report.executed);
    assert_eq!(controller.published_bit(OUTPUT), Some(true));
    controller.drive_bit(INPUT, false);
    assert_eq!(controller.published_bit(OUTPUT), Some(true), "nothing moves between scans");
    controller.scan(10);
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
    assert_eq!(controller.word(COUNT), Some(2));
}

/// REQ-SCAN-002, REQ-SCAN-003
#[test]
fn scan_when_a_bit_differs_then_outputs_are_off_in_that_scan() {
    let difference = Difference::Bit(OUTPUT, 1, 0);
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_A_BIT), Some(StopReason::Safety(SafetyFault::Difference(difference))));
}

#[test]
fn scan_when_a_word_differs_then_outputs_are_off_in_that_scan() {
    let difference = Difference::Word(COUNT, 3, -1);
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_A_WORD), Some(StopReason::Safety(SafetyFault::Difference(difference))));
}

#[test]
fn scan_when_a_flag_differs_then_outputs_are_off_in_that_scan() {
    let fault = SafetyFault::Difference(Difference::Status);
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_STATUS), Some(StopReason::Safety(fault)));
}

/// REQ-SCAN-010
#[test]
fn scan_when_control_took_another_path_then_outputs_are_off_in_that_scan() {
    let fault = SafetyFault::Difference(Difference::Path);
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_PATH), Some(StopReason::Safety(fault)));
    let budget = stopped_in_third_scan(EXCEEDS_BUDGET_ON_ANOTHER_PATH);
    assert_eq!(
        budget,
        Some(StopReason::Safety(SafetyFault::BudgetExceeded)),
        "where the path was cut off is not compared"
    );
}

#[test]
fn scan_when_a_fault_record_differs_then_outputs_are_off_in_that_scan() {
    let fault = SafetyFault::Difference(Difference::FaultRecord(ProgramIndex(0)));
    assert_eq!(stopped_in_third_scan(DIFFERS_IN_RECORD), Some(StopReason::Safety(fault)));
}

/// REQ-SCAN-005
#[test]
fn scan_when_both_channels_fault_then_the_task_stops_with_14_2() {
    let reason = stopped_in_third_scan(FAULTS).unwrap();
    assert_eq!(reason.type_and_code(), (14, 2));
}

/// REQ-SCAN-004
#[test]
fn scan_when_the_budget_runs_out_then_the_task_stops_with_14_1() {
    let reason = stopped_in_third_scan(EXCEEDS_BUDGET).unwrap();
    assert_eq!(reason, StopReason::Safety(SafetyFault::BudgetExceeded));
    assert_eq!(reason.type_and_code(), (14, 1));
}

/// REQ-SCAN-006
#[test]
fn scan_when_the_image_in_memory_changes_then_it_is_found_within_one_pass() {
    let bytes = sealed(FAITHFUL);
    let mut controller = running(FAITHFUL);
    let scans = bytes.len().div_ceil(IMAGE_CHECK_BYTES_PER_SCAN) as i64;
    let last = controller.checked_bytes_mut().len() - 1;
    controller.checked_bytes_mut()[last] ^= 1;
    let stopped: Vec<_> = (0..scans).map(|scan| controller.scan(scan * 10).stopped).collect();
    assert_eq!(stopped.last(), Some(&Some(StopReason::Safety(SafetyFault::ImageCorrupted))));
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
}

/// REQ-SCAN-007
#[test]
fn mode_when_a_change_is_asked_for_then_it_acts_after_more_than_one_and_less_than_two_periods() {
    let mut controller = running(FAITHFUL);
    controller.scan(0);
    controller.request_mode(Mode::Program);
    assert!(controller.scan(10).executed, "one period has not passed");
    assert!(!controller.scan(20).executed);
    assert_eq!(controller.mode(), Mode::Program);
    assert_eq!(controller.published_bit(OUTPUT), Some(false), "outputs are off in Program");
    controller.request_mode(Mode::Run);
    assert!(!controller.scan(30).executed);
    assert!(controller.scan(40).executed);
    assert_eq!(controller.channels_mut().0.prescans, 2, "each change to Run prescans");
}

/// A clock that says that the watchdog has expired in one scan.
struct Late {
    expires_in: u32,
    parts: Vec<Part>,
}

impl ScanClock for Late {
    fn begin(&mut self) {
        self.parts.clear();
    }

    fn ended(&mut self, part: Part) {
        self.parts.push(part);
    }

    fn expired(&mut self) -> bool {
        self.expires_in -= 1;
        self.expires_in == 0
    }
}

/// REQ-SCAN-004
#[test]
fn scan_when_the_clock_says_that_it_took_too_long_then_nothing_is_published() {
    let mut controller = running(FAITHFUL);
    let mut clock = Late { expires_in: 2, parts: Vec::new() };
    controller.scan_observed(0, &mut clock, &mut Silent, &mut Silent);
    assert_eq!(clock.parts, Part::ALL);
    assert_eq!(controller.published_bit(OUTPUT), Some(true));
    let report = controller.scan_observed(10, &mut clock, &mut Silent, &mut Silent);
    assert_eq!(report.stopped, Some(StopReason::Safety(SafetyFault::WatchdogExpired)));
    assert_eq!(controller.published_bit(OUTPUT), Some(false));
    assert_eq!(controller.scan_observed(20, &mut NoClock, &mut Silent, &mut Silent).stopped, report.stopped);
}
