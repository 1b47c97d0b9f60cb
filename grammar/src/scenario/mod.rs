//! Scenario files: text to tree, and the canonical layout of the text.

mod build;
mod layout;
mod refusal;
pub(crate) mod token;

use std::path::Path;

use lalrpop_util::lalrpop_mod;

use crate::errors::Errors;
use crate::excerpt::Excerpt;
use crate::limits::FILE_BYTES_MAX;
use crate::tree::scenario::ScenarioFile;
use crate::tree::{ErrorKind, ReadError, SourceId, Sources, Span};

pub use layout::laid_out;

lalrpop_mod!(
    #[allow(clippy::all, unused_qualifications, missing_docs)]
    scenario,
    "/scenario/scenario.rs"
);

/// A scenario file as far as it could be read, and what is wrong with it.
#[derive(Debug)]
pub struct ScenarioReading {
    /// What could be read.
    pub file: ScenarioFile,
    /// What could not, ordered by place.
    pub errors: Vec<ReadError>,
}

/// Reads the bytes of a scenario file.
pub fn read_scenarios(sources: &mut Sources, path: &Path, bytes: Vec<u8>) -> ScenarioReading {
    let length = bytes.len();
    if length > FILE_BYTES_MAX {
        let message = format!("the file has {length} bytes; at most {FILE_BYTES_MAX} are read");
        return refused(sources, path, ErrorKind::TooLarge, message);
    }
    match String::from_utf8(bytes) {
        Ok(text) => read_text(sources, path, text),
        Err(_) => refused(sources, path, ErrorKind::NotUtf8, "the file is not UTF-8".to_owned()),
    }
}

fn refused(sources: &mut Sources, path: &Path, kind: ErrorKind, message: String) -> ScenarioReading {
    let source = sources.add(path, String::new());
    let error = ReadError::new(kind, Span::new(source, 0, 0), message);
    ScenarioReading { file: ScenarioFile { source, items: Vec::new() }, errors: vec![error] }
}

fn read_text(sources: &mut Sources, path: &Path, text: String) -> ScenarioReading {
    let source: SourceId = sources.add(path, text);
    let text = sources.get(source).map_or("", |file| file.text());
    let file = Excerpt { text, source, start: 0, map: None };
    let mut recovered = Vec::new();
    let tokens = token::tokens(text).map(Ok::<_, ReadError>);
    let parsed = scenario::ItemsParser::new().parse(file, &mut recovered, tokens);
    let mut errors = Errors::default();
    for recovery in recovered {
        errors.push(refusal::refusal(file, recovery.error));
    }
    let items = parsed.unwrap_or_else(|error| {
        errors.push(refusal::refusal(file, error));
        Vec::new()
    });
    if items.is_empty() && errors.is_empty() {
        errors.push(
            ReadError::new(ErrorKind::Empty, Span::new(source, 0, 0), "the file holds no scenario")
                .with_help("a scenario begins with `scenario \"its name\"` and ends with `end`"),
        );
    }
    ScenarioReading { file: ScenarioFile { source, items }, errors: errors.into_list() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> ScenarioReading {
        read_scenarios(&mut Sources::new(), Path::new("test.scenario"), text.as_bytes().to_vec())
    }

    fn messages(text: &str) -> Vec<String> {
        read(text).errors.iter().map(|error| error.message.clone()).collect()
    }

    #[test]
    fn file_when_it_holds_every_form_then_it_is_read_without_an_error() {
        let reading = read(include_str!("every_form.scenario"));
        assert!(reading.errors.is_empty(), "{:#?}", reading.errors);
        assert_eq!(reading.file.items.len(), 7);
    }

    #[test]
    fn lines_when_two_are_wrong_then_both_are_told_and_the_others_are_read() {
        let text = "scenario \"x\"\n  given A = 1\n  when B is 1\n  then C is\n  then D is 0\nend\n";
        assert_eq!(
            messages(text),
            [
                "`=` does not belong here; expected `is VALUE`, `terminal NUMBER`, or what happens to the module: \
                 power lost, lost, idle",
                "`then` does not belong here; expected a value: on, off, or a number",
            ]
        );
    }

    #[test]
    fn file_when_it_has_no_scenario_then_it_says_what_belongs_there() {
        assert_eq!(messages("// nothing\n"), ["the file holds no scenario"]);
    }

    #[test]
    fn quotes_when_not_closed_then_that_is_said() {
        let found = messages("scenario \"x\n  given A is 1\nend\n");
        assert_eq!(found.first().map(String::as_str), Some("a quoted text is not closed on its line"));
    }

    #[test]
    fn times_when_without_a_unit_then_the_units_are_named() {
        assert_eq!(
            messages("scenario \"x\"\n  at 200\n  when A is 1\nend\n"),
            ["`when` does not belong here; expected a unit of time: ms, s, min or scans"]
        );
    }

    #[test]
    fn any_bytes_when_read_then_nothing_panics() {
        let whole = include_str!("every_form.scenario");
        for end in (0..whole.len()).filter(|end| whole.is_char_boundary(*end)) {
            let _ = read(&whole[..end]);
            let _ = read(&whole[end..]);
        }
    }
}
