//! Mutants of a seed: a function of a number, so that every run has the same ones.

/// Pieces that tend to reach far: brackets, numbers at limits, words of the language.
const PIECES: &[&str] = &[
    "[",
    "]",
    "(",
    ")",
    ",",
    ";",
    ":",
    ":=",
    "\"",
    "'",
    "$",
    "(*",
    "*)",
    "//",
    "<![CDATA[",
    "]]>",
    "&#x0;",
    "&amp;",
    "<",
    ">",
    "-",
    "2147483647",
    "-2147483648",
    "4294967296",
    "16#ffff_ffff",
    "2#",
    "1.#QNAN",
    "1.0e38",
    "99999999999999999999",
    "?",
    "END_RUNG",
    "END_TAG",
    "END_ROUTINE",
    "N: ",
    "RC: ",
    "allow W0101: x",
    "XIC(",
    "MOV(",
    "CPT(",
    "DCS(",
    "JSR(",
    "\\",
    "\u{feff}",
    "é",
];
/// How often a piece is repeated when it is.
const REPEATS: [usize; 4] = [2, 64, 65, 300];
/// Changes of one mutant at most.
const CHANGES_MAX: usize = 6;
/// Bytes of a mutant at most.
const LENGTH_MAX: usize = 1 << 20;

/// Makes mutants: the same ones from the same seed.
#[derive(Debug, Clone)]
pub struct Mutator {
    random: fastrand::Rng,
}

impl Mutator {
    /// A mutator with a seed.
    pub fn new(seed: u64) -> Mutator {
        Mutator { random: fastrand::Rng::with_seed(seed) }
    }

    /// A number below `bound`; 0 for 0.
    fn below(&mut self, bound: usize) -> usize {
        if bound == 0 { 0 } else { self.random.usize(..bound) }
    }

    /// A mutant of `seed`, into which pieces of `other` may come.
    pub fn mutant(&mut self, seed: &[u8], other: &[u8]) -> Vec<u8> {
        let mut bytes = seed.to_vec();
        for _ in 0..self.random.usize(1..=CHANGES_MAX) {
            self.change(&mut bytes, other);
        }
        bytes.truncate(LENGTH_MAX);
        bytes
    }

    fn change(&mut self, bytes: &mut Vec<u8>, other: &[u8]) {
        let at = self.below(bytes.len());
        match self.below(8) {
            0 if !bytes.is_empty() => bytes[at] ^= 1 << self.below(8),
            1 if !bytes.is_empty() => bytes[at] = self.random.u8(..),
            2 => {
                let end = (at + 1 + self.below(40)).min(bytes.len());
                bytes.drain(at.min(end)..end);
            }
            3 => {
                let end = (at + 1 + self.below(200)).min(bytes.len());
                let piece = bytes[at.min(end)..end].to_vec();
                let to = self.below(bytes.len());
                bytes.splice(to..to, piece);
            }
            4 | 5 => {
                let piece = PIECES[self.below(PIECES.len())];
                bytes.splice(at..at, piece.bytes());
            }
            6 => {
                let piece = PIECES[self.below(PIECES.len())].repeat(REPEATS[self.below(REPEATS.len())]);
                bytes.splice(at..at, piece.into_bytes());
            }
            _ => {
                let begin = self.below(other.len());
                let end = (begin + self.below(400)).min(other.len());
                bytes.splice(at..at, other[begin..end].iter().copied());
            }
        }
    }
}
