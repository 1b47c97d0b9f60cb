//! `docs/scenarios.md`: every example is played, and every word of the format is explained.

use super::support::{failures, heater, missing, report};
use crate::support::{project_path, text};

/// The examples of the page.
fn examples() -> Vec<String> {
    let page = text(&project_path("docs/scenarios.md"));
    let blocks = page.split("```scenario\n").skip(1);
    blocks.map(|block| block.split("```").next().unwrap().to_owned()).collect()
}

#[test]
fn page_when_its_examples_are_played_then_all_are_met_and_cover_the_heater() {
    let examples = examples();
    let sample = text(&project_path("samples/estop-with-contactors/project.rll"));
    let projects = [heater(), heater(), sample];
    assert_eq!(examples.len(), projects.len());
    let found: Vec<_> = examples.iter().zip(projects).map(|(example, project)| report(&project, example)).collect();
    let not_met: Vec<String> = found.iter().flat_map(failures).collect();
    assert_eq!(not_met, [] as [String; 0]);
    assert_eq!(missing(&found[1]), [] as [&str; 0]);
}

/// REQ-TEST-018
#[test]
fn page_when_its_examples_are_laid_out_then_nothing_changes() {
    let changed: Vec<String> =
        examples().into_iter().filter(|example| twinrung_grammar::laid_out(example) != *example).collect();
    assert_eq!(changed, [] as [String; 0]);
}

#[test]
fn page_when_searched_then_it_has_every_word_of_the_format() {
    let every = text(&project_path("grammar/src/scenario/token.rs"));
    let page = text(&project_path("docs/scenarios.md"));
    let words = every.lines().filter_map(|line| line.trim().strip_prefix("#[token(\"")?.split('"').next());
    let missing: Vec<&str> = words
        .filter(|word| word.bytes().all(|byte| byte.is_ascii_lowercase()))
        .filter(|word| !page.contains(word))
        .collect();
    assert_eq!(missing, [] as [&str; 0]);
}
