//! Defects are put into a copy and taken out again, and what cannot be put in is told.

use std::fs;

use twinrung_defects::{Channel, Defect, Misfit, ScratchTree};

fn defect(find: &str, replace: &str) -> Defect {
    let words = |text: &str| text.to_owned();
    Defect {
        name: words("late-timer"),
        file: words("vm/primary/src/timer.rs"),
        find: words(find),
        replace: words(replace),
        why: words("the preset is taken as not reached"),
    }
}

#[test]
fn defect_when_its_text_stands_once_then_it_is_replaced_and_otherwise_told() {
    assert_eq!(defect("a >= b", "a > b").applied("if a >= b {}"), Ok("if a > b {}".to_owned()));
    assert_eq!(defect("a >= b", "a > b").applied("if a < b {}"), Err(Misfit::Stands(0)));
    assert_eq!(defect("a", "b").applied("a a"), Err(Misfit::Stands(2)));
    assert_eq!(defect("a", "a").applied("a"), Err(Misfit::ChangesNothing));
}

#[test]
fn defect_when_its_file_is_of_the_other_channel_or_outside_then_it_is_refused() {
    let of_the_primary = defect("a", "b");
    assert_eq!(of_the_primary.is_of(Channel::Primary), Ok(()));
    assert_eq!(of_the_primary.is_of(Channel::Partner), Err(Misfit::Elsewhere));
    let outside = Defect { file: "vm/primary/../partner/src/lib.rs".to_owned(), ..of_the_primary };
    assert_eq!(outside.is_of(Channel::Primary), Err(Misfit::Elsewhere));
}

#[test]
fn scratch_tree_when_a_defect_is_dropped_then_the_file_is_as_it_was_and_the_project_untouched() {
    let project = tempfile::tempdir().unwrap();
    let scratch = tempfile::tempdir().unwrap();
    let file = "vm/primary/src/timer.rs";
    fs::create_dir_all(project.path().join("vm/primary/src")).unwrap();
    fs::create_dir_all(project.path().join("target")).unwrap();
    fs::write(project.path().join(file), "if a >= b {}").unwrap();
    fs::write(project.path().join("target/built"), "").unwrap();
    let tree = ScratchTree::copy(project.path(), scratch.path()).unwrap();
    let applied = tree.apply(&defect("a >= b", "a > b")).unwrap();
    assert_eq!(fs::read_to_string(tree.root().join(file)).unwrap(), "if a > b {}");
    drop(applied);
    assert_eq!(fs::read_to_string(tree.root().join(file)).unwrap(), "if a >= b {}");
    assert_eq!(fs::read_to_string(project.path().join(file)).unwrap(), "if a >= b {}");
    assert!(!tree.root().join("target").exists());
}
