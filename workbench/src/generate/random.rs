//! Random choices that a seed determines: SplitMix64, which needs no state but one word and no crate. A fuzzer gives the first
//! choices as bytes instead, so that changing a byte changes one choice.

/// A stream of choices.
#[derive(Debug, Clone)]
pub struct Random {
    state: u64,
    /// Choices that were given, the next one last.
    given: Vec<u8>,
}

impl Random {
    /// The stream of a seed.
    pub fn new(seed: u64) -> Random {
        Random { state: seed ^ 0x5851_F42D_4C95_7F2D, given: Vec::new() }
    }

    /// The stream whose choices are these bytes, one each, and after them those of the seed 0.
    pub fn of_bytes(bytes: &[u8]) -> Random {
        Random { given: bytes.iter().rev().copied().collect(), ..Random::new(0) }
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        // Mixed like a seed, since a choice among many looks at the high bits too.
        let mut z =
            self.given.pop().map_or(self.state, |byte| (u64::from(byte) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15));
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number below `end`, 0 where `end` is 0.
    pub fn below(&mut self, end: usize) -> usize {
        if end == 0 { 0 } else { (self.bits() % end as u64) as usize }
    }

    /// A number from `least` to `greatest`, both included.
    pub fn between(&mut self, least: usize, greatest: usize) -> usize {
        least + self.below(greatest - least + 1)
    }

    /// True in `percent` of 100 cases.
    pub fn percent(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }

    /// True in one of `cases` cases.
    pub fn one_in(&mut self, cases: usize) -> bool {
        self.below(cases) == 0
    }

    /// One of a list that is not empty.
    pub fn of<'l, T>(&mut self, list: &'l [T]) -> &'l T {
        &list[self.below(list.len())]
    }
}
