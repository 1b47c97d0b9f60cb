//! The checklists of 1756-RM093 Appendix D, filled in as far as a project can answer them.
//!
//! A line is answered `Yes` or `No` only where the files alone decide it, and then with the evidence. Everything else is
//! left to a person, with what the files have to say about it. Nothing is ticked on a guess: where the project has errors
//! or is a partial export, a line that would be `Yes` is left to a person too.

mod application;
mod channel;
mod system;

use serde::Serialize;
use twinrung_bytecode::signature::short_form;
use twinrung_compiler::diagnostic::{Code, Finding};
use twinrung_compiler::{CheckedProject, Severity};
use twinrung_grammar::tree::{File, Sources};

use crate::usage;

/// Who answers a line, and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Answer {
    /// The files show that it is fulfilled.
    Yes,
    /// The files show that it is not.
    No,
    /// The files cannot decide it.
    Person,
}

/// One line of a checklist.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Line {
    /// Its number in the manual.
    pub number: u32,
    /// What it asks, in our words.
    pub requirement: &'static str,
    /// The answer.
    pub answer: Answer,
    /// What the files say about it.
    pub evidence: Vec<String>,
}

/// One checklist, filled in for one subject.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Checklist {
    /// Which of the manual's lists.
    pub title: &'static str,
    /// The page of 1756-RM093I.
    pub page: u32,
    /// The controller, or the channel.
    pub subject: String,
    /// Its lines in the manual's order.
    pub lines: Vec<Line>,
}

/// What the lists are answered from.
#[derive(Debug, Clone, Copy)]
pub struct Evidence<'a> {
    /// The files.
    pub sources: &'a Sources,
    /// The project's tree.
    pub file: &'a File,
    /// What a check found.
    pub findings: &'a [Finding],
    /// The project, when no error was found.
    pub project: Option<&'a CheckedProject>,
    /// The safety application signature, when the project compiles.
    pub signature: Option<&'a [u8; 32]>,
}

/// Findings of one line that are listed; the others are counted.
const LISTED_MAX: usize = 5;

/// Fills in all lists: the system, each safety input channel, each safety output channel, the application program.
pub fn fill(evidence: &Evidence<'_>) -> Vec<Checklist> {
    let index = evidence.project.map_or_else(usage::Index::default, |project| usage::Index::new(project));
    let mut lists = vec![system::list(evidence)];
    lists.extend(channel::lists(evidence, &index));
    lists.push(application::list(evidence, &index));
    lists
}

impl Evidence<'_> {
    /// The controller's name, or the file's.
    fn subject(&self) -> String {
        match &self.file.controller {
            Some(controller) => controller.name.text.to_string(),
            None => self.file.sources.first().and_then(|id| self.sources.get(*id)).map_or_else(String::new, |file| {
                file.path().file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
            }),
        }
    }

    /// Whether a missing finding means something: everything was there, and everything was read and judged.
    fn is_whole(&self) -> bool {
        self.project.is_some() && self.file.controller.is_some() && !self.is_partial()
    }

    fn is_partial(&self) -> bool {
        self.file.export.as_ref().is_some_and(|export| export.is_partial())
    }

    /// Findings with these codes, as `S0301 file:line message`.
    fn found(&self, codes: &[&'static Code]) -> Vec<String> {
        let of = self.findings.iter().filter(|finding| codes.iter().any(|code| code.id == finding.code.id));
        let mut lines: Vec<String> = of
            .map(|finding| {
                let place = self.sources.line_column(finding.span);
                let path = self.sources.get(finding.span.source).map(|file| file.path().display().to_string());
                let accepted = finding.accepted.as_ref().map(|reason| format!(" (accepted: {reason})"));
                format!(
                    "{} {}:{} {}{}",
                    finding.code.id,
                    path.unwrap_or_default(),
                    place.line,
                    finding.message,
                    accepted.unwrap_or_default()
                )
            })
            .collect();
        let more = lines.len().saturating_sub(LISTED_MAX);
        lines.truncate(LISTED_MAX);
        if more > 0 {
            lines.push(format!("and {more} more"));
        }
        lines
    }

    /// A line that these codes decide: `No` with one of them, `Yes` without where the check saw everything.
    fn decided(&self, number: u32, requirement: &'static str, codes: &[&'static Code], yes: Vec<String>) -> Line {
        let found = self.found(codes);
        if !found.is_empty() {
            return Line { number, requirement, answer: Answer::No, evidence: found };
        }
        if self.is_whole() {
            return Line { number, requirement, answer: Answer::Yes, evidence: yes };
        }
        let mut evidence = yes;
        evidence.push(self.why_not_whole());
        Line { number, requirement, answer: Answer::Person, evidence }
    }

    fn why_not_whole(&self) -> String {
        let errors = self.findings.iter().filter(|finding| finding.severity == Severity::Error).count();
        if errors > 0 {
            format!("not decided: the project has errors ({errors}); mend them and fill in again")
        } else {
            "not decided: this is a part of a project".to_owned()
        }
    }

    fn signature_text(&self) -> Option<String> {
        self.signature.map(|signature| short_form(signature).to_string())
    }
}

/// A line that the files cannot decide.
fn person(number: u32, requirement: &'static str, evidence: Vec<String>) -> Line {
    Line { number, requirement, answer: Answer::Person, evidence }
}
