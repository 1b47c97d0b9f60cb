//! Whatever is read without an error prints as a text that reads as the same tree, and prints as that text again: samples,
//! refused samples, tests, and mutants of them that happen to be valid.

mod support;

#[allow(dead_code, unreachable_pub)]
#[path = "../../tests/hostile/src/mutator.rs"]
mod mutator;

use std::fs;
use std::path::{Path, PathBuf};

use mutator::Mutator;
use support::without_spans;
use twinrung_grammar::tree::Sources;
use twinrung_grammar::{print_file, print_file_checked, read};

/// Folders that hold good beginnings, from the root of the project.
const FOLDERS: [&str; 3] = ["samples", "grammar/tests", "tests/verdict"];
/// Mutants of each kind of file.
const MUTANTS: usize = 4_000;
/// A longer seed makes a mutant that is rarely valid and costs much.
const SEED_BYTES_MAX: usize = 12_000;

fn files(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            files(&path, ending, found);
        } else if path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending)) {
            found.push(path);
        }
    }
}

fn seeds(ending: &str) -> Vec<(String, Vec<u8>)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = Vec::new();
    FOLDERS.iter().for_each(|folder| files(&root.join(folder), ending, &mut found));
    found.into_iter().map(|path| (path.display().to_string(), fs::read(path).unwrap())).collect()
}

/// Why what a text says does not survive being printed; nothing for a text that is not read without errors.
fn lost(name: &str, bytes: &[u8]) -> Option<String> {
    let reading = read(&mut Sources::new(), name, bytes.to_vec());
    if !reading.errors.is_empty() {
        return None;
    }
    let printed = print_file(&reading.file);
    let again = read(&mut Sources::new(), "printed.rll", printed.clone().into_bytes());
    if !again.errors.is_empty() {
        return Some(format!("what was printed cannot be read: {:?}\n{printed}", again.errors));
    }
    if print_file(&again.file) != printed {
        return Some(format!("what was printed is printed otherwise:\n{printed}\n{}", print_file(&again.file)));
    }
    // An export's tree says where its text came from; a printed text's does not.
    let (before, after) = (without_spans(&reading.file), without_spans(&again.file));
    let differs = !name.ends_with("L5X") && before != after;
    differs.then(|| {
        let line = before.lines().zip(after.lines()).find(|(one, other)| one != other);
        format!("what was printed is another tree: {line:?}\n{printed}")
    })
}

/// How many mutants of texts are valid, and which of them do not survive.
fn lost_mutants(seed: u64) -> (usize, Vec<String>) {
    let mut seeds = seeds("rll");
    seeds.retain(|(_, bytes)| bytes.len() <= SEED_BYTES_MAX);
    let mut mutator = Mutator::new(seed);
    let mutants = (0..MUTANTS).map(|number| {
        let (one, other) = (&seeds[number % seeds.len()].1, &seeds[(number * 7 + 1) % seeds.len()].1);
        mutator.mutant(one, other)
    });
    let is_valid = |bytes: &Vec<u8>| read(&mut Sources::new(), "mutant.rll", bytes.clone()).errors.is_empty();
    let valid: Vec<Vec<u8>> = mutants.filter(is_valid).collect();
    let found = valid.iter().filter_map(|bytes| lost("mutant.rll", bytes)).collect();
    (valid.len(), found)
}

/// REQ-LANG-030
#[test]
fn samples_when_printed_and_read_then_are_the_same() {
    let all = ["rll", "L5K", "L5X"].into_iter().flat_map(seeds);
    let wrong: Vec<String> =
        all.filter_map(|(name, bytes)| lost(&name, &bytes).map(|why| format!("{name}: {why}"))).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// REQ-LANG-030
#[test]
fn mutants_of_texts_when_valid_and_printed_then_read_as_the_same() {
    let (valid, wrong) = lost_mutants(0x7072_696e);
    assert!(valid > MUTANTS / 20, "{valid} of {MUTANTS} are valid");
    assert!(wrong.is_empty(), "{} of {valid}:\n{}", wrong.len(), wrong.join("\n\n"));
}

/// An export can hold names that no text can say: then there is no text, and never a wrong one. Names that can be said are
/// the rule.
///
/// REQ-LANG-033
#[test]
fn mutants_of_exports_when_valid_then_their_text_is_right_or_refused() {
    let mut seeds = seeds("L5X");
    seeds.retain(|(_, bytes)| bytes.len() <= SEED_BYTES_MAX);
    let mut mutator = Mutator::new(0x7072_696f);
    let mutants = (0..MUTANTS).map(|number| {
        let (one, other) = (&seeds[number % seeds.len()].1, &seeds[(number * 7 + 1) % seeds.len()].1);
        read(&mut Sources::new(), "mutant.L5X", mutator.mutant(one, other))
    });
    let (said, refused): (Vec<_>, Vec<_>) = mutants
        .filter(|reading| reading.errors.is_empty())
        .map(|reading| print_file_checked(&reading.file).map_err(|why| why.to_string()))
        .partition(Result::is_ok);
    assert!(said.len() > 2 * refused.len() && said.len() > MUTANTS / 40, "{} said, {} not", said.len(), refused.len());
    let silent: Vec<_> = refused.iter().filter(|why| why.as_ref().is_err_and(String::is_empty)).collect();
    assert!(silent.is_empty(), "{silent:?}");
}
