//! The comparison compares something that differs, in every scan: one bit, another each time. A comparison that has gone
//! blind to a bit is found within as many scans as there are bits.

use crate::{compare, reciprocal};

const BYTES: usize = 64;
const WORDS: usize = 16;
/// Places of a difference: each bit of a byte, then each bit of a word.
const PLACES: u64 = 8 + 32;

/// What a comparison of some cells finds: the bits in which bytes and words differ.
pub(crate) type Cells = fn(bits: (&[u8], &[u8]), words: (&[u32], &[u32]), mask: u32) -> u64;

/// What the first comparison finds wrong with itself; 0 where that is nothing.
pub(crate) fn first(challenge: u64) -> u64 {
    remainder(compare::sum, challenge)
}

/// What the second comparison finds wrong with itself; 0 where that is nothing.
pub(crate) fn second(challenge: u64) -> u64 {
    remainder(reciprocal::sum, challenge)
}

fn remainder(cells: Cells, challenge: u64) -> u64 {
    let place = challenge.checked_rem(PLACES).unwrap_or_default();
    let index = (challenge as usize).wrapping_mul(7);
    let mask = u32::MAX;
    let (bits, words) = ([0x5A_u8; BYTES], [0x9669_A55A_u32; WORDS]);
    let (mut other_bits, mut other_words) = (bits.map(|byte| !byte), words.map(|word| !word));
    let difference = 1_u64 << place;
    if let Some(byte) = other_bits.get_mut(index % BYTES) {
        *byte ^= difference as u8;
    }
    if let Some(word) = other_words.get_mut(index % WORDS) {
        *word ^= (difference >> 8) as u32;
    }
    cells((&bits, &other_bits), (&words, &other_words), mask) ^ difference
}

#[cfg(test)]
mod tests {
    use super::*;

    /// REQ-SCAN-014
    #[test]
    fn self_test_when_the_comparison_sees_then_nothing_is_wrong() {
        assert!((0..10 * PLACES).all(|challenge| first(challenge) == 0 && second(challenge) == 0));
    }

    /// REQ-SCAN-014
    #[test]
    fn self_test_when_a_comparison_is_blind_to_a_bit_then_it_is_found_within_forty_scans() {
        fn blind_in_a_byte(bits: (&[u8], &[u8]), words: (&[u32], &[u32]), mask: u32) -> u64 {
            compare::sum(bits, words, mask) & !0x10
        }
        fn blind_in_a_word(bits: (&[u8], &[u8]), words: (&[u32], &[u32]), mask: u32) -> u64 {
            reciprocal::sum(bits, words, mask) & !(1 << 39)
        }
        fn sees_nothing(_: (&[u8], &[u8]), _: (&[u32], &[u32]), _: u32) -> u64 {
            0
        }
        let found = |cells: Cells| (0..PLACES).filter(|challenge| remainder(cells, *challenge) != 0).count();
        assert_eq!([blind_in_a_byte, blind_in_a_word, sees_nothing].map(|cells| found(cells)), [1, 1, 40]);
    }
}
