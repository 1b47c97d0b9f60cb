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

/// Compares two channels after an execution that ended as `ends` say; nothing where they hold and say the same.
pub fn compare<A: Channel, B: Channel>(
    image: &Image,
    primary: &A,
    partner: &B,
    ends: (ScanEnd, ScanEnd),
) -> Option<Difference> {
    cells(primary, partner)
        .or_else(|| (ends.0 != ends.1).then_some(Difference::End(ends.0, ends.1)))
        .or_else(|| (primary.status() != partner.status()).then_some(Difference::Status))
        .or_else(|| path(primary, partner, ends))
        .or_else(|| events(image, primary, partner))
        .or_else(|| records(image, primary, partner))
}

fn cells<A: Channel, B: Channel>(primary: &A, partner: &B) -> Option<Difference> {
    let mask = mask(A::REPRESENTATION) ^ mask(B::REPRESENTATION);
    let (bits, other_bits) = (primary.bits(), partner.bits());
    let (words, other_words) = (primary.words(), partner.words());
    if bits.len() != other_bits.len() || words.len() != other_words.len() {
        return Some(Difference::Size);
    }
    let byte_mask = (mask & 0xFF) as u8;
    // One pass without an exit, so that it runs at memory speed; the place is only looked for when there is one.
    let bit_difference = bits.iter().zip(other_bits).fold(0_u8, |sum, (a, b)| sum | (a ^ b ^ byte_mask));
    let word_difference = words.iter().zip(other_words).fold(0_u32, |sum, (a, b)| sum | (a ^ b ^ mask));
    if bit_difference == 0 && word_difference == 0 {
        return None;
    }
    first_difference::<A, B>(bits, other_bits, words, other_words)
}

#[cold]
fn first_difference<A: Channel, B: Channel>(
    bits: &[u8],
    other_bits: &[u8],
    words: &[u32],
    other_words: &[u32],
) -> Option<Difference> {
    let (own, other) = (mask(A::REPRESENTATION), mask(B::REPRESENTATION));
    let plain_bits = bits.iter().zip(other_bits).map(|(a, b)| (a ^ own as u8, b ^ other as u8));
    if let Some((cell, (a, b))) = plain_bits.enumerate().find(|(_, (a, b))| a != b) {
        return Some(Difference::Bit(BitCell(cell as u32), a, b));
    }
    let plain_words = words.iter().zip(other_words).map(|(a, b)| ((a ^ own) as i32, (b ^ other) as i32));
    let (cell, (a, b)) = plain_words.enumerate().find(|(_, (a, b))| a != b)?;
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
