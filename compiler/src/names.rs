//! Names: compared without regard to case, looked up by hash, and suggested when nearly right.

use std::collections::HashMap;

use twinrung_grammar::tree::CompactString;

/// A map with a fast hasher that is seeded anew in every process, so that nobody can prepare collisions.
pub type Map<K, V> = HashMap<K, V, foldhash::fast::RandomState>;

/// A set with the same hasher.
pub type Set<K> = std::collections::HashSet<K, foldhash::fast::RandomState>;

/// The form under which a name is looked up: lower case.
pub fn fold(name: &str) -> CompactString {
    let mut folded = CompactString::new(name);
    folded.make_ascii_lowercase();
    folded
}

/// Compares two names as the sorted tables of an image do: by fold case, then by spelling.
pub fn compare(left: &str, right: &str) -> std::cmp::Ordering {
    let folded = |name: &str| name.bytes().map(|byte| byte.to_ascii_lowercase()).collect::<Vec<u8>>();
    folded(left).cmp(&folded(right)).then_with(|| left.cmp(right))
}

/// Names that are longer than this are not compared: nobody mistypes them once.
const LONGEST_COMPARED: usize = 64;

/// The candidate that is most like `name`, when it is like enough to be meant: at most one letter in three differs, two
/// at most, swapped neighbours counting as one.
pub fn closest<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    if name.len() > LONGEST_COMPARED {
        return None;
    }
    let limit = (name.len() / 3).clamp(1, 2);
    let wanted = name.to_ascii_lowercase();
    let letters = letters_of(name);
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        if candidate.len().abs_diff(name.len()) > limit || candidate.len() > LONGEST_COMPARED {
            continue;
        }
        // Each change adds or takes at most two kinds of letters.
        if (letters ^ letters_of(candidate)).count_ones() as usize > 2 * limit {
            continue;
        }
        let distance = distance(wanted.as_bytes(), candidate.to_ascii_lowercase().as_bytes());
        let better = best.is_none_or(|(least, known)| distance < least || (distance == least && candidate < known));
        if distance > 0 && distance <= limit && distance < name.len() && better {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// Which letters and digits a name has, one bit for each.
fn letters_of(name: &str) -> u64 {
    name.bytes().fold(0, |letters, byte| letters | 1 << (byte.to_ascii_lowercase() & 63))
}

/// The optimal string alignment distance: insertions, deletions, changes and swaps of neighbours.
fn distance(left: &[u8], right: &[u8]) -> usize {
    let width = right.len() + 1;
    let mut before_last = vec![0; width];
    let mut last: Vec<usize> = (0..width).collect();
    for (row, &a) in left.iter().enumerate() {
        let mut current = vec![row + 1; width];
        for (column, &b) in right.iter().enumerate() {
            let change = last[column] + usize::from(a != b);
            let mut least = change.min(last[column + 1] + 1).min(current[column] + 1);
            if row > 0 && column > 0 && a == right[column - 1] && left[row - 1] == b {
                least = least.min(before_last[column - 1] + 1);
            }
            current[column + 1] = least;
        }
        before_last = std::mem::replace(&mut last, current);
    }
    last[right.len()]
}

/// Why a text cannot be the name of a component (neutral-text-and-l5x.md C.2).
pub fn name_fault(name: &str) -> Option<&'static str> {
    let first = name.bytes().next();
    if !first.is_some_and(|byte| byte.is_ascii_alphabetic() || byte == b'_') {
        return Some("a name begins with a letter or an underscore");
    }
    if !name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_') {
        return Some("a name holds letters, digits and underscores only");
    }
    if name.len() > 40 {
        return Some("a name has at most 40 characters");
    }
    if name.contains("__") {
        return Some("a name has no two underscores in a row");
    }
    if name.len() > 1 && name.ends_with('_') {
        return Some("a name does not end with an underscore");
    }
    None
}

/// Operator names of expressions, which no tag may have (neutral-text-and-l5x.md C.2, decided).
pub const RESERVED: [&str; 7] = ["AND", "OR", "XOR", "NOT", "MOD", "ABS", "SQR"];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closest_when_neighbours_are_swapped_then_found() {
        assert_eq!(closest("Mtoor", ["Motor", "Rotor", "Belt"].into_iter()), Some("Motor"));
    }

    #[test]
    fn closest_when_nothing_is_near_then_nothing() {
        assert_eq!(closest("Valve", ["Motor", "Belt"].into_iter()), None);
    }

    #[test]
    fn closest_when_one_letter_is_all_there_is_then_nothing() {
        assert_eq!(closest("C", ["A", "B"].into_iter()), None);
    }

    #[test]
    fn closest_when_two_letters_are_replaced_by_others_that_the_name_has_not_then_found() {
        assert_eq!(closest("Feeder", ["Fooder"].into_iter()), Some("Fooder"));
        assert_eq!(closest("Spindle", ["Spxydle"].into_iter()), Some("Spxydle"));
        assert_eq!(closest("Belt", ["Bolt"].into_iter()), Some("Bolt"));
    }

    #[test]
    fn closest_when_several_are_as_near_then_the_first_of_the_alphabet() {
        assert_eq!(closest("Motor", ["Rotor", "Motos", "Moter"].into_iter()), Some("Moter"));
        assert_eq!(closest("Motor", ["Moter", "Motos", "Rotor"].into_iter()), Some("Moter"));
    }

    #[test]
    fn name_fault_when_two_underscores_then_said() {
        assert!(name_fault("a__b").is_some());
        assert!(name_fault("_SV_070").is_none());
    }
}
