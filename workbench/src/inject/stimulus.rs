//! Inputs for a project that has none: each BOOL input off, then on, then in motion.

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::image::TagKind;
use twinrung_bytecode::index::TagIndex;

use crate::names;
use crate::signal::Signal;
use crate::stimulus::{Stimulus, StimulusRow};

/// One in so many inputs changes in each scan.
const ONE_IN: u32 = 16;

/// A stimulus of so many scans for what modules, other controllers and the tag map send, and for plain BOOLs that no logic
/// writes.
pub fn random(image: &AdmittedImage, scans: u32, seed: u64) -> Stimulus {
    let period_ms = image.image().task.as_ref().map_or(1, |task| u64::from(task.period_us / 1000));
    let tags: Vec<String> = inputs(image);
    let mut random = fastrand::Rng::with_seed(seed);
    let mut values = vec![false; tags.len()];
    let rows = (0..scans)
        .map(|scan| {
            for value in &mut values {
                *value = match scan {
                    0 => false,
                    1 => true,
                    _ => *value != (random.u32(..ONE_IN) == 0),
                };
            }
            let cells = values.iter().map(|value| Some(u8::from(*value).to_string())).collect();
            StimulusRow { line: u64::from(scan) + 2, time_ms: u64::from(scan) * period_ms, cells }
        })
        .collect();
    Stimulus { tags, rows }
}

fn inputs(image: &AdmittedImage) -> Vec<String> {
    let sent: Vec<TagIndex> = image.frozen().iter().map(|range| range.tag).collect();
    let tags = image.image().tags.iter().enumerate().map(|(index, tag)| (TagIndex(index as u32), tag));
    let meant = tags.filter(|(index, tag)| sent.contains(index) || (tag.kind == TagKind::Base && !tag.constant));
    let values = meant.flat_map(|(index, _)| names::values_of(image, index));
    values
        .filter(|(name, signal)| matches!(signal, Signal::Bit(_)) && names::driven(image, name).is_ok())
        .map(|(name, _)| name)
        .collect()
}
