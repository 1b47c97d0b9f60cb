//! Valid samples with one thing broken, each refused by the rule meant for it and by no other.

use std::collections::BTreeSet;

use twinrung_compiler::{Completion, check};
use twinrung_grammar::tree::Sources;

use crate::support::{project_path, text};

mod of_data;
mod of_instructions;
mod of_modules;
mod of_structure;

/// One way to break a sample.
struct Mutation {
    /// The sample.
    sample: &'static str,
    /// What is broken, in words.
    what: &'static str,
    /// Texts that are replaced, each where it stands first.
    changes: &'static [(&'static str, &'static str)],
    /// The code of the rule that refuses it.
    code: &'static str,
}

/// The ways to break the samples.
fn all() -> impl Iterator<Item = &'static Mutation> {
    [of_data::ALL, of_instructions::ALL, of_modules::ALL, of_structure::ALL].into_iter().flatten()
}

fn sample(name: &str) -> String {
    text(&project_path("samples").join(name).join("project.rll"))
}

/// The codes of all errors of a text.
fn errors(text: &str) -> BTreeSet<&'static str> {
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read(&mut sources, "mutant.rll", text.as_bytes().to_vec());
    let checked = check(&reading, &Completion::default());
    checked.findings.iter().filter(|finding| finding.is_error()).map(|finding| finding.code.id).collect()
}

impl Mutation {
    fn text(&self) -> String {
        self.changes.iter().fold(sample(self.sample), |text, (from, to)| text.replacen(from, to, 1))
    }

    fn applies(&self) -> bool {
        let text = sample(self.sample);
        self.changes.iter().all(|(from, _)| text.contains(from))
    }
}

#[test]
fn mutations_when_counted_then_they_are_many_each_is_named_once_and_each_applies() {
    let names: BTreeSet<&str> = all().map(|mutation| mutation.what).collect();
    let codes: BTreeSet<&str> = all().map(|mutation| mutation.code).collect();
    let idle: Vec<&str> = all().filter(|mutation| !mutation.applies()).map(|mutation| mutation.what).collect();
    assert!(names.len() >= 60, "{}", names.len());
    assert!(codes.len() >= 50, "{}", codes.len());
    assert_eq!(names.len(), all().count());
    assert!(idle.is_empty(), "{idle:#?}");
}

#[test]
fn samples_when_nothing_is_broken_then_no_errors() {
    let samples: BTreeSet<&str> = all().map(|mutation| mutation.sample).collect();
    let refused: Vec<_> =
        samples.into_iter().map(|name| (name, errors(&sample(name)))).filter(|(_, codes)| !codes.is_empty()).collect();
    assert!(refused.is_empty(), "{refused:#?}");
}

#[test]
fn samples_when_one_thing_is_broken_then_refused_by_the_rule_meant_for_it_alone() {
    let wrong: Vec<_> = all()
        .map(|mutation| (mutation, errors(&mutation.text())))
        .filter(|(mutation, codes)| *codes != BTreeSet::from([mutation.code]))
        .map(|(mutation, codes)| format!("{}: {} expected, {codes:?} found", mutation.what, mutation.code))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
