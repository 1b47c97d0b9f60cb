//! From the FILE of a verb to a project or an image.

use std::fmt;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use twinrung_bytecode::{AdmittedImage, ImageError, admit, bound};
use twinrung_compiler::diagnostic::{BROKEN_FILE, Finding, OVER_LIMIT, UNREADABLE_FILE};
use twinrung_compiler::lower::is_limit;
use twinrung_compiler::{CheckedProject, Completion, check, compile};
use twinrung_grammar::tree::{File, Sources};
use twinrung_grammar::{Reading, read_path};
use twinrung_workbench::Stimulus;

use crate::findings::{self, Count, Report};
use crate::terminal::{self, Terminal};
use crate::{exit, failed};

/// What completes a partial export.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "To complete a partial export")]
pub struct Complete {
    /// Controller and major revision, e.g. 1756-L73S/20
    #[arg(long, value_name = "CATALOG/REV")]
    pub controller: Option<String>,
    /// Period of the safety task in ms
    #[arg(long, value_name = "MS")]
    pub period: Option<u32>,
    /// Watchdog of the safety task in ms
    #[arg(long, value_name = "MS")]
    pub watchdog: Option<u32>,
    /// Another export that holds what the file refers to; may be given several times
    #[arg(long, value_name = "FILE")]
    pub context: Vec<PathBuf>,
    /// Tags to publish, instead of output modules and produced tags
    #[arg(long, value_name = "TAG,TAG", value_delimiter = ',')]
    pub outputs: Vec<String>,
}

impl Complete {
    /// These arguments as they are typed.
    #[cfg(feature = "injection")]
    pub fn words(&self) -> Vec<String> {
        let Complete { controller, period, watchdog, context, outputs } = self;
        let quoted = |text: &str| crate::stopwatch::quoted(text.as_ref());
        let controller = controller.iter().map(|name| format!("--controller {}", quoted(name)));
        let period = period.iter().map(|ms| format!("--period {ms}"));
        let watchdog = watchdog.iter().map(|ms| format!("--watchdog {ms}"));
        let context = context.iter().map(|path| format!("--context {}", crate::stopwatch::quoted(path.as_os_str())));
        let outputs = (!outputs.is_empty()).then(|| format!("--outputs {}", quoted(&outputs.join(","))));
        controller.chain(period).chain(watchdog).chain(context).chain(outputs).collect()
    }
}

/// What a program must be to be executed.
#[derive(Debug, Clone, Default, Args)]
pub struct Required {
    /// Refuse a program with another safety application signature
    #[arg(long, value_name = "SIGNATURE")]
    pub expect: Option<String>,
    /// Refuse an image whose bound in instructions is above the budget of its watchdog
    #[arg(long)]
    pub require_bound: bool,
}

/// Why there is nothing to work on.
#[derive(Debug)]
pub enum InputError {
    /// The file is not there or cannot be read.
    Unreadable(PathBuf, io::Error),
    /// `--controller` is not CATALOG/REV.
    Controller(String),
    /// An image that the loader refuses.
    Image(PathBuf, ImageError),
    /// A checked project beyond a limit that only the whole image has.
    Limit(String),
    /// A checked project that does not compile: a defect of ours.
    Defect(String),
    /// A scan of the image can execute more than its watchdog allows.
    Bound(bound::BeyondBudget),
    /// The image's signature is not the one that was expected.
    Unexpected {
        /// What was expected.
        expected: String,
        /// The application signature of the image.
        found: String,
    },
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            InputError::Unreadable(path, error) => write!(f, "{}: {error}", path.display()),
            InputError::Controller(text) => {
                write!(f, "--controller takes a catalogue number and a major revision, as 1756-L73S/20; found `{text}`")
            }
            InputError::Image(path, error) => write!(f, "{}: the image is refused: {error}", path.display()),
            InputError::Limit(message) => write!(f, "E0108: {message}"),
            InputError::Defect(message) => write!(f, "a defect of this tool: {message}"),
            InputError::Bound(error) => write!(f, "{error}"),
            InputError::Unexpected { expected, found } => {
                write!(f, "expected the signature {expected}, found {found}")
            }
        }
    }
}

impl std::error::Error for InputError {}

/// A project that was read and checked.
pub struct Read {
    /// The files.
    pub sources: Sources,
    /// Their trees: the project, then what completes it.
    pub trees: Vec<File>,
    /// What was found, ordered.
    pub findings: Vec<Finding>,
    /// The project, when nothing keeps it from being compiled.
    pub project: Option<CheckedProject>,
}

impl Read {
    /// The project with its tree changed, checked again; where it cannot be changed, why. It had no errors before.
    pub fn changed<E>(
        self,
        complete: &Complete,
        change: impl FnOnce(&mut File) -> Result<(), E>,
    ) -> Result<Result<Read, E>, InputError> {
        let mut trees = self.trees.into_iter();
        let mut file = trees.next().unwrap_or_default();
        if let Err(why) = change(&mut file) {
            return Ok(Err(why));
        }
        let completion = Completion { contexts: trees.collect(), ..complete.settings()? };
        Ok(Ok(checked(self.sources, Vec::new(), Reading { file, errors: Vec::new() }, completion)))
    }

    /// The findings with what they point into.
    pub fn report(&self) -> Report<'_> {
        Report { sources: &self.sources, trees: &self.trees, findings: &self.findings }
    }

    /// How many findings there are of each weight.
    pub fn count(&self) -> Count {
        Count::of(&self.findings)
    }

    /// Whether a file, or a part of one, could not be read.
    pub fn is_unreadable(&self) -> bool {
        self.findings.iter().any(|finding| [&UNREADABLE_FILE, &BROKEN_FILE].contains(&finding.code))
    }

    /// Prints why a project is refused and what follows from that (`; nothing was run`); the exit code for it.
    pub fn refuse(&self, out: &mut dyn Write, path: &Path, consequence: &str) -> io::Result<ExitCode> {
        findings::print_human(out, &self.report(), Terminal::of_stdout(), false)?;
        writeln!(out, "{}: {}{consequence}", path.display(), findings::summary(self.count()))?;
        Ok(ExitCode::from(if self.is_unreadable() { exit::UNREADABLE } else { exit::REFUSED }))
    }
}

/// What FILE turned out to be.
pub enum Input {
    /// Source text, or an export.
    Project(Box<Read>),
    /// An image, admitted.
    Image(Box<Loaded>),
}

/// An admitted image with its bytes.
pub struct Loaded {
    /// The image.
    pub image: AdmittedImage,
    /// The sealed bytes.
    pub bytes: Vec<u8>,
}

/// The first bytes of every image.
const IMAGE_MAGIC: &[u8] = twinrung_bytecode::container::MAGIC.as_slice();

impl Complete {
    /// What it says without the files that it names.
    fn settings(&self) -> Result<Completion, InputError> {
        let mut completion = Completion {
            period_ms: self.period,
            watchdog_ms: self.watchdog,
            outputs: self.outputs.clone(),
            ..Completion::default()
        };
        if let Some(text) = &self.controller {
            let (catalog_number, revision) =
                text.rsplit_once('/').ok_or_else(|| InputError::Controller(text.clone()))?;
            let revision = revision.parse().map_err(|_| InputError::Controller(text.clone()))?;
            completion.controller = Some(catalog_number.to_owned());
            completion.revision = Some(revision);
        }
        Ok(completion)
    }

    fn completion(&self, sources: &mut Sources, findings: &mut Vec<Finding>) -> Result<Completion, InputError> {
        let mut completion = self.settings()?;
        for path in &self.context {
            let reading = readable(sources, path)?;
            findings.extend(reading.errors.iter().map(twinrung_compiler::diagnostic::reading_finding));
            completion.contexts.push(reading.file);
        }
        Ok(completion)
    }
}

fn readable(sources: &mut Sources, path: &Path) -> Result<Reading, InputError> {
    // A missing file is the caller's mistake, not a finding in a project.
    fs::metadata(path).map_err(|error| InputError::Unreadable(path.to_owned(), error))?;
    Ok(read_path(sources, path))
}

/// Reads FILE: a project in `.rll`, `.L5K` or `.L5X`, a folder of these, or an image.
pub fn open(path: &Path, complete: &Complete) -> Result<Input, InputError> {
    if is_image(path)? {
        let bytes = fs::read(path).map_err(|error| InputError::Unreadable(path.to_owned(), error))?;
        let image = admit(&bytes).map_err(|error| InputError::Image(path.to_owned(), error))?;
        return Ok(Input::Image(Box::new(Loaded { image, bytes })));
    }
    let mut sources = Sources::new();
    let mut findings = Vec::new();
    let completion = complete.completion(&mut sources, &mut findings)?;
    let reading = readable(&mut sources, path)?;
    Ok(Input::Project(Box::new(checked(sources, findings, reading, completion))))
}

fn checked(sources: Sources, mut findings: Vec<Finding>, reading: Reading, completion: Completion) -> Read {
    let checked = check(&reading, &completion);
    findings.extend(checked.findings);
    let project = checked.project.filter(|_| !findings.iter().any(Finding::is_error));
    let trees = std::iter::once(reading.file).chain(completion.contexts).collect();
    Read { sources, trees, findings, project }
}

fn is_image(path: &Path) -> Result<bool, InputError> {
    use std::io::Read as _;
    if path.is_dir() {
        return Ok(false);
    }
    let unreadable = |error| InputError::Unreadable(path.to_owned(), error);
    let mut begin = Vec::new();
    let file = fs::File::open(path).map_err(unreadable)?;
    file.take(IMAGE_MAGIC.len() as u64).read_to_end(&mut begin).map_err(unreadable)?;
    Ok(begin == IMAGE_MAGIC)
}

/// Checks a project whose text is at hand.
pub fn read_text(name: &Path, text: &str) -> Read {
    let mut sources = Sources::new();
    let reading = twinrung_grammar::read(&mut sources, name, text.as_bytes().to_vec());
    let checked = check(&reading, &Completion::default());
    Read { sources, trees: vec![reading.file], findings: checked.findings, project: checked.project }
}

/// Compiles a checked project and admits its own image, so that nothing runs that a loader would refuse.
pub fn compiled(project: &CheckedProject) -> Result<Loaded, InputError> {
    let compiled = compile(project).map_err(|finding| match finding.code.id {
        id if id == OVER_LIMIT.id => InputError::Limit(finding.message),
        _ => InputError::Defect(finding.message),
    })?;
    let image = admit(&compiled.bytes).map_err(|error| match is_limit(&error) {
        true => InputError::Limit(format!("the project is larger than an image can be: {error}")),
        false => InputError::Image(PathBuf::from("the compiled image"), error),
    })?;
    Ok(Loaded { image, bytes: compiled.bytes })
}

/// FILE as an image: the one that it is, or that of its project. Where a project is refused its findings are printed, with
/// what follows from that (`; nothing was run`), and the exit code is the answer.
pub fn image(
    out: &mut dyn Write,
    path: &Path,
    complete: &Complete,
    consequence: &str,
) -> io::Result<Result<Loaded, ExitCode>> {
    match open(path, complete).map_err(failed)? {
        Input::Image(loaded) => Ok(Ok(*loaded)),
        Input::Project(read) => image_of(out, path, &read, consequence),
    }
}

/// The image of a project that was read, as [`image`] has it.
pub fn image_of(
    out: &mut dyn Write,
    path: &Path,
    read: &Read,
    consequence: &str,
) -> io::Result<Result<Loaded, ExitCode>> {
    let Some(project) = &read.project else { return read.refuse(out, path, consequence).map(Err) };
    let count = read.count();
    if count.warnings + count.suppressed > 0 {
        let path = path.display();
        terminal::tell(format_args!("{path}: {} (twinrung check {path} shows them)", findings::summary(count)));
    }
    compiled(project).map(Ok).map_err(failed)
}

/// The stimulus that is named, or the stimulus.csv in the folder that is FILE.
pub fn stimulus(file: &Path, named: Option<&Path>) -> io::Result<Option<Stimulus>> {
    let beside = file.join("stimulus.csv");
    let path = match named {
        Some(path) => path,
        None if beside.is_file() => &beside,
        None => {
            if let Some(near) = file.parent().map(|folder| folder.join("stimulus.csv")).filter(|near| near.is_file()) {
                terminal::tell(format_args!(
                    "nothing drives the inputs: name the folder instead of the file, or --stimulus {}",
                    near.display()
                ));
            }
            return Ok(None);
        }
    };
    let stimulus = Stimulus::read(&text(path)?);
    stimulus.map(Some).map_err(|error| io::Error::other(format!("{}: {error}", path.display())))
}

/// A text file.
pub fn text(path: &Path) -> io::Result<String> {
    fs::read_to_string(path).map_err(|error| io::Error::other(format!("{}: {error}", path.display())))
}

impl Required {
    /// Refuses an image that is not what is required.
    pub fn check(&self, loaded: &Loaded) -> Result<(), InputError> {
        expect(loaded, self.expect.as_deref())?;
        if self.require_bound { within_budget(loaded) } else { Ok(()) }
    }
}

/// Refuses an image whose bound in instructions is above the budget of its watchdog (REQ-BOUND-007).
pub fn within_budget(loaded: &Loaded) -> Result<(), InputError> {
    bound::check(&loaded.image).map_err(InputError::Bound)
}

/// Refuses an image whose application signature is not the expected one, in its short or its long form.
fn expect(loaded: &Loaded, expected: Option<&str>) -> Result<(), InputError> {
    let Some(expected) = expected else { return Ok(()) };
    let signature = loaded.image.application_signature();
    let long = twinrung_bytecode::signature::long_form(signature);
    let short = twinrung_bytecode::signature::short_form(signature).to_string();
    let plain = |text: &str| text.replace('_', "").to_ascii_lowercase();
    if plain(expected) == plain(&long) || plain(expected) == plain(&short) {
        return Ok(());
    }
    Err(InputError::Unexpected { expected: expected.to_owned(), found: short })
}
