//! Inputs at random: each BOOL input is seen off and on, and stays in motion. One seed gives the same inputs everywhere.

use std::collections::HashSet;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::image::{TagKind, TagRecord, TypeKind, TypeReference};
use twinrung_bytecode::index::TagIndex;
use twinrung_catalog::Element;
use twinrung_controller::Controller;

use crate::drive::runs;
use crate::names;
use crate::signal::Signal;

/// One in so many BOOL inputs changes in each scan: the rate of the mixes that interpreters are compared on.
const ONE_IN: u32 = 16;

/// The inputs of a project, and what drives them.
pub struct Inputs {
    bits: Vec<Bit>,
    words: Vec<Signal>,
    random: fastrand::Rng,
}

struct Bit {
    signal: Signal,
    value: bool,
    seen: [bool; 2],
}

/// Which truths the inputs have had.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Coverage {
    /// BOOL inputs.
    pub bools: u64,
    /// Those that were both off and on in a scan.
    pub both_truths: u64,
    /// Numbers that modules and other controllers send.
    pub numbers: u64,
}

impl Inputs {
    /// What no logic writes: BOOLs of module inputs, consumed tags, mapped tags and plain tags, and numbers of the first
    /// three. Plain numbers are settings, and keep their values; so do tags of predefined types.
    pub fn new<A: Channel, B: Channel>(controller: &mut Controller<A, B>, seed: u64) -> Inputs {
        let image = controller.image();
        let mut bits = Vec::new();
        let mut words = Vec::new();
        let sent: HashSet<TagIndex> = image.frozen().iter().map(|range| range.tag).collect();
        for (index, tag) in image.image().tags.iter().enumerate() {
            let index = TagIndex(index as u32);
            let frozen = sent.contains(&index);
            if !frozen && (tag.kind != TagKind::Base || tag.constant || !is_plain(image, tag)) {
                continue;
            }
            for (_, signal) in names::values_of(image, index) {
                match signal {
                    Signal::Bit(cell) if frozen || !image.program_writes().has_bit(cell) => {
                        bits.push(Bit { signal, value: false, seen: [false; 2] });
                    }
                    Signal::Word(..) if frozen => words.push(signal),
                    _ => {}
                }
            }
        }
        for range in runs(bits.iter().map(|bit| bit.signal)) {
            controller.freeze_also(range);
        }
        Inputs { bits, words, random: fastrand::Rng::with_seed(seed) }
    }

    /// Sets the inputs for a scan: all off in the first, all on in the second, then one in 16 changes.
    pub fn before<A: Channel, B: Channel>(&mut self, controller: &mut Controller<A, B>, scan: u64) {
        for bit in &mut self.bits {
            bit.value = match scan {
                0 => false,
                1 => true,
                _ => bit.value != (self.random.u32(..ONE_IN) == 0),
            };
            bit.seen[usize::from(bit.value)] = true;
            if let Signal::Bit(cell) = bit.signal {
                controller.drive_bit(cell, bit.value);
            }
        }
        for word in &self.words {
            if let Signal::Word(cell, element) = word
                && self.random.u32(..ONE_IN) == 0
            {
                controller.drive_word(*cell, of_type(&mut self.random, *element));
            }
        }
    }

    /// What the inputs have been.
    pub fn coverage(&self) -> Coverage {
        Coverage {
            bools: self.bits.len() as u64,
            both_truths: self.bits.iter().filter(|bit| bit.seen == [true; 2]).count() as u64,
            numbers: self.words.len() as u64,
        }
    }
}

/// Whether a tag holds elementary types and user-defined types alone.
fn is_plain(image: &AdmittedImage, tag: &TagRecord) -> bool {
    let mut open = vec![tag.type_reference];
    while let Some(type_reference) = open.pop() {
        let TypeReference::Structure(index) = type_reference else { continue };
        match image.image().types.get(index.position()) {
            Some(record) if record.kind == TypeKind::User => {
                open.extend(record.members.iter().map(|member| member.type_reference));
            }
            _ => return false,
        }
    }
    true
}

/// The content of a cell: small values, the ends of the range, any value.
fn of_type(random: &mut fastrand::Rng, element: Element) -> i32 {
    let any = random.i32(..);
    let value = match random.u8(..4) {
        0 => 0,
        1 => random.i32(0..100),
        2 => random.choice([i32::MAX, i32::MIN, 1, -1]).unwrap_or_default(),
        _ => any,
    };
    match element {
        Element::Bool => value & 1,
        Element::Sint => i32::from(value as i8),
        Element::Int => i32::from(value as i16),
        Element::Dint => value,
        Element::Real => ((value % 100_000) as f32 / 8.0).to_bits() as i32,
    }
}
