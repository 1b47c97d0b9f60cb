//! Every real export of the shared corpus is read, or refused at a place; the table of outcomes is printed.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::{read_whole, shared_path};

/// Files that are broken as files, and why.
const BROKEN: &[(&str, &str)] = &[("mytest.L5X", "the text of its only rung is `//`")];

/// The L5X files of a folder and of those below it.
pub fn exports(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => found.extend(exports(&path)),
            false if path.extension().is_some_and(|extension| extension == "L5X") => found.push(path),
            false => {}
        }
    }
    found.sort();
    found
}

#[test]
fn corpus_when_read_then_nothing_is_refused_for_its_syntax_and_every_finding_has_a_place() {
    let Some(corpus) = shared_path("corpus") else { return };
    let mut syntax = Vec::new();
    for path in exports(&corpus) {
        let read = read_whole(&path);
        let mut codes: BTreeMap<&str, usize> = BTreeMap::new();
        for finding in read.findings.iter().filter(|finding| finding.is_error()) {
            *codes.entry(finding.code.id).or_default() += 1;
            assert!(read.sources.get(finding.span.source).is_some(), "{}: {}", path.display(), finding.message);
        }
        let verdict = if codes.is_empty() { "compiles".to_owned() } else { format!("{codes:?}") };
        println!("{:<60} {verdict}", path.strip_prefix(&corpus).unwrap().display());
        syntax.extend(codes.keys().filter(|code| code.starts_with("E01")).map(|code| (path.clone(), code.to_string())));
    }
    syntax.retain(|(path, _)| !BROKEN.iter().any(|(name, _)| path.ends_with(name)));
    assert!(syntax.is_empty(), "refused for syntax: {syntax:#?}");
}
