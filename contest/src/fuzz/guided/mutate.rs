//! Changes of a genome.

use crate::generate::{Gene, Genome, Random};

/// A genome with a few changes; some genes come from another.
pub fn changed(random: &mut Random, parent: &Genome, donor: &Genome) -> Genome {
    let mut child = Genome { seed: random.bits(), ..parent.clone() };
    let times = 1 << random.below(4);
    // Either the program stays and its inputs change, or the other way round; rarely both.
    let which = random.below(5);
    for _ in 0..times {
        if which <= 2 {
            change(random, &mut child.inputs, &donor.inputs);
        }
        if which >= 2 {
            change(random, &mut child.program, &donor.program);
        }
    }
    child
}

fn change(random: &mut Random, genes: &mut Vec<Gene>, donor: &[Gene]) {
    if genes.is_empty() {
        return;
    }
    let at = random.below(genes.len());
    match random.below(12) {
        // Drawn anew.
        0..=1 => genes[at].clear(),
        // One choice.
        2..=4 if !genes[at].is_empty() => {
            let place = random.below(genes[at].len());
            genes[at][place] = random.below(256) as u8;
        }
        // A choice beside it.
        5 if !genes[at].is_empty() => {
            let place = random.below(genes[at].len());
            let by = if random.percent(50) { 1 } else { u8::MAX };
            genes[at][place] = genes[at][place].wrapping_add(by);
        }
        // The same beginning and another end.
        6 if !genes[at].is_empty() => {
            let place = random.below(genes[at].len());
            genes[at].truncate(place);
        }
        7 => {
            let copy = genes[at].clone();
            genes.insert(at, copy);
        }
        8 if genes.len() > 1 => {
            genes.remove(at);
        }
        9 => {
            let other = random.below(genes.len());
            genes.swap(at, other);
        }
        10 if !donor.is_empty() => genes[at].clone_from(random.of(donor)),
        11 if at < donor.len() => {
            genes.truncate(at);
            genes.extend_from_slice(&donor[at..]);
        }
        _ => genes[at].clear(),
    }
}
