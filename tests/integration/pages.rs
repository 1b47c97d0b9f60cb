//! The pages in `docs` are those that the catalog, the vectors and the table of codes give.

use std::collections::BTreeSet;
use std::fs;

use twinrung_workbench::pages::{findings, index, protection};

use crate::support::{differs_from_reviewed, expect_reviewed, project_path};

#[test]
fn instruction_pages_when_made_anew_then_they_are_those_in_the_folder_and_no_other_lies_there() {
    let folder = project_path("docs/instructions");
    let files = index::files();
    let wrong: Vec<&str> = files
        .iter()
        .filter(|file| differs_from_reviewed(&folder.join(&file.name), &file.text))
        .map(|file| file.name.as_str())
        .collect();
    assert!(wrong.is_empty(), "these pages differ; BLESS=1 writes them anew: {wrong:?}");
    let made: BTreeSet<String> = files.into_iter().map(|file| file.name).collect();
    let found: BTreeSet<String> =
        fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    assert_eq!(made, found);
}

#[test]
fn rules_page_when_made_anew_then_it_is_the_one_in_the_folder() {
    let path = project_path("docs/rules.md");
    expect_reviewed(&path, &findings::rules_table());
}

/// REQ-MODE-002
#[test]
fn protection_page_when_made_anew_then_it_is_the_one_in_the_folder() {
    expect_reviewed(&project_path("docs/protection.md"), &protection::protection_page());
}
