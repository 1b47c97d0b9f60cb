//! The genomes that reached something new.

use crate::fuzz::coverage::Bits;
use crate::generate::{Genome, Random};

use super::mutate::changed;

/// Genomes kept at most; beyond it the least promising of a few gives way.
const KEPT: usize = 8_192;
/// How many are looked at when one is chosen.
const LOOKED_AT: usize = 3;

/// The genomes, and all that they reached.
#[derive(Debug, Default)]
pub struct Corpus {
    kept: Vec<Kept>,
    features: Bits,
}

#[derive(Debug)]
struct Kept {
    genome: Genome,
    /// Features that nobody had reached before it.
    first: usize,
    /// How often it was changed.
    chosen: usize,
}

impl Kept {
    /// How much there is to expect of another change of it.
    fn promise(&self) -> f64 {
        (1.0 + self.first as f64).ln_1p() / (1.0 + self.chosen as f64)
    }
}

impl Corpus {
    /// Takes up a genome that reached these features, if one of them is new; how many are.
    pub fn offer(&mut self, genome: &Genome, reached: &Bits) -> usize {
        let first = self.features.add(reached);
        if first > 0 {
            let one = Kept { genome: genome.clone(), first, chosen: 0 };
            if self.kept.len() < KEPT {
                self.kept.push(one);
            } else {
                // What has been changed most often for least has the lowest promise; newer ones are further behind.
                let worst =
                    (0..self.kept.len()).min_by(|a, b| self.kept[*a].promise().total_cmp(&self.kept[*b].promise()));
                if let Some(worst) = worst {
                    self.kept[worst] = one;
                }
            }
        }
        first
    }

    /// Notes what a program reached that is not to be changed.
    pub fn note(&mut self, reached: &Bits) {
        self.features.add(reached);
    }

    /// A change of one of them; none where there is none.
    pub fn child(&mut self, random: &mut Random) -> Option<Genome> {
        if self.kept.is_empty() {
            return None;
        }
        let drawn = |random: &mut Random| random.below(self.kept.len());
        let looked: Vec<usize> = (0..LOOKED_AT).map(|_| drawn(random)).collect();
        let donor = drawn(random);
        let best = looked.into_iter().max_by(|a, b| self.kept[*a].promise().total_cmp(&self.kept[*b].promise()))?;
        self.kept[best].chosen += 1;
        Some(changed(random, &self.kept[best].genome, &self.kept[donor].genome))
    }
}
