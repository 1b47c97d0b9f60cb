//! The stimulus of the mixes, and the hash that every contender ends with.

use std::fmt::Write as _;

use twinrung_bytecode::AdmittedImage;
use twinrung_bytecode::channel::Channel;
use twinrung_bytecode::index::{BitCell, WordCell};
use twinrung_controller::Controller;

use super::{INPUTS, PERIOD_MS};
use crate::drive::runs;
use crate::signal::Signal;

/// Seed of the stimulus: the same for every program.
const SEED: u64 = 88_172_645_463_325_252;

/// Toggles some inputs before each scan.
#[derive(Debug, Clone)]
pub struct Toggles {
    state: u64,
    values: Vec<bool>,
    cells: Vec<BitCell>,
    each_scan: usize,
}

impl Toggles {
    /// For the inputs x0, x1, ... of a controller, which from now on copies them in at the start of each scan. `None` where
    /// it does not have the inputs of a mix.
    pub fn new<A: Channel, B: Channel>(controller: &mut Controller<A, B>, each_scan: usize) -> Option<Toggles> {
        let cells: Vec<BitCell> = numbered(controller.image(), 'x').into_iter().map(|(cell, _)| cell).collect();
        if cells.len() != INPUTS {
            return None;
        }
        let mut ascending = cells.clone();
        ascending.sort_unstable();
        for range in runs(ascending.into_iter().map(Signal::Bit)) {
            controller.freeze_also(range);
        }
        Some(Toggles { state: SEED, values: vec![false; INPUTS], cells, each_scan })
    }

    fn next(&mut self) -> u64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        self.state
    }

    /// Toggles so many inputs, one of them perhaps several times.
    pub fn before<A: Channel, B: Channel>(&mut self, controller: &mut Controller<A, B>) {
        for _ in 0..self.each_scan {
            let index = ((self.next() >> 20) & 255) as usize;
            self.set(controller, index, !self.values[index]);
        }
    }

    /// Draws every input anew.
    pub fn redraw<A: Channel, B: Channel>(&mut self, controller: &mut Controller<A, B>) {
        for index in 0..INPUTS {
            let value = (self.next() >> 20) & 1 == 1;
            self.set(controller, index, value);
        }
    }

    fn set<A: Channel, B: Channel>(&mut self, controller: &mut Controller<A, B>, index: usize, value: bool) {
        self.values[index] = value;
        if let Some(cell) = self.cells.get(index) {
            controller.drive_bit(*cell, value);
        }
    }

    /// The stimulus as CSV: so many toggles before each of so many scans.
    pub fn csv(scans: u64, each_scan: usize) -> String {
        let mut toggles = Toggles { state: SEED, values: vec![false; INPUTS], cells: Vec::new(), each_scan };
        let names: Vec<String> = (0..INPUTS).map(|index| format!("x{index}")).collect();
        let mut out = format!("time_ms,{}\n", names.join(","));
        for scan in 0..scans {
            for _ in 0..toggles.each_scan {
                let index = ((toggles.next() >> 20) & 255) as usize;
                toggles.values[index] = !toggles.values[index];
            }
            let _ = write!(out, "{}", scan * PERIOD_MS);
            for value in &toggles.values {
                let _ = write!(out, ",{}", u8::from(*value));
            }
            out.push('\n');
        }
        out
    }
}

/// The tags that are this letter and a number, in order of the number: bit cell and word cell of each.
fn numbered(image: &AdmittedImage, letter: char) -> Vec<(BitCell, WordCell)> {
    let tags = image.image().tags.iter().filter(|tag| tag.program.is_none());
    let mut found: Vec<(u32, BitCell, WordCell)> = tags
        .filter_map(|tag| {
            let number = tag.name.strip_prefix(letter)?.parse().ok()?;
            Some((number, BitCell(tag.bit_cell), WordCell(tag.word_cell)))
        })
        .collect();
    found.sort_unstable();
    found.into_iter().map(|(_, bit, word)| (bit, word)).collect()
}

/// The state of a mix in one number: FNV-1a of 64 bits over all coils y as bytes 0 or 1, then all numbers n as 32 bits, low
/// byte first.
pub fn hash<A: Channel, B: Channel>(controller: &Controller<A, B>) -> u64 {
    let (coils, numbers) = (numbered(controller.image(), 'y'), numbered(controller.image(), 'n'));
    let coils = coils.into_iter().map(|(cell, _)| u8::from(controller.bit(cell).unwrap_or_default()));
    let numbers = numbers.into_iter().flat_map(|(_, cell)| controller.word(cell).unwrap_or_default().to_le_bytes());
    coils
        .chain(numbers)
        .fold(14_695_981_039_346_656_037, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(1_099_511_628_211))
}
