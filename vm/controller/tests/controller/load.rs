//! Loading an image, and the rungs that a scan must execute.

use twinrung_bytecode::image::{Image, ProgramRecord};
use twinrung_bytecode::{admit_library, seal};
use twinrung_controller::{LoadError, SafetyFault, StopReason};

use crate::fake::*;

/// Images in which nothing is executed: the scans of a channel that executes nothing are as they should be.
fn without_rungs(change: impl Fn(&mut ProgramRecord)) -> Image {
    let mut image = image(EXECUTES_NOTHING);
    image.programs.iter_mut().for_each(change);
    image
}

/// Why the third scan, in which nothing is executed, stops the task.
fn third_scan(image: &Image) -> Option<StopReason> {
    let mut controller = running_image(image);
    [0, 10, 20].map(|now_ms| controller.scan(now_ms).stopped)[2]
}

/// REQ-SCAN-018
#[test]
fn scan_when_no_scheduled_program_has_a_rung_then_executing_nothing_is_no_fault() {
    let nothing = Some(StopReason::Safety(SafetyFault::NothingExecuted));
    assert_eq!(third_scan(&without_rungs(|_| {})), nothing);
    assert_eq!(third_scan(&without_rungs(|program| program.disabled = true)), None);
    let mut empty = without_rungs(|_| {});
    empty.routines[0].code.clear();
    empty.routines[0].text.clear();
    assert_eq!(third_scan(&empty), None);
    let mut unscheduled = without_rungs(|_| {});
    unscheduled.task.iter_mut().for_each(|task| task.schedule.clear());
    assert_eq!(third_scan(&unscheduled), None);
}

#[test]
fn errors_of_loading_when_shown_then_they_name_the_channel() {
    let shown = [LoadError::NoTask, LoadError::Primary("too large"), LoadError::Partner("too deep")]
        .map(|error: LoadError<&str, &str>| error.to_string());
    assert_eq!(shown, ["the image has no safety task", "channel 1: too large", "channel 2: too deep"]);
}

#[test]
fn image_when_it_has_no_safety_task_then_no_controller_takes_it() {
    let bytes = seal(&Image::default()).unwrap();
    let library = admit_library(&bytes).unwrap();
    assert_eq!(Pair::load(library, &bytes).err(), Some(LoadError::NoTask));
}
