//! A scan of both channels allocates nothing: freezing, both interpreters, comparison, publishing and the image check, over
//! every sample with its stimulus and over random programs with everything that the base set has; on one thread, and with
//! the partner on a thread of its own.

use std::fs;
use std::path::Path;

use peak_alloc::PeakAlloc;
use twinrung_bytecode::channel::Channel;
use twinrung_compiler::{Completion, check};
use twinrung_controller::Controller;
use twinrung_grammar::read_path;
use twinrung_grammar::tree::Sources;
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_trio::Subject;
use twinrung_workbench::drive::Drive;
use twinrung_workbench::generate::{self, Size};
use twinrung_workbench::{OnThread, Stimulus, cells, names};

#[global_allocator]
static ALLOCATED: PeakAlloc = PeakAlloc;

/// Random programs, and scans of each.
const PROGRAMS: u64 = 40;
/// Fewer where threads wait for each other: on a busy machine that takes long, and after a minute the test harness says so,
/// for which it allocates.
const PROGRAMS_ON_TWO_THREADS: u64 = 10;
const SCANS: usize = 60;

fn loaded<B: Channel>(subject: &Subject) -> Controller<Primary, B> {
    let mut controller =
        Controller::load(subject.image.clone(), &subject.bytes).unwrap_or_else(|error| panic!("{error}"));
    controller.power_up_in_run();
    controller
}

/// What scans took together.
#[derive(Default)]
struct Taken {
    /// Scans that ran to their end.
    scans: u64,
    /// Bytes that were held at some moment of a scan beyond those held before it.
    bytes: usize,
}

impl Taken {
    fn scan<B: Channel>(&mut self, controller: &mut Controller<Primary, B>, now_ms: u64) {
        let before = ALLOCATED.current_usage();
        ALLOCATED.reset_peak_usage();
        let report = controller.scan(now_ms as i64);
        self.bytes += ALLOCATED.peak_usage().saturating_sub(before);
        self.scans += u64::from(report.stopped.is_none());
    }
}

fn sample(folder: &Path) -> (Subject, Stimulus) {
    let mut sources = Sources::new();
    let reading = read_path(&mut sources, &folder.join("project.rll"));
    let project = check(&reading, &Completion::default()).project.unwrap();
    let stimulus = Stimulus::read(&fs::read_to_string(folder.join("stimulus.csv")).unwrap()).unwrap();
    (Subject::from_project(project), stimulus)
}

fn samples_take<B: Channel>() -> Taken {
    let folders = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("samples")).unwrap();
    let folders = folders.map(|entry| entry.unwrap().path()).filter(|path| path.join("project.rll").is_file());
    let mut taken = Taken::default();
    for (subject, stimulus) in folders.map(|folder| sample(&folder)) {
        let mut controller = loaded::<B>(&subject);
        let mut drive = Drive::new(&mut controller, &stimulus).unwrap();
        for now_ms in (0..=stimulus.last_ms()).step_by(10) {
            drive.until(&mut controller, now_ms);
            taken.scan(&mut controller, now_ms);
        }
    }
    taken
}

fn random_programs_take<B: Channel>(programs: u64) -> Taken {
    let mut taken = Taken::default();
    for seed in 0..programs {
        let generated = generate::program(seed, Size::SMALL);
        let stimulus = generate::stimulus(seed, &generated, SCANS);
        // Some few programs are refused; another test counts them.
        let Ok(subject) = Subject::from_text(&generated.text) else { continue };
        let mut controller = loaded::<B>(&subject);
        for step in &stimulus.steps {
            let (primary, partner) = controller.channels_mut();
            for (name, value) in &step.values {
                let signal = names::signal(&subject.image, name).unwrap();
                cells::write(primary, signal, cells::held(*value));
                cells::write(partner, signal, cells::held(*value));
            }
            taken.scan(&mut controller, step.now_ms as u64);
        }
    }
    taken
}

/// REQ-SCAN-009. One test, so that nothing else allocates meanwhile.
#[test]
fn scans_when_run_over_samples_and_random_programs_then_nothing_is_allocated() {
    let probe = ALLOCATED.current_usage();
    ALLOCATED.reset_peak_usage();
    drop(std::hint::black_box(vec![0_u8; 4096]));
    assert!(ALLOCATED.peak_usage() >= probe + 4096, "the allocator does not count");
    allocate_nothing("one thread", samples_take::<Partner>(), random_programs_take::<Partner>(PROGRAMS));
    let programs = random_programs_take::<OnThread<Partner>>(PROGRAMS_ON_TWO_THREADS);
    allocate_nothing("two threads", samples_take::<OnThread<Partner>>(), programs);
}

fn allocate_nothing(threads: &str, samples: Taken, programs: Taken) {
    assert_eq!((samples.bytes, programs.bytes), (0, 0), "{threads}");
    let (samples, programs) = (samples.scans, programs.scans);
    assert!(samples > 1000 && programs > 50, "{threads}: {samples} and {programs} scans ran");
}
