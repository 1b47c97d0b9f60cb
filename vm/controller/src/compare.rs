//! The comparison: every named cell, the status, the fault records and the events of both channels, after every scan.

use twinrung_bytecode::channel::{Channel, Representation, ScanEnd};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::{BitCell, EventTaskIndex, ProgramIndex, WordCell};

/// Where the channels differ first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Difference {
    /// A bit cell; primary and partner value in plain form.
    Bit(BitCell, u8, u8),
    /// A word cell; primary and partner value in plain form.
    Word(WordCell, i32, i32),
    /// The arithmetic status, a fault or the count of executed instructions.
    Status,
    /// How the execution ended.
    End(ScanEnd, ScanEnd),
    /// The path that control took (REQ-SCAN-010).
    Path,
    /// How often EVENT triggered a task.
    Event(EventTaskIndex),
    /// A program's MajorFaultRecord.
    FaultRecord(ProgramIndex),
    /// The channels do not even hold the same number of cells.
    Size,
}

/// What turns a channel's byte or word into plain form.
pub(crate) const fn mask(representation: Representation) -> u32 {
    match representation {
        Representation::Plain => 0,
        Representation::Complemented => u32::MAX,
    }
}

/// What the first comparison found.
pub(crate) struct Compared {
    /// What is wrong, as bits; 0 where both channels hold and say the same.
    pub(crate) remainder: u64,
    /// Where they differ first.
    pub(crate) difference: Option<Difference>,
}

/// Compares two channels after an execution that ended as `ends` say; nothing where they hold and say the same.
pub fn compare<A: Channel, B: Channel>(
    image: &Image,
    primary: &A,
    partner: &B,
    ends: (ScanEnd, ScanEnd),
) -> Option<Difference> {
    compared(image, primary, partner, ends).difference
}

/// As [`compare`], with a number that is 0 only where nothing differs.
pub(crate) fn compared<A: Channel, B: Channel>(
    image: &Image,
    primary: &A,
    partner: &B,
    ends: (ScanEnd, ScanEnd),
) -> Compared {
    let mask = mask(A::REPRESENTATION) ^ mask(B::REPRESENTATION);
    let cells = sum((primary.bits(), partner.bits()), (primary.words(), partner.words()), mask);
    let size = primary.bits().len() != partner.bits().len() || primary.words().len() != partner.words().len();
    let others = [
        size,
        ends.0 != ends.1,
        primary.status() != partner.status(),
        path(primary, partner, ends).is_some(),
        events(image, primary, partner).is_some(),
        records(image, primary, partner).is_some(),
    ];
    let remainder = others.into_iter().zip(OTHERS..).fold(cells, |sum, (differs, bit)| sum | u64::from(differs) << bit);
    let difference = if remainder == 0 { None } else { first_difference(image, primary, partner, ends) };
    Compared { remainder, difference }
}

/// The first bit in a remainder that is not one of cells.
const OTHERS: u32 = 40;

/// The bits in which bytes (0 to 7) and words (8 to 39) differ. One pass without an exit, so that it runs at memory speed;
/// the place is only looked for when there is one.
#[inline(never)]
pub(crate) fn sum(bits: (&[u8], &[u8]), words: (&[u32], &[u32]), mask: u32) -> u64 {
    let byte_mask = (mask & 0xFF) as u8;
    let bit_difference = bits.0.iter().zip(bits.1).fold(0_u8, |sum, (a, b)| sum | (a ^ b ^ byte_mask));
    let word_difference = words.0.iter().zip(words.1).fold(0_u32, |sum, (a, b)| sum | (a ^ b ^ mask));
    u64::from(bit_difference) | u64::from(word_difference) << 8
}

#[cold]
fn first_difference<A: Channel, B: Channel>(
    image: &Image,
    primary: &A,
    partner: &B,
    ends: (ScanEnd, ScanEnd),
) -> Option<Difference> {
    if primary.bits().len() != partner.bits().len() || primary.words().len() != partner.words().len() {
        return Some(Difference::Size);
    }
    cell(primary, partner)
        .or_else(|| (ends.0 != ends.1).then_some(Difference::End(ends.0, ends.1)))
        .or_else(|| (primary.status() != partner.status()).then_some(Difference::Status))
        .or_else(|| path(primary, partner, ends))
        .or_else(|| events(image, primary, partner))
        .or_else(|| records(image, primary, partner))
}

fn cell<A: Channel, B: Channel>(primary: &A, partner: &B) -> Option<Difference> {
    let (own, other) = (mask(A::REPRESENTATION), mask(B::REPRESENTATION));
    let bits = primary.bits().iter().zip(partner.bits()).map(|(a, b)| (a ^ own as u8, b ^ other as u8));
    if let Some((cell, (a, b))) = bits.enumerate().find(|(_, (a, b))| a != b) {
        return Some(Difference::Bit(BitCell(cell as u32), a, b));
    }
    let words = primary.words().iter().zip(partner.words()).map(|(a, b)| ((a ^ own) as i32, (b ^ other) as i32));
    let (cell, (a, b)) = words.enumerate().find(|(_, (a, b))| a != b)?;
    Some(Difference::Word(WordCell(cell as u32), a, b))
}

/// Control took another path, though every value is the same.
fn path<A: Channel, B: Channel>(primary: &A, partner: &B, ends: (ScanEnd, ScanEnd)) -> Option<Difference> {
    let differ = primary.path_signature() != partner.path_signature();
    (differ && ends.0 != ScanEnd::BudgetExceeded).then_some(Difference::Path)
}

fn events<A: Channel, B: Channel>(image: &Image, primary: &A, partner: &B) -> Option<Difference> {
    (0..image.event_tasks.len())
        .map(|task| EventTaskIndex(task as u16))
        .find(|task| primary.events(*task) != partner.events(*task))
        .map(Difference::Event)
}

fn records<A: Channel, B: Channel>(image: &Image, primary: &A, partner: &B) -> Option<Difference> {
    (0..image.programs.len())
        .map(|program| ProgramIndex(program as u16))
        .find(|program| primary.fault_record(*program) != partner.fault_record(*program))
        .map(Difference::FaultRecord)
}
