//! A set of small numbers that is quick to add to and to walk through.

/// The set.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Bits {
    words: Vec<u64>,
    members: Vec<u32>,
}

impl Bits {
    /// Adds a number; whether it was not there.
    pub fn insert(&mut self, number: u32) -> bool {
        let (word, bit) = (number as usize / 64, 1 << (number % 64));
        if word >= self.words.len() {
            self.words.resize(word + 1, 0);
        }
        let is_new = self.words[word] & bit == 0;
        if is_new {
            self.words[word] |= bit;
            self.members.push(number);
        }
        is_new
    }

    /// Whether a number is there.
    pub fn contains(&self, number: u32) -> bool {
        self.words.get(number as usize / 64).is_some_and(|word| word & (1 << (number % 64)) != 0)
    }

    /// The numbers, in the order in which they came.
    pub fn members(&self) -> &[u32] {
        &self.members
    }

    /// Adds all of another set; how many of them were not there.
    pub fn add(&mut self, other: &Bits) -> usize {
        other.members.iter().filter(|number| self.insert(**number)).count()
    }
}
