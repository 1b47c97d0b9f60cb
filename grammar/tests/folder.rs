//! A folder is one project.

use std::path::Path;

use twinrung_grammar::read_path;
use twinrung_grammar::tree::{ErrorKind, Sources};

fn samples() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/samples")
}

/// REQ-LANG-004
#[test]
fn folder_when_read_then_is_one_project() {
    let mut sources = Sources::new();
    let reading = read_path(&mut sources, &samples().join("folder"));
    let file = &reading.file;
    assert_eq!(reading.errors, []);
    assert_eq!((file.sources.len(), sources.iter().count()), (3, 3));
    assert_eq!(file.controller.as_ref().unwrap().name.as_str(), "Cell");
    assert_eq!(file.programs[0].trivia.leading(), ["// A program of its own."]);
    assert_eq!(sources.get(file.data_types[0].span.source).unwrap().path().file_name().unwrap(), "type.RLL");
}

#[test]
fn folder_when_it_holds_no_rll_then_is_an_error() {
    let reading = read_path(&mut Sources::new(), &Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    assert_eq!(reading.errors[0].kind, ErrorKind::Empty);
}

#[test]
fn file_when_not_there_then_is_an_error() {
    let reading = read_path(&mut Sources::new(), &samples().join("nothing.rll"));
    assert_eq!(reading.errors[0].kind, ErrorKind::Unreadable);
}

#[test]
fn export_when_merged_into_a_project_then_its_context_gives_way() {
    let mut sources = Sources::new();
    let mut context = read_path(&mut sources, &samples().join("context.L5X")).file;
    let project = read_path(&mut sources, &samples().join("folder")).file;
    assert_eq!(context.merge(project), None);
    assert_eq!(context.programs.len(), 2);
    assert_eq!(sources.text(context.controller.unwrap().name.span), "Cell");
}

#[test]
fn controller_when_there_are_two_then_is_an_error() {
    let mut sources = Sources::new();
    let mut first = read_path(&mut sources, &samples().join("folder")).file;
    let second = read_path(&mut sources, &samples().join("folder")).file;
    assert_eq!(first.merge(second).unwrap().kind, ErrorKind::TwoControllers);
}
