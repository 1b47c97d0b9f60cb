//! The partner on a thread of its own: the same results as on one thread, and a partner that stops is a fault, not a hang.

use std::fs;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use twinrung_bytecode::channel::{Channel, Status};
use twinrung_bytecode::index::{BitCell, TagIndex, WordCell};
use twinrung_bytecode::observer::Silent;
use twinrung_bytecode::{AdmittedImage, CellRange};
use twinrung_controller::{
    Controller, DualController, Partner, Primary, SafetyFault, ScanClock, ScanReport, StopReason,
};
use twinrung_trio::Subject;
use twinrung_workbench::drive::Drive;
use twinrung_workbench::generate::{self, Size};
use twinrung_workbench::{OnThread, cells, names};

use crate::support::{image_of, project_path, read_whole, stimulus};
use crate::wrong_partner::{Defect, WrongPartner};

type Threaded = Controller<Primary, OnThread<Partner>>;

/// Random programs, and scans of each.
const PROGRAMS: u64 = 120;
const SCANS: usize = 40;

fn loaded<B: Channel>(image: &AdmittedImage, bytes: &[u8]) -> Controller<Primary, B> {
    let mut controller = Controller::load(image.clone(), bytes).unwrap_or_else(|error| panic!("{error}"));
    controller.power_up_in_run();
    controller
}

/// What a channel holds after a scan.
#[derive(Debug, PartialEq)]
struct Held {
    bits: Vec<u8>,
    words: Vec<u32>,
    status: Status,
}

impl Held {
    fn by(channel: &impl Channel) -> Held {
        Held { bits: channel.bits().to_vec(), words: channel.words().to_vec(), status: channel.status() }
    }
}

/// Everything that a controller shows after a scan.
#[derive(Debug, PartialEq)]
struct Shown {
    report: ScanReport,
    published_bits: Vec<Option<bool>>,
    published_words: Vec<Option<i32>>,
    channels: (Held, Held),
}

fn shown<B: Channel>(controller: &mut Controller<Primary, B>, report: ScanReport) -> Shown {
    let image = controller.image().image();
    let bits = 0..image.initial_bits.len() as u32;
    let words = 0..image.initial_words.len() as u32;
    let published_bits = bits.map(|cell| controller.published_bit(BitCell(cell))).collect();
    let published_words = words.map(|cell| controller.published_word(WordCell(cell))).collect();
    let (primary, partner) = controller.channels_mut();
    Shown { report, published_bits, published_words, channels: (Held::by(primary), Held::by(partner)) }
}

/// REQ-SCAN-031
#[test]
fn samples_when_run_on_two_threads_then_every_cell_is_that_of_one_thread() {
    let folders = fs::read_dir(project_path("samples")).unwrap().map(|entry| entry.unwrap().path());
    let mut scans = 0;
    for folder in folders.filter(|path| path.join("stimulus.csv").is_file()) {
        let (image, bytes) = image_of(&read_whole(&folder.join("project.rll")));
        let stimulus = stimulus(&folder.join("stimulus.csv"));
        let (mut one, mut two): (DualController, Threaded) = (loaded(&image, &bytes), loaded(&image, &bytes));
        let mut drives = (Drive::new(&mut one, &stimulus).unwrap(), Drive::new(&mut two, &stimulus).unwrap());
        for now_ms in (0..=stimulus.last_ms()).step_by(10) {
            drives.0.until(&mut one, now_ms);
            drives.1.until(&mut two, now_ms);
            let reports = (one.scan(now_ms as i64), two.scan(now_ms as i64));
            assert_eq!(shown(&mut one, reports.0), shown(&mut two, reports.1), "{}: {now_ms} ms", folder.display());
            scans += 1;
        }
    }
    assert!(scans > 1000, "{scans} scans ran");
}

/// REQ-SCAN-031
#[test]
fn random_programs_when_run_on_two_threads_then_every_cell_is_that_of_one_thread() {
    let (mut scans, mut stopped) = (0, 0);
    for seed in 0..PROGRAMS {
        let generated = generate::program(seed, Size::SMALL);
        let Ok(subject) = Subject::from_text(&generated.text) else { continue };
        let mut one: DualController = loaded(&subject.image, &subject.bytes);
        let mut two: Threaded = loaded(&subject.image, &subject.bytes);
        for step in generate::stimulus(seed, &generated, SCANS).steps {
            for (name, value) in &step.values {
                let signal = names::signal(&subject.image, name).unwrap();
                let (primary, partner) = one.channels_mut();
                cells::write(primary, signal, cells::held(*value));
                cells::write(partner, signal, cells::held(*value));
                let (primary, partner) = two.channels_mut();
                cells::write(primary, signal, cells::held(*value));
                cells::write(partner, signal, cells::held(*value));
            }
            let reports = (one.scan(step.now_ms), two.scan(step.now_ms));
            assert_eq!(shown(&mut one, reports.0), shown(&mut two, reports.1), "seed {seed}, {} ms", step.now_ms);
            scans += u32::from(reports.0.stopped.is_none());
            stopped += u32::from(reports.0.stopped.is_some());
        }
    }
    assert!(scans > 1000 && stopped > 0, "{scans} scans ran to their end, {stopped} did not");
}

/// From 20 ms on its thread ends in a panic.
struct Panics;

impl Defect for Panics {
    fn clock(now_ms: i64, _: bool) -> i64 {
        assert!(now_ms < 20, "this channel ends here, as the test asks of it");
        now_ms
    }
}

/// From 20 ms on it does not come to an end before the test says so.
struct Hangs;

static RELEASED: AtomicBool = AtomicBool::new(false);

impl Defect for Hangs {
    fn clock(now_ms: i64, _: bool) -> i64 {
        while now_ms >= 20 && !RELEASED.load(Ordering::Acquire) {
            thread::yield_now();
        }
        now_ms
    }
}

/// The watchdog expired in the third scan.
struct ThirdExpires(u32);

impl ScanClock for ThirdExpires {
    fn begin(&mut self) {}

    fn ended(&mut self, _: twinrung_controller::Part) {}

    fn expired(&mut self) -> bool {
        self.0 += 1;
        self.0 == 3
    }
}

const PROGRAM: &str = r#"
CONTROLLER Stopping (ProcessorType := "1756-L73S", Major := 20)
  TAG
    Out : BOOL (Class := Safety);
  END_TAG
  PROGRAM Main (Class := Safety, MAIN := "Main")
    ROUTINE Main
      N: OTE(Out);
    END_ROUTINE
  END_PROGRAM
  TASK Safety (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5)
    Main;
  END_TASK
END_CONTROLLER
"#;

const OUT: BitCell = BitCell(0);

fn publishing<D: Defect + Send + 'static>() -> Controller<Primary, OnThread<WrongPartner<D>>> {
    let subject = Subject::from_text(PROGRAM).unwrap();
    let mut controller = loaded(&subject.image, &subject.bytes);
    controller.publish_also(CellRange { tag: TagIndex(0), bit_cell: OUT.0, bit_cells: 1, word_cell: 0, word_cells: 0 });
    controller
}

/// REQ-SCAN-030
#[test]
fn channel_when_its_thread_ends_then_outputs_are_off_in_that_scan_and_nobody_waits() {
    let mut controller = publishing::<Panics>();
    assert_eq!([0, 10].map(|now_ms| controller.scan(now_ms).stopped), [None, None]);
    assert_eq!(controller.published_bit(OUT), Some(true));
    let stopped = controller.scan(20).stopped;
    assert_eq!(stopped, Some(StopReason::Safety(SafetyFault::ChannelStopped)));
    assert_eq!(stopped.map(StopReason::type_and_code), Some((14, 4)));
    assert_eq!(controller.published_bit(OUT), Some(false));
    assert_eq!(controller.scan(30).stopped, stopped, "and it stays stopped");
}

/// REQ-SCAN-004, REQ-SCAN-030
#[test]
fn channel_when_it_gives_no_answer_until_the_watchdog_expires_then_outputs_are_off_and_nobody_waits() {
    let mut controller = publishing::<Hangs>();
    let mut clock = ThirdExpires(0);
    let mut scan = |controller: &mut Controller<_, _>, now_ms| {
        controller.scan_observed(now_ms, &mut clock, &mut Silent, &mut Silent).stopped
    };
    assert_eq!([scan(&mut controller, 0), scan(&mut controller, 10)], [None, None]);
    assert_eq!(controller.published_bit(OUT), Some(true));
    controller.channels_mut().1.set_time_limit(Some(Duration::ZERO));
    assert_eq!(scan(&mut controller, 20), Some(StopReason::Safety(SafetyFault::WatchdogExpired)));
    assert_eq!(controller.published_bit(OUT), Some(false));
    RELEASED.store(true, Ordering::Release);
    let late = controller.channels_mut().1.has_stopped();
    assert!(late, "a late answer is not taken");
}
