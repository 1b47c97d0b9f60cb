//! What is thrown at: source text, an export, an image, scenarios.

use std::path::Path;
use std::sync::OnceLock;

use twinrung_bytecode::signature::seal;
use twinrung_bytecode::{AdmittedImage, admit, read as read_image};
use twinrung_compiler::{Completion, check, compile};
use twinrung_controller::{DualController, SafetyFault, StopReason};
use twinrung_grammar::tree::Sources;
use twinrung_workbench::scenario::Suite;

/// Scans that an admitted image runs.
const SCANS: i64 = 3;
/// Watchdog of a mutated image in microseconds: bounds how long its loops run.
const WATCHDOG_US: u32 = 500;

/// A kind of input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// `.rll` and L5K.
    Source,
    /// L5X.
    L5x,
    /// Scenarios.
    Scenario,
    /// An image; it is signed again, so that the verifier sees it and not the hash.
    Image,
}

impl Target {
    /// All of them.
    pub const ALL: [Target; 4] = [Target::Source, Target::L5x, Target::Scenario, Target::Image];

    /// Its name: that of the fuzzer and of the folder of its seeds.
    pub fn name(self) -> &'static str {
        match self {
            Target::Source => "source",
            Target::L5x => "l5x",
            Target::Scenario => "scenario",
            Target::Image => "image",
        }
    }

    /// Throws bytes at it.
    ///
    /// # Panics
    /// Where this project has a defect.
    pub fn run(self, bytes: &[u8]) {
        match self {
            Target::Source => project("hostile.rll", bytes),
            Target::L5x => project("hostile.L5X", bytes),
            Target::Scenario => scenarios(bytes),
            Target::Image => image(bytes),
        }
    }
}

/// The project that hostile scenarios are for.
const PROJECT: &str = include_str!("../../../samples/estop-with-contactors/project.rll");

/// Reads scenarios and lays out what they would do; playing them is what the controller's own limits bound.
fn scenarios(bytes: &[u8]) {
    static IMAGE: OnceLock<(AdmittedImage, Vec<u8>)> = OnceLock::new();
    let (image, sealed) = IMAGE.get_or_init(|| {
        let reading = twinrung_grammar::read(&mut Sources::new(), "project.rll", PROJECT.as_bytes().to_vec());
        let project =
            check(&reading, &Completion::default()).project.unwrap_or_else(|| panic!("the sample is refused"));
        let bytes = compile(&project).unwrap_or_else(|finding| panic!("{}", finding.message)).bytes;
        (admit(&bytes).unwrap_or_else(|error| panic!("{error}")), bytes)
    });
    let (mut sources, path) = (Sources::new(), Path::new("hostile.scenario"));
    let reading = twinrung_grammar::read_scenarios(&mut sources, path, bytes.to_vec());
    for error in &reading.errors {
        assert!(sources.get(error.span.source).is_some(), "an error has no place: {}", error.message);
    }
    for finding in Suite::new(image, sealed).add(path, &reading.file) {
        assert!(sources.get(finding.span.source).is_some(), "{} has no place: {}", finding.code.id, finding.message);
    }
}

/// Reads, checks, and carries what is found correct all the way: the loader admits it, and both channels agree.
fn project(name: &str, bytes: &[u8]) {
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read(&mut sources, name, bytes.to_vec());
    // A partial export is completed, so that its rungs are reached.
    let completion = Completion {
        controller: Some("1756-L73S".to_owned()),
        revision: Some(20),
        period_ms: Some(20),
        watchdog_ms: Some(10),
        ..Completion::default()
    };
    let checked = check(&reading, &completion);
    for finding in &checked.findings {
        assert!(sources.get(finding.span.source).is_some(), "{} has no place: {}", finding.code.id, finding.message);
        assert_ne!(finding.code.id, "D0001", "{}", finding.message);
    }
    let Some(project) = checked.project else { return };
    let compiled = compile(&project).unwrap_or_else(|finding| panic!("{}", finding.message));
    run(&compiled.bytes, true);
}

fn image(bytes: &[u8]) {
    let Ok(mut read) = read_image(bytes) else { return };
    if let Some(task) = &mut read.image.task {
        task.watchdog_us = task.watchdog_us.min(WATCHDOG_US);
    }
    let Ok(signed) = seal(&read.image) else { return };
    run(&signed, false);
}

/// Admits and runs. An image of our own must be admitted; of any other one only nothing bad must come.
fn run(bytes: &[u8], own: bool) {
    let admitted = match admit(bytes) {
        Ok(admitted) => admitted,
        Err(error) => {
            assert!(!own, "the loader refuses a compiled image: {error}");
            return;
        }
    };
    let Ok(mut controller) = DualController::load(admitted, bytes) else { return };
    controller.power_up_in_run();
    for scan in 0..SCANS {
        let report = controller.scan(scan * 20);
        let differs = matches!(report.stopped, Some(StopReason::Safety(SafetyFault::Difference(_))));
        assert!(!differs, "the channels differ in scan {scan}: {:?}", report.stopped);
    }
}
