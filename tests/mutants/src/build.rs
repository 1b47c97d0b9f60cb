//! Building, and what the compiler says of it.

use std::error::Error;
use std::fmt;
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

/// What came of a build. The sources are right where it has no words.
#[derive(Debug)]
pub struct Built {
    /// Places of errors, file (from the root) and line.
    pub errors: Vec<(String, usize)>,
    /// What the compiler said of them.
    pub words: Vec<String>,
    /// The programs, where there was no error.
    pub tests: Vec<Tests>,
}

/// Why there is nothing to run.
#[derive(Debug)]
pub enum BuildError {
    /// Cargo cannot be run.
    Cargo(io::Error),
    /// It refused, and not because of an error in the sources: it has said why.
    Refused,
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::Cargo(error) => write!(f, "cargo cannot be run: {error}"),
            BuildError::Refused => {
                write!(f, "cargo built nothing, as it says above: give arguments that it takes")
            }
        }
    }
}

impl Error for BuildError {}

/// Builds what these words tell cargo to build, a command and its arguments.
///
/// # Errors
///
/// When cargo cannot be run, or refuses.
pub fn build(root: &Path, words: &[String]) -> Result<Built, BuildError> {
    let output = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(words.first())
        .arg("--message-format=json")
        .args(words.iter().skip(1))
        .current_dir(root)
        .stderr(Stdio::inherit())
        .output()
        .map_err(BuildError::Cargo)?;
    read(&String::from_utf8_lossy(&output.stdout), output.status.success())
}

/// Reads what cargo said, and whether it succeeded.
fn read(said: &str, is_built: bool) -> Result<Built, BuildError> {
    let mut built = Built { errors: Vec::new(), words: Vec::new(), tests: Vec::new() };
    for line in said.lines() {
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
    if !is_built && built.words.is_empty() { Err(BuildError::Refused) } else { Ok(built) }
}

/// The outermost place of a span: what a macro made of it stands where it was called.
fn place(span: &Value) -> Option<(String, usize)> {
    let mut span = span;
    while span["expansion"]["span"].is_object() {
        span = &span["expansion"]["span"];
    }
    Some((span["file_name"].as_str()?.to_owned(), usize::try_from(span["line_start"].as_u64()?).ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn workspace() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
    }

    #[test]
    fn build_when_no_such_package_is_there_then_it_is_refused_and_not_taken_for_tests_that_pass() {
        let words = ["test", "--no-run", "-p", "no-such-package"].map(str::to_owned);
        let refused = build(&workspace(), &words).unwrap_err();
        assert!(matches!(refused, BuildError::Refused), "{refused}");
    }

    #[test]
    fn build_when_it_gives_programs_then_those_with_tests_are_told() {
        let library = r#"{"reason":"compiler-artifact","profile":{"test":false},"executable":null,"manifest_path":"/a/Cargo.toml"}"#;
        let tests = r#"{"reason":"compiler-artifact","profile":{"test":true},"executable":"/t/a-1","manifest_path":"/a/Cargo.toml"}"#;
        let built = read(&format!("{library}\n{tests}\n"), true).unwrap();
        assert_eq!(
            (built.tests[0].program.as_path(), built.tests[0].folder.as_path()),
            (Path::new("/t/a-1"), Path::new("/a"))
        );
    }

    #[test]
    fn build_when_a_source_has_an_error_then_its_place_is_that_of_the_macro_call() {
        let error = r#"{"reason":"compiler-message","message":{"level":"error","rendered":"no","spans":[
            {"is_primary":true,"file_name":"macros.rs","line_start":9,"expansion":{"span":{"file_name":"a.rs","line_start":3,"expansion":null}}},
            {"is_primary":false,"file_name":"b.rs","line_start":4,"expansion":null}]}}"#;
        let built = read(&error.replace('\n', " "), false).unwrap();
        assert_eq!((built.errors, built.words), (vec![("a.rs".to_owned(), 3)], vec!["no".to_owned()]));
    }
}
