//! A channel with turned bits may do anything but panic or run on for ever: what the campaign of fault injection relies on.

use std::fs;

use fastrand::Rng;
use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::ScanInputs;
use twinrung_bytecode::injection::{Injectable, Memory};
use twinrung_bytecode::observer::Silent;
use twinrung_primary::Primary;

use crate::support::{image_of, project_path, read_whole};

/// Disturbed channels for each sample.
const DISTURBED: usize = 400;
/// Bits that are turned at once, at most.
const BITS: usize = 3;

fn images() -> impl Iterator<Item = AdmittedImage> {
    let folders = fs::read_dir(project_path("samples")).unwrap().map(|entry| entry.unwrap().path());
    folders
        .map(|folder| folder.join("project.rll"))
        .filter(|file| file.is_file())
        .map(|file| image_of(&read_whole(&file)).0)
}

/// Two scans and a prescan of channels that have run and then got other bits.
fn disturb<C: Injectable>(image: &AdmittedImage, random: &mut Rng) {
    let system_values = vec![0; image.image().system_values_length()];
    let at = |now_ms| ScanInputs { now_ms, budget: 10_000, system_values: &system_values };
    let mut whole = C::load(image).unwrap_or_else(|error| panic!("{error}"));
    whole.prescan(at(0), &mut Silent);
    whole.scan(at(10), &mut Silent);
    for _ in 0..DISTURBED {
        let mut disturbed = whole.clone();
        for _ in 0..random.usize(1..=BITS) {
            let memory = Memory::ALL[random.usize(..Memory::ALL.len())];
            let bits = disturbed.memory_bits(memory);
            disturbed.flip_bit(memory, random.u64(..bits));
        }
        disturbed.scan(at(20), &mut Silent);
        disturbed.scan(at(30), &mut Silent);
        disturbed.prescan(at(40), &mut Silent);
    }
}

#[test]
fn primary_when_bits_of_a_loaded_sample_are_turned_then_every_execution_ends() {
    let mut random = Rng::with_seed(7);
    let disturbed = images().map(|image| disturb::<Primary>(&image, &mut random)).count();
    assert!(disturbed > 10, "the samples are there");
}
