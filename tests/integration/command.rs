//! The command as its users run it, and its output against files that a person has reviewed.

use std::process::Command;

use crate::support::{expect_reviewed, project_path};

/// What a run of the command gave.
pub struct Said {
    /// Its exit code.
    pub code: Option<i32>,
    /// The standard output.
    pub out: String,
    /// The standard error.
    pub err: String,
}

/// Runs the command in the project's folder, so that paths are said as they are given.
pub fn twinrung(arguments: &[&str]) -> Said {
    let output = Command::new(env!("CARGO_BIN_EXE_twinrung"))
        .args(arguments)
        .current_dir(project_path(""))
        .output()
        .unwrap_or_else(|error| panic!("{error}"));
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Said { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) }
}

/// Compares with a file under `tests/verdict` that a person reviewed.
pub fn expect(name: &str, found: &str) {
    expect_reviewed(&project_path("tests/verdict").join(name), found);
}
