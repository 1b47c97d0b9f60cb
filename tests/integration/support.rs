//! What several tests need: folders, projects, runs.

use std::fs;
use std::path::{Path, PathBuf};

use twinrung_bytecode::{AdmittedImage, admit};
use twinrung_compiler::diagnostic::Finding;
use twinrung_compiler::{CheckedProject, Completion, check, compile};
use twinrung_grammar::read_path;
use twinrung_grammar::tree::Sources;
use twinrung_partner::Partner;
use twinrung_primary::Primary;
use twinrung_workbench::{Run, Stimulus};

/// The two interpreters of this project, driven and recorded.
pub type Session = Run<Primary, Partner>;

/// A path in this project.
pub fn project_path(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// A path in the shared folder beside this project, when it is there; says so when it is not.
pub fn shared_path(path: &str) -> Option<PathBuf> {
    let whole = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared").join(path);
    if whole.exists() {
        return Some(whole);
    }
    eprintln!("skipped: ../shared/{path} is not here");
    None
}

/// A file or folder that was read and checked.
pub struct Read {
    /// The files.
    pub sources: Sources,
    /// What was found.
    pub findings: Vec<Finding>,
    /// The project, when it can be compiled.
    pub project: Option<CheckedProject>,
}

/// Reads and checks.
pub fn read(path: &Path, complete: impl FnOnce(&mut Sources) -> Completion) -> Read {
    let mut sources = Sources::new();
    let completion = complete(&mut sources);
    let reading = read_path(&mut sources, path);
    let checked = check(&reading, &completion);
    Read { sources, findings: checked.findings, project: checked.project }
}

/// Reads and checks what is complete by itself.
pub fn read_whole(path: &Path) -> Read {
    read(path, |_| Completion::default())
}

/// Findings as `code line: message`, for failure messages.
pub fn lines(read: &Read) -> Vec<String> {
    let line = |finding: &Finding| {
        let place = read.sources.line_column(finding.span);
        format!("{} {}: {}", finding.code.id, place.line, finding.message)
    };
    read.findings.iter().map(line).collect()
}

/// The sealed bytes of a project, and the image that a loader makes of them.
pub fn image_of(read: &Read) -> (AdmittedImage, Vec<u8>) {
    let project = read.project.as_ref().unwrap_or_else(|| panic!("refused: {:#?}", lines(read)));
    let bytes = compile(project).unwrap_or_else(|finding| panic!("{}", finding.message)).bytes;
    (admit(&bytes).unwrap_or_else(|error| panic!("{error}")), bytes)
}

/// A stimulus file.
pub fn stimulus(path: &Path) -> Stimulus {
    Stimulus::read(&text(path)).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A text file.
pub fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Whether a file that a person reviewed says something else than what was found now. `BLESS=1` writes what was found, for a
/// person to read before it is committed.
pub fn differs_from_reviewed(path: &Path, found: &str) -> bool {
    if std::env::var_os("BLESS").is_some() {
        fs::write(path, found).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    fs::read_to_string(path).ok().as_deref() != Some(found)
}

/// Fails with both texts where a reviewed file says something else.
pub fn expect_reviewed(path: &Path, found: &str) {
    if differs_from_reviewed(path, found) {
        assert_eq!(found, text(path), "{}: not what was reviewed; BLESS=1 writes it anew", path.display());
    }
}

/// Both channels with a stimulus, ready to run.
pub fn session(read: &Read, stimulus: &Stimulus, record: &[String]) -> Session {
    let (image, bytes) = image_of(read);
    let mut session = Session::new(image, &bytes).unwrap_or_else(|error| panic!("{error}"));
    session.stimulate(stimulus).unwrap_or_else(|error| panic!("{error}"));
    session.record(record).unwrap_or_else(|error| panic!("{error}"));
    session
}
