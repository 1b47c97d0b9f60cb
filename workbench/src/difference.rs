//! A difference between the channels, in the words of the project: names of tags, not numbers of cells.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::index::TagIndex;
use twinrung_controller::{Difference, SafetyFault, TimeFault};

use crate::names;
use crate::signal::Signal;

/// Why a task was stopped for good.
pub fn fault_words(image: &AdmittedImage, fault: SafetyFault) -> String {
    let words = match fault {
        SafetyFault::Difference(found) => return words(image, found),
        SafetyFault::WatchdogExpired => "the watchdog expired",
        SafetyFault::BudgetExceeded => "the scan executed more instructions than its watchdog allows",
        SafetyFault::ImageCorrupted => "the image in memory is not the one that was admitted",
        SafetyFault::ChannelStopped => "a channel did not come to the end of its scan",
        SafetyFault::SecondComparison => "the second comparison found a difference that the first did not find",
        SafetyFault::NothingExecuted => "a channel executed nothing in this scan",
        SafetyFault::VerdictIncomplete => "the verdict is not the one that a finished comparison gives",
        SafetyFault::OutputsDiffer => "the outputs that were taken over from the channels differ",
        SafetyFault::ControllerCorrupted => "what the controller holds twice differs",
        SafetyFault::Time(TimeFault::Backwards) => "time ran backwards",
        SafetyFault::Time(TimeFault::Fast) => "time went on faster than a second source of it",
        SafetyFault::Time(TimeFault::Slow) => "time went on slower than a second source of it, or stood",
    };
    words.to_owned()
}

/// What the channels differ in.
pub fn words(image: &AdmittedImage, difference: Difference) -> String {
    match difference {
        Difference::Bit(cell, primary, partner) => {
            let name = name_of(image, |signal| matches!(signal, Signal::Bit(at) if at == cell))
                .unwrap_or_else(|| format!("bit cell {}", cell.0));
            format!("the channels differ in {name}: primary {primary}, partner {partner}")
        }
        Difference::Word(cell, primary, partner) => {
            let name = name_of(image, |signal| matches!(signal, Signal::Word(at, _) if at == cell))
                .unwrap_or_else(|| format!("word cell {}", cell.0));
            format!(
                "the channels differ in {name}: primary {primary} (16#{primary:08x}), partner {partner} (16#{partner:08x})"
            )
        }
        Difference::Path => "control took another path through the rungs in each channel".to_owned(),
        Difference::Status => "the channels differ in the arithmetic status or in the count of instructions".to_owned(),
        Difference::End(primary, partner) => {
            format!("the channels differ in how the execution ended: primary {primary:?}, partner {partner:?}")
        }
        Difference::Event(task) => {
            let name = image.image().event_tasks.get(task.position()).map_or("?", String::as_str);
            format!("the channels differ in how often EVENT triggered {name}")
        }
        Difference::FaultRecord(program) => {
            let record = image.image().programs.get(program.position());
            let name = record.map_or("?", |program| program.name.as_str());
            format!("the channels differ in the fault record of the program {name}")
        }
        Difference::Size => "the channels do not hold the same number of cells".to_owned(),
    }
}

/// The first tag, member or element that is meant.
fn name_of(image: &AdmittedImage, is_meant: impl Fn(Signal) -> bool) -> Option<String> {
    let tags = (0..image.image().tags.len()).map(|tag| TagIndex(tag as u32));
    tags.flat_map(|tag| names::values_of(image, tag)).find(|(_, signal)| is_meant(*signal)).map(|(name, _)| name)
}
