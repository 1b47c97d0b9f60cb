//! The lists of seeded defects fit the sources that they are put into.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use twinrung_defects::{Channel, Defect, read};

/// How many there are at least, both lists together.
const LEAST: usize = 60;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn lists() -> Vec<(Channel, Vec<Defect>)> {
    let list = |channel| read(root(), channel).unwrap_or_else(|error| panic!("{error}")).map(|list| (channel, list));
    Channel::ALL.into_iter().filter_map(list).collect()
}

#[test]
fn seeded_defects_when_their_files_are_read_then_each_text_stands_there_exactly_once() {
    let mut wrong = Vec::new();
    for (channel, defect) in lists().iter().flat_map(|(channel, list)| list.iter().map(move |one| (*channel, one))) {
        let text = fs::read_to_string(root().join(&defect.file)).unwrap_or_default();
        let misfit = defect.is_of(channel).and_then(|()| defect.applied(&text).map(|_| ())).err();
        wrong.extend(misfit.map(|misfit| format!("{}: {}: {misfit}", channel.list(), defect.name)));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn seeded_defects_when_both_lists_are_there_then_they_are_many_and_each_has_a_name_of_its_own() {
    let lists = lists();
    let names: Vec<&str> = lists.iter().flat_map(|(_, list)| list).map(|defect| defect.name.as_str()).collect();
    let distinct: BTreeSet<&str> = names.iter().copied().collect();
    let is_name = |name: &&str| name.bytes().all(|one| one.is_ascii_lowercase() || one.is_ascii_digit() || one == b'-');
    assert_eq!(distinct.len(), names.len(), "two defects have one name: {names:?}");
    assert!(names.iter().all(is_name), "words with hyphens: {names:?}");
    assert!(lists.len() < Channel::ALL.len() || names.len() >= LEAST, "{} defects, at least {LEAST}", names.len());
}
