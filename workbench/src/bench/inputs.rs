//! Inputs at random: each BOOL input is seen off and on, and stays in motion.

use std::collections::HashSet;

use twinrung_bytecode::image::{TagKind, TagRecord, TypeKind, TypeReference};
use twinrung_bytecode::index::TagIndex;
use twinrung_bytecode::{AdmittedImage, CellRange};
use twinrung_catalog::Element;
use twinrung_controller::DualController;

use crate::drive::cells;
use crate::names;
use crate::signal::Signal;

/// One in so many BOOL inputs changes in each scan: the rate of the mixes that interpreters are compared on.
const ONE_IN: u64 = 16;

/// The inputs of a project, and what drives them.
pub struct Inputs {
    bits: Vec<Bit>,
    words: Vec<Signal>,
    random: Random,
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
    pub fn new(controller: &mut DualController, seed: u64) -> Inputs {
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
        Inputs { bits, words, random: Random::new(seed) }
    }

    /// Sets the inputs for a scan: all off in the first, all on in the second, then one in 16 changes.
    pub fn before(&mut self, controller: &mut DualController, scan: u64) {
        for bit in &mut self.bits {
            bit.value = match scan {
                0 => false,
                1 => true,
                _ => bit.value != self.random.one_in(ONE_IN),
            };
            bit.seen[usize::from(bit.value)] = true;
            if let Signal::Bit(cell) = bit.signal {
                controller.drive_bit(cell, bit.value);
            }
        }
        for word in &self.words {
            if let Signal::Word(cell, element) = word
                && self.random.one_in(ONE_IN)
            {
                controller.drive_word(*cell, self.random.of_type(*element));
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

/// The cells of BOOL signals in ascending order, neighbours in one range: what is frozen is copied range by range.
fn runs(signals: impl Iterator<Item = Signal>) -> Vec<CellRange> {
    let mut runs: Vec<CellRange> = Vec::new();
    for range in signals.filter_map(cells) {
        match runs.last_mut() {
            Some(last) if last.bit_cell + last.bit_cells == range.bit_cell => last.bit_cells += 1,
            _ => runs.push(range),
        }
    }
    runs
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

/// Marsaglia's xorshift: the same values everywhere, and fast enough for many inputs.
#[derive(Debug, Clone)]
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Random {
        // Never 0, from which nothing else follows.
        Random(seed.wrapping_mul(2).wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    pub(super) fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 >> 11
    }

    fn one_in(&mut self, many: u64) -> bool {
        self.next().is_multiple_of(many)
    }

    /// The content of a cell: small values, the ends of the range, any value.
    fn of_type(&mut self, element: Element) -> i32 {
        let any = self.next() as i32;
        let value = match self.next() % 4 {
            0 => 0,
            1 => any.rem_euclid(100),
            2 => *[i32::MAX, i32::MIN, 1, -1].get((any & 3) as usize).unwrap_or(&0),
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
}
