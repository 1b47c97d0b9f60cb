//! The second comparison: the same question, asked from the other channel and written in another way. It goes backwards, in
//! the partner's form, and collects in what both agree; the first goes forwards and collects in what they differ. It
//! says only how much is wrong; where, the first one says.

use twinrung_bytecode::channel::{Channel, ScanEnd, Status};
use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::{EventTaskIndex, ProgramIndex};

use crate::compare::mask;

/// Cells in one step.
const STEP: usize = 32;

/// What is wrong, as bits; 0 where both channels hold and say the same and hold all cells of the image.
pub(crate) fn remainder<A: Channel, B: Channel>(image: &Image, own: &B, other: &A, ends: (ScanEnd, ScanEnd)) -> u64 {
    let records = (0..image.programs.len()).rev().map(|program| ProgramIndex(program as u16));
    let records = records.filter(|program| own.fault_record(*program) != other.fault_record(*program)).count();
    let tasks = (0..image.event_tasks.len()).rev().map(|task| EventTaskIndex(task as u16));
    let tasks = tasks.filter(|task| own.events(*task) != other.events(*task)).count();
    let sizes = own.bits().len().abs_diff(image.initial_bits.len())
        | other.bits().len().abs_diff(image.initial_bits.len())
        | own.words().len().abs_diff(image.initial_words.len())
        | other.words().len().abs_diff(image.initial_words.len());
    let rest = [records, tasks, sizes].into_iter().fold(0, |sum, wrong| sum | (wrong as u64));
    let cells = sum(
        (own.bits(), other.bits()),
        (own.words(), other.words()),
        mask(A::REPRESENTATION) ^ mask(B::REPRESENTATION),
    );
    let paths = if ends.1 == ScanEnd::BudgetExceeded { 0 } else { own.path_signature() ^ other.path_signature() };
    cells
        | rest.min(RARE_MAX) << RARE
        | u64::from(ends.1 != ends.0) << END
        | status(own.status(), other.status())
        | u64::from(paths != 0) << PATH
}

/// Where other findings than those of cells stand in a remainder.
const RARE: u32 = 40;
const RARE_MAX: u64 = 0xFF;
const END: u32 = 48;
const STATUS: u32 = 49;
const PATH: u32 = 56;

/// In what two statuses differ.
fn status(own: Status, other: Status) -> u64 {
    let flags = |status: Status| {
        [status.first_scan, status.overflow, status.zero, status.negative, status.carry, status.minor_fault]
            .into_iter()
            .fold(0_u64, |flags, flag| flags << 1 | u64::from(flag))
    };
    let counts = (own.executed ^ other.executed)
        | u64::from((own.minor_faults ^ other.minor_faults) | (own.cleared_faults ^ other.cleared_faults));
    (flags(own) ^ flags(other)) << STATUS | u64::from(counts != 0) << 55
}

/// The bits in which bytes (0 to 7) and words (8 to 39) do not agree. From the end to the beginning, each place of a step with
/// its own sum, so that it runs at memory speed.
#[inline(never)]
pub(crate) fn sum(bits: (&[u8], &[u8]), words: (&[u32], &[u32]), mask: u32) -> u64 {
    let same = (!mask & 0xFF) as u8;
    let ((begin, steps), (other_begin, other_steps)) = (bits.0.as_rchunks::<STEP>(), bits.1.as_rchunks::<STEP>());
    let mut agreed = [u8::MAX; STEP];
    for (own, other) in steps.iter().rev().zip(other_steps.iter().rev()) {
        agreed.iter_mut().zip(own.iter().zip(other)).for_each(|(agreed, (own, other))| *agreed &= own ^ other ^ same);
    }
    let agreed = agreed.into_iter().fold(u8::MAX, |all, one| all & one);
    let agreed = begin.iter().zip(other_begin).rev().fold(agreed, |agreed, (own, other)| agreed & (own ^ other ^ same));
    let ((begin, steps), (other_begin, other_steps)) = (words.0.as_rchunks::<STEP>(), words.1.as_rchunks::<STEP>());
    let mut agreed_words = [u32::MAX; STEP];
    for (own, other) in steps.iter().rev().zip(other_steps.iter().rev()) {
        let places = agreed_words.iter_mut().zip(own.iter().zip(other));
        places.for_each(|(agreed, (own, other))| *agreed &= own ^ other ^ !mask);
    }
    let agreed_words = agreed_words.into_iter().fold(u32::MAX, |all, one| all & one);
    let numbers = begin.iter().zip(other_begin).rev();
    let agreed_words = numbers.fold(agreed_words, |agreed, (own, other)| agreed & (own ^ other ^ !mask));
    u64::from(!agreed) | u64::from(!agreed_words) << 8
}
