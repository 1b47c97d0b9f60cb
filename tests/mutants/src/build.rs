//! Building a woven tree, and what the compiler says of it.

use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

/// A program of tests, and the folder that it runs in.
#[derive(Debug, Clone)]
pub struct Tests {
    /// The program.
    pub program: PathBuf,
    /// The folder of its package.
    pub folder: PathBuf,
}

/// What came of a build.
pub struct Built {
    /// Places of errors, file (from the root) and line.
    pub errors: Vec<(String, usize)>,
    /// What the compiler said of them.
    pub words: Vec<String>,
    /// The programs, where there was no error.
    pub tests: Vec<Tests>,
}

/// Builds the tests that these arguments of `cargo test` name.
///
/// # Errors
///
/// When cargo cannot be run.
pub fn build(root: &Path, arguments: &[String]) -> io::Result<Built> {
    let output = Command::new("cargo")
        .args(["test", "--no-run", "--message-format=json"])
        .args(arguments)
        .current_dir(root)
        .stderr(Stdio::inherit())
        .output()?;
    let mut built = Built { errors: Vec::new(), words: Vec::new(), tests: Vec::new() };
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let Ok(message) = serde_json::from_str::<Value>(line) else { continue };
        match message["reason"].as_str() {
            Some("compiler-message") if message["message"]["level"] == "error" => {
                let spans = message["message"]["spans"].as_array().into_iter().flatten();
                built.errors.extend(spans.filter(|span| span["is_primary"] == true).filter_map(place));
                built.words.push(message["message"]["rendered"].as_str().unwrap_or_default().to_owned());
            }
            Some("compiler-artifact") if message["profile"]["test"] == true => {
                let program = message["executable"].as_str().map(PathBuf::from);
                let folder = message["manifest_path"].as_str().and_then(|path| Path::new(path).parent());
                if let (Some(program), Some(folder)) = (program, folder) {
                    built.tests.push(Tests { program, folder: folder.to_owned() });
                }
            }
            _ => {}
        }
    }
    Ok(built)
}

/// The outermost place of a span: what a macro made of it stands where it was called.
fn place(span: &Value) -> Option<(String, usize)> {
    let mut span = span;
    while span["expansion"]["span"].is_object() {
        span = &span["expansion"]["span"];
    }
    Some((span["file_name"].as_str()?.to_owned(), usize::try_from(span["line_start"].as_u64()?).ok()?))
}
