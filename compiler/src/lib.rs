//! From tree to image: names, types, rules, lowering.
//!
//! ```text
//! tree --check--> CheckedProject + findings --compile--> CompiledImage
//! ```
//!
//! A [`Project`] has every name resolved and every type laid out; a [`CheckedProject`] is one in which nothing was found
//! that keeps it from running, and only [`check`] makes one. It holds programs, routines and rungs as trees with
//! resolved operands, so that an evaluator can walk them without the lowering; see [`project`] and [`operand`].
//!
//! May depend on the grammar, the catalog and the image format. Must never execute anything, never say what a
//! diagnostic looks like on a screen, and never know a fact about an instruction that is not in the catalog.

pub mod completion;
pub mod diagnostic;
mod flow;
pub mod instruction_signature;
pub mod library;
pub mod lower;
pub mod names;
pub mod operand;
pub mod project;
pub mod rules;
mod suppression;

pub use completion::Completion;
pub use diagnostic::{Code, Finding, Severity};
pub use library::{LibraryError, check_library, compile_library};
pub use lower::{CompiledImage, compile};
pub use project::Project;

use diagnostic::{Findings, RungIndex, reading_finding};
use twinrung_grammar::Reading;
use twinrung_grammar::tree::ErrorKind;

/// What a check found.
#[derive(Debug)]
pub struct Checked {
    /// Everything found, ordered by place.
    pub findings: Vec<Finding>,
    /// The project, when no finding is an error.
    pub project: Option<CheckedProject>,
}

/// A project in which no error was found: every name resolves, every type is laid out, every rule is kept.
#[derive(Debug)]
pub struct CheckedProject {
    project: Project,
}

impl std::ops::Deref for CheckedProject {
    type Target = Project;

    fn deref(&self) -> &Project {
        &self.project
    }
}

/// Checks what was read: names, types, rules. Errors of the reading are among the findings; what one mistake causes is
/// not reported as another.
pub fn check(reading: &Reading, completion: &Completion) -> Checked {
    check_inputs(reading, completion, false)
}

pub(crate) fn check_inputs(reading: &Reading, completion: &Completion, library: bool) -> Checked {
    let mut findings = Findings::default();
    for error in &reading.errors {
        findings.push(reading_finding(error));
    }
    let unreadable = |kind: ErrorKind| {
        matches!(
            kind,
            ErrorKind::Unreadable
                | ErrorKind::TooLarge
                | ErrorKind::Empty
                | ErrorKind::MalformedXml
                | ErrorKind::NotL5x
                | ErrorKind::TwoControllers
        )
    };
    if reading.errors.iter().any(|error| unreadable(error.kind)) {
        return Checked { findings: findings.into_list(), project: None };
    }
    let inputs = project::Inputs { file: &reading.file, completion, library };
    let project = project::build(&inputs, &mut findings);
    rules::check(&project, &mut findings);
    let files: Vec<_> = std::iter::once(&reading.file).chain(&completion.contexts).collect();
    rules::check_files(&files, &project, &mut findings);
    // A declaration that could not be read may be the one that a name misses.
    let in_rungs = |kind: ErrorKind| matches!(kind, ErrorKind::MalformedRung | ErrorKind::UnknownRungKind);
    if reading.errors.iter().any(|error| !in_rungs(error.kind)) {
        findings.retain(|finding| !finding.code.id.starts_with("E02"));
    }
    suppression::apply(&reading.file, &completion.contexts, &mut findings);
    if !findings.is_empty() {
        findings.place(&RungIndex::new(std::iter::once(&reading.file).chain(&completion.contexts)));
    }
    let has_errors = findings.has_errors();
    let project = (!has_errors).then_some(CheckedProject { project });
    Checked { findings: findings.into_list(), project }
}
