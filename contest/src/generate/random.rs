//! Random choices, as bytes, in stretches that belong together: each rung and each step of the inputs is a gene of its own, so
//! that changing one leaves the others as they were. What was not given is drawn from a seed (SplitMix64, which needs no
//! state but one word and no crate), and everything that was taken is kept, so that it can be given again.

use std::hash::{DefaultHasher, Hash, Hasher};

use serde::{Deserialize, Serialize};

/// The choices of one stretch.
pub type Gene = Vec<u8>;

/// The choices of a program and of its inputs.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Genome {
    /// The program: its declarations, then rung after rung.
    pub program: Vec<Gene>,
    /// The inputs: what holds for all of them, then step after step.
    pub inputs: Vec<Gene>,
    /// Where choices come from that were not given.
    pub seed: u64,
}

impl Genome {
    /// One of which nothing is given but the seed.
    pub fn of_seed(seed: u64) -> Genome {
        Genome { seed, ..Genome::default() }
    }

    /// A number that its choices give.
    pub fn fingerprint(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        (&self.program, &self.inputs).hash(&mut hasher);
        hasher.finish()
    }
}

/// A stream of choices.
#[derive(Debug, Clone)]
pub struct Random {
    state: u64,
    /// Bytes that the state has given and nobody has taken.
    spare: [u8; 8],
    spare_length: usize,
    given: std::vec::IntoIter<Gene>,
    current: std::vec::IntoIter<u8>,
    taken: Vec<Gene>,
}

impl Random {
    /// The stream of a seed.
    pub fn new(seed: u64) -> Random {
        Random::given(Vec::new(), seed)
    }

    /// The stream whose first choices in each stretch are those of a gene, and after them those of a seed.
    pub fn given(genes: Vec<Gene>, seed: u64) -> Random {
        let mut random = Random {
            state: seed ^ 0x5851_F42D_4C95_7F2D,
            spare: [0; 8],
            spare_length: 0,
            given: genes.into_iter(),
            current: Vec::new().into_iter(),
            taken: Vec::new(),
        };
        random.gene();
        random
    }

    /// Begins a stretch.
    pub fn gene(&mut self) {
        self.current = self.given.next().unwrap_or_default().into_iter();
        self.taken.push(Vec::new());
    }

    /// Keeps nothing of what was taken so far: for a stream that nobody will give again.
    pub fn forget(&mut self) {
        self.taken.clear();
    }

    /// All that was taken, stretch by stretch.
    pub fn taken(self) -> Vec<Gene> {
        self.taken
    }

    fn byte(&mut self) -> u8 {
        let byte = self.current.next().unwrap_or_else(|| self.drawn());
        if let Some(gene) = self.taken.last_mut() {
            gene.push(byte);
        }
        byte
    }

    fn drawn(&mut self) -> u8 {
        if self.spare_length == 0 {
            self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = self.state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            self.spare = (z ^ (z >> 31)).to_le_bytes();
            self.spare_length = self.spare.len();
        }
        self.spare_length -= 1;
        self.spare[self.spare_length]
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        u64::from_le_bytes([(); 8].map(|()| self.byte()))
    }

    /// A number below `end`, 0 where `end` is 0.
    pub fn below(&mut self, end: usize) -> usize {
        match end {
            0..=1 => 0,
            2..=40 | 100 => usize::from(self.byte()) * end / 256,
            41..=4_096 => usize::from(u16::from_be_bytes([self.byte(), self.byte()])) * end / 65_536,
            _ => (self.bits() % end as u64) as usize,
        }
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
