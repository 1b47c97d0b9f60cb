//! Libraries: files that hold safety Add-On Instructions only.

use std::fmt;

use twinrung_grammar::Reading;
use twinrung_grammar::tree::Sources;

use crate::completion::Completion;
use crate::diagnostic::Finding;
use crate::{CheckedProject, check_inputs, compile};

/// Why a library was refused: one line for each finding, `file:line:column: CODE message`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LibraryError {
    lines: Vec<String>,
}

impl fmt::Display for LibraryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.lines.join("\n"))
    }
}

impl std::error::Error for LibraryError {}

/// Compiles files, each (name, text), that hold ADD_ON_INSTRUCTION_DEFINITIONs into the image of a library: no
/// controller, no task, no tags. Every definition is taken as class Safety.
///
/// # Errors
///
/// The findings that are errors, placed.
pub fn compile_library(sources: &[(&str, &str)]) -> Result<Vec<u8>, LibraryError> {
    let project = check_library(sources)?;
    compile(&project)
        .map(|compiled| compiled.bytes)
        .map_err(|finding| LibraryError { lines: vec![format!("{} {}", finding.code.id, finding.message)] })
}

/// Checks such files; what an evaluator walks that executes a library as trees.
///
/// # Errors
///
/// The findings that are errors, placed.
pub fn check_library(sources: &[(&str, &str)]) -> Result<CheckedProject, LibraryError> {
    let mut files = Sources::new();
    let mut whole = Reading::default();
    for (name, text) in sources {
        let reading = twinrung_grammar::read(&mut files, *name, text.as_bytes().to_vec());
        whole.errors.extend(reading.errors);
        whole.errors.extend(whole.file.merge(reading.file));
    }
    let line = |finding: &Finding| {
        let place = files.line_column(finding.span);
        let path = files.get(finding.span.source).map_or_else(String::new, |file| file.path().display().to_string());
        format!("{path}:{}:{}: {} {}", place.line, place.column, finding.code.id, finding.message)
    };
    let checked = check_inputs(&whole, &Completion::default(), true);
    match checked.project {
        Some(project) => Ok(project),
        None => {
            let errors = checked.findings.iter().filter(|finding| finding.is_error());
            Err(LibraryError { lines: errors.map(line).collect() })
        }
    }
}
