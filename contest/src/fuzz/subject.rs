//! A program that is checked, compiled and admitted: what evaluators run.

use twinrung_bytecode::{AdmittedImage, ImageError, admit};
use twinrung_compiler::diagnostic::{Finding, OVER_LIMIT};
use twinrung_compiler::lower::is_limit;
use twinrung_compiler::project::{RoutineId, TagId};
use twinrung_compiler::{CheckedProject, CompiledImage, Completion, check, compile};
use twinrung_grammar::read;
use twinrung_grammar::tree::Sources;

/// A program in the forms that evaluators need.
pub struct Subject {
    /// The checked tree.
    pub project: CheckedProject,
    /// The admitted image.
    pub image: AdmittedImage,
    /// Its sealed bytes.
    pub bytes: Vec<u8>,
    /// Which tag of the project each tag of the image is.
    pub tags: Vec<TagId>,
    /// Which routine of the project each routine of the image is.
    pub routines: Vec<RoutineId>,
}

impl Subject {
    /// Compiles source text.
    ///
    /// # Errors
    ///
    /// The findings that keep it from being compiled, as `code line:column message`.
    pub fn from_text(text: &str) -> Result<Subject, Vec<String>> {
        let mut sources = Sources::new();
        let reading = read(&mut sources, "subject.rll", text.as_bytes().to_vec());
        let checked = check(&reading, &Completion::default());
        let Some(project) = checked.project else {
            return Err(checked
                .findings
                .iter()
                .filter(|finding| finding.is_error())
                .map(|finding| line(&sources, finding))
                .collect());
        };
        match compile(&project) {
            // A program beyond a limit is the user's, whether the compiler or the loader says so; a defect of ours is to be heard.
            Ok(compiled) => match admit(&compiled.bytes) {
                Err(error) if is_limit(&error) => Err(vec![format!("{} {error}", OVER_LIMIT.id)]),
                admitted => Ok(Subject::of_image(project, compiled, admitted)),
            },
            Err(finding) if finding.code.id.starts_with('D') => panic!("{}", line(&sources, &finding)),
            Err(finding) => Err(vec![line(&sources, &finding)]),
        }
    }

    /// Compiles a checked project. Panics when it is beyond a limit, or when the loader refuses what the compiler made: that is
    /// a defect of ours.
    pub fn from_project(project: CheckedProject) -> Subject {
        let compiled =
            compile(&project).unwrap_or_else(|finding| panic!("a checked project does not compile: {finding:?}"));
        let admitted = admit(&compiled.bytes);
        Subject::of_image(project, compiled, admitted)
    }

    fn of_image(
        project: CheckedProject,
        compiled: CompiledImage,
        admitted: Result<AdmittedImage, ImageError>,
    ) -> Subject {
        let CompiledImage { bytes, tags, routines, .. } = compiled;
        let image = admitted.unwrap_or_else(|error| panic!("the loader refuses a compiled image: {error}"));
        Subject { project, image, bytes, tags, routines }
    }
}

fn line(sources: &Sources, finding: &Finding) -> String {
    let place = sources.line_column(finding.span);
    format!("{} {}:{} {}", finding.code.id, place.line, place.column, finding.message)
}
